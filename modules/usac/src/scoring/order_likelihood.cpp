// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/order_likelihood.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Log-likelihood of `count` flags, of which `ones` are set. The probability that a flag is set is
//! the same for all flags; its maximum-likelihood estimate is used.
double logLikelihood(int ones, int count)
{
    const double share = (double)ones / count;
    return ones == 0 || ones == count
               ? 0
               : count * (share * std::log(share) + (1 - share) * std::log(1 - share));
}

}  // namespace

double orderLogLikelihood(const uchar* inliers, int size, int* blocks, const uchar* ends)
{
    int *const ones = blocks, *const counts = blocks + size;
    int last = -1, all = 0;
    for (int i = 0; i < size; ++i)
    {
        const bool begins = !ends || i == 0 || ends[i - 1];
        if (begins)
        {
            ++last;
            ones[last] = counts[last] = 0;
        }
        ones[last] += inliers[i] != 0;
        ++counts[last];
        all += inliers[i] != 0;
        if (ends && !ends[i] && i + 1 < size)
            continue;
        // merges a block with the block before it unless the inlier ratio of the latter is higher
        for (; last > 0 &&
               (double)ones[last] * counts[last - 1] >= (double)ones[last - 1] * counts[last];
             --last)
        {
            ones[last - 1] += ones[last];
            counts[last - 1] += counts[last];
        }
    }
    double sum = 0;
    for (int k = 0; k <= last; ++k)
        sum += logLikelihood(ones[k], counts[k]);
    return size > 0 ? std::max(sum - logLikelihood(all, size), 0.) : 0;
}

}  // namespace usacv20
}  // namespace cv
