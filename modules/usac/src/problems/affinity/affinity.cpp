// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/affinity/affinity.hpp"
#include "problems/affinity/affinity_parameterization.hpp"
#include "problems/kernels.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Affine map from image 1 to image 2, as for a plane that is small or far from the camera.
class AffinityProblem : public PlaneMapProblem
{
public:
    String name() const CV_OVERRIDE { return "affinity"; }
    int dimension() const CV_OVERRIDE { return AffinityParameterization::DIMENSION; }
    SampleCost sampleCost() const CV_OVERRIDE
    {
        return SampleCost(150, 1);
    }  // measured together with the cost of H
    Model closest(const Model& model) const CV_OVERRIDE
    {
        return AffinityParameterization(model).model();
    }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return createAffinity3Solver(); }
    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<AffinityParameterization>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createAffinityFit(residual);
    }
};

}  // namespace

Ptr<Problem> createAffinityProblem() { return makePtr<AffinityProblem>(); }

Ptr<NonMinimalSolver> createAffinityFit(const Ptr<Residual>& residual)
{
    if (hasFormula<TransferError>(*residual))
        return createAffinityLeastSquares();
    return makePtr<LeastSquaresSolver<AffinityParameterization>>(residual, 2);
}

}  // namespace usacv20
}  // namespace cv
