// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PLANE_MAP_HPP
#define OPENCV_USACV20_BENCHMARK_PLANE_MAP_HPP

#include "problem_kind.hpp"

namespace benchmark {

/** Maps from image 1 to image 2, given by a matrix of two or three rows that multiplies homogeneous
points. Errors are distances in image 2, in pixels. */
class PlaneMap : public ProblemKind
{
public:
    using ProblemKind::ProblemKind;

    double modelError(const ImagePair& pair, const cv::Mat& model) const CV_OVERRIDE;
    double failureLimit(const ImagePair& pair) const CV_OVERRIDE;
    double modelCost(const ImagePair& pair, const cv::Mat& model,
                     double threshold) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
