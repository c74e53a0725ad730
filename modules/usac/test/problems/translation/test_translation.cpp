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

}  // namespace
}  // namespace opencv_test
