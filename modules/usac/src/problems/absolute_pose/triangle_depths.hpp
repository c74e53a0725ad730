// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TRIANGLE_DEPTHS_HPP
#define OPENCV_USACV20_TRIANGLE_DEPTHS_HPP

namespace cv {
namespace usacv20 {

/** @brief A triangle with known side lengths and known viewing rays through its corners.

Let d1, d2, d3 be the distances of the corners from the camera center, c_ij the cosine of the angle
between two rays, and s_ij = 2 - 2 c_ij the squared distance between the unit vectors of these rays.
The law of cosines for the squared length a_ij of a side is

    a_ij = d_i^2 + d_j^2 - 2 c_ij d_i d_j = (d_i - d_j)^2 + s_ij d_i d_j

The second form does not suffer from cancellation for small angles. Side 23 is the longest one and
the unit of length. */
struct Triangle
{
    double a12, a13;       //!< squared lengths of the other two sides; a23 = 1
    double s12, s13, s23;  //!< squared distances between unit rays, divided by sigma^2
    double sigma;          //!< largest distance between the unit vectors of two rays
};

/** @brief A position of the triangle: d1 = w / sigma, d2 = w / sigma + p, d3 = w / sigma + q.

In these unknowns, with the members of Triangle (whose s12, s13, s23 are divided by sigma^2),

    a12 = p^2 + s12 w (w + sigma p)
    a13 = q^2 + s13 w (w + sigma q)
      1 = (p - q)^2 + s23 (w + sigma p) (w + sigma q)

For sigma = 0, these are the equations of a camera at infinity: all numbers are of the order of 1,
however far away the triangle is. With the distances as unknowns, poses of a scene at a distance of
100 times its size are 10 000 times less accurate, even after Newton steps; with p, q and w, no
Newton steps are needed. */
struct TriangleDepths
{
    double p, q, w;
};

//! Maximum number of positions of a triangle in front of the camera.
enum { MAX_TRIANGLE_DEPTHS = 4 };

/** @brief All positions of a triangle with d1, d2, d3 > 0, each once.

@param triangle shape and rays of the triangle; all numbers are finite, and no two rays are equal
@param depths output, at most #MAX_TRIANGLE_DEPTHS
@return the number of positions */
int solveTriangle(const Triangle& triangle, TriangleDepths* depths);

}  // namespace usacv20
}  // namespace cv

#endif
