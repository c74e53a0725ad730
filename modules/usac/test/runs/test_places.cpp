// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"

// Many wrong matches share one or two points of image 2 (or space 2), as with a watermark or a dead
// pixel. A model that maps everything to such a point has many inliers but must not be returned.

namespace opencv_test {
namespace {

const UsacV20Method FLAGS[] = {USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_PROSAC,
                               USACV20_MAGSAC};

//! Fractions of the 200 matches: true ones, and wrong ones that share `places` points of image 2
//! (or space 2).
struct Parts
{
    double right, atPlaces;
    int places;
};

const Parts PARTS[] = {{0.3, 0.4, 1}, {0.2, 0.3, 1}, {0.3, 0.4, 2}, {0.2, 0.8, 1}};
const int SIZE = 200, RUNS = 20;

template <class Options>
void setParts(const Parts& parts, uint64 seed, Options& options)
{
    options.structured = cvRound(SIZE * parts.atPlaces);
    options.places = parts.places;
    options.seed = seed;
}

Params paramsOf(UsacV20Method flag, const std::vector<float>& scores)
{
    Params params = Params::fromMethod(flag);
    params.threshold = 1.5;
    if (flag == USACV20_PROSAC)
        params.scores = scores;
    return params;
}

bool rightMap(ProblemType problem, const Parts& parts, UsacV20Method flag, uint64 seed)
{
    SceneOptions options;
    options.setSize(SIZE, parts.right);
    options.outlierModel = OUTLIERS_PLACE;
    setParts(parts, seed, options);
    const Scene scene = makeScene(problem, options);
    return modelError(scene, estimate(scene, paramsOf(flag, scene.scores))) < 1.5;
}

bool rightPose(const Parts& parts, UsacV20Method flag, uint64 seed)
{
    PoseSceneOptions options;
    options.inlierRatio = parts.right;
    options.outliers = POSE_OUTLIERS_PLACE;
    setParts(parts, seed, options);
    const PoseScene scene = makePoseScene(options);
    Report report;
    const Mat pose = estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion,
                                          paramsOf(flag, scene.scores), noArray(), report);
    return !pose.empty() && rotationError(scene, Matx34d(pose)) < 1.5 &&
           centerError(scene, Matx34d(pose)) < 0.05;
}

bool rightMotion(ProblemType problem, const Parts& parts, UsacV20Method flag, uint64 seed)
{
    RigidSceneOptions options;
    options.inlierRatio = parts.right;
    options.modelScale = problem == SIMILARITY_3D ? 2.5 : 1;
    options.outliers = RIGID_OUTLIERS_PLACE;
    setParts(parts, seed, options);
    const RigidScene scene = makeRigidScene(options);
    Params params = paramsOf(flag, scene.scores);
    params.threshold = scene.threshold;
    const Mat motion = Usac::create(problem, scene.points1, scene.points2, params)->run();
    return !motion.empty() && motionError(scene, Matx34d(motion)) * scene.unit < scene.threshold;
}

bool isRight(ProblemType problem, const Parts& parts, UsacV20Method flag, uint64 seed)
{
    if (problem == ABSOLUTE_POSE)
        return rightPose(parts, flag, seed);
    if (problem == RIGID_3D || problem == SIMILARITY_3D)
        return rightMotion(problem, parts, flag, seed);
    return rightMap(problem, parts, flag, seed);
}

typedef testing::TestWithParam<int> Usac_Places;
INSTANTIATE_TEST_CASE_P(/**/, Usac_Places,
                        testing::Values((int)HOMOGRAPHY, (int)AFFINITY, (int)SIMILARITY,
                                        (int)ABSOLUTE_POSE, (int)RIGID_3D, (int)SIMILARITY_3D,
                                        (int)TRANSLATION_2D));

TEST_P(Usac_Places, no_flag_collapses)
{
    for (const Parts& parts : PARTS)
        for (UsacV20Method flag : FLAGS)
        {
            int wrong = 0;
            for (int seed = 1; seed <= RUNS; ++seed)
                wrong += !isRight((ProblemType)GetParam(), parts, flag, seed);
            EXPECT_LE(wrong, 1) << parts.right << " right, " << parts.atPlaces << " at "
                                << parts.places << " places, flag " << (int)flag;
        }
}

//! Without degeneracy checks, the run can return a model that maps everything to one point. The
//! report must then say that only few inliers are independent.
TEST(Usac_Places_Report, says_that_few_inliers_are_independent)
{
    int collapsed = 0;
    for (int seed = 1; seed <= RUNS; ++seed)
    {
        SceneOptions options;
        options.setSize(SIZE, 0.2);
        options.outlierModel = OUTLIERS_PLACE;
        setParts(PARTS[3], seed, options);
        const Scene scene = makeScene(HOMOGRAPHY, options);
        Params params = paramsOf(USACV20, scene.scores);
        params.degeneracy = 0;
        Report report;
        const Mat model = Usac::create(HOMOGRAPHY, scene.points1, scene.points2, params)
                              ->run(noArray(), &report);
        if (model.empty() || report.inliers < SIZE / 2)
            continue;
        ++collapsed;
        EXPECT_NE(String::npos, report.describe().find("inliers are independent"))
            << report.describe();
    }
    EXPECT_GT(collapsed, 0);
}

//! An object that is 16 pixels wide in image 2 must be found in at least 19 of 20 scenes, however
//! large it is in image 1. The map of the object must not be mistaken for a map of everything to
//! one point.
TEST(Usac_Places_Objects, small_ones_are_found)
{
    for (int problem : {HOMOGRAPHY, AFFINITY, SIMILARITY})
        for (double size : {16., 160., 320.})
            for (UsacV20Method flag : FLAGS)
            {
                int found = 0;
                for (int seed = 1; seed <= RUNS; ++seed)
                {
                    RNG rng(seed);
                    std::vector<Point2d> points1, points2;
                    std::vector<float> scores;
                    const Point2d corner1 = uniformPoint(rng, 0., 640 - size, 0., 480 - size),
                                  corner2 = uniformPoint(rng, 0., 624., 0., 464.);
                    for (int i = 0; i < SIZE; ++i)
                    {
                        const bool right = i < SIZE / 2;
                        const Point2d u = uniformPoint(rng, 0., 1.),
                                      noise = gaussianPoint(rng, 0.5);
                        points1.push_back(right ? corner1 + u * size
                                                : uniformPoint(rng, 0., 640., 0., 480.));
                        points2.push_back(right ? corner2 + u * 16 + noise
                                                : uniformPoint(rng, 0., 640., 0., 480.));
                        scores.push_back(rng.uniform(0.f, 1.f));
                    }
                    Mat mask;
                    const Mat model = Usac::create((ProblemType)problem, points1, points2,
                                                   paramsOf(flag, scores))
                                          ->run(mask);
                    found += !model.empty() &&
                             countNonZero(mask.rowRange(0, SIZE / 2)) > 0.9 * SIZE / 2;
                }
                EXPECT_GE(found, RUNS - 1)
                    << problem << ", " << size << " pixels, flag " << (int)flag;
            }
}

}
//! Wrong matches between two small places of each image, or copies of five of them: every model has
//! many inliers that depend on each other. Nevertheless only few models may be optimized, and few
//! samples of five different matches suffice.
TEST(Usac_FewPlaces, little_work)
{
    for (ProblemType problem : {AFFINITY, SIMILARITY})
        for (bool copies : {false, true})
        {
            RNG rng(1);
            std::vector<Point2d> points[2];
            for (int i = 0; i < 2000; ++i)
                for (std::vector<Point2d>& to : points)
                {
                    const int place = rng.uniform(0, 2);
                    const Point2d point(150 + 350 * place + rng.gaussian(2),
                                        120 + 230 * place + rng.gaussian(2));
                    to.push_back(copies && i >= 5 ? to[i % 5] : point);
                }
            Report report;
            estimateModel(problem, points[0], points[1], Params(), noArray(), report);
            EXPECT_LE(report.localOptimizations, 60) << (int)problem << report.describe();
            EXPECT_TRUE(!copies || report.iterations <= 500) << (int)problem << report.describe();
        }
}

}  // namespace
