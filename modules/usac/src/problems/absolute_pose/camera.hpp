// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_POSE_CAMERA_HPP
#define OPENCV_USACV20_POSE_CAMERA_HPP

#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

/** @brief The camera of an absolute pose.

The search uses undistorted pixel coordinates relative to the principal point, divided by the mean
focal length, so that errors are proportional to errors in (undistorted) pixels. Models are
`matrix` [R t], where `matrix` is the camera matrix K in these units. */
class PoseCamera
{
    const Matx33d K;
    const Distortion distortion;

public:
    //! Arguments as for cv::solvePnP. Raises cv::Exception if the arguments do not describe a
    //! camera; its message names them cameraMatrix1 and distCoeffs1, as in Usac::create().
    PoseCamera(InputArray cameraMatrix, InputArray distCoeffs);

    //! Converts pixels to the coordinates of the search, in place. Pixels at which the lens images
    //! no point become NaN.
    void toSearch(double* u, double* v, int count) const;
    //! Like toSearch(), but does not remove the distortion.
    void toSearchUnits(double* u, double* v, int count) const;
    //! Computes where the lens images a point of the normalized image plane, in the units of
    //! toSearchUnits(). False if the lens does not image the point.
    bool see(const Vec2d& point, Vec2d& seen, Matx22d* derivative = 0) const;

    const Matx33d matrix, inverse;  //!< last row and column of `matrix`: 0 0 1
    const double focal;             //!< mean focal length in pixels
    const bool distorted;
};

}  // namespace usacv20
}  // namespace cv

#endif
