// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/labeling.hpp"
#include "components/check_components.hpp"
#include "numeric/bits.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! K (see Labeling) is set to 0 if it is below this value, which saves the exponential. This is the
//! K of a point with an error of 3.25 thresholds.
constexpr float NEGLIGIBLE = 0.005f;
//! Work per point to find the edges (without a kd-tree) and to cut the graph, in point tests of
//! 2 ns, the unit of Watch: 100 ns per point if there are a million points. The value only affects
//! how late a time limit ends a run.
constexpr double CUT_WORK = 50;

}  // namespace

int Labeling::findDegree(const Context& context)
{
    const int known = context.neighborhood().mostEdges();
    if (known >= 0)
        return known;
    const Vec2i* edges = 0;
    const int count = context.neighborhood().edges(context, 0, edges);
    checkEdges(edges, count, size);
    std::fill(node, node + size, 0);
    int most = 0;
    for (int e = 0; e < count; ++e)
        most = std::max(most, std::max(++node[edges[e][0]], ++node[edges[e][1]]));
    return most;
}

float Labeling::weight(float squaredError) const
{
    const float weight = std::exp(squaredError * factor);
    return weight > NEGLIGIBLE ? weight : 0;  // NaN gives 0
}

/* Let D be the cost of p as an inlier minus its cost as an outlier. Without edges, D is 1 - 2 K_p.
An edge (p, q) changes D by -lambda a if q is an inlier, and by lambda (1 - a) if q is an outlier,
with a = (K_p + K_q) / 2. All edges of p together change D most if all q are outliers with K_q = 0,
or if all q are inliers with K_q = 1. For most points, |1 - 2 K_p| is larger than even this change,
so that the error of the point alone determines the label. */
void Labeling::labelByError(const Context& context, const Model& model, uchar* wanted)
{
    context.components.residual->squaredErrors(context.points, model, 0, size, errors);
    const float most = lambda * degree, farthest = std::log(NEGLIGIBLE) / factor;
    float inner = 0, outer = farthest;  // squared errors below and above which the label is known
    if (most < 2)
    {
        inner = std::log((1 + most) / (2 + most / 2)) / factor;
        outer = std::min(std::log((1 - most / 2) / (2 + most / 2)) / factor, farthest);
    }
    const int count = size;
    const float* USAC_RESTRICT const error = errors;
    int* USAC_RESTRICT const label = node;
    USAC_SIMD
    for (int i = 0; i < count; ++i)  // NaN gives an outlier
        label[i] = error[i] < inner ? (int)INLIER : error[i] < outer ? 0 : (int)OUTLIER;
    std::fill(K, K + size, -1.f);
    int open = 0;
    for (int i = 0; i < count; ++i)  // without branches, which would often be mispredicted
    {
        pointOfNode[open] = i;
        wanted[i] = label[i] == 0;
        open += label[i] == 0;
    }
    nodeCount = open;
    for (int v = 0; v < nodeCount; ++v)
    {
        const int i = pointOfNode[v];
        K[i] = weight(errors[i]);
        unary[i] = 1 - 2 * K[i];
    }
}

void Labeling::labelByNeighbors(Arena& arena, const Vec2i* edges, int count)
{
    // lowest and highest value of `unary` plus the changes by the edges, over all labels that the
    // neighbors can have
    Arena::Scope scope(arena);
    float *const lowest = scope.take<float>(size), *const highest = scope.take<float>(size);
    for (int k = 0; k < nodeCount; ++k)
        lowest[pointOfNode[k]] = highest[pointOfNode[k]] = unary[pointOfNode[k]];
    for (int e = 0; e < count; ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        if ((node[p] & node[q]) < 0)  // both have a label
            continue;
        for (int end = 0; end < 2; ++end)
            if (K[edges[e][end]] < 0)
                K[edges[e][end]] = weight(errors[edges[e][end]]);
        const float a = 0.5f * (K[p] + K[q]), least = lambda * a, most = lambda * (1 - a);
        for (int end = 0; end < 2; ++end)
            if (node[edges[e][end]] == 0)
            {
                lowest[edges[e][end]] -= least;
                highest[edges[e][end]] += most;
            }
    }
    const int open = nodeCount;
    nodeCount = 0;
    for (int k = 0; k < open; ++k)
    {
        const int i = pointOfNode[k];
        node[i] = highest[i] < 0 ? INLIER : lowest[i] >= 0 ? OUTLIER : nodeCount;
        if (node[i] >= 0)
            pointOfNode[nodeCount++] = i;
    }
}

int Labeling::cut(const Context& context, const Model& model, int* inliers)
{
    size = context.points.size;
    Arena::Scope scope(context.arena);
    errors = scope.take<float>(size);
    K = scope.take<float>(size);
    unary = scope.take<float>(size);
    node = scope.take<int>(size);
    pointOfNode = scope.take<int>(size);
    uchar* const wanted = scope.take<uchar>(size);
    lambda = (float)context.params.spatialWeight;
    factor = (float)(-0.5 / (context.points.threshold * context.points.threshold));
    const bool late = context.stopBefore(size * CUT_WORK);
    if (degree < 0 || degreeSize != size)
        degree = late ? 0 : findDegree(context);
    degreeSize = size;
    labelByError(context, model, wanted);
    const Vec2i* edges = 0;
    int count = late ? 0 : context.neighborhood().edges(context, wanted, edges);
    if (context.stop(0))  // the run was stopped during the search for edges
        count = 0;
    checkEdges(edges, count, size);
    labelByNeighbors(context.arena, edges, count);
    labelByCut(context.arena, edges, count);
    int found = 0;
    for (int i = 0; i < size; ++i)  // without branches, because these would often be mispredicted
    {
        inliers[found] = i;
        found += node[i] == INLIER;
    }
    return found;
}

/* With x = 1 for an inlier and 0 for an outlier, and with a = (K_p + K_q) / 2, the cost of an edge
(p, q) is lambda times a + (1 - a) x_p - a x_q + (1 - x_p) x_q. The terms in x_p or x_q alone are
added to `unary`; the last term is one arc of the graph. */
void Labeling::labelByCut(Arena& arena, const Vec2i* edges, int count)
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
