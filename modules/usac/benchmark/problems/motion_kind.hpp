// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_MOTION_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_MOTION_KIND_HPP

#include "problem_kind.hpp"

namespace benchmark {

/** Problems whose model is a 3x4 motion matrix: absolute pose (P), rigid motion (R) and similarity
of 3D space (M). The error of a model is the angle, in degrees, between its rotation and the true
one. An estimate is a failure if this error is above 5 degrees, or if the center error, which
doc/benchmark.md defines, is above 5 %. */
class MotionKind : public ProblemKind
{
public:
    MotionKind(ProblemType type_, char letter_, double threshold_, int maxIterations_)
        : ProblemKind(type_, letter_, cv::Size(4, 3), threshold_, maxIterations_)
    {}

    bool inPixels() const CV_OVERRIDE { return false; }
    double failureLimit(const ImagePair& pair) const CV_OVERRIDE;
    double poseError(const ImagePair& pair, const Estimate& estimate) const CV_OVERRIDE;
    bool failed(const ImagePair& pair, double error, double centerError) const CV_OVERRIDE;
};

}  // namespace benchmark

#endif
