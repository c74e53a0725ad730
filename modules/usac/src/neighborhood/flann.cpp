// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"
#include "opencv2/flann.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Layers, each twice as wide as the one before; most neighbors that are kept unless the caller
//! asks for more. Half, double: H of some pairs changes with the layers, nothing else; see
//! doc/constants.md.
constexpr int LAYERS = 4, WIDEST = 512;
//! Most edges of a point to others. 4: time -18 to -23 %, errors of F +3 %; 16: time +8 to +10 %.
constexpr int LINKS = 8;

//! Tests of a point, as Watch counts them: of the tree and of the order of the edges for each point
//! and edge, of a search. Half, double: as those of Watch.
constexpr double BUILD_WORK = 300, SORT_WORK = 60, FIND_WORK = 2000;

typedef cvflann::L2<float> SquaredDistance;
typedef cvflann::KDTreeSingleIndex<SquaredDistance> KdTree;  // exact, without random numbers

//! Squared distance and index of a point.
typedef std::pair<float, int> Found;

//! The nearest points within a radius, at most `capacity` of them, in a heap. FLANN's sets have no
//! such bound, or no radius.
class NearestWithin : public cvflann::ResultSet<float>
{
public:
    NearestWithin(int capacity_, float squaredRadius, std::vector<Found>& found_)
        : capacity(capacity_), beyond(std::nextafter(squaredRadius, FLT_MAX)), found(found_)
    {
        found.clear();
    }

    bool full() const CV_OVERRIDE { return found.size() == capacity; }
    float worstDist() const CV_OVERRIDE
    {
        return full() ? std::min(found.front().first, beyond) : beyond;
    }

    void addPoint(float distance, int index) CV_OVERRIDE
    {
        if (!(distance < worstDist()))
            return;
        if (full())
        {
            std::pop_heap(found.begin(), found.end());
            found.pop_back();
        }
        found.push_back(Found(distance, index));
        std::push_heap(found.begin(), found.end());
    }

private:
    const size_t capacity;
    const float beyond;
    std::vector<Found>& found;
};

//! What a layer contains of the surroundings of a point.
struct Reach
{
    int neighbors;         //!< at most, nearest first
    double squaredRadius;  //!< pixels
};

/** @brief Nearest neighbors in the joint space of all coordinates (x1, y1, x2, y2 of two views) in
pixels, by an exact kd-tree of cv::flann. Where the arrays have no common unit (Problem::commonUnit;
a pose) in that of the last one.

Each of the #LAYERS layers reaches twice as far as the one before: the layers of k nearest neighbors
have k, 2 k, 4 k and 8 k of them, those of a radius r have the points within r, 2 r, 4 r and 8 r.
P-NAPSAC needs layers that grow, as it asks for ever more members; the finest one is what the
parameters say. The graph cut uses that one, NAPSAC the coarsest. More than #WIDEST neighbors are
kept only if k itself is larger; of more points within a radius, the nearest ones. So memory is O(N)
whatever the radius. Edges link each point to its nearest neighbors in the finest layer, at most
#LINKS of them: with more, the spatial coherence would outweigh the error of a point.

The tree is built at first use in O(N log N); neighbors are looked for when a point is asked about
for the first time, in O(log N) each, as samplers see but few of many points. */
class FlannNeighborhood : public Neighborhood
{
public:
    explicit FlannNeighborhood(const Reach* reach_)
        : coordinates(0), columns(0), size(0), known(0), links(0), linkCount(0)
    {
        std::copy(reach_, reach_ + LAYERS, reach);
    }

    void start(const Context&) CV_OVERRIDE
    {
        tree.release();
        links = 0;
    }

    int layers() const CV_OVERRIDE { return LAYERS; }

    int members(const Context& context, int layer, int point, const int*& members) CV_OVERRIDE
    {
        if (!build(context))
            return alone(context, point, members);
        Surroundings& around = known[point];
        if (around.layers <= layer)
        {
            find(point, reach[layer]);
            around.layers = layer + 1;
            around.members = context.arena.take<int>(found.size());
            for (size_t i = 0; i < found.size(); ++i)
                around.members[i] = found[i].second;
            for (int l = 0; l <= layer; ++l)
                around.counts[l] = countWithin(reach[l]);
        }
        members = around.members;
        return around.counts[layer];
    }

    int edges(const Context& context, const Vec2i*& edges) CV_OVERRIDE
    {
        if (!build(context))
            return 0;
        if (!links)
            link(context);
        edges = links;
        return linkCount;
    }

private:
    //! What is known about a point.
    struct Surroundings
    {
        int* members;        //!< the point itself, then its neighbors, nearest first
        int layers;          //!< how many have been asked for
        int counts[LAYERS];  //!< members of each of them
    };

    static bool isLess(const Vec2i& a, const Vec2i& b)
    {
        return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
    }

    //! The point without its neighbors: the run has to end.
    static int alone(const Context& context, int point, const int*& members)
    {
        int* const one = context.arena.take<int>(1);
        *one = point;
        members = one;
        return 1;
    }

    //! Of the first points, if the run has to end meanwhile.
    void link(const Context& context)
    {
        const Reach nearest = {std::min<int>(reach[0].neighbors, LINKS), reach[0].squaredRadius};
        links = context.arena.take<Vec2i>((size_t)size * LINKS);
        Vec2i* end = links;
        for (int i = 0; i < size && !context.stop(FIND_WORK); ++i)
        {
            find(i, nearest);
            const int count = countWithin(nearest);
            for (int k = 1; k < count; ++k)
                *end++ = Vec2i(std::min(i, found[k].second), std::max(i, found[k].second));
        }
        if (context.stopBefore((end - links) * SORT_WORK))
            end = links;
        std::sort(links, end, isLess);
        linkCount = (int)(std::unique(links, end) - links);
    }

    //! @return false if the run has to end before there is a tree
    bool build(const Context& context)
    {
        const Correspondences& p = context.points;
        size = p.size;
        if (tree || size == 0)
            return true;
        if (context.stopBefore(size * BUILD_WORK))
            return false;
        // internal units of a pixel; E: of a pixel of a camera with the mean focal length
        const double unit2 = p.threshold / (context.params.threshold * context.params.reach),
                     unit1 = unit2 * p.frame[0].scale / p.frame[1].scale;
        const double LARGEST = 1e18;  // its square is a float
        const int first = p.problem->commonUnit() || p.coordinates[1] == 0 ? 0 : p.coordinates[0];
        columns = p.columns() - first;
        coordinates = context.arena.take<float>((size_t)columns * size);
        for (int i = 0; i < size; ++i)
            for (int k = 0; k < columns; ++k)
            {
                const double value = p.exact[first + k][i] /
                                     (first + k < p.coordinates[0] ? unit1 : unit2);
                coordinates[(size_t)columns * i + k] = (float)std::max(-LARGEST,
                                                                       std::min(value, LARGEST));
            }
        known = context.arena.take<Surroundings>(size);
        std::fill(known, known + size, Surroundings());
        const cvflann::Matrix<float> rows(coordinates, size, columns);
        tree = makePtr<KdTree>(rows, cvflann::KDTreeSingleIndexParams());
        tree->buildIndex();
        return true;
    }

    //! Writes the point itself and then its neighbors, sorted, to `found`.
    void find(int point, const Reach& wanted)
    {
        const int capacity = (int)std::min<int64>((int64)wanted.neighbors + 1, size);
        NearestWithin result(capacity, (float)std::min<double>(wanted.squaredRadius, FLT_MAX),
                             found);
        tree->findNeighbors(result, coordinates + (size_t)columns * point, exact);
        std::sort(found.begin(), found.end());
        size_t self = 0;  // which many equal points may have kept out
        while (self + 1 < found.size() && found[self].second != point)
            ++self;
        found[self] = Found(0.f, point);
        std::rotate(found.begin(), found.begin() + self, found.begin() + self + 1);
    }

    int countWithin(const Reach& wanted) const
    {
        int count = 1;
        while (count < (int)found.size() && count <= wanted.neighbors &&
               found[count].first <= wanted.squaredRadius)
            ++count;
        return count;
    }

    Reach reach[LAYERS];
    float* coordinates;  //!< pixels, one point a row
    int columns;         //!< of a row
    int size;            //!< points
    Ptr<KdTree> tree;
    const cvflann::SearchParams exact;
    Surroundings* known;  //!< of each point
    std::vector<Found>
        found;     //!< by the last search; keeps its memory, bounded by the members of a point
    Vec2i* links;  //!< null: nobody has asked for them
    int linkCount;
};

}  // namespace

Ptr<Neighborhood> createKnnNeighborhood(int neighbors)
{
    Reach reach[LAYERS];
    for (int layer = 0; layer < LAYERS; ++layer)
    {
        reach[layer].neighbors = std::max(neighbors, std::min<int>(neighbors << layer, WIDEST));
        reach[layer].squaredRadius = DBL_MAX;
    }
    return makePtr<FlannNeighborhood>(reach);
}

Ptr<Neighborhood> createRadiusNeighborhood(double radius)
{
    Reach reach[LAYERS];
    for (int layer = 0; layer < LAYERS; ++layer)
    {
        reach[layer].neighbors = WIDEST;
        reach[layer].squaredRadius = radius * radius * (1 << 2 * layer);
    }
    return makePtr<FlannNeighborhood>(reach);
}

}  // namespace usacv20
}  // namespace cv
