// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"
#include "numeric/bits.hpp"

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
constexpr int CELL_LINKS = 3;

//! The first points of a run, sorted by the codes of their cells.
class SortedCells
{
public:
    SortedCells() : size(0), codes(0), sorted(0), rank(0), sortedCodes(0), capacity(0) {}

    //! Forgets the points, and the memory of the previous run.
    void clear() { size = capacity = 0; }

    //! Sorts the points unless the same number of points is already sorted.
    //! @param bits, axes number of bits of the code for each axis; number of axes
    void build(const Correspondences& points, int bits, int axes, Arena& arena)
    {
        if (size == points.size)
            return;
        size = points.size;
        if (size > capacity)
        {
            capacity = size;
            codes = arena.take<ushort>(size);
            sorted = arena.take<int>(size);
            rank = arena.take<int>(size);
            sortedCodes = arena.take<ushort>(size);
        }
        std::fill(codes, codes + size, (ushort)0);
        for (int axis = 0; axis < axes; ++axis)
            addAxis(points, bits, axes, axis);
        sort(arena);
    }

    int size;             //!< number of points; 0: none are sorted
    ushort* codes;        //!< code of each point
    int* sorted;          //!< points, sorted by code
    int* rank;            //!< position of each point in `sorted`
    ushort* sortedCodes;  //!< codes of the points in `sorted`

private:
    //! Moves bit k of v to bit k * step.
    static int spread(int v, int step)
    {
        int result = 0;
        for (int bit = 0; v >> bit; ++bit)
            result |= (v >> bit & 1) << bit * step;
        return result;
    }

    void addAxis(const Correspondences& points, int bits, int axes, int axis)
    {
        const int cells = 1 << bits;
        ushort* const to = codes;
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
                const float cell = (values[begin + i] - low) * scale, inside = cell > 0 ? cell : 0;
                inCell[i] = (uchar)(int)(inside < last ? inside : last);
            }
            for (int i = 0; i < count; ++i)
                to[begin + i] = (ushort)(to[begin + i] | codeOf[inCell[i]]);
        }
    }

    //! Radix sort by two digits of eight bits; points of equal code keep their order.
    void sort(Arena& arena)
    {
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

    int capacity;  //!< number of points for which there is memory
};

/** @brief Multi-layer grid in the joint space of all coordinates, x1, y1, x2, y2 of two views
@cite barath2019progressive.

If there are four axes, the finest layer divides each axis into 16 cells, and the next layers divide
it into 8, 4 and 2. The bits of the four cell numbers are interleaved (Morton code, 16 bits). Thus
the points of a cell of any layer are contiguous in the list of points sorted by code, and one list
serves all layers. With fewer axes there are more layers, because each axis gets more of the 16
bits. Points outside the range Correspondences::lower to upper belong to the outermost cells. The
grid takes O(N) memory and time (radix sort); a query takes O(log N). Edges link each point to the
next #CELL_LINKS points in its cell of the second layer. Edges between the first points of the run
come from a list of these points alone. */
class GridNeighborhood : public Neighborhood
{
public:
    explicit GridNeighborhood(int columns)
        : axes(columns), bits(std::min<int>(CODE_BITS / columns, MOST_BITS)), links(0), room(0)
    {}

    void start(const Context&) CV_OVERRIDE
    {
        all.clear();
        first.clear();
        room = 0;
    }

    int layers() const CV_OVERRIDE { return bits; }

    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        if (first.size == context.points.size)
            std::swap(all, first);
        all.build(context.points, bits, axes, context.arena);
        const ushort* const codes = all.sortedCodes;
        const int shift = axes * layer, cell = all.codes[point] >> shift, place = all.rank[point];
        // Range of the points of the cell in the sorted list. Both ends move away from the point by
        // steps that double until they leave the cell; then a binary search finds the border.
        int begin = place, end = place + 1;
        for (int step = 1; begin > 0 && codes[begin - 1] >> shift == cell; step *= 2)
            begin = std::max(begin - step, 0);
        begin = (int)(std::lower_bound(codes + begin, codes + place, cell << shift, lessCode) -
                      codes);
        for (int step = 1; end < all.size && codes[end] >> shift == cell; step *= 2)
            end = std::min(end + step, all.size);
        end = (int)(std::lower_bound(codes + place, codes + end, (cell + 1) << shift, lessCode) -
                    codes);
        members = all.sorted + begin;
        return end - begin;
    }

    int edges(const Context& context, const uchar* wanted, const Vec2i*& edges) CV_OVERRIDE
    {
        const int size = context.points.size;
        SortedCells& cells = all.size == size ? all : first;
        cells.build(context.points, bits, axes, context.arena);
        if (size > room)
        {
            room = size;
            links = context.arena.take<Vec2i>((size_t)size * CELL_LINKS);
        }
        edges = links;
        Arena::Scope scope(context.arena);
        const int words = (size + WORD_BITS - 1) / WORD_BITS;
        uint64* const wantedAt = scope.take<uint64>(words);  // a bit for each place in the list
        std::fill(wantedAt, wantedAt + words, (uint64)(wanted ? 0 : -1));
        for (int i = wanted ? nextMarked(wanted, 0, size) : size; i < size;
             i = nextMarked(wanted, i + 1, size))
            wantedAt[cells.rank[i] / WORD_BITS] |= (uint64)1 << cells.rank[i] % WORD_BITS;
        return link(cells, wantedAt);
    }

    int mostEdges() const CV_OVERRIDE { return 2 * CELL_LINKS; }
    bool edgesOfFirstPoints() const CV_OVERRIDE { return true; }

private:
    static bool lessCode(ushort code, int value) { return code < value; }

    //! Writes the edges with an endpoint that is wanted, in the order of their first places.
    //! @param wantedAt bits of the places of the wanted points
    //! @return number of edges
    int link(const SortedCells& cells, const uint64* wantedAt)
    {
        const auto isWanted = [wantedAt](int place) {
            return wantedAt[place / WORD_BITS] >> place % WORD_BITS & 1;
        };
        const int *const sorted = cells.sorted, size = cells.size;
        const ushort* const codes = cells.sortedCodes;
        Vec2i* to = links;
        for (int w = 0, next = 0; w * WORD_BITS < size; ++w)
            for (uint64 word = wantedAt[w]; word; word &= word - 1)
            {
                const int place = w * WORD_BITS + lowestOne(word), last = std::min(place, size - 1);
                for (int i = std::max(next, place - CELL_LINKS); i <= last; ++i)
                {
                    const int end = std::min(i + CELL_LINKS + 1, size), cell = codes[i] >> axes;
                    for (int k = i + 1; k < end && codes[k] >> axes == cell; ++k)
                        if (isWanted(i) | isWanted(k))
                            *to++ = Vec2i(sorted[i], sorted[k]);
                }
                next = place + 1;
            }
        return (int)(to - links);
    }

    const int axes, bits;  //!< number of columns, and of bits per column
    SortedCells all;       //!< all points of the run
    SortedCells first;     //!< the first points of the run
    Vec2i* links;          //!< memory for edges
    int room;              //!< number of points for which `links` has room
};

}  // namespace

Ptr<Neighborhood> createGridNeighborhood(int columns) { return makePtr<GridNeighborhood>(columns); }

}  // namespace usacv20
}  // namespace cv
