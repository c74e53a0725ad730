// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "loop/factory.hpp"
#include "local_optimization/local_optimization.hpp"
#include "neighborhood/neighborhood.hpp"
#include "polishing/polishing.hpp"
#include "ordering/ordering.hpp"
#include "problems/noise_of_matches.hpp"
#include "samplers/samplers.hpp"
#include "scoring/scores.hpp"
#include "termination/termination.hpp"
#include "verification/verification.hpp"

namespace cv {
namespace usacv20 {

namespace {

Ptr<Sampler> createSampler(int type)
{
    switch (type)
    {
    case SAMPLER_UNIFORM: return createUniformSampler();
    case SAMPLER_PROSAC: return createProsacSampler();
    case SAMPLER_NAPSAC: return createNapsacSampler();
    case SAMPLER_IMPORTANCE: return createImportanceSampler();
    default: return createPNapsacSampler();
    }
}

Ptr<Ordering> createOrdering(int type, bool haveScores)
{
    switch (type)
    {
    case ORDERING_NONE: return Ptr<Ordering>();
    case ORDERING_INPUT_ORDER:
        return haveScores ? createScoreOrdering() : createInputOrderOrdering();
    case ORDERING_DENSITY: return createDensityOrdering();
    default: return haveScores ? createScoreOrdering() : createDensityOrdering();
    }
}

Ptr<Neighborhood> createNeighborhood(const Params& params, int columns)
{
    switch (params.neighborhood)
    {
    case NEIGHBORHOOD_KNN: return createKnnNeighborhood(params.neighbors);
    case NEIGHBORHOOD_RADIUS: return createRadiusNeighborhood(params.neighborRadius);
    default: return createGridNeighborhood(columns);
    }
}

Ptr<Score> createScore(const Params& params, const Problem& problem)
{
    switch (params.quality)
    {
    case QUALITY_INLIERS: return createInlierScore();
    case QUALITY_MLESAC: return createMlesacScore();
    case QUALITY_LMEDS: return createLmedsScore();
    case QUALITY_MAGSAC: return createMagsacScore(problem.errorDimension(), params.reach);
    case QUALITY_MAGSAC_PLUS_PLUS:
        return createMagsacPlusPlusScore(problem.errorDimension(), params.reach);
    default: return createMsacScore();
    }
}

Ptr<Verifier> createVerifier(const Params& params, const SampleCost& cost)
{
    switch (params.verification)
    {
    case VERIFICATION_NONE: return Ptr<Verifier>();
    case VERIFICATION_TDD: return createTddVerifier(params.tddPoints);
    default: return createSprtVerifier(cost);
    }
}

Ptr<LocalOptimizer> createLocalOptimizer(int type)
{
    switch (type)
    {
    case LOCAL_OPTIMIZATION_NONE: return Ptr<LocalOptimizer>();
    case LOCAL_OPTIMIZATION_LO_RANSAC: return createLoRansacOptimizer();
    case LOCAL_OPTIMIZATION_FLO_RANSAC: return createFloRansacOptimizer();
    case LOCAL_OPTIMIZATION_GC_RANSAC: return createGcRansacOptimizer();
    case LOCAL_OPTIMIZATION_SIGMA_CONSENSUS: return createSigmaConsensus();
    case LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS: return createSigmaConsensusPlusPlus();
    default: return createGraphCutOptimizer();
    }
}

void createTerminations(int flags, std::vector<Ptr<Termination>>& terminations)
{
    if (flags & TERMINATION_STANDARD)
        terminations.push_back(createStandardTermination());
    if (flags & TERMINATION_SPRT)
        terminations.push_back(createSprtTermination());
    if (flags & TERMINATION_P_NAPSAC)
        terminations.push_back(createPNapsacTermination());
    if (flags & TERMINATION_MAGSAC)
        terminations.push_back(createMagsacTermination());
    if (flags & TERMINATION_PROSAC)
        terminations.push_back(createProsacTermination());
    if (flags & TERMINATION_ORDER)
        terminations.push_back(createConfirmedOrderTermination());
}

Ptr<Polisher> createPolisher(int type)
{
    switch (type)
    {
    case POLISHING_NONE: return Ptr<Polisher>();
    case POLISHING_REWEIGHTED: return createReweightedPolisher();
    case POLISHING_ROBUST: return createRobustPolisher();
    default: return createLeastSquaresPolisher();
    }
}

}  // namespace

Components createComponents(const Problem& problem, const Params& params,
                            const Correspondences& points)
{
    Components parts;
    parts.residual = residualWithNoise(problem.createResidual(params.residual), points);
    parts.minimalSolver = problem.createMinimalSolver();
    parts.score = createScore(params, problem);
    if (params.sampler == SAMPLER_PROSAC || params.sampler == SAMPLER_P_NAPSAC)
        parts.ordering = createOrdering(params.ordering, !params.scores.empty());
    parts.neighborhood = createNeighborhood(params,
                                            problem.coordinates(0) + problem.coordinates(1));
    parts.sampler = createSampler(params.sampler);
    parts.nonMinimalSolver = problem.createNonMinimalSolver(parts.residual);
    problem.createDegeneracies(params.degeneracy, parts.degeneracies);
    parts.verifier = createVerifier(params, problem.sampleCost());
    parts.localOptimizer = createLocalOptimizer(params.localOptimization);
    createTerminations(params.termination, parts.terminations);
    parts.polisher = createPolisher(params.polishing);
    return parts;
}

}  // namespace usacv20
}  // namespace cv
