// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/lane_solver.hpp"
#include "problems/fundamental/fundamental.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! One to three fundamental matrices from seven points, see seven_points.inl.hpp.
class Fundamental7Solver : public LaneSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 7; }

protected:
    SolverKernel kernelOf(const lanes::Kernels& kernels) const CV_OVERRIDE
    {
        return kernels.sevenPoints;
    }
};

}  // namespace

Ptr<MinimalSolver> createFundamental7Solver() { return makePtr<Fundamental7Solver>(); }

}  // namespace usacv20
}  // namespace cv
