// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_REAL_SET_HPP
#define OPENCV_USACV20_TEST_REAL_SET_HPP

#include <string>
#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac.hpp"

namespace opencv_test {

//! One data set of test_data/. The README.md of that folder names the sources of the data.
struct RealSet
{
    explicit RealSet(const std::string& name);

    //! Mean error in pixels of the check points (check1, check2): correct correspondences that do
    //! not come from the matches. Transfer error in image 2 for H, Sampson distance for F and E.
    //! 1e9 if `estimated` is empty.
    double error(const cv::Mat& estimated) const;
    cv::Mat find(cv::UsacV20Method flag, double pixels, cv::OutputArray mask) const;
    cv::Mat estimateWith(const cv::usacv20::Params& params, cv::OutputArray mask,
                         cv::usacv20::Report& report) const;
    //! The data set with only the given fraction of its matches: those with the lowest (best)
    //! scores, best first.
    RealSet sorted(double part = 1) const;

    cv::usacv20::ProblemType problem;
    std::vector<cv::Point2d> points1, points2, check1, check2;
    std::vector<float> scores;
    cv::Mat model, K1, K2, d1, d2;
};

}  // namespace opencv_test

#endif
