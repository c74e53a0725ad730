// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/pose_contracts.hpp"

namespace opencv_test {

EstimatorCall callOf(const PoseScene& scene, const Params& params)
{
    EstimatorCall call;
    call.problem = ABSOLUTE_POSE;
    call.object = scene.object;
    call.points2 = scene.image;
    call.params = params;
    call.K1 = Mat(scene.K, true);
    call.d1 = Mat(scene.distortion, true);
    return call;
}

Mat checkedPose(const PoseScene& scene, const Params& params, Mat& mask, Report& report)
{
    const EstimatorCall before = callOf(scene, params);
    const Mat pose = estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion,
                                          params, mask, report);
    EXPECT_EQ("", brokenResult(before, pose, mask, report));
    EXPECT_TRUE(sameBits(Mat(before.object), Mat(scene.object)));
    EXPECT_TRUE(sameBits(Mat(before.points2), Mat(scene.image)));
    EXPECT_TRUE(sameBits(before.d1, Mat(scene.distortion)));
    return pose;
}

namespace {

//! Runs cv::solvePnPRansac with the flag of a preset. Its result must agree with `pose` and `mask`,
//! the result of the preset.
void checkFlag(const PoseScene& scene, UsacV20Method flag, const Params& params, const Mat& pose,
               const Mat& mask)
{
    Mat rvec, tvec, R;
    std::vector<int> inliers, expected;
    const bool found = cv::solvePnPRansac(
        scene.object, scene.image, scene.K, scene.distortion, rvec, tvec, false,
        params.maxIterations, (float)params.threshold, params.confidence, inliers, flag);
    EXPECT_EQ(!pose.empty(), found);
    for (int i = 0; i < mask.rows; ++i)
        if (mask.at<uchar>(i))
            expected.push_back(i);
    EXPECT_EQ(expected, inliers);
    if (!found)
        return;
    EXPECT_TRUE(sameBits(pose.col(3), tvec));
    Rodrigues(rvec, R);
    EXPECT_LE(cvtest::norm(R, pose.colRange(0, 3), NORM_INF), 1e-7);
}

}  // namespace

std::vector<Mat> checkEveryWay(const PoseScene& scene, double pixels, int maxIterations)
{
    const std::vector<NamedPreset> presets = allPresets(ABSOLUTE_POSE);
    std::vector<Mat> poses;
    for (size_t i = 0; i < presets.size(); ++i)
    {
        SCOPED_TRACE(presets[i].name);
        Params params = presets[i].params;
        params.threshold = (float)pixels;
        params.maxIterations = maxIterations;
        Mat mask, other;
        Report report;
        poses.push_back(checkedPose(scene, params, mask, report));
        const int threads = params.threads;
        for (int run = 0; run < (threads == 1 ? 3 : 1); ++run)
        {
            params.threads = threads == 1 ? 1 + 3 * run / 2 : threads;  // 1, 2 and 4 threads
            const Mat pose = estimateAbsolutePose(scene.object, scene.image, scene.K,
                                                  scene.distortion, params, other);
            EXPECT_TRUE(sameBits(poses[i], pose)) << params.threads << " threads";
            EXPECT_TRUE(sameBits(mask, other)) << params.threads << " threads";
        }
        params.threads = threads;
        const UsacV20Method flags[] = {USACV20,        USACV20_FAST,   USACV20_ACCURATE,
                                       USACV20_PROSAC, USACV20_MAGSAC, USACV20_PARALLEL,
                                       USACV20_AUTO};
        const char* names[] = {"usacV20",        "fast",     "accurate", "sorted",
                               "magsacPlusPlus", "parallel", "automatic"};
        for (int f = 0; f < 7; ++f)
            if (std::string(names[f]) == presets[i].name)
                checkFlag(scene, flags[f], params, poses[i], mask);
    }
    return poses;
}

}  // namespace opencv_test
