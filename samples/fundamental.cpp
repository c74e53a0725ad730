// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Estimates the fundamental matrix between two images, and compares flags of OpenCV with a flag of
// this module.

#include "tools.hpp"

namespace {

/** Reads true correspondences of a rectified stereo pair from its disparities: x2 = x1 - disparity,
where a disparity of 0 means unknown. Disparities are rounded to a pixel. The rounding moves points
along the epipolar lines, which are the rows, and does not change the distance from these lines. */
tools::Matches readTruth(const std::string& name)
{
    tools::Matches truth;
    if (name.empty() || name == "none")
        return truth;
    const cv::Mat disparity = cv::imread(tools::findFile(name), cv::IMREAD_GRAYSCALE);
    for (int y = 0; y < disparity.rows; y += 10)
        for (int x = 0; x < disparity.cols; x += 10)
            if (disparity.at<uchar>(y, x) > 0 && x >= disparity.at<uchar>(y, x))
            {
                truth.points1.push_back(cv::Point2f((float)x, (float)y));
                truth.points2.push_back(
                    cv::Point2f((float)(x - disparity.at<uchar>(y, x)), (float)y));
            }
    return truth;
}

//! Mean Sampson distance of the true correspondences under F, in pixels.
double meanDistance(const cv::Matx33d& F, const tools::Matches& truth)
{
    double sum = 0;
    for (size_t i = 0; i < truth.points1.size(); ++i)
        sum += std::sqrt(cv::sampsonDistance(cv::Vec3d(truth.points1[i].x, truth.points1[i].y, 1),
                                             cv::Vec3d(truth.points2[i].x, truth.points2[i].y, 1),
                                             F));
    return sum / truth.points1.size();
}

//! Estimates the fundamental matrix like a typical program. `Method` is the type of the flags of
//! OpenCV or of the flags of this module.
template <class Method>
tools::Result estimate(const char* name, Method method, const tools::Matches& matches,
                       const tools::Settings& s)
{
    return tools::measure(name, s.runs, [&](cv::Mat& mask) {
        return cv::findFundamentalMat(matches.points1, matches.points2, method, s.threshold,
                                      s.confidence, s.maxIterations, mask);
    });
}

int sample(const cv::CommandLineParser& parser)
{
    const cv::Mat image1 = tools::readImage(parser.get<std::string>("@image1"));
    const cv::Mat image2 = tools::readImage(parser.get<std::string>("@image2"));
    const tools::Matches truth = readTruth(parser.get<std::string>("truth"));
    const tools::Settings settings(parser, parser.get<int>("iterations"));
    const tools::Matches matches = tools::match(image1, image2, parser);

    std::vector<tools::Result> results;
    results.push_back(estimate("RANSAC", cv::RANSAC, matches, settings));
    results.push_back(estimate("USAC_DEFAULT", cv::USAC_DEFAULT, matches, settings));
    results.push_back(estimate("USACV20", cv::USACV20, matches, settings));
    for (size_t i = 0; i < results.size(); ++i)
        if (!truth.points1.empty() && !results[i].model.empty())
        {
            results[i].error = meanDistance(results[i].model, truth);
            results[i].errorText = cv::format("%.3f px", results[i].error);
        }

    // Repeats the estimation to get the report, which a call with a flag does not return.
    cv::usacv20::Report report;
    cv::usacv20::estimateFundamental(matches.points1, matches.points2, settings.params(),
                                     cv::noArray(), report);
    tools::Result& ours = results.back();
    ours.iterations = report.iterations;
    tools::printTable(matches, results, settings.runs);
    std::cout << "USACV20: " << report.describe() << std::endl;
    if (!ours.model.empty())
        tools::writePicture(
            parser, tools::drawEpipolarLines(image1, image2, matches, ours.mask, ours.model),
            cv::format(
                "USACV20: %d of %d matches are inliers; some of them with their epipolar lines",
                cv::countNonZero(ours.mask), (int)ours.mask.total()));
    return tools::exitCode(ours, tools::failureLimit(image2));
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string keys = tools::keys("aloeL.jpg", "aloeR.jpg", "fundamental.jpg") +
                             "{truth          | aloeGT.png | true disparities of a rectified pair "
                             "as an 8-bit image, or none}"
                             "{threshold      | 1          | inlier threshold in pixels}"
                             "{iterations     | 1000       | largest number of samples}";
    return tools::runSample(argc, argv, keys, "Fundamental matrix of two images.", sample);
}
