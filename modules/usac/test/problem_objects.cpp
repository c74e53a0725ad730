// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "problem_objects.hpp"

#include "problems/essential/essential_parameterization.hpp"
#include "problems/fundamental/fundamental_parameterization.hpp"
#include "problems/homography/homography_parameterization.hpp"
#include "scoring/residuals.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

const Problem& problemObject(ProblemType type)
{
    static const Ptr<Problem> objects[] = {createHomographyProblem(), createFundamentalProblem(),
                                           createEssentialProblem(Matx33d::eye(), noArray(), noArray(), noArray())};
    return *objects[type];
}

Ptr<Residual> residualOf(Residual::Kind kind)
{
    switch (kind)
    {
    case Residual::TRANSFER: return createTransferResidual();
    case Residual::SYMMETRIC_TRANSFER: return createSymmetricTransferResidual();
    case Residual::SAMPSON: return createSampsonResidual();
    default: return createSymmetricEpipolarResidual();
    }
}

Ptr<NonMinimalSolver> createLeastSquaresSolver(ProblemType type, Residual::Kind kind)
{
    return problemObject(type).createNonMinimalSolver(residualOf(kind));
}

static ProblemType typeOf(const Problem* problem)
{
    return problem->name() == "homography" ? HOMOGRAPHY : problem->name() == "fundamental" ? FUNDAMENTAL : ESSENTIAL;
}

Parameterization::Parameterization(ProblemType type_, const Model& model) : type(type_), given(model) {}
Parameterization::Parameterization(const Problem* problem, const Model& model) : type(typeOf(problem)), given(model) {}

bool Parameterization::hasFullRank() const
{
    return type == HOMOGRAPHY    ? HomographyParameterization(given).hasFullRank()
           : type == FUNDAMENTAL ? FundamentalParameterization(given).hasFullRank()
                                 : EssentialParameterization(given).hasFullRank();
}

int Parameterization::dimension() const { return problemObject(type).dimension(); }

Parameterization::Basis Parameterization::tangent() const
{
    if (type == HOMOGRAPHY)
        return HomographyParameterization(given).tangent();
    if (type == FUNDAMENTAL)
        return FundamentalParameterization(given).tangent();
    return EssentialParameterization(given).tangent();
}

Parameterization Parameterization::plus(const Step& step) const
{
    return Parameterization(type, type == HOMOGRAPHY    ? HomographyParameterization(given).plus(step).model()
                                  : type == FUNDAMENTAL ? FundamentalParameterization(given).plus(step).model()
                                                        : EssentialParameterization(given).plus(step).model());
}

Model Parameterization::model() const
{
    return type == HOMOGRAPHY    ? HomographyParameterization(given).model()
           : type == FUNDAMENTAL ? FundamentalParameterization(given).model()
                                 : EssentialParameterization(given).model();
}

}  // namespace opencv_test
