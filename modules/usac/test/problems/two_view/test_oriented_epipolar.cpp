// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "support/own_points.hpp"
#include "support/problem_objects.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Orientation, trueModelsAreKept)
{
    for (int problem = 0; problem < 3; ++problem)
    {
        SceneOptions options;
        options.noise = 0;
        options.outliers = 0;
        const Scene scene = makeScene((ProblemType)problem, options);
        const Params params;
        const Ptr<Usac> usac = createUsac(scene, params);
        const RunContext context(usac->points(), usac->components(), params);
        const Model truth = toInternal(usac->points(), scene.model);
        const Ptr<Degeneracy> check = problem == 0 ? createHomographyOrientation()
                                                   : createOrientedEpipolar();
        for (int i = 0; i < 500; ++i)
        {
            int sample[MAX_SAMPLE_SIZE];
            Rng(1, i).distinct(scene.size(), usac->components().minimalSolver->sampleSize(),
                               sample);
            EXPECT_TRUE(check->validSample(context, sample));
            EXPECT_TRUE(check->validModel(context, sample, truth));
            EXPECT_TRUE(check->validModel(context, sample, Matx33d(truth) * -3.))
                << "the sign of a model must not matter";
        }
    }
}

//! Most models of samples with outliers violate the oriented epipolar constraint and must be
//! rejected.
TEST(Usac_Orientation, wrongModelsAreRefused)
{
    for (int problem = 1; problem < 3; ++problem)
    {
        SceneOptions options;
        options.inliers = 10;
        options.outliers = 400;
        const Scene scene = makeScene((ProblemType)problem, options);
        const Params params;
        const Ptr<Usac> usac = createUsac(scene, params);
        const RunContext context(usac->points(), usac->components(), params);
        const Ptr<Degeneracy> check = createOrientedEpipolar();
        int total = 0, refused = 0;
        for (int i = 0; i < 500; ++i)
        {
            int sample[MAX_SAMPLE_SIZE];
            Model models[MAX_MODELS];
            Rng(2, i).distinct(scene.size(), usac->components().minimalSolver->sampleSize(),
                               sample);
            const int count = usac->components().minimalSolver->solve(usac->points(), sample,
                                                                      models);
            for (int k = 0; k < count; ++k, ++total)
                refused += !check->validModel(context, sample, models[k]);
        }
        EXPECT_GT(refused, total / 2);
        EXPECT_LT(refused, total);
    }
}

TEST(Usac_Orientation, homographySamples)
{
    std::vector<Point2d> square, mirrored, crossed;
    const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (int i = 0; i < 4; ++i)
    {
        square.push_back(Point2d(corners[i][0], corners[i][1]));
        mirrored.push_back(Point2d(-corners[i][0], corners[i][1]));
        crossed.push_back(square[i]);
    }
    std::swap(crossed[0], crossed[1]);
    const Ptr<Degeneracy> check = createHomographyOrientation();
    const Params params;
    const Components none;
    const int sample[] = {0, 1, 2, 3};
    const OwnPoints same(HOMOGRAPHY, square, square), mirror(HOMOGRAPHY, square, mirrored),
        cross(HOMOGRAPHY, square, crossed);
    EXPECT_TRUE(check->validSample(RunContext(same.view(), none, params), sample));
    EXPECT_TRUE(check->validSample(RunContext(mirror.view(), none, params), sample))
        << "a reflection is a homography";
    EXPECT_FALSE(check->validSample(RunContext(cross.view(), none, params), sample));
    const RunContext context(same.view(), none, params);
    EXPECT_TRUE(check->validModel(context, sample, Matx33d::eye()));
    EXPECT_FALSE(check->validModel(context, sample, Matx33d(1, 0, 0, 1, 0, 0, 0, 0, 1)));
    EXPECT_FALSE(check->validModel(context, sample, Matx33d::zeros()));
    EXPECT_FALSE(check->validModel(context, sample, Matx33d(1, 2, 3, 4, 5, 6, 7, 8, 9)));
}

}  // namespace
}  // namespace opencv_test
