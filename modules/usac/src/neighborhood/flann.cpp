// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "neighborhood/neighborhood.hpp"
#include "opencv2/flann.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! LAYERS: number of layers; each is twice as wide as the previous one. WIDEST: maximum number of
//! neighbors stored per point, unless the caller asks for more.
constexpr int LAYERS = 4, WIDEST = 512;
//! Maximum number of edges from a point to its nearest neighbors.
constexpr int TREE_LINKS = 8;

//! Estimated work in point tests, the unit of Watch: to build the tree (per point), to sort the
//! edges (per edge), and to find the neighbors of one point. The values affect only how late a run
//! with a time limit ends.
constexpr double BUILD_WORK = 300, SORT_WORK = 60, FIND_WORK = 2000;

typedef cvflann::L2<float> SquaredDistance;
typedef cvflann::KDTreeSingleIndex<SquaredDistance> KdTree;  // exact, not randomized

//! Squared distance and index of a point.
typedef std::pair<float, int> Found;

//! Collects the nearest points within a radius, at most `capacity` of them, in a heap. The usable
//! result sets of FLANN limit either the radius or the number of points: KNNRadiusUniqueResultSet,
//! which limits both, does not compile.
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

//! Limits that define which neighbors of a point a layer contains.
struct Reach
{
    int neighbors;         //!< maximum number of neighbors; the nearest neighbors are used
    double squaredRadius;  //!< largest squared distance, in squared pixels
};

/** @brief Nearest neighbors in the joint space of all coordinates (x1, y1, x2, y2 of two views) in
pixels (3-D motions: in the caller's unit), found with an exact kd-tree of cv::flann. If the two
arrays have no common unit (Problem::commonUnit, as for an absolute pose), only the coordinates of
the second array are used.

Each of the #LAYERS layers is twice as wide as the previous one: for k nearest neighbors, the layers
have k, 2 k, 4 k and 8 k neighbors; for a radius r, they have the points within r, 2 r, 4 r and 8 r.
P-NAPSAC needs several layers, because it samples from larger and larger neighborhoods of a point.
The caller's k or r is that of the finest layer, which the graph cut uses; NAPSAC uses the coarsest
layer. At most #WIDEST neighbors of a point are stored, or k if k is larger, so that memory is O(N)
for any radius. Edges link each point to at most #TREE_LINKS nearest neighbors in the finest layer:
with more edges, the graph cut would give the labels of neighbors more weight than the error of the
point itself.

The tree is built at its first use in O(N log N). The neighbors of a point are searched in O(log N)
when they are first requested, and again for a wider layer. They are not searched in advance,
because samplers use only some points. */
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

    int edges(const Context& context, const uchar*, const Vec2i*& edges) CV_OVERRIDE
    {
        if (!build(context))
            return 0;
        if (!links)
            link(context);
        edges = links;
        return linkCount;
    }

private:
    //! Neighbors of a point that have been found so far.
    struct Surroundings
    {
        int* members;        //!< the point itself, then its neighbors by increasing distance
        int layers;          //!< number of layers that have been searched, from the finest one on
        int counts[LAYERS];  //!< number of elements of `members` in each of these layers
    };

    static bool isLess(const Vec2i& a, const Vec2i& b)
    {
        return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]);
    }

    //! Returns only the point itself. Used if the run must end before the tree is built.
    static int alone(const Context& context, int point, const int*& members)
    {
        int* const one = context.arena.take<int>(1);
        *one = point;
        members = one;
        return 1;
    }

    //! Creates the edges. If the run must end before all edges are found and sorted, only the first
    //! points have edges, or there are no edges.
    void link(const Context& context)
    {
        const Reach nearest = {std::min<int>(reach[0].neighbors, TREE_LINKS),
                               reach[0].squaredRadius};
        links = context.arena.take<Vec2i>((size_t)size * TREE_LINKS);
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

    //! Builds the tree unless it exists. @return false if the run must end before it can be built
    bool build(const Context& context)
    {
        const Correspondences& p = context.points;
        size = p.size;
        if (tree || size == 0)
            return true;
        if (context.stopBefore(size * BUILD_WORK))
            return false;
        const double unit2 = p.unit / p.meanSigma,
                     unit1 = unit2 * p.frame[0].scale / p.frame[1].scale;
        const double LARGEST = 1e18;  // its square fits into a float
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

    //! Writes the point itself and then its neighbors, sorted by distance, to `found`.
    void find(int point, const Reach& wanted)
    {
        const int capacity = (int)std::min<int64>((int64)wanted.neighbors + 1, size);
        NearestWithin result(capacity, (float)std::min<double>(wanted.squaredRadius, FLT_MAX),
                             found);
        tree->findNeighbors(result, coordinates + (size_t)columns * point, exact);
        std::sort(found.begin(), found.end());
        size_t self = 0;  // index of the point itself; above 0 if equal points come before it
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
    float* coordinates;  //!< coordinates in pixels, one row per point
    int columns;         //!< number of coordinates per point
    int size;            //!< number of points
    Ptr<KdTree> tree;
    const cvflann::SearchParams exact;
    Surroundings* known;       //!< neighbors of each point
    std::vector<Found> found;  //!< result of the last search; a member to reuse its memory
    Vec2i* links;              //!< the edges; null: they have not been requested yet
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
