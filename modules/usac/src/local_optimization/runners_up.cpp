// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/runners_up.hpp"

namespace cv {
namespace usacv20 {

RunnersUp::RunnersUp(int most_, Arena& arena)
    : most(most_), limit(std::numeric_limits<double>::infinity()), kept(arena.take<Candidate>(most + 1)), count(0)
{
    for (int i = 0; i <= most; ++i)
        new (kept + i) Candidate();
}

void RunnersUp::add(const Candidate& candidate)
{
    if (most == 0 || candidate.quality.cost >= limit)
        return;
    int place = count;
    for (; place > 0 && candidate.quality.betterThan(kept[place - 1].quality); --place)
        kept[place] = kept[place - 1];
    kept[place] = candidate;
    count = std::min(count + 1, most);
    if (count == most)
        limit = kept[most - 1].quality.cost;
}

void RunnersUp::clear()
{
    count = 0;
    limit = std::numeric_limits<double>::infinity();
}

int RunnersUp::take(const Candidate*& candidates)
{
    const int taken = count;
    candidates = kept;
    count = 0;
    return taken;
}

}  // namespace usacv20
}  // namespace cv
