// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

//! A context with `count` points, for criteria that use only their number.
struct Counts
{
    Counts(ProblemType problem, int count, const Params& params_ = Params())
        : params(params_), scene(makeScene(problem, optionsOf(count))),
          usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena),
          m(usac->components().minimalSolver->sampleSize()), n(count)
    {}

    static SceneOptions optionsOf(int count)
    {
        SceneOptions options;
        options.inliers = count;
        options.outliers = 0;
        return options;
    }

    int iterations(const Ptr<Termination>& termination, int inliers)
    {
        state.bestQuality = Quality(n - inliers, inliers);
        return termination->iterations(context, state);
    }

    //! Probability that a sample is all-inlier: the fraction of the subsets of m points that
    //! contain only inliers.
    double good(double inliers) const
    {
        long double p = 1;
        for (int i = 0; i < m; ++i)
            p *= std::max<long double>(inliers - i, 0) / (n - i);
        return (double)p;
    }

    //! Smallest number of samples that all fail with a probability of at most 1 - confidence.
    int needed(double p) const
    {
        if (p <= 0)
            return INT_MAX;
        const double k = std::ceil(std::log(1 - params.confidence) /
                                   std::log1p(-std::min(p, 1 - 1e-16)));
        return k >= INT_MAX ? INT_MAX : std::max(1, (int)k);
    }

    const Params params;
    const Scene scene;
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;
    const int m, n;
    State state;
};

TEST(Usac_Termination, standard)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (double confidence = 0.5; confidence < 1; confidence += 0.0999)
        {
            Params params;
            params.confidence = confidence;
            Counts counts((ProblemType)problem, 60, params);
            int previous = INT_MAX;
            for (int inliers = 0; inliers <= 60; ++inliers)
            {
                const int k = counts.iterations(createStandardTermination(), inliers);
                EXPECT_EQ(counts.needed(counts.good(inliers)), k) << inliers << " inliers";
                EXPECT_LE(k, previous);
                previous = k;
            }
            EXPECT_EQ(1, previous);
        }
    EXPECT_EQ((int)STOP_STANDARD, createStandardTermination()->reason());
}

TEST(Usac_Termination, pNapsac)
{
    const double relaxations[] = {0, 0.1, 0.5, 1};
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int r = 0; r < 4; ++r)
        {
            Params params;
            params.relaxation = relaxations[r];
            Counts counts((ProblemType)problem, 60, params);
            for (int inliers = 0; inliers <= 60; ++inliers)
            {
                const int k = counts.iterations(createPNapsacTermination(), inliers);
                const double beside = inliers - counts.m;
                const double significant = std::min(
                    counts.m + beside * (1 + relaxations[r] * beside / (beside + 30)), 60.);
                EXPECT_EQ(inliers <= counts.m ? INT_MAX : counts.needed(counts.good(significant)),
                          k)
                    << inliers;
            }
        }
    EXPECT_EQ((int)STOP_P_NAPSAC, createPNapsacTermination()->reason());
}

//! The relaxation of P-NAPSAC's criterion (Params::relaxation) must not reduce the number of
//! samples if the best model could be that of a plane (`successProbability` below 1). It must
//! reduce the number less if many samples contain the same match twice.
TEST(Usac_Termination, pNapsacRelaxesWhatIsCertain)
{
    Params params;
    params.relaxation = 0.5;
    Counts counts(ESSENTIAL, 100, params);
    const Ptr<Termination> standard = createStandardTermination(),
                           relaxed = createPNapsacTermination();
    EXPECT_LT(counts.iterations(relaxed, 40), counts.iterations(standard, 40) / 2);
    counts.state.successProbability = 0.5;
    EXPECT_EQ(counts.iterations(standard, 40), counts.iterations(relaxed, 40));
    counts.state.successProbability = 1;
    counts.state.countedSamples = 1000;
    const double once = (double)counts.iterations(relaxed, 40) / counts.iterations(standard, 40);
    counts.state.repeatedSamples = 500;
    const double copies = (double)counts.iterations(relaxed, 40) / counts.iterations(standard, 40);
    EXPECT_GT(copies, 1.2 * once);
}

SequentialTest makeTest(double epsilon, double delta, double A, int samples)
{
    SequentialTest test;
    test.epsilon = epsilon;
    test.delta = delta;
    test.A = A;
    test.samples = samples;
    return test;
}

TEST(Usac_Termination, sprtWithOneTest)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        Counts counts((ProblemType)problem, 60);
        EXPECT_EQ(INT_MAX, counts.iterations(createSprtTermination(), 30))
            << "nothing has been tested";
        counts.state.tests.push(counts.arena, makeTest(0.5, 0.1, 20, 0));
        for (int inliers = 0; inliers <= 60; ++inliers)
            EXPECT_EQ(counts.needed(counts.good(inliers) * (1 - 1 / 20.)),
                      counts.iterations(createSprtTermination(), inliers))
                << inliers;
    }
    EXPECT_EQ((int)STOP_SPRT, createSprtTermination()->reason());
}

//! The solution h, found by a fine scan, of
//! epsilon (delta_l / epsilon_l)^h + (1 - epsilon) ((1 - delta_l) / (1 - epsilon_l))^h = 1.
//! `test` has been designed for epsilon_l and delta_l.
double exponentByScan(const SequentialTest& test, double epsilon)
{
    const double a = test.delta / test.epsilon, b = (1 - test.delta) / (1 - test.epsilon);
    double h = 1e-4;
    while (epsilon * std::pow(a, h) + (1 - epsilon) * std::pow(b, h) < 1)
        h += 1e-4;
    return h;
}

TEST(Usac_Termination, sprtWithEarlierTests)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int inliers = 20; inliers <= 50; inliers += 5)
        {
            Counts counts((ProblemType)problem, 60);
            const double epsilon = inliers / 60., good = counts.good(inliers);
            const SequentialTest first = makeTest(0.25, 0.05, 3, 1),
                                 second = makeTest(0.3, 0.1, 8, 2),
                                 last = makeTest(epsilon, 0.1, 30, 5);
            counts.state.tests.push(counts.arena, first);
            counts.state.tests.push(counts.arena, second);
            counts.state.tests.push(counts.arena, last);
            const double kept1 = good * (1 - std::pow(first.A, -exponentByScan(first, epsilon)));
            const double kept2 = good * (1 - std::pow(second.A, -exponentByScan(second, epsilon)));
            const double failure = std::log(1 - counts.params.confidence) - std::log1p(-kept1) -
                                   2 * std::log1p(-kept2);
            const double more = std::ceil(failure / std::log1p(-good * (1 - 1 / last.A)));
            EXPECT_NEAR(3 + std::max(more, 0.), counts.iterations(createSprtTermination(), inliers),
                        more > 1000 ? 1 : 0)
                << inliers;
        }
}

//! Samples drawn with an earlier test that would reject the best model must not count.
TEST(Usac_Termination, sprtOfAWrongTest)
{
    Counts counts(HOMOGRAPHY, 60);
    counts.state.tests.push(counts.arena, makeTest(0.9, 0.8, 20, 1000));
    counts.state.tests.push(counts.arena, makeTest(0.2, 0.1, 20, 5));
    EXPECT_EQ(1000 + counts.needed(counts.good(12) * (1 - 1 / 20.)),
              counts.iterations(createSprtTermination(), 12));
}

//! If all points are inliers, the earlier test keeps the correct model for certain, so that no more
//! samples are needed.
TEST(Usac_Termination, sprtOfInliersOnly)
{
    Counts counts(HOMOGRAPHY, 60);
    counts.state.tests.push(counts.arena, makeTest(0.5, 0.1, 20, 12));
    counts.state.tests.push(counts.arena, makeTest(0.6, 0.1, 20, 5));
    EXPECT_GE(12, counts.iterations(createSprtTermination(), 60));
    EXPECT_LT(12, counts.iterations(createSprtTermination(), 40));
}

}
}  // namespace
