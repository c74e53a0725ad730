// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/any_parameterization.hpp"
#include "problems/similarity/similarity.hpp"
#include "problems/similarity/similarity_parameterization.hpp"
#include "problems/kernels.hpp"
#include "problems/two_view/plane_map.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Rotation, uniform scale and translation from image 1 to image 2.
class SimilarityProblem : public PlaneMapProblem
{
public:
    String name() const CV_OVERRIDE { return "similarity"; }
    int dimension() const CV_OVERRIDE { return SimilarityParameterization::DIMENSION; }
    SampleCost sampleCost() const CV_OVERRIDE
    {
        return SampleCost(120, 1);
    }  // measured together with the cost of H
    Model closest(const Model& model) const CV_OVERRIDE
    {
        return SimilarityParameterization(model).model();
    }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return createSimilarity2Solver(); }
    Ptr<Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<BuiltInParameterization<SimilarityParameterization>>();
    }

    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return createSimilarityFit(residual);
    }
};

}  // namespace

Ptr<Problem> createSimilarityProblem() { return makePtr<SimilarityProblem>(); }

Ptr<NonMinimalSolver> createSimilarityFit(const Ptr<Residual>& residual)
{
    if (hasFormula<TransferError>(*residual))
        return createSimilarityLeastSquares();
    return makePtr<LeastSquaresSolver<SimilarityParameterization>>(residual, 2);
}

}  // namespace usacv20
}  // namespace cv
