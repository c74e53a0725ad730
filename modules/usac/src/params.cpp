// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

Params::Params()
    : threshold(1.5), confidence(0.99), maxIterations(5000), seed(0), threads(1), sampler(SAMPLER_P_NAPSAC),
      ordering(ORDERING_AUTO), scoreOrder(SCORES_LOWER_IS_BETTER), neighborhood(NEIGHBORHOOD_GRID), neighbors(10),
      neighborRadius(40), residual(RESIDUAL_STANDARD), quality(QUALITY_MSAC), reach(1), widestReach(1),
      verification(VERIFICATION_SPRT), tddPoints(1), localOptimization(LOCAL_OPTIMIZATION_GRAPH_CUT),
      localIterations(5), localSampleMultiple(3), localSamples(4), spatialWeight(0.14), runnersUp(16), orderedEvery(8),
      termination(TERMINATION_SPRT | TERMINATION_P_NAPSAC | TERMINATION_EXACT), relaxation(0.05), persistence(1),
      degeneracy(DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC | DEGENERACY_REPEATED), polishing(POLISHING_ROBUST),
      polishingSteps(6), significance(0)
{}

namespace {

void checkRange(const char* name, double value, double low, double high)
{
    if (!(value >= low && value <= high))  // also for NaN
        CV_Error_(Error::StsOutOfRange, ("%s: %g .. %g is expected, not %g", name, low, high, value));
}

//! Refuses options that contradict each other.
void checkCombination(bool impossible, const char* message)
{
    if (impossible)
        CV_Error(Error::StsBadArg, message);
}

void checkCombinations(const Params& p)
{
    const int criteria = p.termination & ~TERMINATION_EXACT;
    checkCombination((criteria & TERMINATION_SPRT) && p.verification != VERIFICATION_SPRT,
                     "termination: TERMINATION_SPRT needs verification VERIFICATION_SPRT");
    checkCombination((criteria & TERMINATION_PROSAC) && p.sampler != SAMPLER_PROSAC && p.sampler != SAMPLER_P_NAPSAC,
                     "termination: TERMINATION_PROSAC needs a sampler with a growing set of points, SAMPLER_PROSAC or "
                     "SAMPLER_P_NAPSAC");
    checkCombination(
        (criteria & TERMINATION_PROSAC) &&
            !(p.ordering == ORDERING_INPUT_ORDER || (p.ordering == ORDERING_AUTO && !p.scores.empty())),
        "termination: TERMINATION_PROSAC needs points in an order, by scores or by ORDERING_INPUT_ORDER; many wrong "
        "models fit the densest places");
    checkCombination(p.termination == TERMINATION_EXACT,
                     "termination: TERMINATION_EXACT modifies another criterion and stands alone");
    checkCombination(p.sampler == SAMPLER_IMPORTANCE && (p.scores.empty() || p.scoreOrder != SCORES_HIGHER_IS_BETTER),
                     "sampler: SAMPLER_IMPORTANCE needs scores that are probabilities, with scoreOrder "
                     "SCORES_HIGHER_IS_BETTER");
    if (p.quality != QUALITY_LMEDS)
        return;
    checkCombination(p.reach != 1, "reach: QUALITY_LMEDS has no threshold to multiply");
    checkCombination(p.widestReach != 1, "widestReach: QUALITY_LMEDS has no threshold to multiply");
    checkCombination(p.verification != VERIFICATION_NONE,
                     "verification: SPRT and T(d,d) count inliers, for which QUALITY_LMEDS has no threshold yet");
    checkCombination(p.localOptimization != LOCAL_OPTIMIZATION_NONE,
                     "localOptimization: it selects inliers, for which QUALITY_LMEDS has no threshold yet");
    checkCombination((p.degeneracy & DEGENERACY_DEGENSAC) != 0,
                     "degeneracy: DEGENERACY_DEGENSAC selects inliers, for which QUALITY_LMEDS has no threshold yet");
    checkCombination(
        (criteria & (TERMINATION_PROSAC | TERMINATION_MAGSAC)) != 0,
        "termination: TERMINATION_PROSAC and TERMINATION_MAGSAC need the threshold, which QUALITY_LMEDS does "
        "not have yet");
}

//! Scores must have one value for each correspondence; as probabilities, finite ones that are not negative nor all 0.
void checkScores(const Params& p, int count)
{
    if (count >= 0 && !p.scores.empty() && (int)p.scores.size() != count)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("scores: one for each of the %d correspondences is expected, not %d", count, (int)p.scores.size()));
    if (p.sampler != SAMPLER_IMPORTANCE)
        return;
    for (size_t i = 0; i < p.scores.size(); ++i)
        if (!(p.scores[i] >= 0 && p.scores[i] <= FLT_MAX))
            CV_Error_(Error::StsOutOfRange,
                      ("scores: SAMPLER_IMPORTANCE expects finite numbers of at least 0, not %g", p.scores[i]));
}

}  // namespace

void Params::check(int count) const
{
    if (!(threshold > 0 && threshold <= DBL_MAX))
        CV_Error_(Error::StsOutOfRange, ("threshold: a positive number of pixels is expected, not %g", threshold));
    if (!(confidence > 0 && confidence < 1))
        CV_Error_(Error::StsOutOfRange, ("confidence: a number between 0 and 1 is expected, not %g", confidence));
    checkRange("maxIterations", maxIterations, 1, INT_MAX);
    checkRange("threads", threads, 0, 1024);
    checkRange("sampler", sampler, SAMPLER_UNIFORM, SAMPLER_IMPORTANCE);
    checkRange("ordering", ordering, ORDERING_AUTO, ORDERING_NONE);
    checkRange("scoreOrder", scoreOrder, SCORES_LOWER_IS_BETTER, SCORES_HIGHER_IS_BETTER);
    checkRange("neighborhood", neighborhood, NEIGHBORHOOD_GRID, NEIGHBORHOOD_RADIUS);
    checkRange("neighbors", neighbors, 1, 1000);
    if (!(neighborRadius > 0 && neighborRadius <= DBL_MAX))
        CV_Error_(Error::StsOutOfRange,
                  ("neighborRadius: a positive number of pixels is expected, not %g", neighborRadius));
    checkRange("residual", residual, RESIDUAL_STANDARD, RESIDUAL_SYMMETRIC);
    checkRange("quality", quality, QUALITY_INLIERS, QUALITY_MAGSAC_PLUS_PLUS);
    checkRange("reach", reach, 1, 10);
    checkRange("widestReach", widestReach, 1, 1e6);
    checkRange("verification", verification, VERIFICATION_NONE, VERIFICATION_TDD);
    checkRange("tddPoints", tddPoints, 1, 100);
    checkRange("localOptimization", localOptimization, LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_GC_RANSAC);
    checkRange("localIterations", localIterations, 1, 1000);
    checkRange("localSampleMultiple", localSampleMultiple, 2, 100);
    checkRange("localSamples", localSamples, 0, 1000);
    checkRange("spatialWeight", spatialWeight, 0, 10);
    checkRange("runnersUp", runnersUp, 0, 100);
    checkRange("orderedEvery", orderedEvery, 1, 1000);
    checkRange("termination", termination, 0, 2 * TERMINATION_EXACT - 1);
    checkRange("relaxation", relaxation, 0, 1);
    checkRange("persistence", persistence, 1, 100);
    checkRange("degeneracy", degeneracy, 0, DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC | DEGENERACY_REPEATED);
    checkRange("polishing", polishing, POLISHING_NONE, POLISHING_ROBUST);
    checkRange("polishingSteps", polishingSteps, 1, 100);
    checkRange("significance", significance, 0, 1);
    checkCombinations(*this);
    checkScores(*this, count);
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
    visit("ordering", params.ordering);
    visit("scores", params.scores);
    visit("scoreOrder", params.scoreOrder);
    visit("neighborhood", params.neighborhood);
    visit("neighbors", params.neighbors);
    visit("neighborRadius", params.neighborRadius);
    visit("residual", params.residual);
    visit("quality", params.quality);
    visit("reach", params.reach);
    visit("widestReach", params.widestReach);
    visit("verification", params.verification);
    visit("tddPoints", params.tddPoints);
    visit("localOptimization", params.localOptimization);
    visit("localIterations", params.localIterations);
    visit("localSampleMultiple", params.localSampleMultiple);
    visit("localSamples", params.localSamples);
    visit("spatialWeight", params.spatialWeight);
    visit("runnersUp", params.runnersUp);
    visit("orderedEvery", params.orderedEvery);
    visit("termination", params.termination);
    visit("relaxation", params.relaxation);
    visit("persistence", params.persistence);
    visit("degeneracy", params.degeneracy);
    visit("polishing", params.polishing);
    visit("polishingSteps", params.polishingSteps);
    visit("significance", params.significance);
}

struct FieldWriter
{
    FileStorage& fs;
    template <class T>
    void operator()(const char* name, const T& value)
    {
        fs << name << value;
    }
};

struct FieldReader
{
    const FileNode& node;
    template <class T>
    void operator()(const char* name, T& value)
    {
        if (!node[name].empty())
            node[name] >> value;
    }
};

}  // namespace

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

bool isUsacV20Method(int method) { return method >= (int)USACV20 && method <= (int)USACV20_PARALLEL; }

UsacV20Method methodFromInt(int method)
{
    if (!isUsacV20Method(method))
        CV_Error_(Error::StsBadArg, ("method: one of the flags USACV20* is expected, not %d", method));
    return (UsacV20Method)method;
}

}  // namespace usacv20
}  // namespace cv
