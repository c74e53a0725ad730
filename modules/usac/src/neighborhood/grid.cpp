// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Multi-layer grid in the joint space of the coordinates (x1, y1, x2, y2) @cite barath2019progressive.

The finest layer divides each of the four axes into 16 cells, the next ones into 8, 4 and 2. With the bits of the four
cell numbers interleaved (Morton's code, 16 bits), the points of a cell of any layer are neighbors in the sorted list of
codes: one sorted list serves all layers. Points outside the range where nearly all points lie fall into the outermost
cells. O(N) memory and time (radix sort), O(log N) a query; edges link each point to the next #LINKS in its cell. */
class GridNeighborhood : public Neighborhood
{
public:
    int layers() const CV_OVERRIDE { return LAYERS; }

    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        build(context.points);
        const int shift = 4 * layer, cell = codes[point] >> shift, size = (int)sorted.size();
        int first = rank[point], last = first + 1;  // in the cell; bounds double their distance until they are outside
        for (int step = 1; first > 0 && sortedCodes[first - 1] >> shift == cell; step *= 2)
            first = std::max(first - step, 0);
        first = (int)(std::lower_bound(sortedCodes.begin() + first, sortedCodes.begin() + rank[point], cell << shift,
                                       lessCode) -
                      sortedCodes.begin());
        for (int step = 1; last < size && sortedCodes[last] >> shift == cell; step *= 2)
            last = std::min(last + step, size);
        last = (int)(std::lower_bound(sortedCodes.begin() + rank[point], sortedCodes.begin() + last,
                                      (cell + 1) << shift, lessCode) -
                     sortedCodes.begin());
        members = sorted.data() + first;
        return last - first;
    }

    const std::vector<Vec2i>& edges(const Context& context) CV_OVERRIDE
    {
        build(context.points);
        const int size = (int)sorted.size();
        if (links.empty() && size > 1)
        {
            links.reserve((size_t)size * LINKS);
            for (int i = 0; i < size; ++i)
                for (int k = 1; k <= LINKS && i + k < size; ++k)
                    if (sortedCodes[i] >> LINK_SHIFT == sortedCodes[i + k] >> LINK_SHIFT)
                        links.push_back(Vec2i(sorted[i], sorted[i + k]));
        }
        return links;
    }

private:
    enum { LAYERS = 4, BITS = 4, LINKS = 3, LINK_SHIFT = 4 };

    static bool lessCode(ushort code, int value) { return code < value; }

    //! Puts the four bits of v at the places 0, 4, 8 and 12.
    static int spread(int v) { return (v & 1) | (v & 2) << 3 | (v & 4) << 6 | (v & 8) << 9; }

    void build(const Correspondences& points)
    {
        if (!codes.empty() || points.size == 0)
            return;
        codes.assign(points.size, 0);
        ushort* const to = codes.data();
        const float* coordinates[4] = {points.x1, points.y1, points.x2, points.y2};
        for (int axis = 0; axis < 4; ++axis)
        {
            const float low = points.lower[axis], range = points.upper[axis] - low;
            const float scale = range > 0 ? (1 << BITS) / range : 0;
            for (int i = 0; i < points.size; ++i)
            {
                const float last = (1 << BITS) - 1, cell = (coordinates[axis][i] - low) * scale,
                            inside = cell > 0 ? cell : 0;
                to[i] = (ushort)(to[i] | spread((int)(inside < last ? inside : last)) << axis);
            }
        }
        sort();
    }

    //! Radix sort by two digits of eight bits; points of equal code stay in their order.
    void sort()
    {
        const int size = (int)codes.size();
        std::vector<int> half(size);
        sorted.resize(size);
        for (int i = 0; i < size; ++i)
            sorted[i] = i;
        for (int shift = 0; shift < 16; shift += 8)
        {
            int start[257] = {0};
            for (int i = 0; i < size; ++i)
                ++start[((codes[i] >> shift) & 255) + 1];
            for (int d = 0; d < 256; ++d)
                start[d + 1] += start[d];
            for (int i = 0; i < size; ++i)
                half[start[(codes[sorted[i]] >> shift) & 255]++] = sorted[i];
            sorted.swap(half);
        }
        sortedCodes.resize(size);
        rank.resize(size);
        for (int i = 0; i < size; ++i)
        {
            sortedCodes[i] = codes[sorted[i]];
            rank[sorted[i]] = i;
        }
    }

    std::vector<ushort> codes;        //!< of each point
    std::vector<int> sorted;          //!< points by code
    std::vector<int> rank;            //!< of each point in `sorted`
    std::vector<ushort> sortedCodes;  //!< their codes
    std::vector<Vec2i> links;
};

}  // namespace

Ptr<Neighborhood> createGridNeighborhood() { return makePtr<GridNeighborhood>(); }

}  // namespace usacv20
}  // namespace cv
