// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// If wrong matches are consistent with each other, the true model must be found nevertheless,
// because its cost is the lowest. doc/structured.md has the failure rates for more scenes.

namespace opencv_test {
namespace {

//! Mean cost of the matches as with QUALITY_MSAC; 1 without a model.
double truncatedCost(const Scene& scene, const Mat& model, double threshold)
{
    if (model.empty())
        return 1;
    const Matx33d M = squareModel(model);
    double sum = 0;
    for (int i = 0; i < scene.size(); ++i)
    {
        const double error = pixelError(scene, M, scene.points1[i], scene.points2[i]) / threshold;
        sum += error * error < 1 ? error * error : 1;
    }
    return sum / scene.size();
}

struct Agreement
{
    const char* name;
    OutlierModel model;
    double right, structured;  //!< fractions of true matches, and of wrong matches that agree
};

const Agreement AGREEMENTS[] = {
    {"a common shift", OUTLIERS_SHIFT, 0.45, 0.35},
    {"a plane that moves by itself", OUTLIERS_PLANE, 0.4, 0.35},
    {"another motion in one part of the image", OUTLIERS_SECOND_MODEL, 0.53, 0.47}};

//! Number of runs whose model costs more than the true one by more than `matches` outliers. (A fit
//! to noisy points costs less than the true model.)
int missed(ProblemType problem, const Agreement& agreement, const Params& preset, int runs,
           double matches = 2)
{
    int result = 0;
    for (int seed = 1; seed <= runs; ++seed)
    {
        SceneOptions options;
        options.setSize(400, agreement.right);
        options.outlierModel = agreement.model;
        options.structured = cvRound(400 * agreement.structured);
        options.seed = seed;
        const Scene scene = makeScene(problem, options);
        Params params = preset;
        params.maxIterations = 1000000;
        params.seed = seed;
        const double truth = truncatedCost(scene, Mat(scene.model), params.threshold);
        result += truncatedCost(scene, estimate(scene, params), params.threshold) >
                  truth + matches / scene.size();
    }
    return result;
}

//! At most 3 of 40 runs are allowed to miss the true model. If Params::runnersUp were 0, so
//! that no samples would be drawn from the outliers of the best model either, F would be missed in
//! 18 to 40 % of the scenes.
TEST(Usac_Agreeing, matches_do_not_hide_the_right_model)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (ProblemType problem : problems)
        for (const Agreement& agreement : AGREEMENTS)
            EXPECT_LE(missed(problem, agreement, Params::usacV20(), 40), 3)
                << (int)problem << ": " << agreement.name;
}

//! MAGSAC++ rates models by errors up to 2.4 thresholds, or more if the noise seems to be larger.
//! Consistent wrong matches can then look like noise, or lower the cost of a model that few matches
//! fit well. A run counts as a miss only if the MSAC cost of its model exceeds that of the true
//! model by more than the cost of eight outliers (instead of two), because MAGSAC++ minimizes
//! another cost.
TEST(Usac_Agreeing, matches_do_not_look_like_noise)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (ProblemType problem : problems)
        for (const Agreement& agreement : AGREEMENTS)
            EXPECT_LE(missed(problem, agreement, Params::magsacPlusPlus(), 40, 8), 2)
                << (int)problem << ": " << agreement.name;
}

//! Samples drawn from the outliers of the best model must count as iterations like all other
//! samples, so that there are never more than Params::maxIterations.
TEST(Usac_Agreeing, matches_do_not_lead_beyond_the_limit)
{
    for (int limit = 1; limit < 600; limit += 37)
    {
        SceneOptions options;
        options.setSize(200, 0.45);
        options.outlierModel = OUTLIERS_SHIFT;
        options.structured = 70;
        options.seed = limit;
        Params params;
        params.maxIterations = limit;
        Report report;
        estimate(makeScene(FUNDAMENTAL, options), params, noArray(), &report);
        EXPECT_LE(report.iterations, limit);
    }
}

//! Random matches whose points are in clusters or near the center of the image must give no model
//! in at least 28 of 30 scenes, even with MAGSAC++, whose range of errors grows with the noise.
TEST(Usac_Agreeing, clusters_of_points_are_no_noise)
{
    const OutlierModel models[] = {OUTLIERS_CLUSTERS, OUTLIERS_CENTER};
    const Params presets[] = {Params::usacV20(), Params::magsacPlusPlus()};
    for (int problem : TWO_VIEW_PROBLEMS)
        for (OutlierModel model : models)
            for (const Params& preset : presets)
            {
                int accepted = 0;
                for (uint64 seed = 1; seed <= 30; ++seed)
                {
                    SceneOptions options;
                    options.inliers = 0;
                    options.outliers = 200;
                    options.outlierModel = model;
                    options.seed = seed;
                    Params params = preset;
                    params.maxIterations = 1000;
                    accepted += !estimate(makeScene((ProblemType)problem, options), params).empty();
                }
                EXPECT_LE(accepted, 2) << problem << ", " << (int)model;
            }
}

}  // namespace
}  // namespace opencv_test
