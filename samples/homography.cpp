// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Estimates the homography between two images of a plane, and compares flags of OpenCV with a flag
// of this module.

#include "tools.hpp"

namespace {

//! Maps the points of a grid in image 1 with both homographies. @return mean distance, in pixels of
//! image 2, between the two results for a point
double meanDistance(const cv::Mat& H, const cv::Mat& truth, cv::Size size)
{
    std::vector<cv::Point2d> grid, mapped, expected;
    for (int y = 0; y <= 20; ++y)
        for (int x = 0; x <= 20; ++x)
            grid.push_back(cv::Point2d(x * (size.width - 1) / 20., y * (size.height - 1) / 20.));
    cv::perspectiveTransform(grid, mapped, H);
    cv::perspectiveTransform(grid, expected, truth);
    double sum = 0;
    for (size_t i = 0; i < grid.size(); ++i)
        sum += cv::norm(mapped[i] - expected[i]);
    return sum / grid.size();
}

cv::Mat readTruth(const std::string& name)
{
    cv::Mat truth;
    if (name.empty() || name == "none")
        return truth;
    const cv::FileStorage fs(tools::findFile(name), cv::FileStorage::READ);
    fs.getFirstTopLevelNode() >> truth;
    CV_Assert(truth.rows == 3 && truth.cols == 3);
    return truth;
}

//! Estimates the homography like a typical program. `Method` is the type of the flags of OpenCV or
//! of the flags of this module.
template <class Method>
tools::Result estimate(const char* name, Method method, const tools::Matches& matches,
                       const tools::Settings& s)
{
    return tools::measure(name, s.runs, [&](cv::Mat& mask) {
        return cv::findHomography(matches.points1, matches.points2, method, s.threshold, mask,
                                  s.maxIterations, s.confidence);
    });
}

std::vector<cv::Point2d> cornersOf(cv::Size size)
{
    return {cv::Point2d(0, 0), cv::Point2d(size.width, 0), cv::Point2d(size.width, size.height),
            cv::Point2d(0, size.height)};
}

/** Maps the corners of image 1 to image 2, prints the results with their standard deviations, and
draws their 95 % confidence ellipses, ten times enlarged. `canvas` shows both images side by side;
`size` is that of image 1. */
void drawCorners(cv::Mat canvas, const cv::Mat& H, const cv::Mat& covariance, cv::Size size)
{
    std::vector<cv::Point2d> corners = cornersOf(size), mapped;
    cv::perspectiveTransform(corners, mapped, H);
    const cv::Mat each = cv::usacv20::pointCovariance(cv::usacv20::HOMOGRAPHY, H, covariance,
                                                      corners);
    cv::Mat right = canvas.colRange(size.width, canvas.cols);
    for (int k = 0; k < 4; ++k)
    {
        const cv::Mat C = each.row(k).reshape(1, 2);
        if (!cv::checkRange(C))
            continue;
        std::cout << cv::format("corner (%.1f, %.1f) +- (%.2f, %.2f) px", mapped[k].x, mapped[k].y,
                                std::sqrt(C.at<double>(0, 0)), std::sqrt(C.at<double>(1, 1)))
                  << std::endl;
        cv::Mat variances, axes;
        cv::eigen(C, variances, axes);
        const double quantile = 5.99;  // 95 % quantile of chi-square with two degrees of freedom
        const double scale = 10 * std::sqrt(quantile);
        const double angle = std::atan2(axes.at<double>(0, 1), axes.at<double>(0, 0));
        const cv::Size2f diameters((float)(2 * scale * std::sqrt(variances.at<double>(0))),
                                   (float)(2 * scale * std::sqrt(variances.at<double>(1))));
        cv::ellipse(right, cv::RotatedRect(mapped[k], diameters, (float)(angle * 180 / CV_PI)),
                    cv::Scalar(255, 80, 0), 2, cv::LINE_AA);
    }
}

void drawOutline(cv::Mat canvas, const cv::Mat& H, cv::Size size)
{
    std::vector<cv::Point2d> corners = cornersOf(size);
    cv::perspectiveTransform(corners, corners, H);
    cv::Mat right = canvas.colRange(size.width, canvas.cols);
    for (int k = 0; k < 4; ++k)
        cv::line(right, corners[k], corners[(k + 1) % 4], cv::Scalar(0, 140, 255), 3, cv::LINE_AA);
}

int sample(const cv::CommandLineParser& parser)
{
    const cv::Mat image1 = tools::readImage(parser.get<std::string>("@image1"));
    const cv::Mat image2 = tools::readImage(parser.get<std::string>("@image2"));
    const cv::Mat truth = readTruth(parser.get<std::string>("truth"));
    const tools::Settings settings(parser, parser.get<int>("iterations"));
    const tools::Matches matches = tools::match(image1, image2, parser);

    std::vector<tools::Result> results;
    results.push_back(estimate("RANSAC", cv::RANSAC, matches, settings));
    results.push_back(estimate("USAC_DEFAULT", cv::USAC_DEFAULT, matches, settings));
    results.push_back(estimate("USACV20", cv::USACV20, matches, settings));
    for (size_t i = 0; i < results.size(); ++i)
        if (!truth.empty() && !results[i].model.empty())
        {
            results[i].error = meanDistance(results[i].model, truth, image1.size());
            results[i].errorText = cv::format("%.2f px", results[i].error);
        }

    // Repeats the estimation to get the report and the covariance, which a call with a flag does
    // not return.
    cv::usacv20::Report report;
    cv::usacv20::Params params = settings.params();
    params.covariance = 1;
    cv::usacv20::estimateHomography(matches.points1, matches.points2, params, cv::noArray(),
                                    report);
    tools::Result& ours = results.back();
    ours.iterations = report.iterations;
    tools::printTable(matches, results, settings.runs);
    std::cout << "USACV20: " << report.describe() << std::endl;
    if (!ours.model.empty())
    {
        cv::Mat picture = tools::drawInliers(image1, image2, matches, ours.mask);
        drawOutline(picture, ours.model, image1.size());
        if (!report.covariance.empty())
            drawCorners(picture, ours.model, report.covariance, image1.size());
        tools::writePicture(
            parser, picture,
            cv::format("USACV20: %d of %d inliers (green, some joined); orange: image "
                       "1; blue: 10 x 95 %% ellipses",
                       cv::countNonZero(ours.mask), (int)ours.mask.total()));
    }
    return tools::exitCode(ours, tools::failureLimit(image2));
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string keys = tools::keys("graf1.png", "graf3.png", "homography.jpg") +
                             "{truth          | H1to3p.xml | file with the true homography from "
                             "image 1 to image 2, or none}"
                             "{threshold      | 2          | inlier threshold in pixels}"
                             "{iterations     | 10000      | largest number of samples}";
    return tools::runSample(argc, argv, keys, "Homography of two images of a plane.", sample);
}
