// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BITS_HPP
#define OPENCV_USACV20_BITS_HPP

#include <cstring>
#include "numeric/instruction_set.hpp"

namespace cv {
namespace usacv20 {

//! Number of bits of a word.
constexpr int WORD_BITS = 64;

//! Number of bits of a word that are 1, summed in parallel in fields of 2, 4 and 8 bits.
inline int ones(uint64 word)
{
    word -= (word >> 1) & 0x5555555555555555ULL;
    word = (word & 0x3333333333333333ULL) + ((word >> 2) & 0x3333333333333333ULL);
    return (int)((((word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fULL) * 0x0101010101010101ULL) >> 56);
}

//! Index of the lowest bit that is 1; the word must not be 0.
inline int lowestOne(uint64 word)
{
#ifdef __GNUC__
    return __builtin_ctzll(word);
#else
    return ones((word & (0 - word)) - 1);
#endif
}

/** A word whose bit i is 1 if i < count and errors[i] <= limit, otherwise 0 (also if errors[i] is
NaN); `count` is at most #WORD_BITS. The results of the comparisons are first stored as bytes 0 or
1, which compilers vectorize; then a multiplication gathers eight of these bytes as the bits of the
highest byte. */
inline uint64 within(const float* errors, int count, float limit)
{
#if defined __BYTE_ORDER__ && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    const uint64 gather = 0x8040201008040201ULL;
#else
    const uint64 gather = 0x0102040810204080ULL;
#endif
    uchar flags[WORD_BITS];
    if (count < WORD_BITS)
        std::memset(flags, 0, WORD_BITS);
    if (count == WORD_BITS)  // compilers vectorize this loop, because its length is constant
    {
        USAC_SIMD
        for (int i = 0; i < WORD_BITS; ++i)
            flags[i] = errors[i] <= limit ? 1 : 0;
    }
    else
        for (int i = 0; i < count; ++i)
            flags[i] = errors[i] <= limit ? 1 : 0;
    uint64 word = 0;
    for (int k = 0; k < WORD_BITS; k += 8)
    {
        uint64 eight;
        std::memcpy(&eight, flags + k, 8);
        word |= (eight * gather >> 56) << k;
    }
    return word;
}

//! The first index from `begin` on whose mark is not 0; `end` if there is none. Eight marks are
//! read at a time, for marks that are mostly 0.
inline int nextMarked(const uchar* marks, int begin, int end)
{
    for (uint64 eight; begin + 8 <= end; begin += 8)
    {
        std::memcpy(&eight, marks + begin, 8);
        if (eight)
            break;
    }
    while (begin < end && !marks[begin])
        ++begin;
    return begin;
}

}  // namespace usacv20
}  // namespace cv

#endif
