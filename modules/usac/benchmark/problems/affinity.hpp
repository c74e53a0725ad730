// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_AFFINITY_HPP
#define OPENCV_USACV20_BENCHMARK_AFFINITY_HPP

#include "plane_map.hpp"

namespace benchmark {

//! A, an affine map of image 1 to image 2. The default settings are those of calib3d's function.
class Affinity : public PlaneMap
{
public:
    Affinity();

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE;
    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
