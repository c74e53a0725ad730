// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Two models of nearly the same cost: what the scores of the matches decide.

namespace opencv_test {
namespace {

//! In how many of `runs` scenes the model is that of the 200 right matches, and not that of
//! `second` matches of another motion.
int rightOnes(ProblemType problem, int second, double information, ScoreModel scores, bool given,
              int runs)
{
    int right = 0;
    for (int seed = 1; seed <= runs; ++seed)
    {
        SceneOptions options;
        options.inliers = 200;
        options.outliers = second + 100;
        options.second = second;
        options.scoreInformation = information;
        options.scoreModel = scores;
        options.seed = seed;
        const Scene scene = makeScene(problem, options);
        Params params;
        params.threshold = 1.5;
        params.maxIterations = 20000;
        params.seed = seed;
        if (given)
            params.scores = scene.scores;
        right += modelError(scene, estimate(scene, params)) < 1.5;
    }
    return right;
}

//! The second motion has 3 % more matches, and random scores.
TEST(Usac_Alternatives, good_scores_decide_between_models_of_nearly_the_same_cost)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL})
    {
        enum { RUNS = 20 };
        EXPECT_LE(rightOnes(problem, 206, 0.9, SCORES_OF_TRUTH, false, RUNS), RUNS / 2)
            << (int)problem;
        EXPECT_GE(rightOnes(problem, 206, 0.9, SCORES_OF_TRUTH, true, RUNS), RUNS - 1)
            << (int)problem;
    }
}

//! The matches of a second motion with a tenth less have the best scores.
TEST(Usac_Alternatives, scores_that_lie_do_not_make_a_clearly_worse_model)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL})
        EXPECT_GE(rightOnes(problem, 180, 0.9, SCORES_OF_SECOND, true, 20), 19) << (int)problem;
}

}  // namespace
}  // namespace opencv_test
