// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PIXELS_HPP
#define OPENCV_USACV20_PIXELS_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

typedef std::vector<Point2d> Points;

//! Sampson distance of each match in pixels: the distance to the nearest match that fulfills
//! x2^T F x1 = 0, to first order @cite hartley2003multiple (11.4.3).
std::vector<double> sampsonDistances(const Matx33d& F, const Points& points1,
                                     const Points& points2);

/** Sampson distance of each match in pixels: the distance, in both images, to the nearest match
that H maps exactly, to first order. The distance is infinite if H does not map the point to the
same side of the camera as most points, or if the computed distance is not a finite number. */
std::vector<double> mapDistances(const Matx33d& H, const Points& points1, const Points& points2);

//! The square of the area that the points cover, up to a constant factor: the determinant of their
//! covariance matrix. It is computed from at most 200 of the points.
double squaredArea(const Points& points);

//! The essential matrix, with singular values 1, 1, 0, that is nearest to camera2^T F camera1.
Matx33d essentialOf(const Matx33d& F, const Matx33d& camera1, const Matx33d& camera2);

//! The rotation that is nearest to a matrix.
Matx33d nearestRotation(const Matx33d& matrix);

//! The rotation that maps `directions1` as closely as possible to `directions2`, by least squares
//! of unit vectors @cite umeyama1991least.
Matx33d fitRotation(const std::vector<Vec3d>& directions1, const std::vector<Vec3d>& directions2);

}  // namespace usacv20
}  // namespace cv

#endif
