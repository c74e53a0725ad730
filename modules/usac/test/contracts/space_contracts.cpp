// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/space_contracts.hpp"

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

EstimatorCall callOf(ProblemType type, const RigidScene& scene, const Params& params)
{
    EstimatorCall call;
    call.problem = type;
    call.object = scene.points1;
    call.space2 = scene.points2;
    call.params = params;
    return call;
}

Estimate estimate(const EstimatorCall& call)
{
    Estimate found;
    found.model = call.problem == ABSOLUTE_POSE
                      ? estimateAbsolutePose(call.object, call.points2, call.K1, call.d1,
                                             call.params, found.mask, found.report)
                      : estimatePoints(call.problem, call.object, call.space2, call.params,
                                       found.mask, found.report);
    return found;
}

Estimate checkedEstimate(const EstimatorCall& call)
{
    EstimatorCall before = call;
    before.d1 = call.d1.clone();
    const Estimate found = estimate(call);
    EXPECT_EQ("", brokenResult(before, found.model, found.mask, found.report));
    EXPECT_TRUE(sameBits(column(before.object), column(call.object)));
    EXPECT_TRUE(sameBits(column(before.points2), column(call.points2)));
    EXPECT_TRUE(sameBits(column(before.space2), column(call.space2)));
    EXPECT_TRUE(sameBits(before.d1, call.d1));
    return found;
}

namespace {

//! The threshold of solvePnPRansac is in single precision; calls with other thresholds differ.
void checkFlagForPoses(const EstimatorCall& call, UsacV20Method flag, const Estimate& estimated)
{
    if ((float)call.params.threshold != call.params.threshold)
        return;
    Mat rvec, tvec, R;
    std::vector<int> inliers, expected;
    const bool found = cv::solvePnPRansac(
        call.object, call.points2, call.K1, call.d1, rvec, tvec, false, call.params.maxIterations,
        (float)call.params.threshold, call.params.confidence, inliers, flag);
    EXPECT_EQ(!estimated.model.empty(), found);
    for (int i = 0; i < estimated.mask.rows; ++i)
        if (estimated.mask.at<uchar>(i))
            expected.push_back(i);
    EXPECT_EQ(expected, inliers);
    if (!found)
        return;
    EXPECT_TRUE(sameBits(estimated.model.col(3), tvec));
    Rodrigues(rvec, R);
    EXPECT_LE(cvtest::norm(R, estimated.model.colRange(0, 3), NORM_INF), 1e-7);
}

}  // namespace

std::vector<Mat> checkEveryWay(const EstimatorCall& call, int maxIterations)
{
    const struct
    {
        const char* preset;
        UsacV20Method flag;
    } flags[] = {{"usacV20", USACV20},
                 {"fast", USACV20_FAST},
                 {"accurate", USACV20_ACCURATE},
                 {"sorted", USACV20_PROSAC},
                 {"magsacPlusPlus", USACV20_MAGSAC},
                 {"parallel", USACV20_PARALLEL},
                 {"automatic", USACV20_AUTO}};
    std::vector<Mat> models;
    for (const NamedPreset& preset : allPresets(call.problem))
    {
        SCOPED_TRACE(preset.name);
        EstimatorCall own = call;
        own.params = preset.params;
        own.params.threshold = call.params.threshold;
        own.params.maxIterations = maxIterations;
        const Estimate found = checkedEstimate(own);
        models.push_back(found.model);
        for (const auto& each : flags)
            if (call.problem == ABSOLUTE_POSE && each.preset == std::string(preset.name))
                checkFlagForPoses(own, each.flag, found);
        const int threads = own.params.threads;
        for (int run = 0; run < (threads == 1 ? 3 : 1); ++run)
        {
            own.params.threads = threads == 1 ? 1 + 3 * run / 2 : threads;  // 1, 2 and 4 threads
            const Estimate other = estimate(own);
            EXPECT_TRUE(sameBits(found.model, other.model)) << own.params.threads << " threads";
            EXPECT_TRUE(sameBits(found.mask, other.mask)) << own.params.threads << " threads";
        }
    }
    return models;
}

}  // namespace opencv_test
