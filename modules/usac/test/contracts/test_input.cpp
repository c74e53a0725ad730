// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "support/contracts.hpp"
#include "contracts/expected_answer.hpp"

// Every layout and depth of points, masks and camera matrices must give the same result, bit by
// bit.

namespace opencv_test {
namespace {

typedef UsacProblem UsacInput;
INSTANTIATE_TEST_CASE_P(/**/, UsacInput, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacInput, every_layout)
{
    const Scene scene = makeScene(problem());
    const Mat points1 = column(scene.points1).reshape(1).clone(),
              points2 = column(scene.points2).reshape(1).clone();
    const ExpectedAnswer expected(problem(), points1, points2);
    const int count = points1.rows;
    expected.compare("Nx1, 2 channels", points1.reshape(2), points2.reshape(2));
    expected.compare("1xN, 2 channels", points1.reshape(2, 1), points2.reshape(2, 1));
    expected.compare("Nx1 and 1xN", points1.reshape(2), points2.reshape(2, 1));

    Mat wide1(count + 3, 7, CV_64F, Scalar(1e3)), wide2(count + 1, 3, CV_64F, Scalar(-7));
    Mat roi1 = wide1(Rect(2, 1, 2, count)), roi2 = wide2(Rect(1, 0, 2, count));
    points1.copyTo(roi1);
    points2.copyTo(roi2);
    ASSERT_FALSE(roi1.isContinuous() || roi2.isContinuous());
    expected.compare("columns of a wider matrix", roi1, roi2);

    Mat columns1(count, 3, CV_64FC2, Scalar(5, 5)), columns2(count, 2, CV_64FC2, Scalar(6, 6));
    points1.reshape(2).copyTo(columns1.col(1));
    points2.reshape(2).copyTo(columns2.col(1));
    expected.compare("a column of points", columns1.col(1), columns2.col(1));

    Mat rows(3, count, CV_64FC2, Scalar(7, 7));
    points1.reshape(2, 1).copyTo(rows.row(0));
    points2.reshape(2, 1).copyTo(rows.row(2));
    expected.compare("rows of a matrix", rows.row(0), rows.row(2));

    const Mat joint1 = points1.t(), joint2 = points2.t();
    expected.compare("expression", joint1.t(), joint2.t());
    expected.compare("UMat", points1.getUMat(ACCESS_READ), points2.getUMat(ACCESS_READ));
}

TEST_P(UsacInput, every_mask)
{
    const Scene scene = makeScene(problem());
    const int count = scene.size();
    Report report;
    Mat expected;
    const Mat model = estimatePoints(problem(), scene.points1, scene.points2, Params(), expected,
                                     report);
    ASSERT_EQ(count, expected.rows);
    ASSERT_EQ(1, expected.cols);
    const Mat values = expected.clone();

    std::vector<uchar> bytes;
    std::vector<char> chars(3, 'x');
    UMat umat;
    Mat wrongSize(7, 9, CV_32FC3, Scalar::all(4)), full(count, 1, CV_8U, Scalar(255)),
        row(1, count, CV_8U, Scalar(9));
    Mat_<uchar> typed;
    estimatePoints(problem(), scene.points1, scene.points2, Params(), bytes, report);
    EXPECT_TRUE(sameBits(values, column(bytes)));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), chars, report);
    ASSERT_EQ((size_t)count, chars.size());
    EXPECT_EQ(0, std::memcmp(values.data, chars.data(), count));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), umat, report);
    EXPECT_TRUE(sameBits(values, umat.getMat(ACCESS_READ)));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), wrongSize, report);
    EXPECT_TRUE(sameBits(values, wrongSize));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), full, report);
    EXPECT_TRUE(sameBits(values, full));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), row, report);
    EXPECT_TRUE(sameBits(values, row));
    estimatePoints(problem(), scene.points1, scene.points2, Params(), typed, report);
    EXPECT_TRUE(sameBits(values, typed));
    const Mat none = estimatePoints(problem(), scene.points1, scene.points2, Params(), noArray(),
                                    report);
    EXPECT_TRUE(sameBits(model, none));
    EXPECT_EQ(countNonZero(values), report.inliers);
}

TEST_P(UsacInput, prefilled_mask_is_cleared_when_there_is_no_model)
{
    const std::vector<Point2d> few(1, Point2d(1, 2)), same(50, Point2d(10, 20));
    Mat mask(3, 1, CV_8U, Scalar(1)), wrong(80, 2, CV_32S, Scalar(1));
    Report report;
    if (sampleSizeOf(problem()) == 1)  // one match, even if repeated, determines a translation
        return;
    EXPECT_TRUE(estimatePoints(problem(), few, few, Params(), mask, report).empty());
    EXPECT_EQ(Size(1, 1), mask.size());
    EXPECT_EQ(0, countNonZero(mask));
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);
    EXPECT_TRUE(estimatePoints(problem(), same, same, Params(), wrong, report).empty());
    EXPECT_EQ(Size(1, 50), wrong.size());
    EXPECT_EQ((int)CV_8UC1, wrong.type());
    EXPECT_EQ(0, countNonZero(wrong));
    EXPECT_EQ((int)STOP_TOO_FEW_POINTS, report.stop);  // the same match 50 times
}

TEST(Usac_Input, every_camera_matrix)
{
    const Scene scene = makeScene(ESSENTIAL);
    const Mat K = Mat(scene.K).clone();
    Mat mask, other;
    Report report;
    const Mat E = estimateEssential(scene.points1, scene.points2, K, Params(), mask, report);
    ASSERT_FALSE(E.empty());
    Mat single, wide(5, 6, CV_64F, Scalar(3)), singleWide(4, 7, CV_32F, Scalar(2)), integers;
    K.convertTo(single, CV_32F);  // 600, 320 and 240 are exact in float
    K.convertTo(integers, CV_32S);
    K.copyTo(wide(Rect(2, 1, 3, 3)));
    single.copyTo(singleWide(Rect(3, 0, 3, 3)));
    const Mat forms[] = {single, wide(Rect(2, 1, 3, 3)), singleWide(Rect(3, 0, 3, 3)), integers,
                         K.t().t()};
    for (int i = 0; i < 5; ++i)
    {
        EXPECT_TRUE(
            sameBits(E, estimateEssential(scene.points1, scene.points2, forms[i], Params(), other)))
            << i;
        EXPECT_TRUE(sameBits(mask, other)) << i;
        EXPECT_TRUE(sameBits(E, estimateEssential(scene.points1, scene.points2, K, forms[i],
                                                  noArray(), noArray(), Params(), other, report)))
            << i;
    }
    EXPECT_TRUE(
        sameBits(E, estimateEssential(scene.points1, scene.points2, scene.K, Params(), other)));
    EXPECT_TRUE(sameBits(E, estimateEssential(scene.points1, scene.points2, K.getUMat(ACCESS_READ),
                                              Params(), other)));
    EXPECT_TRUE(sameBits(E, estimateEssential(scene.points1, scene.points2, K, noArray(), noArray(),
                                              noArray(), Params(), other, report)));
}

//! The neighborhood graph must have at most 16 edges per point on average, so that its memory is
//! bounded.
void expectSparseGraph(Usac& usac)
{
    const Params params;
    const RunContext context(usac.points(), usac.components(), params);
    EXPECT_LE(edgesOf(*usac.components().neighborhood, context).size(),
              (size_t)16 * usac.points().size);
}

TEST_P(UsacInput, crowded_points_have_a_sparse_graph)
{
    // 60 000 matches are within a square of side 1 in each image and 600 are elsewhere, so that
    // nearly all pairs of matches are neighbors
    SceneOptions options;
    options.inliers = 500;
    Scene scene = makeScene(problem(), options);
    RNG rng(4);
    for (int i = 0; i < 60000; ++i)
    {
        scene.points1.push_back(uniformPoint(rng, 100., 101.));
        scene.points2.push_back(uniformPoint(rng, 500., 501., 300., 301.));
    }
    Mat mask;
    Report report;
    Ptr<Usac> usac = createUsac(scene, Params());
    expectSparseGraph(*usac);
    const Mat model = usac->run(mask, &report);
    checkResult(problem(), scene.points1, scene.points2, Params().threshold, model, mask, report);
}

}  // namespace
}  // namespace opencv_test
