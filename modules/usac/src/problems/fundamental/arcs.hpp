// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ARCS_HPP
#define OPENCV_USACV20_ARCS_HPP

#include <cmath>

namespace cv {
namespace usacv20 {

//! Sizes for an ArcsKernel. Here, a point is a match off the plane of PlaneParallax, described by
//! ARCS_ROWS numbers. The number of points is padded to a multiple of ARCS_BLOCK. A line is a line
//! of possible epipoles in image 2, described by ARCS_WEIGHTS coefficients and divided into
//! ARCS_BINS bins.
constexpr int ARCS_BLOCK = 16, ARCS_ROWS = 9, ARCS_WEIGHTS = 24, ARCS_BINS = 256;
/** Computes, for each of `stride` points, an arc of a line: if the epipole lies on this arc, the
point is within the threshold. See PlaneParallax and arcs.inl.hpp.
@param rows #ARCS_ROWS rows of `stride` numbers: n (3 rows) and the upper triangle of G (6 rows),
see PlaneParallax::setPlane()
@param stride number of points, a multiple of #ARCS_BLOCK
@param weights #ARCS_WEIGHTS coefficients of the line, see PlaneParallax::vote()
@param from, to output: first and last bin of each arc; `to` is smaller than `from` if the arc
passes the end of the (closed) line; 0 and -1 if the arc is the whole line */
typedef void (*ArcsKernel)(const float* rows, int stride, const float* weights, int* from, int* to);

namespace {  // unnamed: these functions are compiled several times, for different instruction sets

/* Position of the point u + t v, with t = s / c, on the line through the homogeneous points u and
v. This number replaces the angle of the point and needs no arc tangent: t itself if |t| <= 1, else
2 - 1 / t. The positions -1 and 3 are the same point, because the projective line is closed. */
inline float placeOf(float s, float c)
{
    const bool small = fabsf(s) <= fabsf(c);
    const float ratio = (small ? s : c) / (small ? c : s);
    return small ? ratio : 2.f - ratio;
}

//! Bin of a position that placeOf() has returned. NaN gives the first bin.
inline int binOf(float place)
{
    const float bin = (place + 1) * (0.25f * ARCS_BINS);
    const float low = bin > 0 ? bin : 0.f, last = (float)(ARCS_BINS - 1);
    return (int)(low < last ? low : last);
}

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
