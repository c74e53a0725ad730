// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MOMENTS_HPP
#define OPENCV_USACV20_MOMENTS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Weighted means and second moments of matches, from which the least-squares map x2 = A x1
+ t of an affinity or a similarity is computed: the problem is linear, and the rows of A separate
once the means are at the origin @cite umeyama1991least. One pass over the matches, about 30
operations each. */
struct Moments
{
    /** Moments of `count` matches. Coordinates are relative to the first match, to lose little
    precision if all are close together far from the origin. If `weights` is null, all are 1. */
    Moments(const Correspondences& points, const int* indices, int count, const double* weights);

    //! The map with the linear part (a b; c d) that maps the means of the images to each other.
    Matx33d map(double a, double b, double c, double d) const;

    double mean[4];         //!< x1, y1, x2, y2
    double xx, xy, yy;      //!< of image 1, about the means
    double xu, xv, yu, yv;  //!< x1 x2, x1 y2, y1 x2, y1 y2 about the means
};

}  // namespace usacv20
}  // namespace cv

#endif
