// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FACADE_HPP
#define OPENCV_USACV20_TEST_FACADE_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace opencv_test {

//! Matches of a facade with 12 columns of windows, the ground and a slanted wall. Some matches of
//! windows are matches to the window of another column in the same row; others are random.
class Facade
{
public:
    //! @param right, columns fractions of right matches, and of matches to another column among the
    //! matches of windows
    Facade(int size, double right, double columns, int seed);

    //! Root mean square Sampson distance of the right matches, without noise, from F.
    double error(const cv::Mat& model) const;

    cv::Matx33d R, F;
    cv::Vec3d t;
    std::vector<cv::Point2d> points1, points2;
    std::vector<bool> truth;  //!< of each match: it is right

private:
    std::vector<cv::Point2d> clean1, clean2;
};

}  // namespace opencv_test

#endif
