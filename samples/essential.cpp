// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Estimates the essential matrix and the relative pose from two images of calibrated cameras, and
// compares flags of OpenCV with a flag of this module. OpenCV's chessboard images are used to
// calibrate the two cameras and to find the true pose.

#include "opencv2/core/version.hpp"
#include "tools.hpp"
#if CV_VERSION_MAJOR >= 5  // in OpenCV 5, calib3d is divided into these modules
#include "opencv2/calib.hpp"
#include "opencv2/objdetect.hpp"
#endif

namespace {

struct Stereo
{
    cv::Mat K1, dist1, K2, dist2;
    cv::Mat R, t;  //!< the true relative pose: X2 = R X1 + t
};

bool findCorners(const cv::Mat& image, cv::Size board, std::vector<cv::Point2f>& corners)
{
    cv::Mat gray;
    cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
    if (!cv::findChessboardCorners(gray, board, corners))
        return false;
    cv::cornerSubPix(gray, corners, cv::Size(11, 11), cv::Size(-1, -1),
                     cv::TermCriteria(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 30, 0.01));
    return true;
}

//! Calibrates both cameras and their relative pose from pairs of chessboard images, whose names are
//! in the file `list`. `board` is the number of inner corners in a row and in a column.
Stereo calibrate(const std::string& list, cv::Size board)
{
    const cv::FileStorage fs(tools::findFile(list), cv::FileStorage::READ);
    std::vector<std::string> files;
    fs.getFirstTopLevelNode() >> files;
    std::vector<cv::Point3f> plane;
    for (int i = 0; i < board.area(); ++i)
        plane.push_back(cv::Point3f((float)(i % board.width), (float)(i / board.width), 0));
    std::vector<std::vector<cv::Point3f>> object;
    std::vector<std::vector<cv::Point2f>> corners1, corners2;
    cv::Size size;
    for (size_t i = 0; i + 1 < files.size(); i += 2)
    {
        const cv::Mat image1 = tools::readImage(files[i]), image2 = tools::readImage(files[i + 1]);
        std::vector<cv::Point2f> c1, c2;
        if (!findCorners(image1, board, c1) || !findCorners(image2, board, c2))
            continue;
        object.push_back(plane);
        corners1.push_back(c1);
        corners2.push_back(c2);
        size = image1.size();
    }
    Stereo s;
    cv::Mat E, F;
    s.K1 = cv::initCameraMatrix2D(object, corners1, size);
    s.K2 = cv::initCameraMatrix2D(object, corners2, size);
    const double rms = cv::stereoCalibrate(object, corners1, corners2, s.K1, s.dist1, s.K2, s.dist2,
                                           size, s.R, s.t, E, F, cv::CALIB_USE_INTRINSIC_GUESS);
    std::cout << cv::format(
        "calibrated from %d pairs of chessboard images, reprojection error %.2f px\n",
        (int)object.size(), rms);
    return s;
}

//! Estimates the essential matrix like a typical program. `Method` is the type of the flags of
//! OpenCV or of the flags of this module.
template <class Method>
tools::Result estimate(const char* name, Method method, const tools::Matches& matches,
                       const Stereo& stereo, const tools::Settings& s)
{
    return tools::measure(name, s.runs, [&](cv::Mat& mask) {
        return cv::findEssentialMat(matches.points1, matches.points2, stereo.K1, stereo.dist1,
                                    stereo.K2, stereo.dist2, method, s.confidence, s.threshold,
                                    mask);
    });
}

double degrees(double cosine)
{
    return std::acos(std::max(-1., std::min(1., cosine))) * 180 / CV_PI;
}

//! Computes the angle between the true and the estimated rotation, and the angle between the true
//! and the estimated direction of translation; Result::error becomes the larger angle, in degrees.
void rate(tools::Result& result, const tools::Matches& matches, const Stereo& stereo)
{
    std::vector<cv::Point2f> points1, points2;
    cv::undistortPoints(matches.points1, points1, stereo.K1, stereo.dist1);
    cv::undistortPoints(matches.points2, points2, stereo.K2, stereo.dist2);
    cv::Mat R, t, mask = result.mask.clone();
    cv::recoverPose(result.model, points1, points2, R, t, 1.0, cv::Point2d(), mask);
    const double rotation = degrees((cv::trace(R.t() * stereo.R)[0] - 1) / 2);
    const double translation = degrees(t.dot(stereo.t) / cv::norm(t) / cv::norm(stereo.t));
    result.error = std::max(rotation, translation);
    result.errorText = cv::format("R %.2f, t %.2f deg", rotation, translation);
}

//! Draws inliers and their epipolar lines in undistorted images, where these lines are straight.
cv::Mat draw(const cv::Mat& image1, const cv::Mat& image2, const tools::Matches& matches,
             const Stereo& stereo, const tools::Result& result)
{
    cv::Mat straight1, straight2;
    cv::undistort(image1, straight1, stereo.K1, stereo.dist1);
    cv::undistort(image2, straight2, stereo.K2, stereo.dist2);
    tools::Matches straight;
    cv::undistortPoints(matches.points1, straight.points1, stereo.K1, stereo.dist1, cv::noArray(),
                        stereo.K1);
    cv::undistortPoints(matches.points2, straight.points2, stereo.K2, stereo.dist2, cv::noArray(),
                        stereo.K2);
    const cv::Mat F = stereo.K2.inv().t() * result.model * stereo.K1.inv();
    return tools::drawEpipolarLines(straight1, straight2, straight, result.mask, F);
}

int sample(const cv::CommandLineParser& parser)
{
    const cv::Mat image1 = tools::readImage(parser.get<std::string>("@image1"));
    const cv::Mat image2 = tools::readImage(parser.get<std::string>("@image2"));
    const Stereo stereo = calibrate(parser.get<std::string>("chessboards"),
                                    cv::Size(parser.get<int>("columns"), parser.get<int>("rows")));
    const tools::Settings settings(parser, 1000);  // the default of cv::findEssentialMat
    const tools::Matches matches = tools::match(image1, image2, parser);

    std::vector<tools::Result> results;
    results.push_back(estimate("RANSAC", cv::RANSAC, matches, stereo, settings));
    results.push_back(estimate("USAC_DEFAULT", cv::USAC_DEFAULT, matches, stereo, settings));
    results.push_back(estimate("USACV20", cv::USACV20, matches, stereo, settings));
    for (size_t i = 0; i < results.size(); ++i)
        if (!results[i].model.empty())
            rate(results[i], matches, stereo);

    // Repeats the estimation to get the report, which a call with a flag does not return.
    cv::usacv20::Report report;
    cv::usacv20::estimateEssential(matches.points1, matches.points2, stereo.K1, stereo.K2,
                                   stereo.dist1, stereo.dist2, settings.params(), cv::noArray(),
                                   report);
    tools::Result& ours = results.back();
    ours.iterations = report.iterations;
    tools::printTable(matches, results, settings.runs);
    std::cout << "USACV20: " << report.describe() << std::endl;
    if (!ours.model.empty())
        tools::writePicture(
            parser, draw(image1, image2, matches, stereo, ours),
            cv::format(
                "USACV20: %d of %d matches are inliers; some of them with their epipolar lines",
                cv::countNonZero(ours.mask), (int)ours.mask.total()));
    return tools::exitCode(ours, 10);  // limit of the error in degrees
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string
        keys = tools::keys("left01.jpg", "right01.jpg", "essential.jpg") +
               "{chessboards    | stereo_calib.xml | list of pairs of chessboard images of the "
               "same two cameras}"
               "{columns        | 9                | number of inner corners in a row of the "
               "chessboard}"
               "{rows           | 6                | number of inner corners in a column}"
               "{threshold      | 1                | inlier threshold in pixels}";
    return tools::runSample(argc, argv, keys,
                            "Essential matrix of two images of calibrated cameras.", sample);
}
