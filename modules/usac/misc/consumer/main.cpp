// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <algorithm>
#include <iostream>
#include <opencv2/usac.hpp>

int main()
{
    // 300 points and the points to which a known homography maps them; every third mapped point is
    // replaced with a random point.
    const cv::Mat truth = cv::Mat_<double>({3, 3}, {1.1, 0.1, 20, -0.05, 0.9, 10, 1e-4, -5e-5, 1});
    cv::RNG rng(1);
    std::vector<cv::Point2d> src(300), dst;
    for (cv::Point2d& p : src)
        p = cv::Point2d(rng.uniform(0., 640.), rng.uniform(0., 480.));
    cv::perspectiveTransform(src, dst, truth);
    for (size_t i = 0; i < dst.size(); i += 3)
        dst[i] = cv::Point2d(rng.uniform(0., 640.), rng.uniform(0., 480.));

    // One call with a flag, and two calls with the number of a flag (one of this module and one of
    // OpenCV), as in a program that gets the number only at run time.
    const int methods[] = {(int)cv::USACV20_FAST, cv::RANSAC};
    const cv::Mat models[] = {cv::findHomography(src, dst, cv::USACV20, 1.0),
                              cv::usacv20::findHomography(src, dst, methods[0], 1.0),
                              cv::usacv20::findHomography(src, dst, methods[1], 1.0)};
    double worst = 0;
    for (const cv::Mat& H : models)
        worst = std::max(worst, H.empty() ? 1
                                          : cv::norm(H, truth, cv::NORM_INF) /
                                                cv::norm(truth, cv::NORM_INF));
    std::cout << "relative error of the homographies: " << worst << std::endl;
    return worst < 1e-6 ? 0 : 1;
}
