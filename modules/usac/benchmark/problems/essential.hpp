// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ESSENTIAL_HPP
#define OPENCV_USACV20_BENCHMARK_ESSENTIAL_HPP

#include "epipolar.hpp"

namespace benchmark {

//! E, the essential matrix; the pair must have both camera matrices.
class Essential : public Epipolar
{
public:
    Essential();

    bool hasCamera1() const CV_OVERRIDE { return true; }
    bool hasCamera2() const CV_OVERRIDE { return true; }
    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                         const cv::usacv20::Params& params) const CV_OVERRIDE;
    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE;
    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE;

protected:
    void checkTruth(const TruthReader& in, const ImagePair& pair) const CV_OVERRIDE;
    cv::Matx33d toFundamental(const ImagePair& pair, const cv::Matx33d& model) const CV_OVERRIDE;
    cv::Matx33d toEssential(const ImagePair& pair, const cv::Matx33d& model) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
