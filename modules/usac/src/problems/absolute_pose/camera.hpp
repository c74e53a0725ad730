// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POSE_CAMERA_HPP
#define OPENCV_USACV20_POSE_CAMERA_HPP

#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

/** @brief The camera of an absolute pose.

The search works on pixels from the principal point, without distortion, over the mean focal length:
there an error is one of pixels but for a factor, and the camera matrix is `matrix` [R t]. */
class PoseCamera
{
    const Matx33d K;
    const Distortion distortion;

public:
    //! As the arguments of the same names of cv::solvePnP. Raises cv::Exception for what is no
    //! camera.
    PoseCamera(InputArray cameraMatrix, InputArray distCoeffs);

    //! Pixels to points of the search, in place; NaN where nothing is seen.
    void toSearch(double* u, double* v, int count) const;
    //! Pixels from the principal point over the mean focal length, in place: the same but for the
    //! distortion.
    void toSearchUnits(double* u, double* v, int count) const;
    //! Where a point of the normalized image plane is seen, in these units. False if it is not.
    bool see(const Vec2d& point, Vec2d& seen, Matx22d* derivative = 0) const;

    const Matx33d matrix,
        inverse;         //!< its last row is 0 0 1, its last column, too; and its inverse
    const double focal;  //!< mean focal length in pixels
    const bool distorted;
};

}  // namespace usacv20
}  // namespace cv

#endif
