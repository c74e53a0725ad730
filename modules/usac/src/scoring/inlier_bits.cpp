// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/bits.hpp"
#include "scoring/inlier_bits.hpp"

namespace cv {
namespace usacv20 {

InlierBits::InlierBits() { std::fill(words, words + WORDS, (uint64)0); }

InlierBits::InlierBits(const Context& context, const Model& model, double width)
{
    std::fill(words, words + WORDS, (uint64)0);
    const Correspondences& p = context.points;
    const int looked = std::min<int>(p.size, MOST);
    const double threshold = width * context.inlierThreshold();
    const float limit = (float)(threshold * threshold);
    float errors[MOST];
    context.components.residual->squaredErrors(p, model, 0, looked, errors);
    for (int i = 0; i < looked; i += WORD_BITS)
        words[i / WORD_BITS] = within(errors + i, std::min(looked - i, (int)WORD_BITS), limit);
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
