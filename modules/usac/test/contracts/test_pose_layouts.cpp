// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/expected_answer.hpp"
#include "contracts/pose_contracts.hpp"

// Every layout and depth of object and image points must give the same result, bit by bit.

namespace opencv_test {
namespace {

//! Object points as an Nx3 and image points as an Nx2 matrix of type CV_64F.
struct PoseArrays
{
    Mat object, image;
};

//! The result for given points. compare() expects the same bits for another form of these points.
class ExpectedPose
{
public:
    ExpectedPose(const PoseScene& scene_, const PoseArrays& arrays) : scene(scene_)
    {
        pose = estimateAbsolutePose(arrays.object, arrays.image, scene.K, scene.distortion,
                                    Params(), mask);
        EXPECT_FALSE(pose.empty());
        EXPECT_GT(countNonZero(mask), 50);
    }

    void compare(const char* what, InputArray object, InputArray image) const
    {
        SCOPED_TRACE(what);
        Mat other, inliers, rvec, tvec;
        const Mat again = estimateAbsolutePose(object, image, scene.K, scene.distortion, Params(),
                                               other);
        EXPECT_TRUE(sameBits(pose, again));
        EXPECT_TRUE(sameBits(mask, other));
        EXPECT_TRUE(cv::solvePnPRansac(object, image, scene.K, scene.distortion, rvec, tvec,
                                       inliers, Params()));
        EXPECT_TRUE(sameBits(pose.col(3), tvec));
        EXPECT_EQ(countNonZero(mask), (int)inliers.total());
    }

private:
    const PoseScene& scene;
    Mat pose, mask;
};

PoseScene sceneOf(int coefficients)
{
    PoseSceneOptions options;
    options.coefficients = coefficients;
    return makePoseScene(options);
}

PoseArrays arraysOf(const PoseScene& scene)
{
    const PoseArrays arrays = {column(scene.object).reshape(1).clone(),
                               column(scene.image).reshape(1).clone()};
    return arrays;
}

TEST(Usac_PoseLayouts, every_shape)
{
    for (int coefficients : {0, 5})
    {
        const PoseScene scene = sceneOf(coefficients);
        const PoseArrays a = arraysOf(scene);
        const ExpectedPose expected(scene, a);
        const Mat objects[] = {a.object,
                               a.object.t(),
                               a.object.reshape(3),
                               a.object.reshape(3, 1),
                               solid(a.object, false),
                               solid(a.object, true)};
        const Mat images[] = {a.image,
                              a.image.t(),
                              a.image.reshape(2),
                              a.image.reshape(2, 1),
                              solid(a.image, false),
                              solid(a.image, true)};
        const char* names[] = {"Nx3",   "3xN",  "Nx1, 3 channels", "1xN, 3 channels",
                               "Nx1x3", "1xNx3"};
        for (int i = 0; i < 6; ++i)
        {
            expected.compare(names[i], objects[i], images[i]);
            expected.compare(names[i], objects[i], images[(i + 1) % 6]);
            if (i < 4)
                expected.compare(names[i], partOfLarger(objects[i]), partOfLarger(images[i]));
            expected.compare(names[i], objects[i].getUMat(ACCESS_READ),
                             images[i].getUMat(ACCESS_READ));
        }
        expected.compare("vectors", scene.object, scene.image);
        expected.compare("10x20, 3 channels", a.object.reshape(3, 10), a.image.reshape(2, 20));
        expected.compare("rows far apart in memory", partOfLarger(a.object).colRange(0, 3),
                         a.image.colRange(0, 2));
        Mat ones(a.image.rows, 1, CV_64F, Scalar(1)), homogeneous;
        hconcat(a.image, ones, homogeneous);
        expected.compare("homogeneous points of the image", a.object, homogeneous);
    }
}

//! The coordinates are integers 0 .. 127, which every depth can represent.
TEST(Usac_PoseLayouts, every_depth)
{
    PoseScene scene = sceneOf(0);
    PoseArrays a = arraysOf(scene);
    double least = 0;
    minMaxLoc(a.object, &least);
    // not negative, so that CV_8U can represent the rounded numbers
    a.object = (a.object - least) * 10;
    a.object.convertTo(a.object, CV_8U);
    a.image.convertTo(a.image, CV_8U, 0.2);
    scene.K = scene.K * 0.2;
    scene.K(2, 2) = 1;
    for (Mat* points : {&a.object, &a.image})
        points->convertTo(*points, CV_64F);
    a.object = cv::min(a.object, 127);
    a.image = cv::min(a.image, 127);
    const ExpectedPose expected(scene, a);
    for (int depth : depthsOfIntegers())
    {
        SCOPED_TRACE(cv::format("depth %d", depth));
        Mat object, image;
        a.object.convertTo(object, depth);
        a.image.convertTo(image, depth);
        expected.compare("Nx3", object, image);
        expected.compare("3xN", object.t(), image.t());
        expected.compare("Nx1, 3 channels", object.reshape(3), image.reshape(2));
        expected.compare("Nx1x3", solid(object, false), solid(image, false));
        expected.compare("part of a larger matrix", partOfLarger(object), partOfLarger(image));
        expected.compare("this depth and double", object, a.image);
        expected.compare("double and this depth", a.object, image);
    }
}

TEST(Usac_PoseLayouts, camera_and_lens_of_any_type)
{
    PoseScene scene = sceneOf(5);
    for (double& d : scene.distortion)
        d = (float)d;
    const Mat K(scene.K), d(scene.distortion);
    const ExpectedPose expected(scene, arraysOf(scene));
    for (int depth : {CV_32F, CV_64F})
    {
        Mat camera, lens, mask, expectedMask;
        K.convertTo(camera, depth);
        d.convertTo(lens, depth);
        const Mat cameras[] = {camera, partOfLarger(camera), 2 * camera},
                  lenses[] = {lens, lens.t()};
        const Mat pose = estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion,
                                              Params(), expectedMask);
        for (const Mat& c : cameras)
            for (const Mat& l : lenses)
            {
                EXPECT_TRUE(sameBits(
                    pose, estimateAbsolutePose(scene.object, scene.image, c, l, Params(), mask)));
                EXPECT_TRUE(sameBits(expectedMask, mask));
            }
    }
}

//! Distortion coefficients in half precision (CV_16F) must have the same effect as the same numbers
//! in single precision. If all of them are 0, there must be no effect.
TEST(Usac_PoseLayouts, lens_of_half_precision)
{
    const PoseScene scene = sceneOf(5);
    const Mat coefficients(Matx<float, 1, 5>(-0.25f, 0.125f, 0.f, 0.0078125f, 0.f));
    Mat half, halfOfNoLens;
    coefficients.convertTo(half, CV_16F);
    Mat(1, 5, CV_32F, Scalar(0)).convertTo(halfOfNoLens, CV_16F);
    const Mat expected = removeDistortion(scene.image, scene.K, coefficients);
    EXPECT_TRUE(sameBits(expected, removeDistortion(scene.image, scene.K, half)));
    EXPECT_TRUE(sameBits(removeDistortion(scene.image, scene.K, noArray()),
                         removeDistortion(scene.image, scene.K, halfOfNoLens)));
}

TEST(Usac_PoseLayouts, input_is_unchanged_to_the_bit)
{
    const PoseScene scene = sceneOf(5);
    const PoseArrays a = arraysOf(scene);
    for (int depth : {CV_32S, CV_32F, CV_64F})
    {
        Mat wide(scene.size(), 8, depth, Scalar(7)), object = wide.colRange(1, 4),
                                                     image = wide.colRange(5, 7);
        a.object.convertTo(object, depth);
        a.image.convertTo(image, depth);
        Mat K(4, 5, CV_32F, Scalar(3)), camera = K(Rect(1, 1, 3, 3)),
                                        lens(5, 1, CV_64F, Scalar(1e-5));
        Mat(scene.K).convertTo(camera, CV_32F);
        const Mat wideBefore = wide.clone(), KBefore = K.clone(), lensBefore = lens.clone();
        for (const NamedPreset& preset : allPresets(ABSOLUTE_POSE))
        {
            Params params = preset.params;
            params.maxIterations = 100;
            Mat mask;
            estimateAbsolutePose(object, image, camera, lens, params, mask);
        }
        EXPECT_TRUE(sameBits(wideBefore, wide)) << "depth " << depth;
        EXPECT_TRUE(sameBits(KBefore, K));
        EXPECT_TRUE(sameBits(lensBefore, lens));
    }
}

TEST(Usac_PoseLayouts, wrong_shapes_are_refused)
{
    const PoseScene scene = sceneOf(0);
    const PoseArrays a = arraysOf(scene);
    const int count = scene.size();
    const Mat wrong[] = {Mat(count, 2, CV_64F), Mat(count, 4, CV_64F), Mat(count, 1, CV_64FC2),
                         Mat(2, count, CV_32F), Mat(4, count, CV_32F), Mat(count, 1, CV_64FC4)};
    for (const Mat& object : wrong)
        expectException([&]() { estimateAbsolutePose(object, a.image, scene.K); }, "objectPoints");
    expectException([&]() { estimateAbsolutePose(a.object, Mat(count, 1, CV_64F), scene.K); },
                    "imagePoints");
    expectException([&]() { estimateAbsolutePose(a.object, a.image.rowRange(1, count), scene.K); },
                    "imagePoints");
}

}  // namespace
}  // namespace opencv_test
