// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "two_view/pair_models.hpp"

namespace cv {
namespace usacv20 {

namespace {

/* A model is found more often than the fraction of all-inlier samples suggests: local optimization
also corrects models of samples that contain an outlier, the plane-and-parallax algorithm computes
models from degenerate samples (F), and many samples are drawn from regions where right matches are
dense. When the number of samples is computed, a sample of USACV20 therefore counts as (inliers /
ONE_FOR_E)^2 samples for E, at least 1 and at most MOST_FOR_E, and as SAMPLES_FOR_F samples for F.
doc/measurements/collections_tables.md has the measured numbers; the constants are near the lowest
numbers measured on photographs and in collections, but above the number measured for E with matches
that are scattered over both images. Samples for H, and samples of other presets, count as one,
because they were not measured. */
constexpr double ONE_FOR_E = 11.5, MOST_FOR_E = 4, SAMPLES_FOR_F = 4;
//! Number of values that represent the inlier ratios between TwoViewRules::inlierRatio and the
//! lowest element of TwoViewRules::ratios. See doc/constants.md.
constexpr int TAIL = 8;
constexpr int E_SAMPLE = 5, F_SAMPLE = 7;

//! True if the search is that of USACV20, for which the numbers used in countedAs() were measured.
bool isMeasured(const Params& params)
{
    const Params usual;
    return params.localOptimization == usual.localOptimization && params.quality == usual.quality &&
           params.sampler == usual.sampler && params.localIterations == usual.localIterations &&
           params.localSamples == usual.localSamples && params.polishing == usual.polishing;
}

//! The fraction of all-inlier samples among samples whose points are drawn without replacement. The
//! number of inliers is assumed to be at least TwoViewRules::minInliers and the sample size.
double rightSamples(const TwoViewRules& rules, int sampleSize, int matches, double ratio)
{
    double count = std::ceil(ratio * matches);
    if (matches > 0 && (count - 1) / matches >= ratio)  // rounding error, as in 0.07 * 100 > 7
        --count;
    count = std::max(count, (double)std::max(rules.minInliers, sampleSize));
    double part = 1;
    for (int i = 0; i < sampleSize; ++i)
        part *= std::min((count - i) / std::max(matches - i, 1), 1.);
    return part;
}

//! The number of samples that one sample counts as when the number of samples is computed.
double countedAs(const TwoViewRules& rules, bool measured, int sampleSize, int matches,
                 double ratio)
{
    if (!measured || (sampleSize != E_SAMPLE && sampleSize != F_SAMPLE))
        return 1;
    if (sampleSize == F_SAMPLE)
        return SAMPLES_FOR_F;
    const double inliers = std::max(ratio * matches, (double)rules.minInliers) / ONE_FOR_E;
    return std::min(std::max(inliers * inliers, 1.), MOST_FOR_E);
}

//! Logarithm of the probability that one sample does not lead to the model of a pair; -infinity if
//! every sample leads to it.
double missedBySample(const TwoViewRules& rules, bool measured, int sampleSize, int matches,
                      double ratio)
{
    const double right = rightSamples(rules, sampleSize, matches, ratio);
    if (right >= 1)
        return -HUGE_VAL;
    return countedAs(rules, measured, sampleSize, matches, ratio) * std::log1p(-right);
}

//! The pairs of a collection, with the probabilities that a sample misses the model of a pair.
class Collection
{
public:
    Collection(const TwoViewRules& rules, bool measured, int sampleSize, int matches)
        : slowest(-HUGE_VAL)
    {
        double least = 1;
        for (size_t i = 0; i < rules.ratios.size(); ++i)
        {
            const double ratio = std::max(rules.ratios[i], rules.inlierRatio);
            least = std::min(least, ratio);
            add(missedBySample(rules, measured, sampleSize, matches, ratio), 1);
        }
        const double between = rules.ratios.empty() ? 0 : least - rules.inlierRatio;
        for (int i = 0; i < TAIL; ++i)
            add(missedBySample(rules, measured, sampleSize, matches,
                               rules.inlierRatio + between * (i + 0.5) / TAIL),
                1. / TAIL);
        for (size_t i = 0; i < weights.size(); ++i)
            weights[i] /= rules.ratios.size() + 1;
    }

    //! The expected fraction of pairs whose model is not found with `samples` samples.
    double missed(double samples) const
    {
        double sum = 0;
        for (size_t i = 0; i < weights.size(); ++i)
            if (logarithms[i] > -HUGE_VAL)
                sum += weights[i] * std::exp(samples * logarithms[i]);
        return sum;
    }

    double slowest;  //!< largest of `logarithms`: of the pairs whose models are hardest to find

private:
    void add(double logarithm, double weight)
    {
        slowest = std::max(slowest, logarithm);
        if (!logarithms.empty() && logarithms.back() == logarithm)
        {
            weights.back() += weight;
            return;
        }
        logarithms.push_back(logarithm);
        weights.push_back(weight);
    }

    std::vector<double> logarithms,
        weights;  //!< for pairs of one inlier ratio: missedBySample(); fraction of all pairs
};

void checkRatio(double value, const char* name)
{
    if (!(value >= 0 && value <= 1))
        CV_Error_(Error::StsOutOfRange,
                  ("%s: a number from 0 to 1 is expected, not %g", name, value));
}

}  // namespace

TwoViewRules::TwoViewRules()
    : minInliers(15), inlierRatio(0.25), planarRatio(0.8), calibrationRatio(0.95)
{}

void TwoViewRules::check() const
{
    if (minInliers < 1)
        CV_Error_(Error::StsOutOfRange,
                  ("minInliers: a positive number is expected, not %d", minInliers));
    checkRatio(inlierRatio, "inlierRatio");
    checkRatio(planarRatio, "planarRatio");
    checkRatio(calibrationRatio, "calibrationRatio");
    for (size_t i = 0; i < ratios.size(); ++i)
        if (!(ratios[i] > 0 && ratios[i] <= 1))
            CV_Error_(Error::StsOutOfRange,
                      ("ratios: numbers above 0 and up to 1 are expected, not %g", ratios[i]));
}

void TwoViewRules::check(const Params& params) const
{
    params.check();
    check();
    if (!params.initialModel.empty())
        CV_Error_(Error::StsBadArg,
                  ("initialModel: none is expected, as E, F and H are estimated, not %d numbers",
                   (int)params.initialModel.size()));
    if (params.quality == QUALITY_LMEDS)
        CV_Error(Error::StsBadArg,
                 "quality: QUALITY_LMEDS cannot be used for pairs, because it chooses a threshold "
                 "for each model, but E, F and H are compared at one threshold");
}

double TwoViewRules::samples(const Params& params, int sampleSize, int matches) const
{
    const double lost = 1 - std::min(params.confidence, 1 - 1e-15);
    const Collection pairs(*this, isMeasured(params), sampleSize, matches);
    if (pairs.slowest <= std::log(lost))
        return LEAST_SAMPLES;
    double low = 0, high = std::ceil(std::log(lost) / pairs.slowest);
    while (high - low > 1)
    {
        const double middle = std::floor((low + high) / 2);
        if (middle <= low || middle >= high)  // above 2^53, doubles do not represent all integers
            break;
        (pairs.missed(middle) <= lost ? high : low) = middle;
    }
    return std::max((double)LEAST_SAMPLES, high);
}

double TwoViewRules::reached(const Params& params, int sampleSize, int matches) const
{
    const double drawn = std::min((double)params.maxIterations,
                                  samples(params, sampleSize, matches));
    return -std::expm1(drawn *
                       missedBySample(*this, isMeasured(params), sampleSize, matches, inlierRatio));
}

}  // namespace usacv20
}  // namespace cv
