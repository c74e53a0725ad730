// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CAMERAS_HPP
#define OPENCV_USACV20_CAMERAS_HPP

#include "problems/distortion.hpp"

namespace cv {
namespace usacv20 {

//! Harmonic mean of the focal lengths of two cameras in pixels: its inverse is the mean size of a
//! pixel on the normalized image planes. The focal length of a camera is the mean of the absolute
//! values of fx and fy, which are negative if an axis of the image has the opposite direction.
double meanFocalLength(const Matx33d& K1, const Matx33d& K2);

//! The cameras of two views, with distortion.
class Cameras
{
public:
    /** Raises cv::Exception if the arguments do not describe cameras.
    @param cameraMatrix1, cameraMatrix2 3x3, any depth; if the second matrix is empty, both cameras
    have the first matrix
    @param distCoeffs1, distCoeffs2 4, 5, 8, 12 or 14 coefficients as for cv::undistortPoints;
    empty: no distortion */
    Cameras(InputArray cameraMatrix1, InputArray cameraMatrix2, InputArray distCoeffs1,
            InputArray distCoeffs2);

    //! Converts pixels of both images to undistorted points of the normalized image planes, in
    //! place. A pixel at which the lens images no point becomes NaN. @return meanFocalLength()
    double toImagePlane(double* const* columns, int count) const;

private:
    Matx33d K1, K2;
    Distortion distortion1, distortion2;
};

}  // namespace usacv20
}  // namespace cv

#endif
