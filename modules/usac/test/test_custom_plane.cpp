// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "run_context.hpp"
#include "test_contracts.hpp"

// A problem of one array of points: the plane n x + d = 0 of points of space, a model of four
// numbers.

namespace opencv_test {
namespace {

class PlaneDistance : public Residual
{
public:
    void squaredErrors(const Correspondences& p, const Model& plane, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
            errors[i - begin] = (float)square(plane, p.exact[0][i], p.exact[1][i], p.exact[2][i]);
    }

    void squaredErrors(const Model& plane, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
            errors[i] = square(plane, c[0][i], c[1][i], c[2][i]);
    }

private:
    static double square(const Model& plane, double x, double y, double z)
    {
        const double* const v = plane.val;
        const double distance = v[0] * x + v[1] * y + v[2] * z + v[3];
        return distance * distance / (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }
};

//! Through the mean, along the two largest axes of the scatter.
bool fitPlane(const Correspondences& p, const int* indices, int count, const double* weights,
              Model& plane)
{
    Vec3d mean;
    double sum = 0;
    for (int k = 0; k < count; ++k)
    {
        const double w = weights ? weights[k] : 1;
        mean += w * Vec3d(p.exact[0][indices[k]], p.exact[1][indices[k]], p.exact[2][indices[k]]);
        sum += w;
    }
    mean *= 1 / sum;
    Matx33d scatter = Matx33d::zeros();
    for (int k = 0; k < count; ++k)
    {
        const Vec3d v = Vec3d(p.exact[0][indices[k]], p.exact[1][indices[k]],
                              p.exact[2][indices[k]]) -
                        mean;
        scatter += (weights ? weights[k] : 1) * (v * v.t());
    }
    Matx31d values;
    Matx33d vectors;
    if (!eigen(scatter, values, vectors) || !(values(1) > 1e-9 * values(0)))
        return false;
    const Vec3d n(vectors(2, 0), vectors(2, 1), vectors(2, 2));
    plane = Matx14d(n[0], n[1], n[2], -n.dot(mean));
    return true;
}

class PlaneSolver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 3; }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        return fitPlane(points, sample, 3, 0, models[0]);
    }
};

class PlaneFit : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        return fitPlane(points, indices, count, weights, model);
    }
};

class PlaneProblem : public Problem
{
public:
    String name() const CV_OVERRIDE { return "plane"; }
    int dimension() const CV_OVERRIDE { return 3; }
    int errorDimension() const CV_OVERRIDE { return 1; }
    int coordinates(int array) const CV_OVERRIDE { return array == 0 ? 3 : 0; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(300, 1); }
    int normalization(int) const CV_OVERRIDE { return SCALE_EACH; }

    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        const Frame& frame = points.frame[1];
        const double* const v = model.val;
        const Vec3d n(v[0], v[1], v[2]);
        const double d = v[3] - frame.scale * n.dot(Vec3d(frame.center));
        result = Matx14d(n[0], n[1], n[2], d / frame.scale) * (1 / cv::norm(n));
        return checkRange(Mat(1, 4, CV_64F, result.val));
    }

    Ptr<Residual> createResidual(int) const CV_OVERRIDE { return makePtr<PlaneDistance>(); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return makePtr<PlaneSolver>(); }
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>&) const CV_OVERRIDE
    {
        return makePtr<PlaneFit>();
    }
};

const Vec4d TRUTH(0.48, -0.6, 0.64, -3);

std::vector<Point3d> scene(int inliers, int outliers, double noise)
{
    RNG rng(11);
    std::vector<Point3d> points;
    for (int i = 0; i < inliers + outliers; ++i)
    {
        Point3d p = Point3d(uniformVector(rng, Vec3d(-5., -5., 0.), Vec3d(5., 5., 10.)));
        if (i < inliers)
            p.z = (-TRUTH[3] - TRUTH[0] * p.x - TRUTH[1] * p.y) / TRUTH[2] + rng.gaussian(noise);
        points.push_back(p);
    }
    return points;
}

double errorOf(const Mat& plane)
{
    const Vec4d found(plane.ptr<double>());
    return std::min(cv::norm(found - TRUTH), cv::norm(found + TRUTH));
}

TEST(Usac_CustomPlane, everyPreset)
{
    const std::vector<Point3d> points = scene(300, 200, 0.01);
    const std::vector<NamedPreset> presets = allPresets();
    for (size_t k = 0; k < presets.size(); ++k)
    {
        Params params = presets[k].params;
        params.threshold = 0.04;
        params.maxIterations = 5000;
        Mat mask;
        Report report;
        const Mat plane = Usac::create(makePtr<PlaneProblem>(), points, noArray(), params)
                              ->run(mask, &report);
        ASSERT_EQ(Size(4, 1), plane.size()) << presets[k].name;
        EXPECT_LE(errorOf(plane), 0.02) << presets[k].name;
        EXPECT_EQ(report.inliers, countNonZero(mask)) << presets[k].name;
        EXPECT_LE(report.chance, 1e-6) << presets[k].name;
        if (!findsThreshold(params))
        {
            EXPECT_NEAR(301, report.inliers, 6) << presets[k].name;
        }
    }
}

//! Random points have planes within the threshold of several, which the report tells.
TEST(Usac_CustomPlane, chanceOfRandomPoints)
{
    Params params;
    params.threshold = 0.04;
    params.significance = 1;
    params.maxIterations = 2000;
    Report report;
    Usac::create(makePtr<PlaneProblem>(), scene(0, 300, 0), noArray(), params)
        ->run(noArray(), &report);
    EXPECT_GE(report.chance, 1e-3);
}

TEST(Usac_CustomPlane, neighborhoodsAndOrderings)
{
    std::vector<Point3d> points = scene(100, 300, 0.01);
    points[7].y = points[150].z = std::numeric_limits<double>::quiet_NaN();
    for (int neighborhood = NEIGHBORHOOD_GRID; neighborhood <= NEIGHBORHOOD_RADIUS; ++neighborhood)
        for (int ordering = ORDERING_NONE; ordering <= ORDERING_DENSITY; ++ordering)
        {
            Params params;
            params.threshold = 0.04;
            params.neighborhood = neighborhood;
            params.ordering = ordering;
            params.neighborRadius = 2;
            Mat mask;
            const Mat plane = Usac::create(makePtr<PlaneProblem>(), points, noArray(), params)
                                  ->run(mask);
            ASSERT_FALSE(plane.empty()) << neighborhood << " " << ordering;
            EXPECT_LE(errorOf(plane), 0.03);
            EXPECT_EQ(0, mask.at<uchar>(7) + mask.at<uchar>(150));
        }
}

//! Of points of space, against all distances.
TEST(Usac_CustomPlane, nearestNeighbors)
{
    Params params;
    params.neighborhood = NEIGHBORHOOD_KNN;
    params.neighbors = 6;
    const Ptr<Usac> usac = Usac::create(makePtr<PlaneProblem>(), scene(100, 100, 0.01), noArray(),
                                        params);
    const Correspondences& p = usac->points();
    const RunContext run(p, usac->components(), params);
    for (int i = 0; i < p.size; ++i)
    {
        std::vector<std::pair<double, int>> all;
        for (int k = 0; k < p.size; ++k)
        {
            const Vec3d d(p.exact[0][k] - p.exact[0][i], p.exact[1][k] - p.exact[1][i],
                          p.exact[2][k] - p.exact[2][i]);
            all.push_back(std::make_pair(d.dot(d), k));
        }
        std::sort(all.begin(), all.end());
        const int* members = 0;
        ASSERT_EQ(7, usac->components().neighborhood->members(run, 0, i, members));
        for (int k = 0; k < 7; ++k)
            EXPECT_EQ(all[k].second, members[k]) << i;
    }
}

TEST(Usac_CustomPlane, layoutsOfPoints)
{
    const std::vector<Point3d> points = scene(30, 0, 0.01);
    const Mat rows = column(points).reshape(1), columns = rows.t();
    Mat floats, one[5];
    rows.convertTo(floats, CV_32F);
    const Mat layouts[] = {Mat(points), rows, columns, Mat(points).reshape(3, 1), floats};
    Params params;
    params.threshold = 0.04;
    for (int k = 0; k < 5; ++k)
    {
        one[k] = Usac::create(makePtr<PlaneProblem>(), layouts[k], noArray(), params)->run();
        EXPECT_LE(cv::norm(one[0], one[k], NORM_INF), k < 4 ? 0. : 1e-5) << k;
    }
    EXPECT_THROW(Usac::create(makePtr<PlaneProblem>(), rows.colRange(0, 2), noArray(), params),
                 cv::Exception);
    EXPECT_THROW(Usac::create(makePtr<PlaneProblem>(), rows, rows, params), cv::Exception)
        << "a second array";
}

//! A solver that writes numbers into a model of no size.
class ShapelessSolver : public PlaneSolver
{
public:
    int solve(const Correspondences&, const int*, Model* models) const CV_OVERRIDE
    {
        models[0].val[0] = 1;
        return 1;
    }
};

TEST(Usac_CustomPlane, modelsHaveAShape)
{
    const Ptr<Usac> usac = Usac::create(makePtr<PlaneProblem>(), scene(30, 0, 0.01), noArray());
    usac->components().minimalSolver = makePtr<ShapelessSolver>();
    EXPECT_THROW(usac->run(), cv::Exception);
}

}
}  // namespace
