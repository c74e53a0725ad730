// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

#include <map>

// Synthetic scenes must have the properties that their options ask for, because other tests and the
// benchmark rely on these properties.

namespace opencv_test {
namespace {

const ProblemType PROBLEMS[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
const OutlierModel OUTLIER_MODELS[] = {OUTLIERS_UNIFORM, OUTLIERS_LOCAL, OUTLIERS_MANY_TO_ONE};

bool samePoints(const Scene& a, const Scene& b)
{
    return a.points1 == b.points1 && a.points2 == b.points2 && a.clean1 == b.clean1 &&
           a.clean2 == b.clean2;
}

//! Of all pairs of a true and a wrong match, the fraction in which the true match has the better
//! score.
double rankedRight(const Scene& scene)
{
    double right = 0, pairs = 0;
    for (int i = 0; i < scene.size(); ++i)
        for (int j = 0; j < scene.size(); ++j)
            if (scene.truth[i] && !scene.truth[j])
            {
                right += scene.scores[i] < scene.scores[j];
                ++pairs;
            }
    return right / pairs;
}

//! For each point of image 2 that belongs to wrong matches, the number of these matches.
std::map<std::pair<double, double>, int> targetsOfOutliers(const Scene& scene)
{
    std::map<std::pair<double, double>, int> result;
    for (int i = 0; i < scene.size(); ++i)
        if (!scene.truth[i])
            ++result[std::make_pair(scene.points2[i].x, scene.points2[i].y)];
    return result;
}

TEST(Usac_Scenes, modelIsExactForPointsWithoutNoise)
{
    for (ProblemType problem : PROBLEMS)
        for (OutlierModel outliers : OUTLIER_MODELS)
            for (int seed = 1; seed <= 5; ++seed)
            {
                SceneOptions options;
                options.outlierModel = outliers;
                options.planeFraction = 0.25 * (seed % 4);
                options.seed = seed;
                options.noise = 1;
                const Scene scene = makeScene(problem, options);
                EXPECT_LT(modelError(scene, Mat(scene.model)), 1e-9)
                    << "problem " << (int)problem << ", seed " << seed;
                EXPECT_EQ(problem == HOMOGRAPHY ? options.inliers
                                                : cvRound(options.inliers * options.planeFraction),
                          (int)std::count(scene.onPlane.begin(), scene.onPlane.end(), (uchar)1));
                double sum = 0;
                for (int i = 0; i < scene.size(); ++i)
                {
                    const Point2d d = scene.points2[i] - scene.clean2[i];
                    sum += d.dot(d);
                    EXPECT_TRUE(scene.truth[i] || d.dot(d) == 0);
                }
                EXPECT_NEAR(options.noise, std::sqrt(sum / 2 / options.inliers),
                            0.18);  // five standard deviations
            }
}

TEST(Usac_Scenes, scoresAreAsInformativeAsAskedFor)
{
    const double informations[] = {0.3, 0.5, 0.7, 0.9, 1};
    SceneOptions options;
    options.setSize(3000, 0.4);
    const Scene plain = makeScene(HOMOGRAPHY, options);
    for (double information : informations)
    {
        options.scoreInformation = information;
        const Scene scene = makeScene(HOMOGRAPHY, options);
        // about four standard deviations for an information of 0.5
        EXPECT_NEAR(information, rankedRight(scene), 0.04);
        EXPECT_GE(*std::min_element(scene.scores.begin(), scene.scores.end()), 0.f);
        EXPECT_LE(*std::max_element(scene.scores.begin(), scene.scores.end()), 1.f);
        EXPECT_TRUE(samePoints(plain, scene)) << "the points depend on the scores";
    }
    for (double wrong : {-0.1, 0., 1.1})
    {
        options.scoreInformation = wrong;
        EXPECT_THROW(makeScene(HOMOGRAPHY, options), cv::Exception);
    }
}

TEST(Usac_Scenes, localOutliersAreCloseAndWrong)
{
    for (ProblemType problem : PROBLEMS)
    {
        SceneOptions options;
        options.outlierModel = OUTLIERS_LOCAL;
        const Scene scene = makeScene(problem, options);
        for (int i = 0; i < scene.size(); ++i)
        {
            if (scene.truth[i])
                continue;
            const double error = pixelError(scene, scene.model, scene.points1[i], scene.points2[i]);
            EXPECT_GE(error, 5);
            EXPECT_LE(error, 50 + 1e-9);
        }
        EXPECT_EQ((size_t)options.outliers, targetsOfOutliers(scene).size());
    }
}

TEST(Usac_Scenes, manyToOneOutliersShareAPointWithATrueMatch)
{
    SceneOptions options;
    options.outlierModel = OUTLIERS_MANY_TO_ONE;
    options.setSize(1000, 0.5);
    const Scene scene = makeScene(FUNDAMENTAL, options);
    const std::map<std::pair<double, double>, int> targets = targetsOfOutliers(scene);
    EXPECT_LE(targets.size(), 51u);
    EXPECT_GE(targets.size(), 40u);
    int ofTrueMatches = 0;
    for (int i = 0; i < scene.size(); ++i)
        ofTrueMatches += scene.truth[i] &&
                         targets.count(std::make_pair(scene.points2[i].x, scene.points2[i].y));
    EXPECT_EQ((int)targets.size(), ofTrueMatches);
}

}  // namespace
}  // namespace opencv_test
