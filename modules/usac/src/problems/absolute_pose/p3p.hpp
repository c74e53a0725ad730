// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_P3P_HPP
#define OPENCV_USACV20_P3P_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Up to four poses of a calibrated camera from three points.

The columns of a datum are X, Y and Z of the object point and u and v of its image on the plane
z = 1 of the camera. A model is the 3x4 matrix [R t] that maps object points to camera coordinates;
R is a rotation. This applies if the camera matrix is the identity; for other camera matrices, see
the constructor.

The law of cosines gives three quadrics in the distances of the points from the camera. The ratios
of these distances are given by the intersections of two conics @cite persson2018lambda, found by
means of a degenerate conic of their pencil: a pair of lines @cite ding2023revisiting. Unlike in
these papers, the unknowns are the first distance and the differences of the other distances from
the first one, in units that avoid cancellation for a narrow field of view or a distant scene, see
TriangleDepths.

Under every model, the three points are in front of the camera and are projected to their images; no
two models are the same. There is no model if, up to rounding, the object points are collinear or
two image points are the same, or if a coordinate is not finite. */
class P3PSolver : public MinimalSolver
{
public:
    //! `camera_`: camera matrix whose last row and last column are 0 0 1. Models are
    //! `camera_` [R t], and (u, v, 1) is `camera_` times the image point on the plane z = 1.
    explicit P3PSolver(const Matx33d& camera_) : camera(camera_), inverse(camera_.inv()) {}

    int sampleSize() const CV_OVERRIDE;
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE;

private:
    const Matx33d camera, inverse;
};

}  // namespace usacv20
}  // namespace cv

#endif
