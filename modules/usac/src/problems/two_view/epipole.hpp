// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_EPIPOLE_HPP
#define OPENCV_USACV20_EPIPOLE_HPP

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! [v]x, the matrix of the cross product with v.
inline Matx33d crossMatrix(const Vec3d& v)
{
    return Matx33d(0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0);
}

//! The epipole e of image 2, F^T e = 0, not normalized: the longest cross product of two columns of
//! F.
inline Vec3d epipole2(const Matx33d& F)
{
    Vec3d best;
    double largest = -1;
    for (int j = 0; j < 3; ++j)
    {
        const int k = (j + 1) % 3;
        const Vec3d e = Vec3d(F(0, j), F(1, j), F(2, j)).cross(Vec3d(F(0, k), F(1, k), F(2, k)));
        if (e.dot(e) > largest)
        {
            largest = e.dot(e);
            best = e;
        }
    }
    return best;
}

}  // namespace usacv20
}  // namespace cv

#endif
