// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/labeling.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! K (see Labeling) is set to 0 if it is below this value, which saves the exponential. This is the
//! K of a point with an error of 3.25 thresholds.
constexpr float NEGLIGIBLE = 0.005f;
//! Work per point to find the edges (without a kd-tree) and to cut the graph, in point tests, the
//! unit of Watch: 100 ns with a million points. The value only affects how late a time limit ends a
//! run.
constexpr double CUT_WORK = 50;

}  // namespace

void Labeling::weigh(const Context& context, const Model& model)
{
    const Correspondences& points = context.points;
    Arena::Scope scope(context.arena);
    float* const errors = scope.take<float>(size);
    context.components.residual->squaredErrors(points, model, 0, size, errors);
    const float factor = (float)(-0.5 / (points.threshold * points.threshold));
    const float reach = std::log(NEGLIGIBLE) / factor;
    for (int i = 0; i < size; ++i)
    {
        K[i] = errors[i] < reach ? std::exp(errors[i] * factor) : 0;  // NaN gives 0
        unary[i] = 1 - 2 * K[i];
    }
}

//! Largest number of edges of a point.
int Labeling::degreeOf(const Vec2i* edges, int count)
{
    std::fill(node, node + size, 0);
    int most = 0;
    for (int e = 0; e < count; ++e)
        most = std::max(most, std::max(++node[edges[e][0]], ++node[edges[e][1]]));
    return most;
}

/* An edge (p, q) changes the cost of p as an inlier minus its cost as an outlier by -lambda a if q
is an inlier, and by lambda (1 - a) if q is an outlier, with a = (K_p + K_q) / 2. A point whose
label is the same for any labels of its neighbors is labeled before the cut. For most points a
coarse test is enough: the magnitude of `unary` exceeds lambda times the largest number of edges. */
void Labeling::labelWithoutCut(Arena& arena, const Vec2i* edges, int count, float lambda)
{
    if (degree < 0)
        degree = degreeOf(edges, count);
    const float mostOfEdges = lambda * degree;
    // bounds of `unary` plus the changes by the edges over all possible labels of the neighbors
    Arena::Scope scope(arena);
    float *const lowest = scope.take<float>(size), *const highest = scope.take<float>(size);
    const float *const k = K, *const cost = unary;
    int* const label = node;
    for (int i = 0; i < size; ++i)
    {
        const bool outlier = (cost[i] >= mostOfEdges) | (k[i] == 0);
        label[i] = cost[i] + mostOfEdges < 0 ? INLIER : outlier ? OUTLIER : 0;
    }
    std::copy(cost, cost + size, lowest);
    std::copy(cost, cost + size, highest);
    for (int e = 0; e < count; ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        if ((label[p] & label[q]) < 0)  // both have a label
            continue;
        const float a = 0.5f * (k[p] + k[q]), least = lambda * a, most = lambda * (1 - a);
        lowest[p] -= least;
        lowest[q] -= least;
        highest[p] += most;
        highest[q] += most;
    }
    nodeCount = 0;
    for (int i = 0; i < size; ++i)
        if (node[i] == 0)
        {
            node[i] = highest[i] < 0 ? INLIER : lowest[i] >= 0 ? OUTLIER : nodeCount;
            if (node[i] >= 0)
                pointOfNode[nodeCount++] = i;
        }
}

int Labeling::cut(const Context& context, const Model& model, int* inliers)
{
    size = context.points.size;
    Arena::Scope scope(context.arena);
    K = scope.take<float>(size);
    unary = scope.take<float>(size);
    node = scope.take<int>(size);
    pointOfNode = scope.take<int>(size);
    weigh(context, model);
    const float lambda = (float)context.params.spatialWeight;
    const Vec2i* edges = 0;
    int count = context.stopBefore(size * CUT_WORK) ? 0
                                                    : context.neighborhood().edges(context, edges);
    if (context.stop(0))  // the time limit was reached while the edges were searched
        count = 0;
    degree = std::max(degree, context.neighborhood().mostEdges());
    labelWithoutCut(context.arena, edges, count, lambda);
    labelByCut(context.arena, edges, count, lambda);
    int found = 0;
    for (int i = 0; i < size; ++i)
        if (node[i] == INLIER)
            inliers[found++] = i;
    return found;
}

/* With x = 1 for an inlier and 0 for an outlier, the cost of an edge (p, q) is lambda times
a + (1 - a) x_p - a x_q + (1 - x_p) x_q. The last term is one arc of the graph. */
void Labeling::labelByCut(Arena& arena, const Vec2i* edges, int count, float lambda)
{
    const int nodes = nodeCount;
    Arena::Scope scope(arena);
    Vec2i* const arcs = scope.take<Vec2i>(count);  // arcs between two nodes of the graph
    int arcCount = 0;
    for (int e = 0; e < count; ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        if ((node[p] & node[q]) < 0)
            continue;
        const float a = 0.5f * (K[p] + K[q]);
        if (node[p] >= 0 && node[q] >= 0)
        {
            unary[p] += lambda * (1 - a);
            unary[q] -= lambda * a;
            arcs[arcCount++] = Vec2i(node[q], node[p]);
        }
        else if (node[p] >= 0)
            unary[p] += lambda * (node[q] == INLIER ? -a : 1 - a);
        else
            unary[q] += lambda * (node[p] == INLIER ? -a : 1 - a);
    }
    const bool linked = arcCount > 0;  // GCGraph does not accept a graph without edges
    if (linked)
    {
        graph = detail::GCGraph<float>();  // empties the graph without freeing its memory
        graph.create((unsigned)nodes, 2 * (unsigned)arcCount);
    }
    for (int v = 0; linked && v < nodes; ++v)  // nodes on the source side will be inliers
    {
        graph.addVtx();
        graph.addTermWeights(v, std::max(-unary[pointOfNode[v]], 0.f),
                             std::max(unary[pointOfNode[v]], 0.f));
    }
    for (int k = 0; k < arcCount; ++k)
        graph.addEdges(arcs[k][0], arcs[k][1], lambda, 0);
    if (linked)
        graph.maxFlow();
    for (int v = 0; v < nodes; ++v)
        node[pointOfNode[v]] = (linked ? graph.inSourceSegment(v) : unary[pointOfNode[v]] < 0)
                                   ? INLIER
                                   : OUTLIER;
}

}  // namespace usacv20
}  // namespace cv
