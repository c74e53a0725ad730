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

//! True if two matches are the same.
inline bool sameMatch(const Correspondences& p, int i, int j)
{
    return samePoint(p, 0, i, j) && samePoint(p, 1, i, j);
}

//! True if `share(i, k)` holds for at least one pair of points i and k of a sample of m.
template <class Share>
inline bool anyPair(const int* sample, int m, const Share& share)
{
    for (int i = 1; i < m; ++i)
        for (int k = 0; k < i; ++k)
            if (share(sample[i], sample[k]))
                return true;
    return false;
}

//! True if two points of a sample of m have the same value in a column. `m` may be a compile-time
//! constant, so that the loops are unrolled.
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

/** Fast first test: false if no two matches of a sample have the same first coordinate in an array,
so that they share no point of it. It settles nearly all samples without data-dependent branches. */
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

//! True if a sample of m contains a match twice, and no two different matches share a point (one of
//! the two would be wrong).
inline bool onlyRepeats(const Correspondences& p, const int* sample, int m)
{
    return mayShareAPoint(p, 0, sample, m) &&
           anyPair(sample, m, [&p](int i, int k) { return sameMatch(p, i, k); }) &&
           !anyPair(sample, m,
                    [&p](int i, int k) { return shareAPoint(p, i, k) && !sameMatch(p, i, k); });
}

//! Upper bound of the scale between two images of a small surface, divided by the ratio of the
//! image sizes. See doc/constants.md.
constexpr int FAR_APART = 10;
//! Points that are at most NEAR_THRESHOLDS thresholds apart, and at most 1 / NEAR_PART of the
//! image, may be the same point up to noise.
constexpr int NEAR_THRESHOLDS = 2, NEAR_PART = 50;

template <class T>
T square(T x)
{
    return x * x;
}

//! Squared distances in the two images below which two points may be the same up to noise, and
//! above which they are far apart.
struct TargetLimits
{
    /** Points are near if they are within two thresholds and within a fiftieth of the image: a
    threshold may be as large as an image.
    @param threshold of the errors
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

/** True if two matches share a point; or if their points in one image are the same up to noise, but
in the other image more than FAR_APART times as far apart: at most one of the matches is right. */
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
