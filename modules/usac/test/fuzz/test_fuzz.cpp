// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "fuzz/fuzz_contracts.hpp"

#include <fstream>
#include <iterator>

namespace opencv_test {
namespace {

//! The stored inputs are those with which the fuzzer has found errors, and those that reach the
//! most code. All contracts must hold for each of them.
TEST(Usac_Fuzz, kept_inputs)
{
    std::vector<cv::String> files;
    cv::glob(USAC_TEST_DATA_DIR "/fuzz/*.bin", files);
    ASSERT_GT(files.size(), 20u);
    for (size_t i = 0; i < files.size(); ++i)
    {
        std::ifstream in(files[i].c_str(), std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(in)),
                                std::istreambuf_iterator<char>());
        ASSERT_FALSE(bytes.empty()) << files[i];
        EXPECT_EQ("", brokenContract(readFuzzInput((const uchar*)bytes.data(), bytes.size())))
            << files[i];
    }
}

//! Random bytes, which need no fuzzer. All contracts must hold. Most of the calls made from these
//! bytes are senseless, but some must give a model.
TEST(Usac_Fuzz, random_bytes)
{
    RNG rng(1);
    int models = 0, refused = 0;
    for (int i = 0; i < 1500; ++i)
    {
        std::vector<uchar> bytes(rng.uniform(1, 700));
        for (size_t k = 0; k < bytes.size(); ++k)
            bytes[k] = (uchar)rng.uniform(0, 256);
        const FuzzInput input = readFuzzInput(bytes.data(), bytes.size());
        ASSERT_EQ("", brokenContract(input)) << "input " << i;
        try
        {
            models += input.problem == FUNDAMENTAL &&
                      !estimateFundamental(input.points1, input.points2, input.params).empty();
        }
        catch (const cv::Exception&)
        {
            ++refused;
        }
    }
    EXPECT_GT(models, 10) << "some inputs must give a model";
    EXPECT_GT(refused, 10);
}

//! A call with points of a grid that has `places` places in each direction.
FuzzInput fewPlaces(int problem, double pitch, int places, int count, RNG& rng)
{
    FuzzInput input = readFuzzInput(0, 0);
    input.problem = (ProblemType)problem;
    input.params.threshold = 3;
    if (problem == ESSENTIAL || problem == ABSOLUTE_POSE)
        input.K1 = Mat(Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1));
    const bool space = problem == RIGID_3D || problem == SIMILARITY_3D;
    for (int i = 0; i < count; ++i)
    {
        double x[6];
        for (double& value : x)
            value = rng.uniform(0, places) * pitch;
        if (space || problem == ABSOLUTE_POSE)
            input.object.push_back(Point3d(x[0], x[1], x[4]));
        else
            input.points1.push_back(Point2d(x[0], x[1]));
        if (space)
            input.space2.push_back(Point3d(x[2], x[3], x[5]));
        else
            input.points2.push_back(Point2d(x[2], x[3]));
    }
    return input;
}

//! If points have few places, many matches share points, and hardly any sample or model passes all
//! checks. All contracts must hold for each problem.
TEST(Usac_Fuzz, few_places)
{
    RNG rng(1);
    for (int problem : ALL_PROBLEMS)
        for (double pitch : {1e-3, 1., 7., 100., 1e6})
            for (int places : {2, 3, 4})
                for (int count = 8; count <= 30; count += 2)
                    ASSERT_EQ("", brokenContract(fewPlaces(problem, pitch, places, count, rng)))
                        << "problem " << problem << ", " << places << " places " << pitch
                        << " apart, " << count << " matches";
}

//! The oracle brokenResult() must detect a wrong row of the mask and a model of wrong norm or rank,
//! because the tests that use this oracle would otherwise be worthless.
TEST(Usac_Fuzz, oracle_sees_a_wrong_row_of_the_mask)
{
    FuzzInput input = readFuzzInput(0, 0);
    const Scene scene = makeScene(HOMOGRAPHY);
    input.points1 = scene.points1;
    input.points2 = scene.points2;
    Report report;
    Mat mask;
    const Matx33d H(
        estimateHomography(input.points1, input.points2, input.params, mask, report).ptr<double>());
    EXPECT_EQ("", brokenResult(input, Mat(H), mask, report));
    for (int row = 0; row < mask.rows; ++row)
    {
        Mat wrong = mask.clone();
        wrong.at<uchar>(row) ^= 1;
        report.inliers = countNonZero(wrong);
        EXPECT_NE("", brokenResult(input, Mat(H), wrong, report)) << "row " << row;
    }
    report.inliers = countNonZero(mask);
    EXPECT_NE("", brokenResult(input, Mat(2 * H), mask, report)) << "h33 is 2";
    input.problem = FUNDAMENTAL;
    EXPECT_NE("", brokenResult(input, Mat((1 / cv::norm(H)) * H), mask, report))
        << "no F has rank 3";
}

}  // namespace
}  // namespace opencv_test
