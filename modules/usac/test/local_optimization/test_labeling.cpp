// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/run_context.hpp"
#include "test_precomp.hpp"
#include "support/given_edges.hpp"
#include "support/given_residual.hpp"
#include "local_optimization/labeling.hpp"

namespace opencv_test {
namespace {

//! The closeness K of a point to the model, as in Labeling: 1 for an error of 0, nearly 0 for a
//! large error. NaN counts as a large error.
double closeness(double squaredError, double inlierThreshold)
{
    return squaredError == squaredError
               ? std::exp(-squaredError / (2 * inlierThreshold * inlierThreshold))
               : 0;
}

//! The energy of a labeling, as defined in the comment of the class Labeling.
double energyOf(const std::vector<double>& K, const std::vector<Vec2i>& edges, double lambda,
                const std::vector<uchar>& inlier)
{
    double energy = 0;
    for (size_t i = 0; i < K.size(); ++i)
        energy += inlier[i] ? 1 - K[i] : K[i];
    for (size_t e = 0; e < edges.size(); ++e)
    {
        const int p = edges[e][0], q = edges[e][1];
        const double mean = (K[p] + K[q]) / 2;
        energy += lambda * (inlier[p] != inlier[q] ? 1 : inlier[p] ? 1 - mean : mean);
    }
    return energy;
}

std::vector<uchar> labelsOf(const std::vector<int>& inliers, size_t size)
{
    std::vector<uchar> labels(size, 0);
    for (size_t i = 0; i < inliers.size(); ++i)
    {
        EXPECT_FALSE(labels[inliers[i]]) << "an inlier is repeated";
        labels[inliers[i]] = 1;
    }
    return labels;
}

//! A labeling problem so small that all labelings can be tried.
struct Graph
{
    Graph(int size_, double lambda, double inlierThreshold)
        : size(size_), points(HOMOGRAPHY, std::vector<Point2d>(size_), std::vector<Point2d>(size_),
                              inlierThreshold),
          residual(makePtr<GivenResidual>()), neighborhood(makePtr<GivenEdges>()),
          context(points.view(), parts, params, arena)
    {
        params.spatialWeight = lambda;
        parts.residual = residual;
        parts.neighborhood = neighborhood;
        residual->given.assign(size, 0.f);
    }

    //! Adds each pair of points as an edge with the given probability, unless one of the two points
    //! already has `degree` edges.
    void addEdges(double probability, int degree, RNG& rng)
    {
        std::vector<int> edgesOf(size, 0);
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < i; ++j)
                if (rng.uniform(0., 1.) < probability && edgesOf[i] < degree && edgesOf[j] < degree)
                {
                    neighborhood->given.push_back(rng.uniform(0, 2) ? Vec2i(i, j) : Vec2i(j, i));
                    ++edgesOf[i];
                    ++edgesOf[j];
                }
    }

    std::vector<double> closenesses() const
    {
        std::vector<double> K(size);
        for (int i = 0; i < size; ++i)
            K[i] = closeness(residual->given[i], points.view().threshold);
        return K;
    }

    std::vector<uchar> cut()
    {
        Labeling labeling;
        std::vector<int> inliers(size, 1);  // the previous contents must have no effect
        inliers.resize(labeling.cut(context, Matx33d::eye(), inliers.data()));
        return labelsOf(inliers, size);
    }

    double leastEnergy() const
    {
        const std::vector<double> K = closenesses();
        double least = DBL_MAX;
        std::vector<uchar> labels(size);
        for (int code = 0; code < 1 << size; ++code)
        {
            for (int i = 0; i < size; ++i)
                labels[i] = (code >> i) & 1;
            least = std::min(least, energyOf(K, neighborhood->given, params.spatialWeight, labels));
        }
        return least;
    }

    const int size;
    OwnPoints points;
    Params params;
    Components parts;
    Ptr<GivenResidual> residual;
    Ptr<GivenEdges> neighborhood;
    Arena arena;
    const Context context;
};

//! An edge with an endpoint that is no point, or between a point and itself, must raise an
//! exception that names the component.
TEST(Usac_GraphCut, wrongEdges)
{
    for (const Vec2i& edge : {Vec2i(0, 12), Vec2i(-1, 3), Vec2i(5, 5)})
        for (int most = -1; most <= 1; most += 2)
        {
            Graph graph(12, 0.1, 1);
            graph.neighborhood->given.push_back(edge);
            graph.neighborhood->most = most;
            try
            {
                graph.cut();
                ADD_FAILURE() << edge << " was accepted";
            }
            catch (const cv::Exception& e)
            {
                EXPECT_NE(String::npos, String(e.what()).find("components().neighborhood"))
                    << e.what();
            }
        }
}

//! Draws errors between 0 and `reach` times the threshold, so that some points have a high, some a
//! medium and some a low closeness K.
void drawErrors(Graph& graph, double reach, RNG& rng)
{
    for (int i = 0; i < graph.size; ++i)
    {
        const double error = rng.uniform(0., reach) * graph.points.view().threshold;
        graph.residual->given[i] = (float)(error * error);
    }
}

TEST(Usac_GraphCut, exactMinimum)
{
    RNG rng(1);
    const double lambdas[] = {0, 0.05, 0.14, 0.3, 0.8, 2};
    int different = 0, inliers = 0, total = 0;
    for (int repeat = 0; repeat < 240; ++repeat)
    {
        Graph graph(rng.uniform(2, 11), lambdas[repeat % 6], 0.02);
        drawErrors(graph, 2.5, rng);
        graph.addEdges(rng.uniform(0.1, 0.9), 6, rng);
        const std::vector<uchar> labels = graph.cut();
        const std::vector<double> K = graph.closenesses();
        EXPECT_NEAR(graph.leastEnergy(),
                    energyOf(K, graph.neighborhood->given, graph.params.spatialWeight, labels),
                    1e-4);
        for (int i = 0; i < graph.size; ++i, ++total)
        {
            different += (labels[i] != 0) != (K[i] > 0.5);
            inliers += labels[i];
        }
    }
    EXPECT_GT(different, 20) << "the edges decide nothing";
    EXPECT_GT(inliers, total / 5);
    EXPECT_LT(inliers, total * 4 / 5);
}

//! The minimum must also be exact if some points are far from the model and some errors are
//! undefined. The spatial weight has its default.
TEST(Usac_GraphCut, exactMinimumWithOutliers)
{
    RNG rng(2);
    for (int repeat = 0; repeat < 200; ++repeat)
    {
        Graph graph(rng.uniform(3, 12), Params().spatialWeight, 2);
        drawErrors(graph, repeat % 2 ? 5 : 20, rng);
        graph.residual->given[1] = std::numeric_limits<float>::quiet_NaN();
        graph.residual->given[2] = std::numeric_limits<float>::infinity();
        graph.addEdges(0.6, 6, rng);
        const std::vector<uchar> labels = graph.cut();
        EXPECT_FALSE(labels[1] || labels[2]);
        EXPECT_NEAR(graph.leastEnergy(),
                    energyOf(graph.closenesses(), graph.neighborhood->given,
                             graph.params.spatialWeight, labels),
                    1e-4);
    }
}

TEST(Usac_GraphCut, withoutEdgesOrWeight)
{
    RNG rng(3);
    for (int repeat = 0; repeat < 100; ++repeat)
    {
        Graph graph(20, repeat % 2 ? 0 : 0.5, 1);
        drawErrors(graph, 3, rng);
        if (repeat % 2)
            graph.addEdges(0.5, 6, rng);
        const std::vector<uchar> labels = graph.cut();
        const std::vector<double> K = graph.closenesses();
        for (int i = 0; i < graph.size; ++i)
            if (std::abs(K[i] - 0.5) > 1e-5)
            {
                EXPECT_EQ(K[i] > 0.5, labels[i] != 0);
            }
    }
    Graph far(20, 0.14, 1);  // all K are 0, so that the graph has no nodes
    far.residual->given.assign(20, 1e6f);
    far.addEdges(0.5, 6, rng);
    EXPECT_EQ(std::vector<uchar>(20, 0), far.cut());
}

}  // namespace
}  // namespace opencv_test
