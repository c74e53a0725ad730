// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Functions that the samples share: they match two images, print the table and draw pictures.

#ifndef OPENCV_USACV20_SAMPLES_TOOLS_HPP
#define OPENCV_USACV20_SAMPLES_TOOLS_HPP

#include <algorithm>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/core/version.hpp>
#if CV_VERSION_MAJOR >= 5
#include <opencv2/features.hpp>
#else
#include <opencv2/features2d.hpp>
#endif
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/usac.hpp>

namespace tools {

//! Correspondences of two images.
struct Matches
{
    std::vector<cv::Point2f> points1, points2;
    std::vector<float> ratios;  //!< descriptor distance of the best match / that of the second best
};

//! The result of one method.
struct Result
{
    std::string method;
    cv::Mat model, mask;
    double milliseconds;  //!< median of the runs
    int iterations;       //!< -1: unknown
    double error;         //!< -1: unknown; the unit depends on the sample program
    std::string errorText;
};

struct Settings
{
    Settings(const cv::CommandLineParser& parser, int maxIterations_)
        : threshold(parser.get<double>("threshold")), confidence(parser.get<double>("confidence")),
          maxIterations(maxIterations_), runs(std::max(parser.get<int>("runs"), 1))
    {}

    //! The options that correspond to the flag cv::USACV20 with the same settings.
    cv::usacv20::Params params() const
    {
        cv::usacv20::Params params = cv::usacv20::Params::usacV20();
        params.threshold = threshold;
        params.confidence = confidence;
        params.maxIterations = maxIterations;
        return params;
    }

    double threshold, confidence;
    int maxIterations, runs;
};

//! Returns the path of a file. `name` is a path or the name of a file of OpenCV's sample data.
inline std::string findFile(const std::string& name)
{
    cv::samples::addSamplesDataSearchPath(
        "/usr/share/doc/opencv-doc/examples/data");  // Debian's package opencv-doc
    const std::string path = cv::samples::findFile(name, false, true);
    if (path.empty())
        CV_Error(cv::Error::StsObjectNotFound, name + ": not found; OPENCV_SAMPLES_DATA_PATH can "
                                                      "name the folder of OpenCV's sample data");
    return path;
}

inline cv::Mat readImage(const std::string& name)
{
    const cv::Mat image = cv::imread(findFile(name));
    if (image.empty())
        CV_Error(cv::Error::StsError, name + ": not a readable image");
    return image;
}

//! Computes keypoints and RootSIFT descriptors, which are square roots of L1-normalized SIFT
//! descriptors, so that their Euclidean distance is the Hellinger distance.
inline void detect(const cv::Mat& image, int features, std::vector<cv::KeyPoint>& keypoints,
                   cv::Mat& descriptors)
{
    cv::SIFT::create(features)->detectAndCompute(image, cv::noArray(), keypoints, descriptors);
    for (int i = 0; i < descriptors.rows; ++i)
        cv::normalize(descriptors.row(i), descriptors.row(i), 1, 0, cv::NORM_L1);
    cv::sqrt(descriptors, descriptors);
}

//! Matches features. A match is accepted if its descriptor distance is below the option `ratio`
//! times that of the second best match.
inline Matches match(const cv::Mat& image1, const cv::Mat& image2,
                     const cv::CommandLineParser& parser)
{
    std::vector<cv::KeyPoint> keypoints1, keypoints2;
    cv::Mat descriptors1, descriptors2;
    detect(image1, parser.get<int>("features"), keypoints1, descriptors1);
    detect(image2, parser.get<int>("features"), keypoints2, descriptors2);
    std::vector<std::vector<cv::DMatch>> nearest;
    if (!descriptors1.empty() && !descriptors2.empty())
        cv::BFMatcher(cv::NORM_L2).knnMatch(descriptors1, descriptors2, nearest, 2);
    const float ratio = parser.get<float>("ratio");
    Matches matches;
    for (size_t i = 0; i < nearest.size(); ++i)
    {
        if (nearest[i].size() < 2 || nearest[i][0].distance >= ratio * nearest[i][1].distance)
            continue;
        matches.points1.push_back(keypoints1[nearest[i][0].queryIdx].pt);
        matches.points2.push_back(keypoints2[nearest[i][0].trainIdx].pt);
        matches.ratios.push_back(nearest[i][0].distance / nearest[i][1].distance);
    }
    return matches;
}

//! Runs estimate(mask), which returns the model, `runs` times. @return the result of the last run,
//! with the median time of all runs
template <class Estimate>
Result measure(const std::string& method, int runs, Estimate estimate)
{
    Result result;
    result.method = method;
    result.iterations = -1;
    result.error = -1;
    std::vector<double> times;
    for (int i = 0; i < runs; ++i)
    {
        cv::TickMeter clock;
        clock.start();
        result.model = estimate(result.mask);
        clock.stop();
        times.push_back(clock.getTimeMilli());
    }
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    result.milliseconds = times[times.size() / 2];
    return result;
}

inline void printTable(const Matches& matches, const std::vector<Result>& results, int runs)
{
    std::cout << cv::format("%d matches; time: median of %d runs\n\n%-14s %-22s %8s %11s %9s\n",
                            (int)matches.points1.size(), runs, "method", "error", "inliers",
                            "iterations", "ms");
    for (size_t i = 0; i < results.size(); ++i)
    {
        const Result& r = results[i];
        const std::string iterations = r.iterations < 0 ? "-" : cv::format("%d", r.iterations);
        const char* error = r.model.empty() ? "no model"
                            : r.error < 0   ? "unknown"
                                            : r.errorText.c_str();
        std::cout << cv::format("%-14s %-22s %8d %11s %9.2f\n", r.method.c_str(), error,
                                r.model.empty() ? 0 : cv::countNonZero(r.mask), iterations.c_str(),
                                r.milliseconds);
    }
    std::cout << std::endl;
}

//! Exit code of a sample: 0 if there is a model and its error, if known, is at most the limit;
//! otherwise 1.
inline int exitCode(const Result& result, double limit)
{
    if (!result.model.empty() && result.error <= limit)
        return 0;
    std::cerr << result.method << ": "
              << (result.model.empty() ? "no model" : "the error is too large") << std::endl;
    return 1;
}

//! Largest error, in pixels, of an estimation that the paper on USACv20 counts as successful: 1 %
//! of the diagonal of the image.
inline double failureLimit(const cv::Mat& image)
{
    return 0.01 * std::sqrt((double)image.cols * image.cols + (double)image.rows * image.rows);
}

//! Both images side by side in light gray, on which colors are visible.
inline cv::Mat sideBySide(const cv::Mat& image1, const cv::Mat& image2)
{
    cv::Mat canvas(std::max(image1.rows, image2.rows), image1.cols + image2.cols, CV_8UC3,
                   cv::Scalar::all(255)),
        gray;
    image1.copyTo(canvas(cv::Rect(cv::Point(), image1.size())));
    image2.copyTo(canvas(cv::Rect(cv::Point(image1.cols, 0), image2.size())));
    cv::cvtColor(canvas, gray, cv::COLOR_BGR2GRAY);
    gray.convertTo(gray, -1, 0.7, 76);
    cv::cvtColor(gray, canvas, cv::COLOR_GRAY2BGR);
    return canvas;
}

//! The k-th of a series of bright colors. Successive colors are easy to distinguish; color k + 8 is
//! similar to color k.
inline cv::Scalar color(int k)
{
    cv::Mat hsv(1, 1, CV_8UC3, cv::Scalar(k * 67 % 180, 255, 220)), bgr;
    cv::cvtColor(hsv, bgr, cv::COLOR_HSV2BGR);
    return cv::Scalar(bgr.at<cv::Vec3b>(0));
}

//! Up to `count` inliers in a fixed random order.
inline std::vector<int> someInliers(const cv::Mat& mask, int count)
{
    std::vector<int> inliers;
    for (int i = 0; i < (int)mask.total(); ++i)
        if (mask.at<uchar>(i))
            inliers.push_back(i);
    cv::RNG rng(1);
    for (int i = (int)inliers.size() - 1; i > 0; --i)
        std::swap(inliers[i], inliers[rng.uniform(0, i + 1)]);
    inliers.resize(std::min<size_t>(inliers.size(), count));
    return inliers;
}

//! Draws the images side by side, all points as dots (green for inliers, red for outliers), and
//! lines between the two points of some inliers, at most `lines`.
inline cv::Mat drawInliers(const cv::Mat& image1, const cv::Mat& image2, const Matches& matches,
                           const cv::Mat& mask, int lines = 60)
{
    cv::Mat canvas = sideBySide(image1, image2);
    const cv::Point2f shift((float)image1.cols, 0);
    for (size_t i = 0; i < matches.points1.size(); ++i)
    {
        const cv::Scalar dot = mask.at<uchar>((int)i) ? cv::Scalar(0, 150, 0)
                                                      : cv::Scalar(0, 0, 230);
        cv::circle(canvas, matches.points1[i], 2, dot, cv::FILLED, cv::LINE_AA);
        cv::circle(canvas, matches.points2[i] + shift, 2, dot, cv::FILLED, cv::LINE_AA);
    }
    const std::vector<int> inliers = someInliers(mask, lines);
    for (size_t k = 0; k < inliers.size(); ++k)
        cv::line(canvas, matches.points1[inliers[k]], matches.points2[inliers[k]] + shift,
                 color((int)k), 1, cv::LINE_AA);
    return canvas;
}

//! Draws the part of the line a x + b y + c = 0 that is inside the image.
inline void drawLine(cv::Mat image, const cv::Vec3d& line, const cv::Scalar& ink)
{
    const double w = image.cols - 1, h = image.rows - 1;
    cv::Point2d a(0, 0), b(w, 0);
    if (std::abs(line[1]) > std::abs(line[0]))
    {
        a.y = -line[2] / line[1];
        b.y = -(line[2] + line[0] * w) / line[1];
    }
    else
    {
        a = cv::Point2d(-line[2] / line[0], 0);
        b = cv::Point2d(-(line[2] + line[1] * h) / line[0], h);
    }
    if (std::max(cv::norm(a), cv::norm(b)) < 1e5)
        cv::line(image, a, b, ink, std::max(1, image.cols / 600), cv::LINE_AA);
}

//! Draws the images side by side with some inliers, at most `lines`, and their epipolar lines under
//! F.
inline cv::Mat drawEpipolarLines(const cv::Mat& image1, const cv::Mat& image2,
                                 const Matches& matches, const cv::Mat& mask, const cv::Matx33d& F,
                                 int lines = 24)
{
    cv::Mat canvas = sideBySide(image1, image2);
    cv::Mat left = canvas(cv::Rect(cv::Point(), image1.size()));
    cv::Mat right = canvas(cv::Rect(cv::Point(image1.cols, 0), image2.size()));
    const std::vector<int> inliers = someInliers(mask, lines);
    for (size_t k = 0; k < inliers.size(); ++k)
    {
        const cv::Point2d p1 = matches.points1[inliers[k]], p2 = matches.points2[inliers[k]];
        drawLine(left, F.t() * cv::Vec3d(p2.x, p2.y, 1), color((int)k));
        drawLine(right, F * cv::Vec3d(p1.x, p1.y, 1), color((int)k));
        const int radius = std::max(3, image1.cols / 200);
        for (int side = 0; side < 2; ++side)
        {
            cv::circle(side ? right : left, side ? p2 : p1, radius, color((int)k), cv::FILLED,
                       cv::LINE_AA);
            cv::circle(side ? right : left, side ? p2 : p1, radius, cv::Scalar::all(0), 1,
                       cv::LINE_AA);
        }
    }
    return canvas;
}

//! Writes the picture, reduced if it is wider than the option `width`, with a line of text below
//! it.
inline void writePicture(const cv::CommandLineParser& parser, const cv::Mat& picture,
                         const std::string& text)
{
    const std::string file = parser.get<std::string>("output");
    const int width = parser.get<int>("width");
    cv::Mat small = picture;
    if (picture.cols > width)
        cv::resize(picture, small, cv::Size(), (double)width / picture.cols,
                   (double)width / picture.cols, cv::INTER_AREA);
    cv::copyMakeBorder(small, small, 0, 32, 0, 0, cv::BORDER_CONSTANT, cv::Scalar::all(255));
    cv::putText(small, text, cv::Point(8, small.rows - 11), cv::FONT_HERSHEY_SIMPLEX, 0.55,
                cv::Scalar::all(0), 1, cv::LINE_AA);
    if (!cv::imwrite(file, small, {cv::IMWRITE_JPEG_QUALITY, 85}))
        CV_Error(cv::Error::StsError, file + ": cannot be written");
    std::cout << "picture: " << file << std::endl;
}

//! Command line options (cv::CommandLineParser) that the samples for homographies, fundamental
//! matrices and essential matrices share.
inline std::string keys(const char* image1, const char* image2, const char* output)
{
    return cv::format(
        "{help h usage ? |    | print this help}"
        "{@image1        | %s | image 1, a path or the name of one of OpenCV's sample images}"
        "{@image2        | %s | image 2}"
        "{ratio          | 0.8  | largest ratio of the descriptor distances of the best and the "
        "second best match}"
        "{features       | 8000 | largest number of features per image}"
        "{confidence     | 0.99 | probability of finding the best model}"
        "{runs           | 11   | number of runs; the median time is printed}"
        "{width          | 1400 | largest width of the picture}"
        "{output o       | %s | picture to write}",
        image1, image2, output);
}

//! The body of main(): runs sample(parser), which returns the exit code. An exception is printed,
//! and the exit code is then 1.
template <class Sample>
int runSample(int argc, char** argv, const std::string& keyList, const char* about, Sample sample)
{
    cv::utils::logging::setLogLevel(
        cv::utils::logging::LOG_LEVEL_ERROR);  // otherwise findFile() logs each file
    try
    {
        cv::CommandLineParser parser(argc, argv, keyList);
        parser.about(about);
        if (parser.has("help"))
        {
            parser.printMessage();
            return 0;
        }
        const int code = sample(parser);
        if (parser.check())
            return code;
        parser.printErrors();
    }
    catch (const std::exception& e)
    {
        std::cerr << e.what() << std::endl;
    }
    return 1;
}

}  // namespace tools

#endif
