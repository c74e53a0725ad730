// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_FACADE_HPP
#define OPENCV_USACV20_TEST_FACADE_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace opencv_test {

//! Matches of a scene with a facade with 12 columns of windows, the ground and a slanted wall. Some
//! wrong matches lead from a window to a window in another column of the same row; the other wrong
//! matches have random points in image 2.
class Facade
{
public:
    //! @param size number of matches
    //! @param right fraction of right matches
    //! @param columns fraction of the matches of windows that lead to another column
    //! @param seed seed of the random numbers
    Facade(int size, double right, double columns, int seed);

    //! Root mean square Sampson distance in pixels of the right matches, without their noise, under
    //! `model`, an estimated F; 1e9 if it is empty.
    double error(const cv::Mat& model) const;

    cv::Matx33d F;  //!< the true fundamental matrix
    std::vector<cv::Point2d> points1, points2;

private:
    std::vector<cv::Point2d> clean1, clean2;
};

}  // namespace opencv_test

#endif
