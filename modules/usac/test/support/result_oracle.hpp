// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_RESULT_ORACLE_HPP
#define OPENCV_USACV20_TEST_RESULT_ORACLE_HPP

#include <string>
#include <vector>
#include "opencv2/usac.hpp"

namespace opencv_test {

//! True if the threshold of the mask is estimated from the data.
inline bool findsThreshold(const cv::usacv20::Params& params)
{
    return params.quality == cv::usacv20::QUALITY_LMEDS ||
           params.thresholdType == cv::usacv20::THRESHOLD_ESTIMATED;
}

//! The arguments of one call of an estimator.
struct EstimatorCall
{
    cv::usacv20::ProblemType problem;
    std::vector<cv::Point2d> points1, points2;
    std::vector<cv::Point3d> object;  //!< absolute pose and 3-D motions: replaces points1
    std::vector<cv::Point3d> space2;  //!< 3-D motions: replaces points2
    cv::usacv20::Params params;
    cv::Mat K1, K2, d1, d2;  //!< for E; absolute pose uses K1 and d1; only K1 is required
};

/** Describes the first documented property that the result of a call lacks; returns "" if the
result has all documented properties. The report must agree with the mask. There must be either no
model, a zero mask and a reason (Report::stop), or a finite model of the documented norm and rank
with mask == (error <= threshold). The errors are computed with formulas other than those of the
module, in `long double` (where it is longer than `double`). Rows for which rounding to `double` can
change the mask are not checked. */
std::string brokenResult(const EstimatorCall& call, const cv::Mat& model, const cv::Mat& mask,
                         const cv::usacv20::Report& report);

}  // namespace opencv_test

#endif
