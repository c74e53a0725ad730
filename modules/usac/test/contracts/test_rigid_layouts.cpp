// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/expected_answer.hpp"
#include "contracts/space_contracts.hpp"

// Every layout and depth of the points of both spaces must give the same result, bit by bit. Arrays
// that are not lists of 3-D points must be refused.

namespace opencv_test {
namespace {

//! Points as Nx3 matrices of type CV_64F, one for each space.
struct SpaceArrays
{
    Mat points1, points2;
};

SpaceArrays arraysOf(const RigidScene& scene)
{
    const SpaceArrays arrays = {column(scene.points1).reshape(1).clone(),
                                column(scene.points2).reshape(1).clone()};
    return arrays;
}

//! The result for given points. compare() expects the same bits for another form of these points.
class ExpectedMotion
{
public:
    ExpectedMotion(ProblemType type_, const SpaceArrays& arrays, double threshold) : type(type_)
    {
        params.threshold = threshold;
        Report report;
        motion = estimatePoints(type, arrays.points1, arrays.points2, params, mask, report);
        EXPECT_FALSE(motion.empty());
        EXPECT_GT(countNonZero(mask), 50);
    }

    void compare(const char* what, InputArray points1, InputArray points2) const
    {
        SCOPED_TRACE(what);
        Mat other;
        Report report;
        EXPECT_TRUE(
            sameBits(motion, estimatePoints(type, points1, points2, params, other, report)));
        EXPECT_TRUE(sameBits(mask, other));
        other = type == RIGID_3D ? estimateRigid3D(points1, points2, params)
                                 : estimateSimilarity3D(points1, points2, params);
        EXPECT_TRUE(sameBits(motion, other)) << "without mask and report";
    }

private:
    const ProblemType type;
    Params params;
    Mat motion, mask;
};

class Usac_RigidLayouts : public UsacProblem
{};
INSTANTIATE_TEST_CASE_P(/**/, Usac_RigidLayouts, testing::ValuesIn(SPACE_PROBLEMS));

TEST_P(Usac_RigidLayouts, every_shape)
{
    const RigidScene scene = makeRigidScene();
    const SpaceArrays a = arraysOf(scene);
    const ExpectedMotion expected(problem(), a, scene.threshold);
    const char* names[] = {"Nx3", "3xN", "Nx1, 3 channels", "1xN, 3 channels", "Nx1x3", "1xNx3"};
    Mat lists[2][6];
    for (int side = 0; side < 2; ++side)
    {
        const Mat& p = side ? a.points2 : a.points1;
        const Mat all[] = {
            p, p.t(), p.reshape(3), p.reshape(3, 1), solid(p, false), solid(p, true)};
        std::copy(all, all + 6, lists[side]);
    }
    for (int i = 0; i < 6; ++i)
    {
        expected.compare(names[i], lists[0][i], lists[1][i]);
        expected.compare(names[i], lists[0][i], lists[1][(i + 1) % 6]);
        if (i < 4)
            expected.compare(names[i], partOfLarger(lists[0][i]), partOfLarger(lists[1][i]));
        expected.compare(names[i], lists[0][i].getUMat(ACCESS_READ),
                         lists[1][i].getUMat(ACCESS_READ));
    }
    expected.compare("vectors", scene.points1, scene.points2);
    expected.compare("10x20, 3 channels", a.points1.reshape(3, 10), a.points2.reshape(3, 20));
    expected.compare("rows far apart in memory", partOfLarger(a.points1).colRange(0, 3),
                     a.points2.colRange(0, 3));
}

TEST_P(Usac_RigidLayouts, wrong_arguments_are_named)
{
    const RigidScene scene = makeRigidScene();
    const SpaceArrays a = arraysOf(scene);
    const int count = scene.size();
    Mat mask;
    Report report;
    const auto refuses = [&](InputArray points1, InputArray points2, const Params& params,
                             const char* words) {
        expectException(
            [&]() { estimatePoints(problem(), points1, points2, params, mask, report); }, words);
    };
    const Params params;
    const Mat wrong[] = {Mat(count, 2, CV_64F),  Mat(count, 4, CV_64F), Mat(count, 1, CV_64FC2),
                         Mat(2, count, CV_32F),  Mat(4, count, CV_32F), Mat(count, 1, CV_64F),
                         Mat(count, 1, CV_64FC4)};
    for (const Mat& points : wrong)
    {
        refuses(points, a.points2, params, "points1");
        refuses(a.points1, points, params, "points2");
    }
    refuses(a.points1.rowRange(0, 9), a.points2, params, "points1 and points2");
    refuses(a.points1, Mat(), params, "points1 and points2");
    Params other = params;
    other.residual = RESIDUAL_SYMMETRIC;
    refuses(a.points1, a.points2, other, "residual");
    for (int flags : {(int)DEGENERACY_DEGENSAC, DEGENERACY_DEGENSAC | DEGENERACY_REPEATED})
    {
        other = params;
        other.degeneracy = flags;
        refuses(a.points1, a.points2, other, "degeneracy");
        refuses(a.points1, a.points2, other, problem() == RIGID_3D ? "rigid3D" : "similarity3D");
    }
    refuses(a.points1, a.points2, Params::usac2013(), "degeneracy");
    other = params;
    other.threshold = 0;
    refuses(a.points1, a.points2, other, "threshold");
    other = params;
    other.scores.assign(5, 1.f);
    refuses(a.points1, a.points2, other, "scores");
    for (int numbers : {9, 6, 11, 13})
    {
        other = params;
        other.initialModel.assign(numbers, 0.5);
        refuses(a.points1, a.points2, other, "initialModel");
    }
}

}  // namespace
}  // namespace opencv_test
