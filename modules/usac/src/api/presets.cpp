// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

Params Params::usacV20() { return Params(); }

Params Params::fast()
{
    Params params;
    params.relaxation = 0.5;
    params.localIterations = 1;
    params.localSamples = 0;
    params.spatialWeight = 0;
    params.runnersUp = 4;
    params.polishingSteps = 3;
    return params;
}

Params Params::accurate()
{
    Params params;
    params.termination = TERMINATION_STANDARD | TERMINATION_EXACT | TERMINATION_ORDER;
    params.persistence = 3;
    params.localIterations = 10;
    params.localSamples = 10;
    params.runnersUp = 24;
    params.polishingSteps = 20;
    return params;
}

Params Params::sorted()
{
    Params params;
    params.sampler = SAMPLER_PROSAC;
    params.ordering = ORDERING_INPUT_ORDER;
    return params;
}

Params Params::trustedScores()
{
    Params params;
    params.sampler = SAMPLER_PROSAC;
    params.orderedEvery = 1;
    params.termination = TERMINATION_PROSAC | TERMINATION_SPRT | TERMINATION_P_NAPSAC |
                         TERMINATION_EXACT;
    return params;
}

Params Params::parallel()
{
    Params params;
    params.threads = 0;
    return params;
}

Params Params::automatic()
{
    Params params;
    params.threshold = 5;
    params.thresholdType = THRESHOLD_ESTIMATED;
    return params;
}

Params Params::ransac()
{
    Params params;
    params.sampler = SAMPLER_UNIFORM;
    params.quality = QUALITY_INLIERS;
    params.verification = VERIFICATION_NONE;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    params.runnersUp = 0;
    params.termination = TERMINATION_STANDARD;
    params.degeneracy = 0;
    params.polishing = POLISHING_LEAST_SQUARES;
    return params;
}

Params Params::msac()
{
    Params params = ransac();
    params.quality = QUALITY_MSAC;
    return params;
}

Params Params::lmeds()
{
    Params params = ransac();
    params.quality = QUALITY_LMEDS;
    return params;
}

Params Params::mlesac()
{
    Params params = ransac();
    params.quality = QUALITY_MLESAC;
    return params;
}

Params Params::prosac()
{
    Params params = ransac();
    params.sampler = SAMPLER_PROSAC;
    params.ordering = ORDERING_INPUT_ORDER;
    params.orderedEvery = 1;
    params.termination = TERMINATION_PROSAC;
    return params;
}

Params Params::loRansac()
{
    Params params = ransac();
    params.localOptimization = LOCAL_OPTIMIZATION_LO_RANSAC;
    params.localSamples = 10;
    params.localIterations = 4;
    params.localSampleMultiple = 2;
    return params;
}

Params Params::floRansac()
{
    Params params = loRansac();
    params.quality = QUALITY_MSAC;
    params.localOptimization = LOCAL_OPTIMIZATION_FLO_RANSAC;
    params.localSamples = 4;
    return params;
}

Params Params::gcRansac()
{
    Params params = msac();
    params.localOptimization = LOCAL_OPTIMIZATION_GC_RANSAC;
    params.neighborhood = NEIGHBORHOOD_RADIUS;
    params.neighborRadius = 20;
    params.localSamples = 20;
    params.localIterations = 10;
    params.localSampleMultiple = 7;
    return params;
}

Params Params::usac2013()
{
    Params params = loRansac();
    params.sampler = SAMPLER_PROSAC;
    params.ordering = ORDERING_INPUT_ORDER;
    params.orderedEvery = 1;
    params.verification = VERIFICATION_SPRT;
    params.termination = TERMINATION_SPRT | TERMINATION_PROSAC;
    params.degeneracy = DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC;
    return params;
}

Params Params::paper()
{
    const Params gc = gcRansac();
    Params params;
    params.orderedEvery = 1;
    params.localOptimization = gc.localOptimization;
    params.localSamples = gc.localSamples;
    params.localIterations = gc.localIterations;
    params.localSampleMultiple = gc.localSampleMultiple;
    params.runnersUp = 0;
    params.termination = TERMINATION_SPRT | TERMINATION_P_NAPSAC;
    params.degeneracy = DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC;
    params.polishing = POLISHING_LEAST_SQUARES;
    params.polishingSteps = 1;
    params.significance = 1;
    return params;
}

Params Params::magsac()
{
    Params params = ransac();
    params.quality = QUALITY_MAGSAC;
    params.localOptimization = LOCAL_OPTIMIZATION_SIGMA_CONSENSUS;
    params.termination = TERMINATION_MAGSAC;
    params.polishing = POLISHING_REWEIGHTED;
    params.polishingSteps = 10;
    params.reach = 3;
    params.widestReach = 1000;
    return params;
}

Params Params::magsacPlusPlus()
{
    Params params;
    params.quality = QUALITY_MAGSAC_PLUS_PLUS;
    params.reach = 2.4;
    params.widestReach = 1000;
    params.localOptimization = LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS;
    params.polishing = POLISHING_REWEIGHTED;
    params.polishingSteps = 10;
    return params;
}

Params Params::fromMethod(UsacV20Method method)
{
    switch (methodFromInt((int)method))  // checked, because any int can be cast to the type
    {
    case USACV20: break;
    case USACV20_FAST: return fast();
    case USACV20_ACCURATE: return accurate();
    case USACV20_PROSAC: return sorted();
    case USACV20_MAGSAC: return magsacPlusPlus();
    case USACV20_PARALLEL: return parallel();
    case USACV20_AUTO: return automatic();
    }
    return usacV20();
}

Params Params::fromMethod(int method) { return fromMethod(methodFromInt(method)); }

namespace {

//! Selects LMedS with the verification, local optimization and termination of Params::lmeds(). Of
//! the degeneracy checks, only #DEGENERACY_ORIENTATION remains.
void useLmeds(Params& params)
{
    const Params lmeds = Params::lmeds();
    params.quality = lmeds.quality;
    params.verification = lmeds.verification;
    params.localOptimization = lmeds.localOptimization;
    params.termination = lmeds.termination;
    params.degeneracy = DEGENERACY_ORIENTATION;
}

//! `final_polisher` of the options, a PolishingMethod. Older versions of OpenCV have neither the
//! field nor the type; the result is then COV_POLISHER (3), the default of newer versions.
template <class T>
auto polisherOf(const T& options, int) -> decltype((int)options.final_polisher)
{
    return (int)options.final_polisher;
}

template <class T>
int polisherOf(const T&, long)
{
    return 3;
}

}  // namespace

Params Params::fromUsacParams(const cv::UsacParams& other)
{
    Params params;
    params.threshold = other.threshold;
    params.confidence = other.confidence;
    params.maxIterations = other.maxIterations;
    params.seed = other.randomGeneratorState;
    params.threads = other.isParallel ? 0 : 1;
    switch (other.sampler)
    {
    case SAMPLING_UNIFORM: params.sampler = SAMPLER_UNIFORM; break;
    case SAMPLING_NAPSAC: params.sampler = SAMPLER_NAPSAC; break;
    case SAMPLING_PROSAC:
        params.sampler = SAMPLER_PROSAC;
        params.ordering = ORDERING_INPUT_ORDER;
        break;
    default: params.sampler = SAMPLER_P_NAPSAC;
    }
    switch (other.neighborsSearch)
    {
    case NEIGH_FLANN_KNN: params.neighborhood = NEIGHBORHOOD_KNN; break;
    case NEIGH_FLANN_RADIUS: params.neighborhood = NEIGHBORHOOD_RADIUS; break;
    default: params.neighborhood = NEIGHBORHOOD_GRID;
    }
    switch (other.loMethod)
    {
    case LOCAL_OPTIM_NULL: params.localOptimization = LOCAL_OPTIMIZATION_NONE; break;
    case LOCAL_OPTIM_GC: params.localOptimization = LOCAL_OPTIMIZATION_GRAPH_CUT; break;
    case LOCAL_OPTIM_SIGMA:
        params.localOptimization = LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS;
        break;
    default: params.localOptimization = LOCAL_OPTIMIZATION_LO_RANSAC; params.localSamples = 4;
    }
    switch (other.score)
    {
    case SCORE_METHOD_RANSAC: params.quality = QUALITY_INLIERS; break;
    case SCORE_METHOD_MAGSAC:
        params.quality = QUALITY_MAGSAC_PLUS_PLUS;
        params.reach = magsacPlusPlus().reach;
        params.widestReach = magsacPlusPlus().widestReach;
        break;
    case SCORE_METHOD_LMEDS: useLmeds(params); break;
    default: params.quality = QUALITY_MSAC;
    }
    switch (polisherOf(other, 0))
    {
    case 0: params.polishing = POLISHING_NONE; break;           // NONE_POLISHER
    case 1: params.polishing = POLISHING_LEAST_SQUARES; break;  // LSQ_POLISHER
    case 2: params.polishing = POLISHING_REWEIGHTED; break;     // MAGSAC
    }
    return params;
}

}  // namespace usacv20
}  // namespace cv
