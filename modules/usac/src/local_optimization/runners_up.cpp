// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/runners_up.hpp"

namespace cv {
namespace usacv20 {

RunnersUp::RunnersUp(int most_) : most(most_), limit(std::numeric_limits<double>::infinity()) {}

void RunnersUp::add(const Candidate& candidate)
{
    if (most == 0 || candidate.quality.cost >= limit)
        return;
    size_t place = kept.size();
    while (place > 0 && candidate.quality.betterThan(kept[place - 1].quality))
        --place;
    kept.insert(kept.begin() + place, candidate);
    if (kept.size() > most)
        kept.pop_back();
    if (kept.size() == most)
        limit = kept.back().quality.cost;
}

void RunnersUp::clear()
{
    kept.clear();
    limit = std::numeric_limits<double>::infinity();
}

std::vector<Candidate> RunnersUp::take()
{
    std::vector<Candidate> taken;
    taken.swap(kept);
    return taken;
}

}  // namespace usacv20
}  // namespace cv
