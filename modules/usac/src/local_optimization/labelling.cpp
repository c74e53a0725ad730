// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "local_optimization/labelling.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! K of a point at 3.25 thresholds.
const float NEGLIGIBLE = 0.005f;

} // namespace

void Labelling::weigh(const Context& context, const Model& model)
{
    const Correspondences& points = context.points;
    const int size = points.size;
    errors.resize(size);
    K.resize(size);
    node.resize(size);
    point.clear();
    unary.clear();
    context.components.residual->squaredErrors(points, model, 0, size, errors.data());
    const float factor = (float)(-0.5 / (points.threshold * points.threshold));
    const float reach = std::log(NEGLIGIBLE) / factor;
    for (int i = 0; i < size; ++i)
    {
        node[i] = -1;
        K[i] = 0;
        if (errors[i] < reach)  // false for NaN
        {
            K[i] = std::exp(errors[i] * factor);
            node[i] = (int)point.size();
            point.push_back(i);
            unary.push_back(1 - 2 * K[i]);
        }
    }
}

void Labelling::unaryInliers(std::vector<int>& inliers) const
{
    for (size_t v = 0; v < point.size(); ++v)
        if (unary[v] < 0)
            inliers.push_back(point[v]);
}

void Labelling::cut(const Context& context, const Model& model, std::vector<int>& inliers)
{
    weigh(context, model);
    inliers.clear();
    const float lambda = (float)context.params.spatialWeight;
    /* With x = 1 for an inlier and a = (K_p + K_q) / 2, the cost of an edge is
       a + (1 - a) x_p - a x_q + (1 - x_p) x_q, the last term being one arc of the graph. */
    const int nodes = (int)point.size();
    if (lambda == 0)
    {
        unaryInliers(inliers);
        return;
    }
    const std::vector<Vec2i>& edges = context.components.neighbourhood->edges(context);
    bool linked = false;
    detail::GCGraph<float> graph((unsigned)nodes, (unsigned)edges.size());
    for (int v = 0; v < nodes; ++v)
        graph.addVtx();
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        const float a = 0.5f * (K[p] + K[q]);
        if (node[p] >= 0 && node[q] >= 0)
        {
            unary[node[p]] += lambda * (1 - a);
            unary[node[q]] -= lambda * a;
            graph.addEdges(node[q], node[p], lambda, 0);
            linked = true;
        }
        else if (node[p] >= 0 || node[q] >= 0)
            unary[std::max(node[p], node[q])] += lambda * (1 - a);
    }
    for (int v = 0; v < nodes; ++v)  // the source side are the inliers
        graph.addTermWeights(v, std::max(-unary[v], 0.f), std::max(unary[v], 0.f));
    if (!linked)  // which GCGraph does not accept
    {
        unaryInliers(inliers);
        return;
    }
    graph.maxFlow();
    for (int v = 0; v < nodes; ++v)
        if (graph.inSourceSegment(v))
            inliers.push_back(point[v]);
}

} // namespace usacv20
} // namespace cv
