// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/draw.hpp"
#include "support/problem_objects.hpp"
#include "components/sample_statistics.hpp"
#include "control/watch.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

//! P(Binomial(n, p) >= k) from the recurrence of Pascal's triangle, without logarithms.
double tailBySum(int k, int n, double p)
{
    std::vector<double> all(1, 1.);
    for (int i = 0; i < n; ++i)
    {
        all.push_back(0);
        for (int j = i + 1; j >= 0; --j)
            all[j] = all[j] * (1 - p) + (j > 0 ? all[j - 1] * p : 0);
    }
    double sum = 0;
    for (int j = n; j >= k && j >= 0; --j)
        sum += all[j];
    return sum;
}

//! The arguments of one evaluation of the criterion, and the expected result.
struct Case
{
    std::vector<uchar> inliers, repeated;
    int m;
    double kept, randomRatio, confidence;
    bool exact;

    int samples(int& length) const
    {
        return prosacSamples(inliers.data(), repeated.empty() ? 0 : repeated.data(),
                             (int)inliers.size(), m, kept, randomRatio, std::log(1 - confidence),
                             exact, length);
    }

    //! The expected result, by evaluating the definitions for all numbers n of best points.
    //! `length` is set to the n that needs the fewest samples, or to 0 if there is none.
    int bruteForce(int& length) const
    {
        const int N = (int)inliers.size();
        std::vector<double> uniform;
        const std::vector<double> limit = publishedGrowth(N, m, &uniform);
        int best = INT_MAX;
        length = 0;
        for (int n = m; n <= N; ++n)
        {
            const int I = (int)std::count(inliers.begin(), inliers.begin() + n, 1);
            const int twins = repeated.empty()
                                  ? 0
                                  : (int)std::count(repeated.begin(), repeated.begin() + n, 1);
            if (I <= m)
                continue;
            double p = kept;
            for (int i = 0; i < m; ++i)
                p *= exact ? (double)(I - i) / (n - i) : (double)I / n;
            double k = 1;  // number of samples; counted without logarithms if it is not too large
            if (p < 1 && std::log(1 - confidence) / std::log(1 - p) > 3000)
                k = std::ceil(std::log(1 - confidence) / std::log(1 - p));
            else
                while (std::pow(1 - p, k) > 1 - confidence)
                    ++k;
            const double missing = std::max(0., std::ceil(k - uniform[n] * (1 + 1e-9)));
            if (n < N && missing > 0)
                continue;
            const double t = limit[n] + missing;
            const bool random = I - twins <= m ||
                                t * tailBySum(I - twins - m, n - twins - m, randomRatio) >= 0.05;
            if (!random && t < best)
            {
                best = (int)t;
                length = n;
            }
        }
        return best;
    }
};

//! A random order in which inliers are more frequent among the best points.
Case randomCase(RNG& rng, int trial)
{
    Case c;
    const int N = rng.uniform(8, 150);
    const double high = rng.uniform(0.1, 1.), low = rng.uniform(0., 1.) * high;
    for (int i = 0; i < N; ++i)
    {
        c.inliers.push_back(rng.uniform(0., 1.) < high + (low - high) * i / N);
        if (trial % 3 == 0)
            c.repeated.push_back(c.inliers[i] && rng.uniform(0, 4) == 0);
    }
    c.m = 4 + trial % 4;
    c.kept = trial % 2 ? 1 : rng.uniform(0.2, 1.);
    c.randomRatio = std::pow(10., rng.uniform(-5., -0.3));
    c.confidence = rng.uniform(0.3, 0.999);
    c.exact = trial % 5 < 3;
    return c;
}

TEST(Usac_TerminationProsac, againstBruteForce)
{
    RNG rng(1);
    int within = 0, never = 0, atTheEnd = 0;
    for (int trial = 0; trial < 600; ++trial)
    {
        const Case c = randomCase(rng, trial);
        int length, expectedLength;
        const int samples = c.samples(length), expected = c.bruteForce(expectedLength);
        EXPECT_EQ(expectedLength, length) << trial;
        // rounding can decide the ceiling of T_{n+1} - T_n, as in the sampler
        EXPECT_NEAR(expected, samples, expected == INT_MAX ? 0 : 3) << trial;
        within += length > 0 && length < (int)c.inliers.size();
        atTheEnd += length == (int)c.inliers.size();
        never += length == 0;
    }
    EXPECT_GT(within, 100);
    EXPECT_GT(never, 50);
    EXPECT_GT(atTheEnd, 10);
}

//! The smallest number of inliers that is not random must be the quantile of the exact binomial
//! distribution, for a single model and for the best of all models.
TEST(Usac_TerminationProsac, minimalSupport)
{
    for (int n = 20; n <= 120; n += 25)
        for (double ratio = 0.001; ratio < 0.5; ratio *= 3)
            for (int kind = 0; kind < 2; ++kind)
            {
                // All inliers come last, so that no smaller set has a higher inlier ratio. The
                // confidence is so low that it asks for hardly any samples.
                const double samples = kind ? publishedGrowth(n, 4)[n] : 1;
                // the least I with P(Binomial(n - 4, ratio) >= I - 4) < 5 % / samples
                int quantile = 5, accepted = 5;
                while (quantile <= n && tailBySum(quantile - 4, n - 4, ratio) * samples >= 0.05)
                    ++quantile;
                while (accepted <= n && chanceOf(accepted, n, 4, ratio) * samples >= 0.05)
                    ++accepted;
                EXPECT_EQ(quantile, accepted) << n << " " << ratio;
                for (int I = quantile - 1; kind && I <= std::min(quantile, n); ++I)
                {
                    std::vector<uchar> inliers(n, 0);
                    std::fill(inliers.end() - I, inliers.end(), 1);
                    int length;
                    prosacSamples(inliers.data(), 0, n, 4, 1, ratio, std::log(0.999), true, length);
                    EXPECT_EQ(I >= quantile && I > 4, length > 0) << n << " " << ratio << " " << I;
                }
            }
}

//! randomInlierRatio() is an estimate of the probability that a random match agrees with a wrong
//! model. The fraction found by counting must be at most 1.1 times the estimate and at least a
//! quarter of it.
TEST(Usac_TerminationProsac, randomInlierRatio)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        SceneOptions options;
        options.inliers = 10;
        options.outliers = 4000;
        const Scene scene = makeScene((ProblemType)problem, options);
        Params params;
        params.threshold = 8;
        const Ptr<Usac> usac = createUsac(scene, params);
        const double ratio = usac->points().problem->randomInlierRatio(usac->points());
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        RNG rng(3);
        double inliers = 0, models = 0;
        for (int i = 0; i < 200; ++i)
        {
            int sample[MAX_SAMPLE_SIZE];
            Model found[MAX_MODELS];
            Rng(problem, i)
                .distinct(usac->points().size, usac->components().minimalSolver->sampleSize(),
                          sample);
            const int count = usac->components().minimalSolver->solve(usac->points(), sample,
                                                                      found);
            for (int k = 0; k < count; ++k, ++models)
                inliers += context.rate(found[k]).inliers -
                           usac->components().minimalSolver->sampleSize();
        }
        const double measured = inliers / models / usac->points().size;
        EXPECT_LE(measured, ratio * 1.1) << "problem " << problem;
        EXPECT_GE(measured, ratio * 0.25) << "problem " << problem;
    }
    const std::vector<Point2d> equal(20, Point2d(1, 2));
    EXPECT_EQ(
        1, problemObject(HOMOGRAPHY).randomInlierRatio(OwnPoints(HOMOGRAPHY, equal, equal).view()));
}

//! Parameters with scores that sort the points: the scores of wrong matches are worse by
//! `separation` on average, so that true matches are more frequent among the best points.
Params sortedParams(const Scene& scene, SamplerType sampler, double separation = 0.4)
{
    RNG rng(scene.size());
    Params params;
    params.sampler = sampler;
    params.orderedEvery = 1;
    params.termination = TERMINATION_PROSAC;
    params.verification = VERIFICATION_NONE;
    params.maxIterations = 20000;
    for (int i = 0; i < scene.size(); ++i)
        params.scores.push_back((float)(rng.uniform(0., 1.) + (scene.truth[i] ? 0 : separation)));
    return params;
}

//! Number of samples that the criterion asks for with the true model and these parameters. It must
//! differ by at most 3 from that of Case::bruteForce. `kept` is the expected probability that a
//! sample is drawn in PROSAC's way and that the verifier keeps its model if the model is good.
int iterationsFor(const Scene& scene, const Params& params, double kept)
{
    const Ptr<Usac> usac = createUsac(scene, params);
    Arena arena;
    const Context context(usac->points(), usac->components(), params, arena);
    usac->components().start(context);
    const Termination& termination = *usac->components().terminations[0];
    State state;
    state.bestFirst(context);
    state.best = toInternal(usac->points(), scene.model);
    state.bestQuality = context.rate(state.best);
    Case c;
    for (int i = 0; i < scene.size(); ++i)
    {
        const int row = usac->points().inputIndex[state.order[i]];
        c.inliers.push_back(pixelError(scene, scene.model, scene.points1[row],
                                       scene.points2[row]) <= params.threshold);
    }
    EXPECT_EQ(state.bestQuality.inliers, (int)std::count(c.inliers.begin(), c.inliers.end(), 1));
    c.m = 4;
    c.kept = kept;
    c.exact = (params.termination & TERMINATION_EXACT) != 0;
    c.randomRatio = usac->points().problem->randomInlierRatio(usac->points());
    c.confidence = params.confidence;
    int length;
    const int iterations = termination.iterations(context, state);
    EXPECT_NEAR(c.bruteForce(length), iterations, 3);
    EXPECT_EQ((int)STOP_PROSAC, termination.reason());
    state.bestQuality.inliers = 4;
    EXPECT_EQ(INT_MAX, termination.iterations(context, state)) << "the sample itself is no support";
    state.bestQuality.inliers = 40;
    state.order = 0;
    EXPECT_EQ(INT_MAX, termination.iterations(context, state)) << "the points are not sorted";
    return iterations;
}

//! If the threshold changes during the search (Params::widestReach, THRESHOLD_ESTIMATED), the
//! support must be tested with the probability of a random inlier at the new threshold.
TEST(Usac_TerminationProsac, heedsAChangedThreshold)
{
    SceneOptions options;
    options.inliers = 30;
    options.outliers = 60;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    const Params params = sortedParams(scene, SAMPLER_PROSAC, 0.02);
    const Ptr<Usac> usac = createUsac(scene, params);
    Arena arena;
    Correspondences points = usac->points();
    const Context context(points, usac->components(), params, arena);
    usac->components().start(context);
    points.threshold *= 60;
    State state;
    state.bestFirst(context);
    state.best = toInternal(points, scene.model);
    state.bestQuality = context.rate(state.best);
    const Termination& termination = *usac->components().terminations[0];
    EXPECT_EQ(INT_MAX, termination.iterations(context, state)) << "chance explains the support";
}

//! Sampling without repetition, T(d,d) and the local samples of P-NAPSAC must each increase the
//! number of samples that the criterion asks for.
TEST(Usac_TerminationProsac, heedsTheOptions)
{
    SceneOptions options;
    options.inliers = 40;
    options.outliers = 60;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    Params params = sortedParams(scene, SAMPLER_PROSAC, 0.02);
    double sums[4] = {0};
    for (params.confidence = 0.5; params.confidence < 0.9999;
         params.confidence += 0.4 * (1 - params.confidence))
    {
        Params exact = params, tdd = params, local = params;
        exact.termination |= TERMINATION_EXACT;
        tdd.verification = VERIFICATION_TDD;
        tdd.tddPoints = 3;
        local.sampler = SAMPLER_P_NAPSAC;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const int inliers = context.rate(toInternal(usac->points(), scene.model)).inliers;
        sums[0] += iterationsFor(scene, params, 1);
        sums[1] += iterationsFor(scene, exact, 1);
        sums[2] += iterationsFor(scene, tdd, std::pow(inliers / 100., 3));
        sums[3] += iterationsFor(scene, local, 0.75);
    }
    for (int option = 1; option < 4; ++option)
        EXPECT_GT(sums[option], sums[0] * 1.02) << option;
}

//! All inliers are in the second half of the order, so that prosacSamples() must examine more than
//! half of the points. If the time limit is reached, it must stop earlier and return INT_MAX, which
//! means that the criterion is not fulfilled.
TEST(Usac_TerminationProsac, endsWithTheTime)
{
    const int size = 3000;
    std::vector<uchar> inliers(size, 0);
    std::fill(inliers.begin() + size / 2, inliers.end(), 1);
    const Correspondences points;
    const Components parts;
    const Params params;
    Arena arena;
    Watch over(1e-6, 0), longTime(1e9, 0);
    const Context late(points, parts, params, arena, &over),
        early(points, parts, params, arena, &longTime);
    int samples[3], lengths[3];
    const Context* const contexts[] = {0, &early, &late};
    for (int k = 0; k < 3; ++k)
        samples[k] = prosacSamples(inliers.data(), 0, size, 4, 1, 0.01, std::log(0.01), true,
                                   lengths[k], contexts[k]);
    EXPECT_LT(samples[0], INT_MAX);
    EXPECT_GT(lengths[0], size / 2);
    EXPECT_EQ(samples[0], samples[1]);
    EXPECT_EQ(lengths[0], lengths[1]);
    EXPECT_EQ(INT_MAX, samples[2]);
    EXPECT_EQ(0, lengths[2]);
}

}
}  // namespace
