// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_EPIPOLAR_HPP
#define OPENCV_USACV20_BENCHMARK_EPIPOLAR_HPP

#include "problem_kind.hpp"

namespace benchmark {

//! Problems of epipolar geometry. Errors are Sampson distances in pixels.
class Epipolar : public ProblemKind
{
public:
    using ProblemKind::ProblemKind;

    double modelError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;
    double failureLimit(const ImagePair& pair) const CV_OVERRIDE;
    double modelCost(const ImagePair& pair, const cv::Mat& model,
                     double threshold) const CV_OVERRIDE;
    double poseError(const ImagePair& pair, const Estimate& estimate) const CV_OVERRIDE;

protected:
    //! The fundamental matrix (toEssential: the essential matrix) of the epipolar geometry that a
    //! model of the problem describes.
    virtual cv::Matx33d toFundamental(const ImagePair& pair, const cv::Matx33d& model) const = 0;
    virtual cv::Matx33d toEssential(const ImagePair& pair, const cv::Matx33d& model) const = 0;
};

}  // namespace benchmark

#endif
