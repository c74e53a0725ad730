// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESSENTIAL_BASIS_HPP
#define OPENCV_USACV20_ESSENTIAL_BASIS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** Four 3x3 matrices X, Y, Z and W, row by row, that span the matrices E with x2^T E x1 = 0 for
five points. The five-point solver finds E = x X + y Y + z Z + W, and loses digits if x, y or z is
large or if all solutions are close together. */
typedef double EssentialBasis[4][9];

/** Changes the basis to one that suits points that a rotation R alone (nearly) explains; R is
estimated from the points. For such points, E = [t]x R is nearly a solution for every t. Within
the space that the basis spans, X, Y and W span the part that is closest to these matrices, and Z is
the remaining direction, scaled so that z is neither large nor small. With the basis of mix()
(five_points.inl.hpp), all solutions lie close to one plane, on which the constraints on E nearly
hold everywhere, so that digits are lost.
@param points the correspondences
@param sample indices of the five points
@param basis input: any basis; output: an orthogonal basis; X, Y and W are unit vectors, and the
length of Z is between 1e-6 and 1 */
void align(const Correspondences& points, const int* sample, EssentialBasis& basis);

}  // namespace usacv20
}  // namespace cv

#endif
