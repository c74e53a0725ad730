// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "api/argument_names.hpp"

#include <functional>

// If an argument is wrong, the message of the exception must begin with the name of the argument in
// the signature of the called function, not with its name inside the module.

namespace opencv_test {
namespace {

typedef std::function<void()> Call;

//! @param begin expected beginning of the message, up to the colon
void expectBegin(const Call& call, const std::string& begin)
{
    try
    {
        call();
        ADD_FAILURE() << "no exception, expected one about: " << begin;
    }
    catch (const cv::Exception& mistake)
    {
        EXPECT_EQ(begin, mistake.err.substr(0, mistake.err.find(": "))) << mistake.err;
        EXPECT_NE(std::string::npos, std::string(mistake.what()).find(begin + ": "))
            << mistake.what();
        EXPECT_FALSE(mistake.func.empty() || mistake.file.empty() || mistake.line == 0);
    }
}

struct Lists
{
    Lists()
        : s(makeScene(HOMOGRAPHY, SceneOptions())), a(column(s.points1)), b(column(s.points2)),
          few(b.rowRange(1, b.rows)), solid()
    {
        for (int i = 0; i < a.rows; ++i)
            space.push_back(Point3d(i, 2 * i % 7, 3));
        const int sizes[] = {4, 2, 2};
        solid = Mat(3, sizes, CV_64F, Scalar(0));
    }

    const Scene s;
    const Mat a, b, few;
    Mat solid;  //!< three-dimensional array, invalid as a list of points
    std::vector<Point3d> space;
    const Params params;
};

TEST(Usac_ArgumentNames, findHomography)
{
    const Lists l;
    Mat mask;
    Params wrong;  // with a wrong field of Params, the message must name the field
    wrong.threshold = -1;
    const int method = (int)USACV20;
    expectBegin([&] { findHomography(l.solid, l.b, USACV20); }, "srcPoints");
    expectBegin([&] { findHomography(l.a, l.solid, mask, USACV20); }, "dstPoints");
    expectBegin([&] { findHomography(l.a, l.few, USACV20); }, "srcPoints and dstPoints");
    expectBegin([&] { findHomography(l.a, l.b, USACV20, 0); }, "ransacReprojThreshold");
    expectBegin([&] { usacv20::findHomography(l.a, l.b, method, 0); }, "ransacReprojThreshold");
    expectBegin([&] { findHomography(l.a, l.b, USACV20, 3, mask, 0); }, "maxIters");
    expectBegin([&] { findHomography(l.a, l.b, USACV20, 3, mask, 9, 2); }, "confidence");
    expectBegin([&] { findHomography(l.a, l.few, mask, l.params); }, "srcPoints and dstPoints");
    expectBegin([&] { findHomography(l.a, l.b, wrong); }, "threshold");
}

TEST(Usac_ArgumentNames, findFundamentalMat)
{
    const Lists l;
    Mat mask;
    expectBegin([&] { findFundamentalMat(l.a, l.few, USACV20); }, "points1 and points2");
    expectBegin([&] { findFundamentalMat(l.a, l.b, USACV20, -1); }, "ransacReprojThreshold");
    expectBegin([&] { usacv20::findFundamentalMat(l.a, l.b, mask, (int)USACV20, -1); },
                "ransacReprojThreshold");
    expectBegin([&] { findFundamentalMat(l.a, l.b, USACV20, 3, 0.99, 0); }, "maxIters");
    expectBegin([&] { findFundamentalMat(l.a, l.b, mask, USACV20, 3, 2); }, "confidence");
}

TEST(Usac_ArgumentNames, findEssentialMat)
{
    const Lists l;
    Mat mask;
    const Mat K = Mat::eye(3, 3, CV_64F), none = Mat::zeros(3, 3, CV_64F),
              odd = Mat::ones(1, 3, CV_64F);
    Report report;
    expectBegin([&] { findEssentialMat(l.a, l.b, none, USACV20); }, "cameraMatrix");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, USACV20, 2); }, "prob");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, USACV20, 0.9, 0); }, "threshold");
    expectBegin([&] { usacv20::findEssentialMat(l.a, l.b, K, (int)USACV20, 0.9, 1, 0); },
                "maxIters");
    expectBegin([&] { findEssentialMat(l.a, l.b, 0, Point2d(), USACV20); }, "focal, pp");
    expectBegin([&] { findEssentialMat(l.a, l.b, 1, Point2d(), USACV20, 2); }, "prob");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, odd, K, Mat(), USACV20); }, "distCoeffs1");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, Mat(), none, Mat(), USACV20); },
                "cameraMatrix2");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, Mat(), K, Mat(), USACV20, 0); }, "prob");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, K, odd, Mat(), mask, l.params); },
                "dist_coeff1");
    expectBegin([&] { findEssentialMat(l.a, l.b, K, K, Mat(), odd, l.params); }, "dist_coeff2");
    expectBegin([&] { estimateEssential(l.a, l.b, none, l.params); }, "cameraMatrix");
    expectBegin([&] { estimateEssential(l.a, l.b, none, l.params, mask, report); }, "cameraMatrix");
    expectBegin([&] { estimateEssential(l.a, l.b, none, K, Mat(), Mat(), l.params, mask, report); },
                "cameraMatrix1");
}

TEST(Usac_ArgumentNames, affine_maps)
{
    const Lists l;
    Mat mask;
    expectBegin([&] { estimateAffine2D(l.solid, l.b, mask, USACV20); }, "from");
    expectBegin([&] { estimateAffine2D(l.a, l.few, mask, USACV20); }, "from and to");
    expectBegin([&] { estimateAffine2D(l.a, l.b, mask, USACV20, 0); }, "ransacReprojThreshold");
    expectBegin([&] { estimateAffine2D(l.a, l.b, mask, USACV20, 3, (size_t)-1); }, "maxIters");
    expectBegin([&] { estimateAffine2D(l.a, l.b, mask, USACV20, 3, 9, 0.9, (size_t)-1); },
                "refineIters");
    expectBegin([&] { estimateAffine2D(l.a, l.few, l.params); }, "pts1 and pts2");
    expectBegin([&] { estimateAffinePartial2D(l.a, l.few, mask, USACV20); }, "from and to");
    expectBegin([&] { estimateAffinePartial2D(l.a, l.b, mask, USACV20, 3, 0); }, "maxIters");
    expectBegin([&] { estimateAffinePartial2D(l.a, l.solid, mask, l.params); }, "pts2");
}

TEST(Usac_ArgumentNames, solvePnPRansac)
{
    const Lists l;
    const Mat K = Mat::eye(3, 3, CV_64F);
    Mat r, t, inliers;
    const auto solve = [&](const Mat& image, const Mat& camera, int iterations, float error,
                           double confidence) {
        return cv::solvePnPRansac(l.space, image, camera, Mat(), r, t, false, iterations, error,
                                  confidence, inliers, USACV20);
    };
    expectBegin([&] { solve(l.few, K, 10, 8, 0.9); }, "objectPoints and imagePoints");
    expectBegin([&] { solve(l.b, Mat::zeros(3, 3, CV_64F), 10, 8, 0.9); }, "cameraMatrix");
    expectBegin([&] { solve(l.b, K, 0, 8, 0.9); }, "iterationsCount");
    expectBegin([&] { solve(l.b, K, 10, 0, 0.9); }, "reprojectionError");
    expectBegin([&] { solve(l.b, K, 10, 8, 1.5); }, "confidence");
}

TEST(Usac_ArgumentNames, estimateAbsolutePose)
{
    const Lists l;
    const Mat K = Mat::eye(3, 3, CV_64F), none, odd = Mat::ones(1, 3, CV_64F);
    Mat mask;
    Report report;
    const auto both = [&](InputArray object, const Mat& image, const Mat& camera, const Mat& lens,
                          const char* begin) {
        expectBegin([&] { estimateAbsolutePose(object, image, camera, lens, l.params, mask); },
                    begin);
        expectBegin(
            [&] { estimateAbsolutePose(object, image, camera, lens, l.params, mask, report); },
            begin);
    };
    both(l.a, l.b, K, none, "objectPoints");
    both(l.space, l.solid, K, none, "imagePoints");
    both(l.space, l.few, K, none, "objectPoints and imagePoints");
    both(l.space, l.b, odd, none, "cameraMatrix");
    both(l.space, l.b, K, odd, "distCoeffs");
}

//! For an absolute pose, the arguments of Usac::create() are called points1, points2, cameraMatrix1
//! and distCoeffs1; those of Usac::setPoints() are called points1 and points2.
TEST(Usac_ArgumentNames, create)
{
    const Lists l;
    const Mat K = Mat::eye(3, 3, CV_64F), none, odd = Mat::ones(1, 3, CV_64F);
    const auto create = [&](InputArray object, const Mat& image, const Mat& camera,
                            const Mat& lens) {
        return Usac::create(ABSOLUTE_POSE, object, image, l.params, camera, noArray(), lens);
    };
    expectBegin([&] { create(l.a, l.b, K, none); }, "points1");
    expectBegin([&] { create(l.space, l.solid, K, none); }, "points2");
    expectBegin([&] { create(l.space, l.few, K, none); }, "points1 and points2");
    expectBegin([&] { create(l.space, l.b, odd, none); }, "cameraMatrix1");
    expectBegin([&] { create(l.space, l.b, K, odd); }, "distCoeffs1");
    const Ptr<Usac> usac = create(l.space, l.b, K, none);
    expectBegin([&] { usac->setPoints(l.a, l.b); }, "points1");
    expectBegin([&] { usac->setPoints(l.space, l.few); }, "points1 and points2");
}

//! In functions for all problems, the camera matrix of an absolute pose is `cameraMatrix1`, and the
//! messages must use this name. A caller of findEssentialMat with a focal length has given no
//! camera matrix, so the message must name the arguments "focal, pp" instead.
TEST(Usac_ArgumentNames, fits_and_focal_lengths)
{
    const Lists l;
    Report report;
    const Mat none, space = Mat::ones(20, 3, CV_64F), image = Mat::ones(20, 2, CV_64F);
    expectBegin([&] { fitModel(ABSOLUTE_POSE, space, image, Params(), noArray(), report); },
                "cameraMatrix1");
    expectBegin([&] { modelErrors(ABSOLUTE_POSE, Mat::eye(3, 4, CV_64F), space, image, Params()); },
                "cameraMatrix1");
    expectBegin(
        [&] {
            refineModel(HOMOGRAPHY, l.a, l.b, Mat::eye(3, 3, CV_64F), Params(), noArray(), report);
        },
        "model");
    for (double focal :
         {0., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        expectBegin([&] { cv::findEssentialMat(l.a, l.b, focal, Point2d(1, 1), USACV20); },
                    "focal, pp");
}

//! Messages of components written by the caller can begin with any text. The part before the first
//! ": " is translated to the caller's argument names only if it is a list of names separated by
//! commas or by the word `and`. Names that are not in the table, such as "reach", stay.
TEST(Usac_ArgumentNames, other_messages_stay)
{
    const ArgumentName names[] = {{"points1", "from"}, {"threshold", "ransacReprojThreshold"}};
    for (const char* const text :
         {"points1", "my threshold: it is odd", ": points1", "points1 or threshold: both",
          "points1, : none", "", "threshold of points1: 3", "points2: points1", "points1:"})
        EXPECT_NO_THROW(throwInWordsOf(names, 2, Exception(Error::StsError, text, "f", "file", 7)))
            << text;
    expectBegin(
        [&] {
            throwInWordsOf(
                names, 2,
                Exception(Error::StsError, "threshold, reach and points1: no", "f", "file", 7));
        },
        "ransacReprojThreshold, reach and from");
}

}  // namespace
}  // namespace opencv_test
