// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/labeling.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! K of a point at 3.25 thresholds.
const float NEGLIGIBLE = 0.005f;

}  // namespace

void Labeling::weigh(const Context& context, const Model& model)
{
    const Correspondences& points = context.points;
    const int size = points.size;
    errors.resize(size);
    K.resize(size);
    unary.resize(size);
    context.components.residual->squaredErrors(points, model, 0, size, errors.data());
    const float factor = (float)(-0.5 / (points.threshold * points.threshold));
    const float reach = std::log(NEGLIGIBLE) / factor;
    for (int i = 0; i < size; ++i)
    {
        K[i] = errors[i] < reach ? std::exp(errors[i] * factor) : 0;  // 0 for NaN
        unary[i] = 1 - 2 * K[i];
    }
}

//! Most edges of a point.
int Labeling::degreeOf(const std::vector<Vec2i>& edges)
{
    node.assign(K.size(), 0);
    int most = 0;
    for (size_t e = 0; e < edges.size(); ++e)
        most = std::max(most, std::max(++node[edges[e][0]], ++node[edges[e][1]]));
    return most;
}

/* An edge changes the cost of p being an inlier, against an outlier, by -lambda a if q is an inlier and by lambda (1 -
a) if q is an outlier, with a = (K_p + K_q) / 2. Whom the edges cannot turn gets its label before any cut: most points
at first sight, as lambda times the number of edges is not enough. */
void Labeling::fix(const std::vector<Vec2i>& edges, float lambda)
{
    const size_t size = unary.size();
    if (degree < 0)
        degree = degreeOf(edges);
    const float turn = lambda * degree;
    node.resize(size);
    lowest.resize(size);
    highest.resize(size);
    for (size_t i = 0; i < size; ++i)
    {
        node[i] = unary[i] + turn < 0 ? INLIER : unary[i] >= turn || K[i] == 0 ? OUTLIER : 0;
        lowest[i] = highest[i] = unary[i];
    }
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        if (node[p] < 0 && node[q] < 0)
            continue;
        const float a = 0.5f * (K[p] + K[q]);
        lowest[p] -= lambda * a;
        lowest[q] -= lambda * a;
        highest[p] += lambda * (1 - a);
        highest[q] += lambda * (1 - a);
    }
    open.clear();
    for (size_t i = 0; i < size; ++i)
        if (node[i] == 0)
        {
            node[i] = highest[i] < 0 ? INLIER : lowest[i] >= 0 ? OUTLIER : (int)open.size();
            if (node[i] >= 0)
                open.push_back((int)i);
        }
}

void Labeling::cut(const Context& context, const Model& model, std::vector<int>& inliers)
{
    weigh(context, model);
    const float lambda = (float)context.params.spatialWeight;
    const std::vector<Vec2i>& edges = context.neighborhood().edges(context);
    fix(edges, lambda);
    label(edges, lambda);
    inliers.clear();
    for (size_t i = 0; i < node.size(); ++i)
        if (node[i] == INLIER)
            inliers.push_back((int)i);
}

/* With x = 1 for an inlier, the cost of an edge is a + (1 - a) x_p - a x_q + (1 - x_p) x_q, the last term being one arc
of the graph. */
void Labeling::label(const std::vector<Vec2i>& edges, float lambda)
{
    const int nodes = (int)open.size();
    arcs.clear();
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        if (node[p] < 0 && node[q] < 0)
            continue;
        const float a = 0.5f * (K[p] + K[q]);
        if (node[p] >= 0 && node[q] >= 0)
        {
            unary[p] += lambda * (1 - a);
            unary[q] -= lambda * a;
            arcs.push_back(Vec2i(node[q], node[p]));
        }
        else if (node[p] >= 0)
            unary[p] += lambda * (node[q] == INLIER ? -a : 1 - a);
        else
            unary[q] += lambda * (node[p] == INLIER ? -a : 1 - a);
    }
    const bool linked = !arcs.empty();  // GCGraph does not accept a graph without edges
    detail::GCGraph<float> graph(linked ? (unsigned)nodes : 0, (unsigned)arcs.size());
    for (int v = 0; linked && v < nodes; ++v)  // the source side are the inliers
    {
        graph.addVtx();
        graph.addTermWeights(v, std::max(-unary[open[v]], 0.f), std::max(unary[open[v]], 0.f));
    }
    for (size_t k = 0; k < arcs.size(); ++k)
        graph.addEdges(arcs[k][0], arcs[k][1], lambda, 0);
    if (linked)
        graph.maxFlow();
    for (int v = 0; v < nodes; ++v)
        node[open[v]] = (linked ? graph.inSourceSegment(v) : unary[open[v]] < 0) ? INLIER : OUTLIER;
}

}  // namespace usacv20
}  // namespace cv
