// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/inlier_bits.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Ones of a word, summed side by side in fields of 2, 4 and 8 bits.
int ones(uint64 word)
{
    word -= (word >> 1) & 0x5555555555555555ULL;
    word = (word & 0x3333333333333333ULL) + ((word >> 2) & 0x3333333333333333ULL);
    return (int)((((word + (word >> 4)) & 0x0f0f0f0f0f0f0f0fULL) * 0x0101010101010101ULL) >> 56);
}

}  // namespace

InlierBits::InlierBits() { std::fill(words, words + WORDS, (uint64)0); }

InlierBits::InlierBits(const Context& context, const Model& model, double width)
{
    std::fill(words, words + WORDS, (uint64)0);
    const Correspondences& p = context.points;
    const int looked = std::min<int>(p.size, MOST);
    const float limit = (float)(width * width * p.threshold * p.threshold);
    float errors[MOST];
    context.components.residual->squaredErrors(p, model, 0, looked, errors);
    for (int i = 0; i < looked; ++i)
        words[i / 64] |= (uint64)(errors[i] <= limit) << (i % 64);  // false for NaN
}

int InlierBits::count() const { return without(InlierBits()); }

int InlierBits::without(const InlierBits& others) const
{
    int sum = 0;
    for (int k = 0; k < WORDS; ++k)
        sum += ones(words[k] & ~others.words[k]);
    return sum;
}

}  // namespace usacv20
}  // namespace cv
