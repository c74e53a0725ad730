// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SELECTION_HPP
#define OPENCV_USACV20_SELECTION_HPP

#include <algorithm>
#include "opencv2/usac/rng.hpp"

namespace cv {
namespace usacv20 {

/** The value at index `rank` after sorting, for few values: the largest value for which at most
`rank` values are smaller. Compares all pairs of values without branches; the branches of sorting
would often be mispredicted. */
template <class T>
T ofRank(int rank, const T* values, int count)
{
    T result = values[0];
    int most = -1;
    for (int i = 0; i < count; ++i)
    {
        int smaller = 0;
        for (int k = 0; k < count; ++k)
            smaller += values[k] < values[i];
        const bool better = smaller <= rank && smaller > most;
        most = better ? smaller : most;
        result = better ? values[i] : result;
    }
    return result;
}

//! The median of `count` > 0 values; if `count` is even, the larger of the two middle values. Can
//! reorder the values.
template <class T>
T median(T* values, int count)
{
    enum { FEW = 32 };  // for which ofRank() takes less time
    if (count <= FEW)
        return ofRank(count / 2, values, count);
    std::nth_element(values, values + count / 2, values + count);
    return values[count / 2];
}

/** Moves `count` random items of a list of `size` items to its front: a partial Fisher-Yates
shuffle. If `count` is not less than `size`, nothing is moved.
@param exchange function that swaps the items at two indices */
template <class Exchange>
void randomPart(int size, int count, Rng& rng, const Exchange& exchange)
{
    for (int i = 0; i < count && count < size; ++i)
        exchange(i, i + rng.uniform(size - i));
}

template <class T>
void randomPart(T* items, int size, int count, Rng& rng)
{
    randomPart(size, count, rng, [items](int i, int k) { std::swap(items[i], items[k]); });
}

}  // namespace usacv20
}  // namespace cv

#endif
