// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "kernel_points.hpp"

namespace opencv_test {
namespace {

typedef testing::TestWithParam<int> Usac_Scores_Kernels;

TEST_P(Usac_Scores_Kernels, againstDirectEvaluation)
{
    const Fixture f((Formula::Kind)GetParam());
    const std::vector<NamedKernels> all = availableKernels();
    int inliersSeen = 0;
    for (int end = 0; end <= COUNT; ++end)
    {
        const Model& model = f.models[end % f.models.size()];
        const int begin = end % 3 == 0 ? 0 : end % 3 == 1 ? end / 2 : std::max(0, end - 17);
        float m[MAX_MODEL_SIZE];
        toFloat(model, m, f.homogeneous());
        const Direct expected = directScore(f, model, begin, end);
        inliersSeen += expected.inliers;
        for (size_t k = 0; k < all.size(); ++k)
        {
            Quality msac(2, 3), inliers(5, 7);  // kernels add to these values
            all[k].kernels.residuals[f.kind].msac(f.points(), m, f.limit(), begin, end, msac);
            all[k].kernels.residuals[f.kind].inliers(f.points(), m, f.limit(), begin, end, inliers);
            EXPECT_NEAR(expected.msac, msac.cost - 2, 1e-3 + 1e-4 * (end - begin))
                << all[k].name << " " << end;
            EXPECT_NEAR(expected.inliers, msac.inliers - 3, expected.doubtful);
            EXPECT_NEAR(expected.inliers, inliers.inliers - 7, expected.doubtful);
            EXPECT_EQ(end - begin - (inliers.inliers - 7), inliers.cost - 5);
        }
    }
    EXPECT_GT(inliersSeen, 3000);
}

TEST_P(Usac_Scores_Kernels, sameBitsWithEveryInstructionSet)
{
    const Fixture f((Formula::Kind)GetParam(), 2);
    const std::vector<NamedKernels> all = availableKernels();
    for (int end = 1; end <= COUNT; ++end)
        for (int begin = 0; begin < end; begin = 2 * begin + 1 + end % 5)
        {
            float m[MAX_MODEL_SIZE];
            toFloat(f.models[(end + begin) % f.models.size()], m, f.homogeneous());
            for (int score = 0; score < 2; ++score)
            {
                std::vector<Quality> sums(all.size(), Quality(0, 0));
                for (size_t k = 0; k < all.size(); ++k)
                {
                    const ResidualKernels& loops = all[k].kernels.residuals[f.kind];
                    const FusedKernel kernel = score ? loops.msac : loops.inliers;
                    kernel(f.points(), m, f.limit(), begin, end, sums[k]);
                    ASSERT_EQ(0, memcmp(&sums[0].cost, &sums[k].cost, sizeof(double)))
                        << all[k].name << " " << end;
                    ASSERT_EQ(sums[0].inliers, sums[k].inliers);
                }
            }
            std::vector<float> first(COUNT, -1.f), errors(COUNT, -1.f);
            all[0].kernels.residuals[f.kind].errors(f.points(), m, begin, end, first.data());
            for (size_t k = 1; k < all.size(); ++k)
            {
                all[k].kernels.residuals[f.kind].errors(f.points(), m, begin, end, errors.data());
                ASSERT_EQ(0, memcmp(first.data(), errors.data(), COUNT * sizeof(float)))
                    << all[k].name << " " << end;
            }
        }
}

TEST_P(Usac_Scores_Kernels, errorsAgainstDirectEvaluation)
{
    const Fixture f((Formula::Kind)GetParam(), 3);
    const Ptr<Residual> residual = f.usac->components().residual;
    ASSERT_EQ(&kernels().residuals[f.kind], residual->kernels());
    const Correspondences& p = f.points();
    for (size_t k = 0; k < f.models.size(); ++k)
    {
        std::vector<float> errors(COUNT);
        std::vector<double> precise(COUNT);
        residual->squaredErrors(p, f.models[k], 0, COUNT, errors.data());
        residual->squaredErrors(f.models[k], p.exact, COUNT, precise.data());
        for (int i = 0; i < COUNT; ++i)
        {
            // leaves out points with large errors, such as those that H maps almost to infinity
            const double expected = directError(p, f.kind, f.models[k], i);
            if (expected > 25)
                continue;
            EXPECT_NEAR(std::sqrt(expected), std::sqrt(errors[i]),
                        1e-4 * (1 + std::sqrt(expected)));
            EXPECT_NEAR(std::sqrt(expected), std::sqrt(precise[i]),
                        1e-5 * (1 + std::sqrt(expected)));
        }
    }
}

//! Score::accumulate(), for residuals without a kernel, must agree with the kernels.
TEST_P(Usac_Scores_Kernels, accumulateAgainstKernels)
{
    const Fixture f((Formula::Kind)GetParam(), 4);
    const Ptr<Residual> residual = f.usac->components().residual;
    const Ptr<Score> scores[] = {createMsacScore(), createInlierScore()};
    std::vector<float> errors(COUNT);
    for (int s = 0; s < 2; ++s)
        for (size_t k = 0; k < f.models.size(); ++k)
        {
            const FusedKernel kernel = scores[s]->fused(*residual);
            ASSERT_TRUE(kernel != 0);
            float m[MAX_MODEL_SIZE];
            toFloat(f.models[k], m, f.homogeneous());
            Quality fused(0, 0), plain(0, 0);
            kernel(f.points(), m, f.limit(), 0, COUNT, fused);
            residual->squaredErrors(f.points(), f.models[k], 0, COUNT, errors.data());
            scores[s]->accumulate(errors.data(), COUNT, f.limit(), plain);
            EXPECT_EQ(fused.inliers, plain.inliers);
            EXPECT_NEAR(fused.cost, plain.cost, s == 0 ? 1e-3 : 0);
        }
}

//! The kernels for fits must return the same bits with every instruction set. The leverages must
//! agree with the derivatives of the single points.
TEST_P(Usac_Scores_Kernels, kernelsOfFits)
{
    const Fixture f((Formula::Kind)GetParam(), 5);
    const Residual& residual = *f.usac->components().residual;
    const std::vector<NamedKernels> all = availableKernels();
    const int numbers = f.models[0].size(), count = 2 * SUMS_CHUNK + 5;
    RNG rng(5);
    std::vector<int> indices(count);
    std::vector<double> weights(count), L(numbers * numbers, NAN);  // NaN: must not be read
    for (int i = 0; i < count; ++i)
    {
        indices[i] = rng.uniform(0, COUNT);
        weights[i] = rng.uniform(0., 2.);
    }
    for (int row = 0; row < numbers; ++row)
        for (int col = 0; col <= row; ++col)
            L[row * numbers + col] = rng.gaussian(1);
    const PointChunks chunks(f.points(), indices.data(), count, weights.data());
    for (size_t k = 0; k < f.models.size(); ++k)
    {
        const Model& model = f.models[k];
        std::vector<double> expected(count, -1.);
        chunks.leverages(all[0].kernels.residuals[f.kind].leverages, model.val, L.data(),
                         expected.data());
        double datum[MAX_COLUMNS], weight, error[Residual::MAX_COMPONENTS],
            derivative[MAX_DERIVATIVE];
        for (int i = 0; chunks.get(i, datum, weight); ++i)
        {
            const int components = residual.linearize(model, datum, error, derivative);
            double sum = 0;
            for (int c = 0; c < components; ++c)
                for (int row = 0; row < numbers; ++row)
                {
                    double entry = 0;
                    for (int col = 0; col <= row; ++col)
                        entry += L[row * numbers + col] * derivative[c * numbers + col];
                    sum += weight * entry * entry;
                }
            EXPECT_NEAR(sum, expected[i], 1e-9 * sum) << k << " " << i;
        }
        double sums[MAX_SUMS], first[MAX_SUMS];
        for (size_t s = 0; s < all.size(); ++s)
        {
            const ResidualKernels& loops = all[s].kernels.residuals[f.kind];
            std::vector<double> leverages(count, -1.);
            chunks.leverages(loops.leverages, model.val, L.data(), leverages.data());
            EXPECT_EQ(0, memcmp(expected.data(), leverages.data(), count * sizeof(double)))
                << all[s].name;
            chunks.sum(loops.sums, loops.count, model.val, s == 0 ? first : sums);
            if (s > 0)
            {
                EXPECT_EQ(0, memcmp(first, sums, loops.count * sizeof(double))) << all[s].name;
            }
        }
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Scores_Kernels, testing::Range(0, (int)Errors::COUNT));

//! Points with infinite or undefined (NaN) errors must be outliers.
TEST(Usac_Scores, undefinedErrorsAreOutliers)
{
    const std::vector<Point2d> points1(40, Point2d(1, 0)), points2(40, Point2d(0, 0));
    const OwnPoints own(HOMOGRAPHY, points1, points2);
    const Model infinite = Matx33d(1, 0, 0, 0, 1, 0, 1, 0, -1),
                undefined = Matx33d(0, 0, 0, 0, 0, 0, 1, 0, -1), zero = Matx33d::zeros();
    const Model* models[] = {&infinite, &undefined, &zero};
    const std::vector<NamedKernels> all = availableKernels();
    for (int k = 0; k < 3; ++k)
        for (size_t a = 0; a < all.size(); ++a)
            for (int kind = Formula::TRANSFER;
                 kind <= (k == 2 ? Formula::SAMPSON : Formula::TRANSFER);
                 kind += Formula::SAMPSON)  // Sampson's distance is undefined for the zero matrix
            {
                float m[MAX_MODEL_SIZE];
                toFloat(*models[k], m);
                Quality msac(0, 0), inliers(0, 0);
                all[a].kernels.residuals[kind].msac(own.view(), m, 1, 0, 40, msac);
                all[a].kernels.residuals[kind].inliers(own.view(), m, 1, 0, 40, inliers);
                EXPECT_EQ(40, msac.cost) << all[a].name << " model " << k;
                EXPECT_EQ(0, msac.inliers);
                EXPECT_EQ(40, inliers.cost);
                EXPECT_EQ(0, inliers.inliers);
            }
    float errors[] = {std::numeric_limits<float>::quiet_NaN(),
                      std::numeric_limits<float>::infinity(), 0.25f};
    Quality msac(0, 0), inliers(0, 0);
    createMsacScore()->accumulate(errors, 3, 1, msac);
    createInlierScore()->accumulate(errors, 3, 1, inliers);
    EXPECT_EQ(2.25, msac.cost);
    EXPECT_EQ(1, msac.inliers);
    EXPECT_EQ(2, inliers.cost);
    EXPECT_EQ(1, inliers.inliers);
}

//! An error equal to the threshold must count as an inlier, with the MSAC cost of an outlier.
TEST(Usac_Scores, threshold)
{
    float errors[] = {4.f, std::nextafter(4.f, 5.f), 1.f};
    Quality msac(0, 0), inliers(0, 0);
    createMsacScore()->accumulate(errors, 3, 4, msac);
    createInlierScore()->accumulate(errors, 3, 4, inliers);
    EXPECT_EQ(2, msac.inliers);
    EXPECT_EQ(2.25, msac.cost);
    EXPECT_EQ(2, inliers.inliers);
    EXPECT_EQ(1, inliers.cost);
}

typedef testing::TestWithParam<int> Usac_Scores_Problem;

TEST_P(Usac_Scores_Problem, earlyExitNeverChangesTheWinner)
{
    SceneOptions options;
    options.inliers = 900;
    options.outliers = 1100;
    const Scene scene = makeScene((ProblemType)GetParam(), options);
    for (int quality = 0; quality < 2; ++quality)
    {
        Params params;
        params.quality = (QualityType)quality;
        const Ptr<Usac> usac = createUsac(scene, params);
        Arena arena;
        const Context context(usac->points(), usac->components(), params, arena);
        usac->components().start(context);
        const int m = usac->components().minimalSolver->sampleSize();
        Quality best, bestBounded;
        int winner = -1, winnerBounded = -1, count = 0, cut = 0, won = 0;
        for (int i = 0; i < 3000; ++i)
        {
            int sample[MAX_SAMPLE_SIZE];
            Model models[MAX_MODELS];
            Rng(9, i).distinct(usac->points().size, m, sample);
            const int found = usac->components().minimalSolver->solve(usac->points(), sample,
                                                                      models);
            for (int k = 0; k < found; ++k, ++count)
            {
                const Quality whole = context.rate(models[k]);
                const Quality bounded = context.rate(models[k], bestBounded.cost);
                ASSERT_EQ(whole.betterThan(best), bounded.betterThan(bestBounded));
                ASSERT_LE(bounded.cost, whole.cost);
                cut += bounded.cost < whole.cost;
                if (bounded.betterThan(bestBounded))
                {
                    bestBounded = bounded;
                    winnerBounded = count;
                }
                if (whole.betterThan(best))
                {
                    ASSERT_EQ(whole.cost, bounded.cost);
                    ASSERT_EQ(whole.inliers, bounded.inliers);
                    best = whole;
                    winner = count;
                    ++won;
                }
            }
        }
        EXPECT_EQ(winner, winnerBounded);
        EXPECT_GT(won, m == 1 ? 1 : 2);
        EXPECT_GT(cut, count / 2);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Scores_Problem, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}
}  // namespace
