// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/runners_up.hpp"
#include "numeric/bits.hpp"

namespace cv {
namespace usacv20 {

namespace {

bool before(const RunnerUp& a, const RunnerUp& b)
{
    return a.unexplained > b.unexplained ||
           (a.unexplained == b.unexplained && a.candidate.quality.betterThan(b.candidate.quality));
}

RunnerUp* make(Arena& arena, int count)
{
    RunnerUp* const result = arena.take<RunnerUp>(count);
    for (int i = 0; i < count; ++i)
        new (result + i) RunnerUp();
    return result;
}

}  // namespace

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

RunnersUp::RunnersUp(int most_, Arena& arena_)
    : most(most_), kept(0), given(0), count(0), unexplainedBefore(0), arena(arena_)
{}

void RunnersUp::insert(const RunnerUp& item)
{
    int place = count;
    for (; place > 0 && before(item, kept[place - 1]); --place)
        kept[place] = kept[place - 1];
    kept[place] = item;
    count = std::min(count + 1, most);
}

void RunnersUp::add(const Candidate& candidate, const InlierBits& inliers)
{
    if (most == 0)
        return;
    if (!kept)
    {
        kept = make(arena, most + 1);
        given = make(arena, most + 1);
    }
    const RunnerUp item = {candidate, inliers, inliers.without(known)};
    if (count < most || before(item, kept[most - 1]))
        insert(item);
}

void RunnersUp::setBest(const InlierBits& inliers)
{
    known = inliers;
    const int all = count;
    count = 0;
    for (int i = 0; i < all; ++i)
    {
        RunnerUp item = kept[i];
        item.unexplained = item.inliers.without(known);
        insert(item);
    }
}

int RunnersUp::take(const RunnerUp*& taken)
{
    unexplainedBefore = mostUnexplained();
    std::swap(kept, given);
    taken = given;
    const int all = count;
    count = 0;
    return all;
}

void RunnersUp::clear() { count = 0; }

}  // namespace usacv20
}  // namespace cv
