// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SHARE_A_POINT_HPP
#define OPENCV_USACV20_SHARE_A_POINT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! True if two matches have the same point in image 1 or in image 2: at most one of them is right, or they are the same.
inline bool shareAPoint(const Correspondences& p, int i, int j)
{
    return (p.x1[i] == p.x1[j] && p.y1[i] == p.y1[j]) || (p.x2[i] == p.x2[j] && p.y2[i] == p.y2[j]);
}

//! True if two matches are the same.
inline bool sameMatch(const Correspondences& p, int i, int j)
{
    return p.x1[i] == p.x1[j] && p.y1[i] == p.y1[j] && p.x2[i] == p.x2[j] && p.y2[i] == p.y2[j];
}

} // namespace usacv20
} // namespace cv

#endif
