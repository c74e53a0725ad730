// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! CODE_BITS: bits of the code of a cell. Four axes have four bits each, for layers with 16, 8, 4
//! and 2 cells per axis as in the program of the authors of @cite barath2019progressive. MOST_BITS:
//! maximum number of bits per axis, a limit that matters only if there is a single axis.
constexpr int CODE_BITS = 16, MOST_BITS = 8;
//! Number of points whose cells are computed together.
constexpr int BLOCK = 256;
//! In the list of points sorted by code, a point is linked to those of the next CELL_LINKS points
//! that are in the same cell of the second layer.
//! doc/measurements/constants_tables.md shows the effects of other values.
constexpr int CELL_LINKS = 3;

/** @brief Multi-layer grid in the joint space of all coordinates, x1, y1, x2, y2 of two views
@cite barath2019progressive.

If there are four axes, the finest layer divides each axis into 16 cells, and the next layers divide
it into 8, 4 and 2. The bits of the four cell numbers are interleaved (Morton code, 16 bits). Thus
the points of a cell of any layer are contiguous in the list of points sorted by code, and one list
serves all layers. With fewer axes there are more layers, because each axis gets more of the 16
bits. Points outside the range Correspondences::lower to upper belong to the outermost cells. The
grid takes O(N) memory and time (radix sort); a query takes O(log N). Edges link each point to the
next #CELL_LINKS points in its cell of the second layer. */
class GridNeighborhood : public Neighborhood
{
public:
    explicit GridNeighborhood(int columns)
        : axes(columns), bits(std::min<int>(CODE_BITS / columns, MOST_BITS)), size(0), codes(0),
          sorted(0), rank(0), sortedCodes(0), links(0)
    {}

    void start(const Context&) CV_OVERRIDE
    {
        codes = 0;
        links = 0;
    }

    int layers() const CV_OVERRIDE { return bits; }

    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        build(context);
        const int shift = axes * layer, cell = codes[point] >> shift;
        // Range of the points of the cell in `sorted`. Both ends move away from the point by steps
        // that double until they leave the cell; then a binary search finds the border.
        int first = rank[point], last = first + 1;
        for (int step = 1; first > 0 && sortedCodes[first - 1] >> shift == cell; step *= 2)
            first = std::max(first - step, 0);
        first = (int)(std::lower_bound(sortedCodes + first, sortedCodes + rank[point],
                                       cell << shift, lessCode) -
                      sortedCodes);
        for (int step = 1; last < size && sortedCodes[last] >> shift == cell; step *= 2)
            last = std::min(last + step, size);
        last = (int)(std::lower_bound(sortedCodes + rank[point], sortedCodes + last,
                                      (cell + 1) << shift, lessCode) -
                     sortedCodes);
        members = sorted + first;
        return last - first;
    }

    int edges(const Context& context, const uchar* wanted, const Vec2i*& edges) CV_OVERRIDE
    {
        build(context);
        if (!links)
            links = context.arena.take<Vec2i>((size_t)size * CELL_LINKS);
        edges = links;
        Arena::Scope scope(context.arena);
        uchar* const wantedAt = scope.take<uchar>(size + CELL_LINKS);  // in the order of `sorted`
        for (int place = 0; place < size; ++place)
            wantedAt[place] = wanted ? wanted[sorted[place]] : 1;
        std::fill(wantedAt + size, wantedAt + size + CELL_LINKS, (uchar)0);
        return link(wantedAt);
    }

    int mostEdges() const CV_OVERRIDE { return 2 * CELL_LINKS; }

private:
    static bool lessCode(ushort code, int value) { return code < value; }

    //! Writes the edges with an endpoint that is wanted. @return their number
    int link(const uchar* wantedAt)
    {
        int found = 0;
        for (int i = 0; i < size; ++i)
        {
            int any = wantedAt[i];
            for (int k = 1; k <= CELL_LINKS; ++k)
                any |= wantedAt[i + k];
            if (!any)
                continue;
            const int end = std::min(i + CELL_LINKS + 1, size), cell = sortedCodes[i] >> axes;
            for (int k = i + 1; k < end && sortedCodes[k] >> axes == cell; ++k)
                if (wantedAt[i] | wantedAt[k])
                    links[found++] = Vec2i(sorted[i], sorted[k]);
        }
        return found;
    }

    //! Moves bit k of v to bit k * step.
    static int spread(int v, int step)
    {
        int result = 0;
        for (int bit = 0; v >> bit; ++bit)
            result |= (v >> bit & 1) << bit * step;
        return result;
    }

    void build(const Context& context)
    {
        if (codes)
            return;
        const Correspondences& points = context.points;
        size = points.size;
        codes = context.arena.take<ushort>(size);
        std::fill(codes, codes + size, (ushort)0);
        ushort* const to = codes;
        const int cells = 1 << bits;
        for (int axis = 0; axis < axes; ++axis)
        {
            ushort codeOf[1 << MOST_BITS];
            for (int cell = 0; cell < cells; ++cell)
                codeOf[cell] = (ushort)(spread(cell, axes) << axis);
            const float low = points.lower[axis], range = points.upper[axis] - low;
            const float scale = range > 0 ? cells / range : 0, last = (float)(cells - 1);
            const float* const values = points.column[axis];
            uchar inCell[BLOCK];
            for (int begin = 0; begin < size; begin += BLOCK)
            {
                const int count = std::min<int>(BLOCK, size - begin);
                for (int i = 0; i < count; ++i)  // compilers can vectorize this loop
                {
                    const float cell = (values[begin + i] - low) * scale,
                                inside = cell > 0 ? cell : 0;
                    inCell[i] = (uchar)(int)(inside < last ? inside : last);
                }
                for (int i = 0; i < count; ++i)
                    to[begin + i] = (ushort)(to[begin + i] | codeOf[inCell[i]]);
            }
        }
        sort(context.arena);
    }

    //! Radix sort by two digits of eight bits; points of equal code keep their order.
    void sort(Arena& arena)
    {
        sorted = arena.take<int>(size);
        rank = arena.take<int>(size);
        sortedCodes = arena.take<ushort>(size);
        Arena::Scope scope(arena);
        int* const byLow = scope.take<int>(size);  // points, sorted by the low digit
        int low[257] = {0}, high[257] = {0};       // start of the points with each digit
        for (int i = 0; i < size; ++i)
        {
            ++low[(codes[i] & 255) + 1];
            ++high[(codes[i] >> 8) + 1];
        }
        for (int d = 0; d < 256; ++d)
        {
            low[d + 1] += low[d];
            high[d + 1] += high[d];
        }
        for (int i = 0; i < size; ++i)
            byLow[low[codes[i] & 255]++] = i;
        for (int k = 0; k < size; ++k)
        {
            const int i = byLow[k], place = high[codes[i] >> 8]++;
            sorted[place] = i;
            sortedCodes[place] = codes[i];
            rank[i] = place;
        }
    }

    const int axes, bits;  //!< number of columns, and of bits per column
    int size;              //!< number of points
    ushort* codes;         //!< code of each point; null: nothing has been built
    int* sorted;           //!< points, sorted by code
    int* rank;             //!< position of each point in `sorted`
    ushort* sortedCodes;   //!< codes of the points in `sorted`
    Vec2i* links;          //!< memory for edges; null: none have been requested yet
};

}  // namespace

Ptr<Neighborhood> createGridNeighborhood(int columns) { return makePtr<GridNeighborhood>(columns); }

}  // namespace usacv20
}  // namespace cv
