// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRANSLATION_HPP
#define OPENCV_USACV20_BENCHMARK_TRANSLATION_HPP

#include "plane_map.hpp"

namespace benchmark {

//! T, translation of image 1 to image 2. OpenCV 4 has no function for it; the default settings are
//! those of S.
class Translation : public PlaneMap
{
public:
    Translation();

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE;
    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
