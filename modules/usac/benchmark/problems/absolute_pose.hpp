// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ABSOLUTE_POSE_HPP
#define OPENCV_USACV20_BENCHMARK_ABSOLUTE_POSE_HPP

#include "motion_kind.hpp"

namespace benchmark {

//! P, the pose [R t] of a camera from object points and their images, x ~ R X + t. The error of the
//! camera center is in percent of the depth of the scene.
class AbsolutePose : public MotionKind
{
public:
    AbsolutePose();

    bool hasCamera2() const CV_OVERRIDE { return true; }
    void read(const std::string& path, ImagePair& pair) const CV_OVERRIDE;
    double modelError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;
    double modelCost(const ImagePair& pair, const cv::Mat& model,
                     double threshold) const CV_OVERRIDE;
    double centerError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;

    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                         const cv::usacv20::Params& params) const CV_OVERRIDE;
    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE;
    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
