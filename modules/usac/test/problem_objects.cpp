// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "problem_objects.hpp"

#include "problems/affinity/affinity_parameterization.hpp"
#include "problems/essential/essential_parameterization.hpp"
#include "problems/fundamental/fundamental_parameterization.hpp"
#include "problems/homography/homography_parameterization.hpp"
#include "problems/similarity/similarity_parameterization.hpp"
#include "scoring/residuals.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

const Problem& problemObject(ProblemType type)
{
    static const Ptr<Problem> objects[] = {
        createHomographyProblem(), createFundamentalProblem(),
        createEssentialProblem(Matx33d::eye(), noArray(), noArray(), noArray()),
        createAffinityProblem(), createSimilarityProblem()};
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
    int type = HOMOGRAPHY;
    while (problemObject((ProblemType)type).name() != problem->name())
        ++type;
    return (ProblemType)type;
}

Parameterization::Parameterization(ProblemType type_, const Model& model)
    : type(type_), given(model)
{}
Parameterization::Parameterization(const Problem* problem, const Model& model)
    : type(typeOf(problem)), given(model)
{}

namespace {

//! What is asked of a parameterization, of any problem.
template <class Asked>
typename Asked::Result ask(ProblemType type, const Model& model, const Asked& asked)
{
    switch (type)
    {
    case HOMOGRAPHY: return asked(HomographyParameterization(model));
    case FUNDAMENTAL: return asked(FundamentalParameterization(model));
    case AFFINITY: return asked(AffinityParameterization(model));
    case SIMILARITY: return asked(SimilarityParameterization(model));
    default: return asked(EssentialParameterization(model));
    }
}

struct HasFullRank
{
    typedef bool Result;
    template <class T>
    bool operator()(const T& here) const
    {
        return here.hasFullRank();
    }
};

struct Tangent
{
    typedef Parameterization::Basis Result;
    template <class T>
    Result operator()(const T& here) const
    {
        return here.tangent();
    }
};

struct Plus
{
    typedef Model Result;
    template <class T>
    Model operator()(const T& here) const
    {
        return here.plus(step).model();
    }
    const Parameterization::Step& step;
};

struct ModelOf
{
    typedef Model Result;
    template <class T>
    Model operator()(const T& here) const
    {
        return here.model();
    }
};

}  // namespace

bool Parameterization::hasFullRank() const { return ask(type, given, HasFullRank()); }

int Parameterization::dimension() const { return problemObject(type).dimension(); }

Parameterization::Basis Parameterization::tangent() const { return ask(type, given, Tangent()); }

Parameterization Parameterization::plus(const Step& step) const
{
    const Plus plus = {step};
    return Parameterization(type, ask(type, given, plus));
}

Model Parameterization::model() const { return ask(type, given, ModelOf()); }

}  // namespace opencv_test
