// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_EXPECTED_ANSWER_HPP
#define OPENCV_USACV20_TEST_EXPECTED_ANSWER_HPP

// Shared by test_input.cpp, test_layouts.cpp and test_rigid_layouts.cpp.

#include "support/contracts.hpp"

namespace opencv_test {

//! The result for given points. compare() expects bitwise the same result for another form of these
//! points.
struct ExpectedAnswer
{
    ExpectedAnswer(ProblemType problem_, const Mat& points1, const Mat& points2,
                   const Matx33d& K_ = sceneCamera())
        : problem(problem_), K(K_)
    {
        Report report;
        model = estimatePoints(problem, points1, points2, Params(), mask, report, K);
        EXPECT_FALSE(model.empty());
        EXPECT_GT(countNonZero(mask), 50);
    }

    void compare(const char* what, InputArray points1, InputArray points2) const
    {
        SCOPED_TRACE(what);
        Mat otherMask;
        Report report;
        const Mat other = estimatePoints(problem, points1, points2, Params(), otherMask, report, K);
        EXPECT_TRUE(sameBits(model, other)) << model << other;
        EXPECT_TRUE(sameBits(mask, otherMask));
    }

    const ProblemType problem;
    const Matx33d K;
    Mat model, mask;
};

//! The points as part of a larger matrix, so that their rows are not contiguous in memory.
inline Mat partOfLarger(const Mat& points)
{
    Mat larger(points.rows + 2, points.cols + 3, points.type(), Scalar::all(-11));
    Mat part = larger(Rect(2, 1, points.cols, points.rows));
    points.copyTo(part);
    return part;
}

//! The rows of a matrix as a three-dimensional array of `first` x `second` x cols numbers.
inline Mat threeDimensional(const Mat& points, int first, int second)
{
    const int sizes[] = {first, second, points.cols};
    return points.clone().reshape(1, 3, sizes).clone();
}

//! The points as an N x 1 x cols array, or as 1 x N x cols if `across`.
inline Mat solid(const Mat& points, bool across)
{
    return threeDimensional(points, across ? 1 : points.rows, across ? points.rows : 1);
}

//! All matrix depths that can represent the integers 0 .. 127. OpenCV 5 has more such depths than
//! OpenCV 4.
inline std::vector<int> depthsOfIntegers()
{
    std::vector<int> depths = {CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F, CV_16F};
#ifdef CV_Bool
    depths.insert(depths.end(), {CV_16BF, CV_32U, CV_64U, CV_64S});
#endif
    return depths;
}

//! Makes the points of a scene, scaled, rounded and clipped to integers 0 .. 127, which every depth
//! can represent. The points are Nx2 matrices of type CV_64F. K is scaled by the same factor.
inline void makeIntegers(ProblemType problem, Mat& points1, Mat& points2, Matx33d& K)
{
    const double scale = 0.19;
    const Scene scene = makeScene(problem);
    column(scene.points1).reshape(1).convertTo(points1, CV_32S, scale);
    column(scene.points2).reshape(1).convertTo(points2, CV_32S, scale);
    points1 = cv::min(cv::max(points1, 0), 127);
    points2 = cv::min(cv::max(points2, 0), 127);
    points1.convertTo(points1, CV_64F);
    points2.convertTo(points2, CV_64F);
    K = scene.K * scale;
    K(2, 2) = 1;
}

}  // namespace opencv_test

#endif
