// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SHARE_A_POINT_HPP
#define OPENCV_USACV20_SHARE_A_POINT_HPP

#include <algorithm>
#include <type_traits>
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! True if two points of an array have the same coordinates.
inline bool samePoint(const Correspondences& p, int array, int i, int j)
{
    const int first = array ? p.coordinates[0] : 0, last = first + p.coordinates[array];
    for (int k = first; k < last; ++k)
        if (p.column[k][i] != p.column[k][j])
            return false;
    return true;
}

//! True if two matches have the same point in at least one array: they are the same match, or at
//! most one of them is right.
inline bool shareAPoint(const Correspondences& p, int i, int j)
{
    return samePoint(p, 0, i, j) || (p.coordinates[1] > 0 && samePoint(p, 1, i, j));
}

//! True if two matches have the same points in both arrays.
inline bool sameMatch(const Correspondences& p, int i, int j)
{
    return samePoint(p, 0, i, j) && samePoint(p, 1, i, j);
}

//! True if `share(i, k)` holds for at least one pair of points i and k of a sample of `m` points.
template <class Share>
inline bool anyPair(const int* sample, int m, const Share& share)
{
    for (int i = 1; i < m; ++i)
        for (int k = 0; k < i; ++k)
            if (share(sample[i], sample[k]))
                return true;
    return false;
}

//! True if two points of a sample of `m` points have the same value in a column. If `m` is a
//! compile-time constant, the loops are unrolled.
template <class Size>
inline bool anyEqual(const float* column, const int* sample, Size m)
{
    float values[MAX_SAMPLE_SIZE];
    bool equal = false;
    for (int i = 0; i < m; ++i)
    {
        values[i] = column[sample[i]];
        for (int k = 0; k < i; ++k)
            equal |= values[i] == values[k];
    }
    return equal;
}

/** Fast preliminary test: false if no two matches of a sample have the same first coordinate in an
array, so that no two matches can share a point of this array. For nearly all samples this test
suffices, and it has no data-dependent branches. */
inline bool mayShareAPoint(const Correspondences& p, int array, const int* sample, int m)
{
    const float* const column = p.column[array ? p.coordinates[0] : 0];
    switch (m)
    {
    case 4: return anyEqual(column, sample, std::integral_constant<int, 4>());
    case 5: return anyEqual(column, sample, std::integral_constant<int, 5>());
    case 7: return anyEqual(column, sample, std::integral_constant<int, 7>());
    default: return anyEqual(column, sample, m);
    }
}

//! True if two matches of a sample share a point, see shareAPoint().
inline bool anyShareAPoint(const Correspondences& p, const int* sample, int m)
{
    return (mayShareAPoint(p, 0, sample, m) ||
            (p.coordinates[1] > 0 && mayShareAPoint(p, 1, sample, m))) &&
           anyPair(sample, m, [&p](int i, int k) { return shareAPoint(p, i, k); });
}

//! True if a sample of `m` matches contains a match twice, but no two different matches that share
//! a point (of which at least one would be wrong).
inline bool onlyRepeats(const Correspondences& p, const int* sample, int m)
{
    return mayShareAPoint(p, 0, sample, m) &&
           anyPair(sample, m, [&p](int i, int k) { return sameMatch(p, i, k); }) &&
           !anyPair(sample, m,
                    [&p](int i, int k) { return shareAPoint(p, i, k) && !sameMatch(p, i, k); });
}

//! Largest plausible ratio between the sizes of a small surface in two images, relative to the
//! ratio of the image sizes. A larger value rejects fewer pairs of matches. See doc/constants.md.
constexpr int FAR_APART = 10;
//! Two points are near, that is, possibly the same up to noise, if their distance is at most
//! NEAR_THRESHOLDS thresholds and at most 1 / NEAR_PART of the image size.
constexpr int NEAR_THRESHOLDS = 2, NEAR_PART = 50;

template <class T>
T square(T x)
{
    return x * x;
}

//! Limits of squared distances in each of the two images (or arrays), for the search for targets: a
//! target is a point to which many different points are matched. Two points are near, that is,
//! possibly the same up to noise, if their squared distance is at most `near`, and far apart if it
//! is above `far`.
struct TargetLimits
{
    /** The limits depend on the image sizes, too, because a threshold can be as large as an image.
    @param threshold threshold of the errors, in the coordinates of the points
    @param sizes extents of the points in the two images, above 0 */
    TargetLimits(double threshold, const float* sizes)
    {
        for (int k = 0; k < 2; ++k)
        {
            const float distance = std::min((float)(NEAR_THRESHOLDS * threshold),
                                            sizes[k] / NEAR_PART);
            near[k] = square(distance);
            far[1 - k] = square(FAR_APART * distance * sizes[1 - k] / sizes[k]);
        }
    }

    float near[2], far[2];
};

/** True if at most one of two different matches can be right: they share a point, or their points
are near in one image and far apart in the other image, see TargetLimits. */
inline bool shareATarget(const Correspondences& p, const TargetLimits& limits, int i, int j)
{
    const float dx1 = p.column[X1][i] - p.column[X1][j], dy1 = p.column[Y1][i] - p.column[Y1][j],
                dx2 = p.column[X2][i] - p.column[X2][j], dy2 = p.column[Y2][i] - p.column[Y2][j];
    const float first = dx1 * dx1 + dy1 * dy1, second = dx2 * dx2 + dy2 * dy2;
    return (first <= limits.near[0] && second > limits.far[1]) ||
           (second <= limits.near[1] && first > limits.far[0]) || shareAPoint(p, i, j);
}

}  // namespace usacv20
}  // namespace cv

#endif
