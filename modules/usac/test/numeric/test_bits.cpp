// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "numeric/bits.hpp"

namespace opencv_test {
namespace {

TEST(Usac_Bits, ofWords)
{
    RNG rng(1);
    for (int trial = 0; trial < 1000; ++trial)
    {
        uint64 word = 0;
        int expected = 0, lowest = -1;
        const int chance = rng.uniform(1, 64);
        for (int k = WORD_BITS - 1; k >= 0; --k)
            if (rng.uniform(0, 64) < chance)
            {
                word |= (uint64)1 << k;
                ++expected;
                lowest = k;
            }
        EXPECT_EQ(expected, ones(word));
        if (word)
        {
            EXPECT_EQ(lowest, lowestOne(word));
        }
    }
}

TEST(Usac_Bits, within)
{
    RNG rng(2);
    for (int count = 0; count <= WORD_BITS; ++count)
    {
        float errors[WORD_BITS];
        for (int i = 0; i < WORD_BITS; ++i)
            errors[i] = i % 7 == 3 ? std::numeric_limits<float>::quiet_NaN()
                                   : rng.uniform(0.f, 2.f);
        const uint64 word = usacv20::within(errors, count, 1.f);
        for (int i = 0; i < WORD_BITS; ++i)
            EXPECT_EQ(i < count && errors[i] <= 1, (word >> i & 1) != 0) << i << " of " << count;
    }
}

TEST(Usac_Bits, nextMarked)
{
    RNG rng(3);
    for (int size = 0; size <= 40; ++size)
        for (int every = 1; every <= 64; every *= 4)
        {
            std::vector<uchar> marks(size + 1);  // with a mark behind the end
            for (int i = 0; i < size; ++i)
                marks[i] = rng.uniform(0, every) == 0 ? (uchar)(1 << rng.uniform(0, 8)) : 0;
            marks[size] = 1;
            for (int begin = 0; begin <= size; ++begin)
            {
                int expected = begin;
                while (expected < size && !marks[expected])
                    ++expected;
                EXPECT_EQ(expected, nextMarked(marks.data(), begin, size));
            }
        }
}

}  // namespace
}  // namespace opencv_test
