// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/expected_answer.hpp"

// Every layout that OpenCV's functions accept for a list of points must be accepted and read in the
// same way. The one exception is described at whatever_opencv_takes.

namespace opencv_test {
namespace {

typedef UsacProblem UsacLayouts;
INSTANTIATE_TEST_CASE_P(/**/, UsacLayouts, testing::ValuesIn(TWO_VIEW_PROBLEMS));

//! Homogeneous coordinates. The absolute values of the weights cycle through `weights` powers of
//! two, by which division is exact, and the signs alternate.
Mat homogeneous(const Mat& points, int weights)
{
    Mat result(points.rows, 3, CV_64F);
    for (int i = 0; i < points.rows; ++i)
    {
        const double w = (i % 2 ? -1 : 1) * (1 << (i % weights));
        result.at<double>(i, 0) = w * points.at<double>(i, 0);
        result.at<double>(i, 1) = w * points.at<double>(i, 1);
        result.at<double>(i, 2) = w;
    }
    return result;
}

//! The points with two additional columns, which estimators must ignore.
Mat withMore(const Mat& points)
{
    Mat result, more(points.rows, 2, points.type());
    for (int i = 0; i < more.rows; ++i)
        more.row(i).setTo(i % 7 - 3);
    hconcat(points, more, result);
    return result;
}

TEST_P(UsacLayouts, a_point_in_each_column)
{
    const Scene scene = makeScene(problem());
    const Mat points1 = column(scene.points1).reshape(1).clone(),
              points2 = column(scene.points2).reshape(1).clone();
    const ExpectedAnswer expected(problem(), points1, points2);
    const Mat across1 = points1.t(), across2 = points2.t();
    expected.compare("2xN", across1, across2);
    expected.compare("2xN and Nx2", across1, points2);
    expected.compare("1xN with 2 channels and 2xN", points1.reshape(2, 1), across2);
    expected.compare("part of a larger matrix", partOfLarger(across1), partOfLarger(across2));
    expected.compare("expression", points1.t(), points2.t());
    expected.compare("UMat", across1.getUMat(ACCESS_READ), across2.getUMat(ACCESS_READ));
    expected.compare("Mat_", Mat_<double>(across1), Mat_<double>(across2));

    const Mat weighted1 = homogeneous(points1, 4), weighted2 = homogeneous(points2, 3);
    expected.compare("3xN", weighted1.t(), weighted2.t());
    expected.compare("3xN, part of a larger matrix", partOfLarger(weighted1.t()),
                     partOfLarger(weighted2.t()));
    expected.compare("3xN and Nx3", weighted1.t(), weighted2);
    expected.compare("3xN and 2xN", weighted1.t(), across2);
}

TEST_P(UsacLayouts, every_depth)
{
    Mat points1, points2;
    Matx33d K;
    makeIntegers(problem(), points1, points2, K);
    const ExpectedAnswer expected(problem(), points1, points2, K);
    const Mat weights = Mat::ones(points1.rows, 1, CV_64F);
    Mat ones1, ones2;
    hconcat(points1, weights, ones1);
    hconcat(points2, weights, ones2);
    for (int depth : depthsOfIntegers())
    {
        SCOPED_TRACE(cv::format("depth %d", depth));
        Mat a, b;
        points1.convertTo(a, depth);
        points2.convertTo(b, depth);
        expected.compare("2xN", Mat(a.reshape(1, a.rows)).t(), Mat(b.reshape(1, b.rows)).t());
        ones1.convertTo(a, depth);
        ones2.convertTo(b, depth);
        expected.compare("Nx3", a, b);
        expected.compare("3xN", Mat(a).t(), Mat(b).t());
        expected.compare("three channels", a.reshape(3), b.reshape(3));
    }
}

TEST_P(UsacLayouts, elements_of_any_matrix)
{
    const Scene scene = makeScene(problem());
    const Mat points1 = column(scene.points1).reshape(1).clone(),
              points2 = column(scene.points2).reshape(1).clone();
    const ExpectedAnswer expected(problem(), points1, points2);
    const Mat weighted1 = homogeneous(points1, 4), weighted2 = homogeneous(points2, 3);
    ASSERT_EQ(300, points1.rows);
    expected.compare("20x15, 2 channels", points1.reshape(2, 20), points2.reshape(2, 20));
    expected.compare("15x20 and 150x2, 2 channels", points1.reshape(2, 15),
                     points2.reshape(2, 150));
    expected.compare("2x150, 3 channels", weighted1.reshape(3, 2), weighted2.reshape(3, 2));
    expected.compare("part of a larger matrix", partOfLarger(points1.reshape(2, 20)),
                     partOfLarger(weighted2.reshape(3, 15)));
    expected.compare("1xNx2", threeDimensional(points1, 1, 300), threeDimensional(points2, 1, 300));
    expected.compare("Nx1x2", threeDimensional(points1, 300, 1), threeDimensional(points2, 300, 1));
    expected.compare("1xNx3 and Nx1x3", threeDimensional(weighted1, 1, 300),
                     threeDimensional(weighted2, 300, 1));
    std::vector<Point3f> threes1, threes2;
    std::vector<Point2f> twos1, twos2;
    for (int i = 0; i < 300; ++i)
    {
        twos1.push_back(scene.points1[i]);
        twos2.push_back(scene.points2[i]);
        threes1.push_back(Point3f(twos1[i].x, twos1[i].y, 1));
        threes2.push_back(Point3f(twos2[i].x, twos2[i].y, 1));
    }
    Mat doubles1, doubles2;
    Mat(twos1).convertTo(doubles1, CV_64F);
    Mat(twos2).convertTo(doubles2, CV_64F);
    ExpectedAnswer(problem(), doubles1, doubles2).compare("vector<Point3f>", threes1, threes2);
}

TEST_P(UsacLayouts, what_stands_behind_more_than_three_coordinates)
{
    const Scene scene = makeScene(problem());
    const Mat points1 = column(scene.points1).reshape(1).clone(),
              points2 = column(scene.points2).reshape(1).clone();
    const ExpectedAnswer expected(problem(), points1, points2);
    const Mat more1 = withMore(points1), more2 = withMore(points2);
    expected.compare("Nx4", more1, more2);
    expected.compare("4xN", more1.t(), more2.t());
    expected.compare("Nx1, 4 channels", more1.reshape(4), more2.reshape(4));
    expected.compare("1xN, 4 channels, and 2xN", more1.reshape(4, 1), points2.t());
    expected.compare("6xN", withMore(more1).t(), more2);
}

//! The arrays are so small that either the rows or the columns could be the points. A row of
//! `shapes` has the numbers of rows, columns and channels, and the expected number of points. In a
//! square array, each row must be a point.
TEST_P(UsacLayouts, both_readings_possible)
{
    const int shapes[][4] = {{1, 2, 1, 1}, {1, 3, 1, 1}, {2, 1, 1, 1}, {3, 1, 1, 1}, {2, 2, 1, 2},
                             {2, 3, 1, 3}, {3, 2, 1, 3}, {3, 3, 1, 3}, {1, 1, 2, 1}, {1, 1, 3, 1},
                             {1, 2, 2, 2}, {2, 1, 3, 2}, {1, 3, 2, 3}};
    for (size_t i = 0; i < sizeof(shapes) / sizeof(shapes[0]); ++i)
    {
        const int *const s = shapes[i], count = s[3];
        SCOPED_TRACE(cv::format("%dx%d with %d channels", s[0], s[1], s[2]));
        Mat points(s[0], s[1], CV_MAKETYPE(CV_32F, s[2])), mask;
        randu(points, 1, 2);
        Report report;
        const bool enough = count >= sampleSizeOf(problem());
        EXPECT_EQ(enough,
                  !estimatePoints(problem(), points, points, Params(), mask, report).empty());
        EXPECT_EQ(enough, report.stop != STOP_TOO_FEW_POINTS);
        EXPECT_EQ(Size(1, count), mask.size());
        EXPECT_EQ(enough ? count : 0, countNonZero(mask));
    }
    // in a square array, each row must be read as a point
    SceneOptions options;
    options.inliers = 10;
    options.outliers = 0;
    options.noise = 0;
    const Scene scene = makeScene(problem(), options);
    for (int count = 4; count <= 7; ++count)
    {
        const Mat points1 = column(scene.points1).reshape(1).rowRange(0, count).clone();
        const Mat points2 = column(scene.points2).reshape(1).rowRange(0, count).clone();
        const Mat square1 = withMore(withMore(withMore(points1))).colRange(0, count);
        const Mat square2 = withMore(withMore(withMore(points2))).colRange(0, count);
        Report report;
        Mat mask, otherMask;
        const Mat model = estimatePoints(problem(), points1, points2, Params(), mask, report);
        EXPECT_TRUE(sameBits(
            model, estimatePoints(problem(), square1, square2, Params(), otherMask, report)))
            << count;
        EXPECT_TRUE(sameBits(mask, otherMask)) << count;
        EXPECT_TRUE(sameBits(model, estimatePoints(problem(), points1.t(), points2.t(), Params(),
                                                   otherMask, report)))
            << count;
        EXPECT_TRUE(sameBits(mask, otherMask)) << count;
    }
}

//! Calls OpenCV's function for the problem. @return the number of rows of its mask; 0 if it found
//! no model, because its mask then does not tell the number of points; -1 if it raised an exception
int openCvTakes(ProblemType problem, const Mat& points1, const Mat& points2, int flag)
{
    Mat model, mask;
    try
    {
        if (problem == HOMOGRAPHY)
            model = cv::findHomography(points1, points2, flag, 3., mask, 50);
        else if (problem == FUNDAMENTAL)
            model = cv::findFundamentalMat(points1, points2, flag, 3., 0.99, 50, mask);
        else if (problem == AFFINITY)
            model = cv::estimateAffine2D(points1, points2, mask, flag, 3., 50);
        else if (problem == SIMILARITY)
            model = cv::estimateAffinePartial2D(points1, points2, mask, flag, 3., 50);
        else
            model = cv::findEssentialMat(points1, points2, sceneCamera(), flag, 0.99, 3., 50, mask);
    }
    catch (const cv::Exception&)
    {
        return -1;
    }
    return model.empty() ? 0 : mask.rows;
}

/** Arrays of many small shapes. If OpenCV's function raises no exception, this module must not
raise one either. If OpenCV's function finds a model, the number of points must be the same. Arrays
with more channels than elements are skipped: OpenCV reads each of their coordinates as a point. */
TEST_P(UsacLayouts, whatever_opencv_takes)
{
    if (!hasFlags(problem()))
        return;
    const bool similarity = problem() == SIMILARITY;  // OpenCV has no USAC for similarities
    const int flags[] = {cv::RANSAC, similarity ? (int)cv::LMEDS : (int)cv::USAC_DEFAULT},
              sides[] = {1, 2, 3, 4, 9};
    RNG rng(5);
    int taken = 0, seen = 0;
    Params params;
    params.maxIterations = 50;
    for (int i = 0; i < 2 * 5 * 5 * 4; ++i)
    {
        const int flag = flags[i % 2], rows = sides[i / 2 % 5], cols = sides[i / 10 % 5],
                  channels = 1 + i / 50;
        Mat points1(rows, cols, CV_MAKETYPE(CV_32F, channels)), points2 = points1.clone(), mask;
        rng.fill(points1, RNG::UNIFORM, 1., 400.);
        rng.fill(points2, RNG::UNIFORM, 1., 400.);
        const int count = openCvTakes(problem(), points1, points2, flag);
        if (count < 0 || (channels > 1 && rows * cols < channels))
            continue;
        ++taken;
        SCOPED_TRACE(cv::format("%dx%d with %d channels, flag %d", rows, cols, channels, flag));
        Report report;
        EXPECT_NO_THROW(estimatePoints(problem(), points1, points2, params, mask, report));
        if (count > 0)
        {
            ++seen;
            EXPECT_EQ(count, mask.rows);
        }
    }
    EXPECT_GT(taken, similarity ? 20 : 50);
    EXPECT_GT(seen, 20);
}

}  // namespace
}  // namespace opencv_test
