// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

Params::Params()
    : threshold(1.5), confidence(0.99), maxIterations(5000), seed(0), threads(1), sampler(SAMPLER_P_NAPSAC),
      prior(PRIOR_AUTO), scoreOrder(SCORES_LOWER_IS_BETTER), quality(QUALITY_MSAC), verification(VERIFICATION_SPRT),
      localOptimization(LOCAL_OPTIMIZATION_GRAPH_CUT), localIterations(5), localSampleMultiple(3), localSamples(4),
      spatialWeight(0.14), termination(TERMINATION_SPRT | TERMINATION_P_NAPSAC), relaxation(0.03),
      degeneracy(DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC), polishing(POLISHING_LEAST_SQUARES)
{
}

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
    params.termination = TERMINATION_STANDARD;
    params.localIterations = 10;
    params.localSamples = 10;
    params.polishing = POLISHING_REWEIGHTED;
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

namespace {

void checkRange(const char* name, double value, double low, double high)
{
    if (!(value >= low && value <= high))  // also for NaN
        CV_Error_(Error::StsOutOfRange, ("%s: %g .. %g is expected, not %g", name, low, high, value));
}

} // namespace

void Params::check(int count) const
{
    if (!(threshold > 0 && threshold <= DBL_MAX))
        CV_Error_(Error::StsOutOfRange, ("threshold: a positive number of pixels is expected, not %g", threshold));
    if (!(confidence > 0 && confidence < 1))
        CV_Error_(Error::StsOutOfRange, ("confidence: a number between 0 and 1 is expected, not %g", confidence));
    checkRange("maxIterations", maxIterations, 1, INT_MAX);
    checkRange("threads", threads, 0, 1024);
    checkRange("sampler", sampler, SAMPLER_UNIFORM, SAMPLER_P_NAPSAC);
    checkRange("prior", prior, PRIOR_AUTO, PRIOR_NONE);
    checkRange("scoreOrder", scoreOrder, SCORES_LOWER_IS_BETTER, SCORES_HIGHER_IS_BETTER);
    checkRange("quality", quality, QUALITY_INLIERS, QUALITY_MSAC);
    checkRange("verification", verification, VERIFICATION_NONE, VERIFICATION_SPRT);
    checkRange("localOptimization", localOptimization, LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_GRAPH_CUT);
    checkRange("localIterations", localIterations, 1, 1000);
    checkRange("localSampleMultiple", localSampleMultiple, 2, 100);
    checkRange("localSamples", localSamples, 0, 1000);
    checkRange("spatialWeight", spatialWeight, 0, 10);
    checkRange("termination", termination, 0, TERMINATION_STANDARD | TERMINATION_SPRT | TERMINATION_P_NAPSAC);
    checkRange("relaxation", relaxation, 0, 1);
    checkRange("degeneracy", degeneracy, 0, DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC);
    checkRange("polishing", polishing, POLISHING_NONE, POLISHING_REWEIGHTED);
    if ((termination & TERMINATION_SPRT) && verification != VERIFICATION_SPRT)
        CV_Error(Error::StsBadArg, "termination: TERMINATION_SPRT needs verification VERIFICATION_SPRT");
    if (count >= 0 && !scores.empty() && (int)scores.size() != count)
        CV_Error_(Error::StsUnmatchedSizes, ("scores: one for each of the %d correspondences is expected, not %d", count,
                  (int)scores.size()));
}

namespace {

//! Calls visit(name, field) for every field but the scores: one list for writing and reading.
template <class P, class Visitor>
void visitFields(P& params, Visitor& visit)
{
    visit("threshold", params.threshold);
    visit("confidence", params.confidence);
    visit("maxIterations", params.maxIterations);
    visit("seed", params.seed);
    visit("threads", params.threads);
    visit("sampler", params.sampler);
    visit("prior", params.prior);
    visit("scores", params.scores);
    visit("scoreOrder", params.scoreOrder);
    visit("quality", params.quality);
    visit("verification", params.verification);
    visit("localOptimization", params.localOptimization);
    visit("localIterations", params.localIterations);
    visit("localSampleMultiple", params.localSampleMultiple);
    visit("localSamples", params.localSamples);
    visit("spatialWeight", params.spatialWeight);
    visit("termination", params.termination);
    visit("relaxation", params.relaxation);
    visit("degeneracy", params.degeneracy);
    visit("polishing", params.polishing);
}

struct FieldWriter
{
    FileStorage& fs;
    template <class T> void operator()(const char* name, const T& value) { fs << name << value; }
};

struct FieldReader
{
    const FileNode& node;
    template <class T> void operator()(const char* name, T& value)
    {
        if (!node[name].empty())
            node[name] >> value;
    }
};

} // namespace

void Params::write(FileStorage& fs) const
{
    FieldWriter writer = {fs};
    visitFields(*this, writer);
}

void Params::read(const FileNode& node)
{
    FieldReader reader = {node};
    visitFields(*this, reader);
}

void write(FileStorage& fs, const String&, const Params& params)
{
    fs << "{";
    params.write(fs);
    fs << "}";
}

void read(const FileNode& node, Params& params, const Params& defaults)
{
    params = defaults;
    params.read(node);
}

bool isUsacV20Method(int method)
{
    return (method >= USACV20 && method <= USACV20_PROSAC) || method == USACV20_PARALLEL;
}

UsacV20Method methodFromInt(int method)
{
    if (!isUsacV20Method(method))
        CV_Error_(Error::StsBadArg, ("method: one of the flags USACV20* is expected, not %d", method));
    return (UsacV20Method)method;
}

} // namespace usacv20
} // namespace cv
