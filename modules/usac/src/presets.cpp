// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

Params Params::usacV20()
{
    return Params();
}

Params Params::fast()
{
    Params params;
    params.relaxation = 0.25;
    params.localIterations = 2;
    params.localSamples = 0;
    params.spatialWeight = 0;
    return params;
}

Params Params::accurate()
{
    Params params;
    params.termination = TERMINATION_STANDARD | TERMINATION_EXACT;
    params.localIterations = 10;
    params.localSamples = 10;
    params.polishing = POLISHING_ROBUST;
    return params;
}

Params Params::prosac()
{
    Params params;
    params.sampler = SAMPLER_PROSAC;
    params.prior = PRIOR_INPUT_ORDER;
    return params;
}

Params Params::parallel()
{
    Params params;
    params.threads = 0;
    return params;
}

Params Params::ransac()
{
    Params params;
    params.sampler = SAMPLER_UNIFORM;
    params.quality = QUALITY_INLIERS;
    params.verification = VERIFICATION_NONE;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    params.termination = TERMINATION_STANDARD;
    params.degeneracy = 0;
    return params;
}

Params Params::fromMethod(int method)
{
    switch (methodFromInt(method))
    {
    case USACV20_FAST: return fast();
    case USACV20_ACCURATE: return accurate();
    case USACV20_PROSAC: return prosac();
    case USACV20_PARALLEL: return parallel();
    default: return usacV20();
    }
}

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
    case SAMPLING_PROSAC: params.sampler = SAMPLER_PROSAC; params.prior = PRIOR_INPUT_ORDER; break;
    default: params.sampler = SAMPLER_P_NAPSAC;
    }
    if (other.score == SCORE_METHOD_RANSAC)
        params.quality = QUALITY_INLIERS;
    if (other.loMethod == LOCAL_OPTIM_NULL)
        params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    return params;
}

} // namespace usacv20
} // namespace cv
