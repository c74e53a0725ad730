// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_OWN_POINTS_HPP
#define OPENCV_USACV20_TEST_OWN_POINTS_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac.hpp"

namespace opencv_test {

//! Correspondences made from a test's points; they are valid as long as this object exists.
class OwnPoints
{
public:
    OwnPoints(cv::usacv20::ProblemType problem, const std::vector<cv::Point2d>& points1,
              const std::vector<cv::Point2d>& points2, double inlierThreshold = 1);

    const cv::usacv20::Correspondences& view() const { return points; }

private:
    cv::usacv20::Correspondences points;
    std::vector<double> doubles[4];
    cv::Mat floats;
    std::vector<int> index;

    OwnPoints(const OwnPoints&);
    OwnPoints& operator=(const OwnPoints&);
};

}  // namespace opencv_test

#endif
