// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** @brief Multi-layer grid in the joint space of all coordinates, x1, y1, x2, y2 of two views @cite
barath2019progressive.

The finest layer divides each of four axes into 16 cells, the next ones into 8, 4 and 2. With the bits of the four cell
numbers interleaved (Morton's code, 16 bits), the points of a cell of any layer are neighbors in the sorted list of
codes: one sorted list serves all layers. Less axes have more layers, as the code has 16 bits. Points outside the range
where nearly all points lie fall into the outermost cells. O(N) memory and time (radix sort), O(log N) a query; edges
link each point to the next #LINKS in its cell. */
class GridNeighborhood : public Neighborhood
{
public:
    explicit GridNeighborhood(int columns) : axes(columns), bits(std::min<int>(CODE_BITS / columns, MOST_BITS)) {}

    int layers() const CV_OVERRIDE { return bits; }

    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        build(context.points);
        const int shift = axes * layer, cell = codes[point] >> shift, size = (int)sorted.size();
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
                    if (sortedCodes[i] >> axes == sortedCodes[i + k] >> axes)
                        links.push_back(Vec2i(sorted[i], sorted[i + k]));
        }
        return links;
    }

private:
    enum { CODE_BITS = 16, MOST_BITS = 8, LINKS = 3 };

    static bool lessCode(ushort code, int value) { return code < value; }

    //! Puts the bits of v at multiples of `step`.
    static int spread(int v, int step)
    {
        int result = 0;
        for (int bit = 0; v >> bit; ++bit)
            result |= (v >> bit & 1) << bit * step;
        return result;
    }

    void build(const Correspondences& points)
    {
        if (!codes.empty() || points.size == 0)
            return;
        codes.assign(points.size, 0);
        ushort* const to = codes.data();
        const int cells = 1 << bits;
        for (int axis = 0; axis < axes; ++axis)
        {
            ushort codeOf[1 << MOST_BITS];
            for (int cell = 0; cell < cells; ++cell)
                codeOf[cell] = (ushort)(spread(cell, axes) << axis);
            const float low = points.lower[axis], range = points.upper[axis] - low;
            const float scale = range > 0 ? cells / range : 0, last = (float)(cells - 1);
            const float* const values = points.column[axis];
            for (int i = 0; i < points.size; ++i)
            {
                const float cell = (values[i] - low) * scale, inside = cell > 0 ? cell : 0;
                to[i] = (ushort)(to[i] | codeOf[(int)(inside < last ? inside : last)]);
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

    const int axes, bits;             //!< numbers of columns, and of bits of a cell's number on each
    std::vector<ushort> codes;        //!< of each point
    std::vector<int> sorted;          //!< points by code
    std::vector<int> rank;            //!< of each point in `sorted`
    std::vector<ushort> sortedCodes;  //!< their codes
    std::vector<Vec2i> links;
};

}  // namespace

Ptr<Neighborhood> createGridNeighborhood(int columns) { return makePtr<GridNeighborhood>(columns); }

}  // namespace usacv20
}  // namespace cv
