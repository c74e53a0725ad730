// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "ordering/repeated_last.hpp"

namespace cv {
namespace usacv20 {

namespace {

uint64 hashOf(const Correspondences& p, int i)
{
    const float values[4] = {p.x1[i], p.y1[i], p.x2[i], p.y2[i]};
    uint64 words[2];
    std::memcpy(words, values, sizeof(words));
    uint64 h = words[0] * 0x9e3779b97f4a7c15ULL;
    h = (h ^ (h >> 32) ^ words[1]) * 0xbf58476d1ce4e5b9ULL;
    return h >> 32;
}

bool same(const Correspondences& p, int i, int k)
{
    return p.x1[i] == p.x1[k] && p.y1[i] == p.y1[k] && p.x2[i] == p.x2[k] && p.y2[i] == p.y2[k];
}

}  // namespace

void repeatedLast(const Correspondences& points, std::vector<int>& order)
{
    int mask = 1;
    while (mask < 2 * (int)order.size())
        mask *= 2;
    std::vector<int> table(mask, -1), repeated;
    --mask;
    size_t kept = 0;
    for (size_t i = 0; i < order.size(); ++i)
    {
        const int point = order[i];
        int at = (int)hashOf(points, point) & mask;
        while (table[at] >= 0 && !same(points, table[at], point))
            at = (at + 1) & mask;
        if (table[at] >= 0)
        {
            repeated.push_back(point);
            continue;
        }
        table[at] = point;
        order[kept++] = point;
    }
    std::copy(repeated.begin(), repeated.end(), order.begin() + kept);
}

}  // namespace usacv20
}  // namespace cv
