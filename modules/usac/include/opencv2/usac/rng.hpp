// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RNG_HPP
#define OPENCV_USACV20_RNG_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @brief Counter-based pseudo-random generator: the k-th number of a stream depends only on seed,
stream and k.

The output function is the finalizer of SplitMix64 @cite steele2014splittable. Each iteration of a
search has its own stream, so that its sample does not depend on the number of threads or on other
draws. */
class Rng
{
public:
    //! Starts at the beginning of a stream.
    explicit Rng(uint64 seed = 0, uint64 stream = 0) : key(mix(seed + mix(stream))), counter(0) {}

    //! 32 uniformly distributed bits.
    unsigned next() { return (unsigned)(mix(key + 0x9e3779b97f4a7c15ULL * ++counter) >> 32); }
    //! Uniform in 0 .. n-1, n > 0.
    int uniform(int n) { return (int)(((uint64)next() * (unsigned)n) >> 32); }
    //! Writes `count` distinct numbers in 0 .. n-1, where count <= n. Compares all pairs; `count`
    //! should therefore be small, such as the size of a sample.
    void distinct(int n, int count, int* out)
    {
        for (int i = 0; i < count;)
        {
            out[i] = uniform(n);
            int j = 0;
            while (out[j] != out[i])
                ++j;
            i += j == i;
        }
    }

private:
    static uint64 mix(uint64 z)
    {
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    uint64 key, counter;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
