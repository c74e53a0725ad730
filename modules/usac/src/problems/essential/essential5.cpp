// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/lane_solver.hpp"
#include "problems/essential/essential.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Up to ten essential matrices from five points of calibrated cameras, see five_points.inl.hpp.
class Essential5Solver : public LaneSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 5; }

protected:
    SolverKernel kernelOf(const lanes::Kernels& kernels) const CV_OVERRIDE
    {
        return kernels.fivePoints;
    }
};

}  // namespace

Ptr<MinimalSolver> createEssential5Solver() { return makePtr<Essential5Solver>(); }

}  // namespace usacv20
}  // namespace cv
