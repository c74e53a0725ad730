// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LABELING_HPP
#define OPENCV_USACV20_LABELING_HPP

#include "opencv2/core/version.hpp"
#if CV_VERSION_MAJOR >= 5
#include "opencv2/geometry/detail/gcgraph.hpp"
#else
#include "opencv2/imgproc/detail/gcgraph.hpp"
#endif
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief Spatially coherent inliers of a model: the inlier/outlier labeling of minimum energy
@cite barath2018graph.

With K_p = exp(-error_p^2 / (2 threshold^2)), a point p costs 1 - K_p as an inlier and K_p as an
outlier. An edge (p, q) costs lambda if the labels differ, lambda (K_p + K_q) / 2 if both points are
outliers, and lambda (1 - (K_p + K_q) / 2) if both points are inliers, where lambda is
Params::spatialWeight. The energy is submodular, so that a minimum cut gives its exact minimum.

Points whose label does not depend on their neighbors (most points in practice) are labeled before
the cut and are not nodes of the graph. Points far from the model (K_p below 0.005, #NEGLIGIBLE) are
always outliers. The graph is set up in O(N) time; in practice, the cut takes linear time. */
class Labeling
{
public:
    Labeling()
        : lambda(0), factor(0), errors(0), K(0), unary(0), node(0), pointOfNode(0), size(0),
          nodeCount(0), degree(-1), degreeSize(0)
    {}

    //! To be called when a run begins, because its points can have other edges than those of the
    //! previous run.
    void start() { degree = -1; }
    //! Computes the labeling of `context.points`, all points of the run or the first ones, and
    //! writes the indices of the inliers to `inliers`, which has room for these points.
    //! @return number of inliers
    int cut(const Context& context, const Model& model, int* inliers);

private:
    enum { INLIER = -1, OUTLIER = -2 };

    //! An upper bound of the number of edges of a point.
    int findDegree(const Context& context);
    float weight(float squaredError) const;
    //! Labels the points whose errors alone show that the edges cannot change the label. Lists the
    //! other points in `pointOfNode` and marks them in `wanted`.
    void labelByError(const Context& context, const Model& model, uchar* wanted);
    //! Labels the points for which the weights of their neighbors show that the edges cannot change
    //! the label. The other points become nodes.
    void labelByNeighbors(Arena& arena, const Vec2i* edges, int count);
    //! Labels the nodes with a minimum cut.
    void labelByCut(Arena& arena, const Vec2i* edges, int count);

    // The members from here to `graph` are valid only during cut(); `graph` keeps its memory.
    float lambda;
    float factor;   //!< K_p = exp(factor error_p^2)
    float* errors;  //!< squared error of each point
    float* K;       //!< K_p of points without a label and of their neighbors; -1: not needed so far
    float* unary;   //!< cost as an inlier minus cost as an outlier, of points without a label;
                    //!< labelByCut() adds the costs of edges that depend on this point alone
    int* node;      //!< node of each point in the graph, or its label #INLIER or #OUTLIER
    int* pointOfNode;              //!< point of each node
    int size, nodeCount;           //!< numbers of points and of nodes
    detail::GCGraph<float> graph;  //!< a member, so that its memory is reused

    int degree;  //!< upper bound of the number of edges of a point (0 if the run must end before
                 //!< the edges are found); -1: not yet known
    int degreeSize;  //!< number of points to which `degree` belongs
};

}  // namespace usacv20
}  // namespace cv

#endif
