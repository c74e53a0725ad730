// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "factory.hpp"
#include "degeneracy/degeneracy.hpp"
#include "local_optimization/local_optimization.hpp"
#include "neighbourhood/neighbourhood.hpp"
#include "polishing/polishing.hpp"
#include "prior/prior.hpp"
#include "residuals/residuals.hpp"
#include "samplers/samplers.hpp"
#include "scores/scores.hpp"
#include "solvers/solvers.hpp"
#include "termination/termination.hpp"
#include "verification/verification.hpp"

namespace cv {
namespace usacv20 {

namespace {

Ptr<MinimalSolver> createMinimalSolver(ProblemType problem)
{
    switch (problem)
    {
    case HOMOGRAPHY: return createHomography4Solver();
    case FUNDAMENTAL: return createFundamental7Solver();
    default: return createEssential5Solver();
    }
}

Ptr<Sampler> createSampler(int type)
{
    switch (type)
    {
    case SAMPLER_UNIFORM: return createUniformSampler();
    case SAMPLER_PROSAC: return createProsacSampler();
    default: return createPNapsacSampler();
    }
}

Ptr<Prior> createPrior(int type, bool haveScores)
{
    switch (type)
    {
    case PRIOR_NONE: return Ptr<Prior>();
    case PRIOR_INPUT_ORDER: return createInputOrderPrior();
    case PRIOR_DENSITY: return createDensityPrior();
    default: return haveScores ? createScorePrior() : createDensityPrior();
    }
}

Ptr<Polisher> createPolisher(int type)
{
    switch (type)
    {
    case POLISHING_NONE: return Ptr<Polisher>();
    case POLISHING_REWEIGHTED: return createReweightedPolisher();
    default: return createLeastSquaresPolisher();
    }
}

} // namespace

Components createComponents(ProblemType problem, const Params& params, bool haveScores)
{
    Components parts;
    parts.residual = problem == HOMOGRAPHY ? createTransferResidual() : createSampsonResidual();
    parts.score = params.quality == QUALITY_INLIERS ? createInlierScore() : createMsacScore();
    if (params.sampler != SAMPLER_UNIFORM)
        parts.prior = createPrior(params.prior, haveScores);
    parts.neighbourhood = createGridNeighbourhood();
    parts.sampler = createSampler(params.sampler);
    parts.minimalSolver = createMinimalSolver(problem);
    parts.nonMinimalSolver = createLeastSquaresSolver(problem);
    if (params.degeneracy & DEGENERACY_ORIENTATION)
        parts.degeneracies.push_back(problem == HOMOGRAPHY ? createHomographyOrientation() : createOrientedEpipolar());
    if ((params.degeneracy & DEGENERACY_DEGENSAC) && problem == FUNDAMENTAL)
        parts.degeneracies.push_back(createDegensac());
    if (params.verification == VERIFICATION_SPRT)
        parts.verifier = createSprtVerifier(problem);
    if (params.localOptimization == LOCAL_OPTIMIZATION_GRAPH_CUT)
        parts.localOptimizer = createGraphCutOptimizer();
    if (params.termination & TERMINATION_STANDARD)
        parts.terminations.push_back(createStandardTermination());
    if (params.termination & TERMINATION_SPRT)
        parts.terminations.push_back(createSprtTermination());
    if (params.termination & TERMINATION_P_NAPSAC)
        parts.terminations.push_back(createPNapsacTermination());
    parts.polisher = createPolisher(params.polishing);
    return parts;
}

} // namespace usacv20
} // namespace cv
