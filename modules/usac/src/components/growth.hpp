// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GROWTH_HPP
#define OPENCV_USACV20_GROWTH_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief The growth of PROSAC's set of the best points @cite chum2005matching.

A sample has m points. Of T_N uniform samples of all N points, T_n = T_N prod_{i<m} (n - i)/(N - i)
consist, on average, only of the n best points; T_N is 200 000, or the number of different samples
if this number is smaller. The set grows from n to n + 1 points after T'_n samples, with T'_{n+1} =
T'_n + ceil(T_{n+1} - T_n). */
class Growth
{
public:
    Growth(int sampleSize, int pointCount);

    //! Adds the next best point to the set.
    void grow();
    //! Number n of points in the set.
    int size() const { return n; }
    //! T'_n: number of samples after which the set grows to n + 1 points.
    double samples() const { return limit; }
    //! T_n. The first T'_n samples contain, on average, at least as many all-inlier samples as T_n
    //! uniform samples of the n best points.
    double uniformSamples() const { return expected; }

private:
    int m, n;
    double expected;  //!< T_n
    double limit;     //!< T'_n
};

//! The growing set of the best points, for a sequence of samples.
class GrowingSet
{
public:
    //! An empty set.
    GrowingSet() : growth(0, 1), total(0), drawn(0) {}
    GrowingSet(int sampleSize, int pointCount)
        : growth(sampleSize, pointCount), total(pointCount), drawn(0)
    {}

    //! Moves on to the next sample.
    void next();
    //! Number n of best points that the current sample is drawn from.
    int size() const { return growth.size(); }
    //! True if the current sample must contain the n-th best point, which was added last.
    bool newest() const { return drawn <= growth.samples() && growth.size() < total; }

private:
    Growth growth;
    int total;
    double drawn;  //!< number of samples including the current sample; t in the paper
};

//! True if the order of the points is known from scores or from the caller; false if the order is
//! guessed from the points, or if there is no ordering.
inline bool orderIsKnown(const Context& context)
{
    const Ptr<Ordering>& ordering = context.components.ordering;
    return ordering && ordering->informative(context);
}

}  // namespace usacv20
}  // namespace cv

#endif
