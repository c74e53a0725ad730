// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/lane_solver.hpp"
#include "problems/homography/homography.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The homography that maps four points exactly, see lanes/four_points.inl.hpp.
class Homography4Solver : public LaneSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 4; }

protected:
    SolverKernel kernelOf(const lanes::Kernels& kernels) const CV_OVERRIDE
    {
        return kernels.fourPoints;
    }
};

}  // namespace

Ptr<MinimalSolver> createHomography4Solver() { return makePtr<Homography4Solver>(); }

}  // namespace usacv20
}  // namespace cv
