// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LANE_SOLVER_HPP
#define OPENCV_USACV20_LANE_SOLVER_HPP

#include "lanes/lane_kernels.hpp"

namespace cv {
namespace usacv20 {

//! A minimal solver for 3x3 matrices that solves several samples at once, each in one lane of the
//! vector registers.
class LaneSolver : public MinimalSolver
{
public:
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE;
    void solveMany(const Correspondences& points, const int* const* samples, int count,
                   Model* const* models, int* found) const CV_OVERRIDE;
    int together() const CV_OVERRIDE { return MAX_TOGETHER; }

protected:
    virtual SolverKernel kernelOf(const lanes::Kernels& kernels) const = 0;
};

}  // namespace usacv20
}  // namespace cv

#endif
