// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NULL_VECTORS_HPP
#define OPENCV_USACV20_NULL_VECTORS_HPP

#include <Eigen/Core>

namespace cv {
namespace usacv20 {

//! A Householder reflection whose last column is a multiple of the vector n; n is not zero.
Eigen::Matrix3d completion(const Eigen::Vector3d& n);

/** Computes orthogonal U and V whose last columns are the left and right singular vectors of the
smallest singular value of a matrix M that is nearly singular, such as an epipolar geometry. The
largest singular value of the matrix of cofactors has the same singular vectors, so that few steps
of power iteration find them; this takes a fraction of the time of a singular value decomposition.
@return false if the ratio of the third to the second singular value is not below about 1e-3, or
that of the second to the first one not above 1e-3 */
bool completeNullVectors(const Eigen::Matrix3d& M, Eigen::Matrix3d& U, Eigen::Matrix3d& V);

}  // namespace usacv20
}  // namespace cv

#endif
