// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/own_points.hpp"
#include "support/contracts.hpp"
#include "problems/registry.hpp"

// Tests of translations between two images, in addition to the tests of all problems.

namespace opencv_test {
namespace {

const Point2d TRUTH(37.25, -12.5);

//! Matches of a translation with noise in image 2, followed by random wrong matches.
struct Matches
{
    Matches(int right_, int wrong, double noise, uint64 seed, const Point2d& truth_ = TRUTH)
        : right(right_), truth(truth_)
    {
        RNG rng(seed);
        for (int i = 0; i < right + wrong; ++i)
        {
            const Point2d p = uniformPoint(rng, 0., 640., 0., 480.);
            points1.push_back(p);
            points2.push_back(i < right ? p + truth + gaussianPoint(rng, noise)
                                        : uniformPoint(rng, 0., 640., 0., 480.));
        }
    }

    Mat estimate(const Params& params) const
    {
        Mat mask;
        Report report;
        const Mat model = estimateTranslation2D(points1, points2, params, mask, report);
        checkResult(TRANSLATION_2D, points1, points2, params.threshold, model, mask, report);
        return model;
    }

    //! Distance from the true translation in pixels; infinite without a model.
    double error(const Mat& model) const
    {
        return model.empty()
                   ? std::numeric_limits<double>::infinity()
                   : std::hypot(model.at<double>(0, 2) - truth.x, model.at<double>(1, 2) - truth.y);
    }

    //! Error of the mean displacement of the true matches in pixels.
    double errorOfMean() const
    {
        Point2d sum;
        for (int i = 0; i < right; ++i)
            sum += points2[i] - points1[i];
        return cv::norm(sum * (1. / right) - truth);
    }

    const int right;
    const Point2d truth;
    std::vector<Point2d> points1, points2;
};

//! The problem and its solver for fits, without a search.
struct Parts
{
    Parts()
        : problem(createProblem(TRANSLATION_2D, noArray(), noArray(), noArray(), noArray())),
          fit(problem->createNonMinimalSolver(problem->createResidual(RESIDUAL_STANDARD)))
    {}

    Ptr<Problem> problem;
    Ptr<NonMinimalSolver> fit;
};

TEST(Usac_Translation, minimalSolver)
{
    const Matches matches(20, 0, 0, 1);
    const OwnPoints own(TRANSLATION_2D, matches.points1, matches.points2);
    const Ptr<MinimalSolver> solver = Parts().problem->createMinimalSolver();
    ASSERT_EQ(1, solver->sampleSize());
    for (int i = 0; i < 20; ++i)
    {
        Model models[MAX_MODELS];
        ASSERT_EQ(1, solver->solve(own.view(), &i, models));
        const Matx33d expected(1, 0, TRUTH.x, 0, 1, TRUTH.y, 0, 0, 1);
        for (int k = 0; k < 9; ++k)
            EXPECT_NEAR(expected.val[k], models[0].val[k], 1e-12);
    }
}

//! A fit must be the weighted mean of the displacements up to rounding, even if the displacements
//! are large. Without points or with weights of 0 it must fail.
TEST(Usac_Translation, leastSquares)
{
    const Parts parts;
    for (double far : {0., 1e6})
    {
        Matches matches(50, 0, 1, 2, TRUTH + Point2d(far, far));
        std::vector<double> weights;
        std::vector<int> all;
        RNG rng(3);
        long double sum = 0, x = 0, y = 0;
        for (int i = 0; i < 50; ++i)
        {
            weights.push_back(rng.uniform(0.1, 1.));
            all.push_back(i);
            sum += weights[i];
            x += weights[i] * ((long double)matches.points2[i].x - matches.points1[i].x);
            y += weights[i] * ((long double)matches.points2[i].y - matches.points1[i].y);
        }
        const OwnPoints own(TRANSLATION_2D, matches.points1, matches.points2);
        Model model = Matx33d::eye();
        ASSERT_TRUE(parts.fit->fit(own.view(), all.data(), 50, weights.data(), model));
        EXPECT_NEAR((double)(x / sum), model.val[2], 1e-12 + 1e-15 * far);
        EXPECT_NEAR((double)(y / sum), model.val[5], 1e-12 + 1e-15 * far);
        std::vector<double> none(50, 0.);
        EXPECT_FALSE(parts.fit->fit(own.view(), all.data(), 50, none.data(), model));
        EXPECT_FALSE(parts.fit->fit(own.view(), all.data(), 0, 0, model));
    }
}

//! One exact match must suffice to find the translation.
TEST(Usac_Translation, fewExactPoints)
{
    for (int count = 0; count <= 5; ++count)
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            const Matches matches(count, 0, 0, seed);
            Mat mask;
            Report report;
            const Mat model = estimateTranslation2D(matches.points1, matches.points2, Params(),
                                                    mask, report);
            ASSERT_EQ(count < 1, model.empty()) << count << " points, seed " << seed;
            EXPECT_EQ(count < 1, report.stop == STOP_TOO_FEW_POINTS);
            if (count >= 1)
            {
                EXPECT_EQ(count, countNonZero(mask));
                EXPECT_LE(matches.error(model), 1e-10);
            }
        }
}

//! The mean error must be nearly that of the mean displacement of the true matches, which is the
//! best possible estimate.
TEST(Usac_Translation, inlierRatios)
{
    for (int percent : {5, 10, 20, 30, 50, 70, 90})
    {
        double ours = 0, best = 0;
        for (uint64 seed = 1; seed <= 20; ++seed)
        {
            const int right = 400 * percent / 100;
            const Matches matches(right, 400 - right, 0.5, seed);
            Params params;
            params.threshold = 2;
            ours += matches.error(matches.estimate(params));
            best += matches.errorOfMean();
        }
        EXPECT_LE(ours, 1.3 * best + 0.01) << percent << " % are right";
    }
}

TEST(Usac_Translation, everyPreset)
{
    for (const NamedPreset& preset : allPresets(TRANSLATION_2D))
        for (ResidualType residual : {RESIDUAL_STANDARD, RESIDUAL_SYMMETRIC})
            for (uint64 seed = 1; seed <= 3; ++seed)
            {
                const Matches matches(200, 150, 0.5, seed);
                Params params = preset.params;
                params.residual = residual;
                params.threshold = 1.5;
                Report report;
                const Mat model = estimateTranslation2D(matches.points1, matches.points2, params,
                                                        noArray(), report);
                // the true matches come first: where all samples follow this order (orderedEvery is
                // 1), PROSAC's criterion can end the search early, and a larger error is allowed
                EXPECT_LE(matches.error(model), params.orderedEvery == 1 ? 0.6 : 0.3)
                    << preset.name << ", " << (int)residual;
                EXPECT_LE(report.chance, 1e-6);
            }
}

//! With two motions, 6 pixels apart, the result must be the motion with more matches and not a
//! motion between the two.
TEST(Usac_Translation, twoMotions)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        Matches matches(80, 40, 0.5, seed);
        const Matches other(60, 0, 0.5, seed + 100, TRUTH + Point2d(6, 0));
        matches.points1.insert(matches.points1.end(), other.points1.begin(), other.points1.end());
        matches.points2.insert(matches.points2.end(), other.points2.begin(), other.points2.end());
        EXPECT_LE(matches.error(matches.estimate(Params())), 0.3) << seed;
    }
}

//! An initial model that is not a translation must be replaced by the translation that maps the
//! center of the points in the same way.
TEST(Usac_Translation, initialModelWithARotation)
{
    const Matches matches(40, 1000, 0.5, 5);
    const Point2d center(320, 240);
    const double c = std::cos(0.2), s = std::sin(0.2);
    const Point2d to = center + TRUTH;
    Params params;
    params.maxIterations = 1;
    params.setInitialModel(Mat_<double>({2, 3}, {c, -s, to.x - c * center.x + s * center.y, s, c,
                                                 to.y - s * center.x - c * center.y}));
    EXPECT_LE(matches.error(matches.estimate(params)), 0.5);
}

//! An outlier that occurs 101 times must count as one match.
TEST(Usac_Translation, repeatedMatches)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        Matches matches(60, 40, 0.5, seed);
        for (int i = 0; i < 100; ++i)
        {
            matches.points1.push_back(matches.points1[70]);
            matches.points2.push_back(matches.points2[70]);
        }
        EXPECT_LE(matches.error(matches.estimate(Params())), 0.4) << seed;
    }
}

//! The model must have the form that cv::warpAffine accepts. (cv::estimateTranslation2D of OpenCV 5
//! returns only the last column of this matrix.)
TEST(Usac_Translation, form)
{
    const Matches matches(50, 20, 0.2, 7);
    const Mat model = matches.estimate(Params());
    ASSERT_EQ(Size(3, 2), model.size());
    EXPECT_EQ(0, cvtest::norm(Mat(Matx22d::eye()), model.colRange(0, 2), NORM_INF));
    std::vector<Point2d> moved;
    cv::transform(matches.points1, moved, model);
    EXPECT_LE(cv::norm(moved[0] - matches.points2[0]), 1.5);
    EXPECT_EQ(CV_64F, model.type());
}

}  // namespace
}  // namespace opencv_test
