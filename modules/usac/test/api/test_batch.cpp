// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/contracts.hpp"
#include "opencv2/usac/batch.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"

// The results of many tasks estimated in one call must equal, bit by bit, those of one call per
// task.

namespace opencv_test {
namespace {

enum { COUNT = 12 };

//! Scenes of different sizes; the Params of each scene contain its scores.
struct Scenes
{
    explicit Scenes(ProblemType problem)
    {
        for (int i = 0; i < COUNT; ++i)
        {
            SceneOptions options;
            options.inliers = 30 + 40 * (i % 5);
            options.outliers = 20 + 30 * (i % 3);
            options.seed = i + 1;
            const Scene scene = makeScene(problem, options);
            points1.push_back(scene.points1);
            points2.push_back(scene.points2);
            params.push_back(Params());
            params.back().scores = scene.scores;
        }
    }

    std::vector<std::vector<Point2d>> points1, points2;
    std::vector<Params> params;
};

bool sameBits(const Mat& a, const Mat& b)
{
    return a.size() == b.size() && a.type() == b.type() &&
           (a.empty() || cv::norm(a, b, NORM_INF) == 0);
}

void expectSame(const Estimate& expected, const Estimate& found, int i)
{
    EXPECT_TRUE(sameBits(expected.model, found.model)) << i;
    EXPECT_TRUE(sameBits(expected.mask, found.mask)) << i;
    EXPECT_EQ(expected.report.iterations, found.report.iterations) << i;
    EXPECT_EQ(expected.report.cost, found.report.cost) << i;
    EXPECT_EQ(expected.error, found.error) << i;
}

typedef std::vector<Estimate> (*Batch)(InputArrayOfArrays, InputArrayOfArrays, const ParamsOfTasks&,
                                       int);
typedef Mat (*Single)(InputArray, InputArray, const Params&, OutputArray, Report&);

void checkProblem(ProblemType problem, Batch batch, Single single)
{
    const Scenes scenes(problem);
    for (int each = 0; each < 2; ++each)
        for (int threads = 0; threads <= 4; ++threads)
        {
            const std::vector<Estimate> found = each ? batch(scenes.points1, scenes.points2,
                                                             scenes.params, threads)
                                                     : batch(scenes.points1, scenes.points2,
                                                             Params(), threads);
            ASSERT_EQ((size_t)COUNT, found.size());
            for (int i = 0; i < COUNT; ++i)
            {
                Estimate expected;
                expected.model = single(scenes.points1[i], scenes.points2[i],
                                        each ? scenes.params[i] : Params(), expected.mask,
                                        expected.report);
                EXPECT_FALSE(expected.model.empty());
                expectSame(expected, found[i], i);
            }
        }
}

TEST(Usac_Batch, sameAsOneByOne)
{
#define USACV20_IMAGES(TYPE, NAME, PLURAL) checkProblem(TYPE, estimate##PLURAL, estimate##NAME);
#define USACV20_SPACES(TYPE, NAME, PLURAL)
#define USACV20_CAMERAS(TYPE, NAME, PLURAL)
#define USACV20_POSE(TYPE, NAME, PLURAL)
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) USACV20_##ARGUMENTS(TYPE, NAME, PLURAL)
#include "problems/registry.inl.hpp"
}

//! Camera matrices are given as a list with one per pose, as one matrix for all poses, or as a list
//! with a single element; distortions in the first two ways or not at all. The results must be
//! those of single calls.
TEST(Usac_Batch, poses)
{
    std::vector<std::vector<Point3d>> object;
    std::vector<std::vector<Point2d>> image;
    std::vector<Mat> cameras, lenses;
    PoseScene scene;
    for (int i = 0; i < COUNT; ++i)
    {
        PoseSceneOptions options;
        options.seed = i + 1;
        options.size = 40 + 30 * i;
        options.coefficients = 5;
        scene = makePoseScene(options);
        object.push_back(scene.object);
        image.push_back(scene.image);
        cameras.push_back(Mat(scene.K).clone());
        lenses.push_back(Mat(scene.distortion).clone());
    }
    Params params;
    params.threshold = 2;
    const std::vector<Estimate> each = estimateAbsolutePoses(object, image, cameras, lenses, params,
                                                             3);
    const std::vector<Estimate> last = estimateAbsolutePoses(object, image, scene.K,
                                                             scene.distortion, params, 2);
    const std::vector<Estimate> none = estimateAbsolutePoses(object, image,
                                                             std::vector<Mat>(1, cameras[0]));
    ASSERT_EQ((size_t)COUNT, each.size());
    for (int i = 0; i < COUNT; ++i)
    {
        Estimate expected;
        expected.model = estimateAbsolutePose(object[i], image[i], cameras[i], lenses[i], params,
                                              expected.mask, expected.report);
        expectSame(expected, each[i], i);
        expected.model = estimateAbsolutePose(object[i], image[i], scene.K, scene.distortion,
                                              params, expected.mask, expected.report);
        expectSame(expected, last[i], i);
        expected.model = estimateAbsolutePose(object[i], image[i], cameras[0], noArray(), Params(),
                                              expected.mask, expected.report);
        expectSame(expected, none[i], i);
    }
}

TEST(Usac_Batch, essentialMatrices)
{
    const Scenes scenes(ESSENTIAL);
    SceneOptions options;
    const Scene one = makeScene(ESSENTIAL, options);
    const std::vector<Estimate> found = estimateEssentials(scenes.points1, scenes.points2, one.K,
                                                           one.K);
    for (int i = 0; i < COUNT; ++i)
    {
        Estimate expected;
        expected.model = estimateEssential(scenes.points1[i], scenes.points2[i], one.K, one.K,
                                           noArray(), noArray(), Params(), expected.mask,
                                           expected.report);
        expectSame(expected, found[i], i);
    }
}

//! A batch mixes problems. Task 2 has lists of different length, task 5 a negative threshold and
//! task 8 no camera matrix: these three must report errors. Task 6 has no points and thus no model.
TEST(Usac_Batch, mixedAndWrongTasks)
{
    const Scenes H(HOMOGRAPHY), F(FUNDAMENTAL);
    std::vector<Task> tasks;
    for (int i = 0; i < COUNT; ++i)
        tasks.push_back(i % 2 ? Task(HOMOGRAPHY, column(H.points1[i]), column(H.points2[i]))
                              : Task(FUNDAMENTAL, column(F.points1[i]), column(F.points2[i])));
    tasks[2].points2 = tasks[2].points2.rowRange(1, tasks[2].points2.rows);
    tasks[5].params.threshold = -1;
    tasks[6].points1 = tasks[6].points2 = Mat();
    tasks[8].problem = ESSENTIAL;
    const std::vector<Estimate> found = estimateBatch(tasks, 2), again = estimateBatch(tasks, 1);
    for (int i = 0; i < COUNT; ++i)
    {
        expectSame(found[i], again[i], i);
        const bool wrong = i == 2 || i == 5 || i == 8;
        EXPECT_EQ(wrong, !found[i].error.empty()) << i << found[i].error;
        EXPECT_EQ(wrong || i == 6, found[i].model.empty()) << i;
    }
    EXPECT_NE(String::npos, found[2].error.find("points1 and points2"));
    EXPECT_NE(String::npos, found[5].error.find("threshold"));
    EXPECT_NE(String::npos, found[8].error.find("cameraMatrix"));
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, found[6].report.stop);
    EXPECT_TRUE(estimateBatch(std::vector<Task>()).empty());
}

TEST(Usac_Batch, wrongLists)
{
    const Scenes scenes(HOMOGRAPHY);
    std::vector<std::vector<Point2d>> less(scenes.points1.begin() + 1, scenes.points1.end());
    expectException([&]() { estimateHomographies(scenes.points1, less); }, "points1 and points2");
    expectException([&]() { estimateHomographies(scenes.points1[0], scenes.points2[0]); },
                    "points1");
    expectException([&]() { estimateHomographies(scenes.points1, scenes.points2, Params(), -1); },
                    "threads");
    expectException(
        [&]() { estimateHomographies(scenes.points1, scenes.points2, std::vector<Params>(3)); },
        "params");
    expectException([&]() { estimateEssentials(scenes.points1, scenes.points2, noArray()); },
                    "cameraMatrices1");
    expectException(
        [&]() { estimateEssentials(scenes.points1, scenes.points2, std::vector<Mat>(2)); },
        "cameraMatrices1");
    EXPECT_TRUE(estimateHomographies(noArray(), noArray()).empty());
    EXPECT_TRUE(estimateHomographies(std::vector<Mat>(), std::vector<Mat>()).empty());
}

//! Estimate::error names the members of Task for estimateBatch(), but the arguments of the called
//! function for the batches of one problem.
TEST(Usac_Batch, namesOfArguments)
{
    const Mat space = Mat::ones(9, 3, CV_64F), image = Mat::ones(9, 2, CV_64F), odd(2, 3, CV_64F),
              few = image.rowRange(1, 9), K = Mat::eye(3, 3, CV_64F), lens(1, 3, CV_64F);
    const auto begin = [](const std::vector<Estimate>& found) {
        return found.size() == 1 ? found[0].error.substr(0, found[0].error.find(": ")) : String();
    };
    const auto poses = [&](const Mat& points, const Mat& camera, const Mat& distortion) {
        return begin(estimateAbsolutePoses(std::vector<Mat>(1, space), std::vector<Mat>(1, points),
                                           camera, distortion));
    };
    EXPECT_EQ("objectPoints and imagePoints", poses(few, K, Mat()));
    EXPECT_EQ("cameraMatrices", poses(image, odd, Mat()));
    EXPECT_EQ("distCoeffs", poses(image, K, lens));
    const std::vector<Mat> images(1, image);
    EXPECT_EQ("cameraMatrices1", begin(estimateEssentials(images, images, odd)));
    EXPECT_EQ("cameraMatrices2", begin(estimateEssentials(images, images, K, odd)));
    EXPECT_EQ("distCoeffs1", begin(estimateEssentials(images, images, K, K, lens)));
    std::vector<Task> tasks(1, Task(ABSOLUTE_POSE, space, few));
    EXPECT_EQ("cameraMatrix1", begin(estimateBatch(tasks)));
    tasks[0].cameraMatrix1 = K;
    EXPECT_EQ("points1 and points2", begin(estimateBatch(tasks)));
}

//! By default, a batch uses as many threads as OpenCV has, here 3. The second batch asks for 4, but
//! OpenCV has only 1. The number of threads must not change the results.
TEST(Usac_Batch, anyNumberOfThreads)
{
    const Scenes scenes(HOMOGRAPHY);
    const int before = getNumThreads();
    setNumThreads(3);
    const std::vector<Estimate> three = estimateHomographies(scenes.points1, scenes.points2);
    setNumThreads(1);
    const std::vector<Estimate> one = estimateHomographies(scenes.points1, scenes.points2, Params(),
                                                           4);
    setNumThreads(before);
    for (int i = 0; i < COUNT; ++i)
        expectSame(one[i], three[i], i);
}

}  // namespace
}  // namespace opencv_test
