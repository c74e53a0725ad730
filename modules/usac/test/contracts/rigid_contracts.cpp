// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/rigid_contracts.hpp"

namespace opencv_test {

Mat estimateMotion(ProblemType type, InputArray points1, InputArray points2, const Params& params,
                   OutputArray mask, Report& report)
{
    return type == RIGID_3D ? estimateRigid3D(points1, points2, params, mask, report)
                            : estimateSimilarity3D(points1, points2, params, mask, report);
}

Estimate estimate(ProblemType type, const RigidScene& scene, const Params& params)
{
    Estimate result;
    result.model = estimateMotion(type, scene.points1, scene.points2, params, result.mask,
                                  result.report);
    return result;
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

Estimate checkedMotion(ProblemType type, const RigidScene& scene, const Params& params)
{
    const EstimatorCall before = callOf(type, scene, params);
    const Estimate found = estimate(type, scene, params);
    EXPECT_EQ("", brokenResult(before, found.model, found.mask, found.report));
    EXPECT_TRUE(sameBits(Mat(before.object), Mat(scene.points1)));
    EXPECT_TRUE(sameBits(Mat(before.space2), Mat(scene.points2)));
    return found;
}

std::vector<Mat> checkEveryWay(ProblemType type, const RigidScene& scene, double limit,
                               int maxIterations)
{
    const std::vector<NamedPreset> presets = allPresets(type);
    std::vector<Mat> motions;
    for (size_t i = 0; i < presets.size(); ++i)
    {
        SCOPED_TRACE(presets[i].name);
        Params params = presets[i].params;
        params.threshold = limit;
        params.maxIterations = maxIterations;
        const Estimate found = checkedMotion(type, scene, params);
        motions.push_back(found.model);
        const int threads = params.threads;
        for (int run = 0; run < (threads == 1 ? 3 : 1); ++run)
        {
            params.threads = threads == 1 ? 1 + 3 * run / 2 : threads;  // 1, 2 and 4 threads
            const Estimate other = estimate(type, scene, params);
            EXPECT_TRUE(sameBits(found.model, other.model)) << params.threads << " threads";
            EXPECT_TRUE(sameBits(found.mask, other.mask)) << params.threads << " threads";
        }
    }
    return motions;
}

}  // namespace opencv_test
