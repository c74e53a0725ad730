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

//! In pixels: the error of each match under x2^T F x1 = 0 to first order @cite hartley2003multiple
//! (11.4.3).
std::vector<double> sampsonDistances(const Matx33d& F, const Points& points1,
                                     const Points& points2);

/** In pixels: Sampson distance of each match, to first order that to the nearest one that H maps
exactly, in both images. Infinite where H takes the point to the other side of the camera than most
of the points. */
std::vector<double> mapDistances(const Matx33d& H, const Points& points1, const Points& points2);

//! The square of the area that the points cover, up to a factor; some of them tell it.
double squaredArea(const Points& points);

//! The essential matrix nearest to a fundamental matrix of two cameras, singular values 1, 1, 0.
Matx33d essentialOf(const Matx33d& F, const Matx33d& camera1, const Matx33d& camera2);

//! The rotation nearest to a matrix of determinant above 0.
Matx33d nearestRotation(const Matx33d& matrix);

//! The rotation that takes directions nearest to directions, by least squares of unit vectors @cite
//! umeyama1991least.
Matx33d fitRotation(const std::vector<Vec3d>& directions1, const std::vector<Vec3d>& directions2);

}  // namespace usacv20
}  // namespace cv

#endif
