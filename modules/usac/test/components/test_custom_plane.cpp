// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "support/contracts.hpp"

// Tests of a custom problem with one array of points: a plane n x + d = 0 is fitted to 3-D points.
// The model has four numbers.

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

//! Fits a plane by total least squares: the plane contains the weighted mean and the two largest
//! principal axes of the points. Returns false if the points are collinear.
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

//! Planes with a normal of unit length. Two parameters rotate the normal, and the third one moves
//! the plane along the normal.
class PlaneParameterization : public cv::usacv20::Parameterization
{
public:
    int dimension() const CV_OVERRIDE { return 3; }

    bool tangent(const Model& plane, double* basis) const CV_OVERRIDE
    {
        const Axes turned = axesAround(plane);
        for (int row = 0; row < 4; ++row)
        {
            basis[3 * row] = turned(row, 0);
            basis[3 * row + 1] = turned(row, 1);
            basis[3 * row + 2] = row == 3;
        }
        return checkRange(Mat(4, 3, CV_64F, basis));
    }

    Model plus(const Model& plane, const double* x) const CV_OVERRIDE
    {
        const Vec4d start = unit(Vec4d(plane.val));
        const Matx41d moved = Matx41d(start) + axesAround(plane) * Matx21d(x);
        Vec4d result = unit(Vec4d(moved(0), moved(1), moved(2), 0));
        result[3] = start[3] + x[2];
        return Matx14d(result.val);
    }

private:
    typedef Matx<double, 4, 2> Axes;

    static Vec4d unit(const Vec4d& v) { return v / std::sqrt(v.dot(v) - v[3] * v[3]); }

    //! Two directions perpendicular to the normal and to each other.
    static Axes axesAround(const Model& plane)
    {
        const Vec4d p = unit(Vec4d(plane.val));
        const Vec3d n(p[0], p[1], p[2]),
            other = std::abs(n[0]) < 0.5 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
        const Vec3d a = normalize(n.cross(other)), b = n.cross(a);
        return Axes(a[0], b[0], a[1], b[1], a[2], b[2], 0, 0);
    }
};

//! The same problem as PlaneProblem, but with a parameterization of planes instead of its own
//! non-minimal solver.
class VaryingPlaneProblem : public PlaneProblem
{
public:
    Ptr<cv::usacv20::Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<PlaneParameterization>();
    }
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>& residual) const CV_OVERRIDE
    {
        return Problem::createNonMinimalSolver(residual);
    }
};

const Vec4d TRUE_PLANE(0.48, -0.6, 0.64, -3);

std::vector<Point3d> scene(int inliers, int outliers, double noise)
{
    RNG rng(11);
    std::vector<Point3d> points;
    for (int i = 0; i < inliers + outliers; ++i)
    {
        Point3d p = Point3d(uniformVector(rng, Vec3d(-5., -5., 0.), Vec3d(5., 5., 10.)));
        if (i < inliers)
            p.z = (-TRUE_PLANE[3] - TRUE_PLANE[0] * p.x - TRUE_PLANE[1] * p.y) / TRUE_PLANE[2] +
                  rng.gaussian(noise);
        points.push_back(p);
    }
    return points;
}

double errorOf(const Mat& plane)
{
    const Vec4d found(plane.ptr<double>());
    return std::min(cv::norm(found - TRUE_PLANE), cv::norm(found + TRUE_PLANE));
}

//! If a problem has a parameterization but no non-minimal solver, the module must make a solver
//! from the parameterization. The results must be as good as with the non-minimal solver PlaneFit.
TEST(Usac_CustomPlane, parameterizationInPlaceOfAFit)
{
    const PlaneParameterization planes;
    EXPECT_EQ("", checkParameterization(planes, Model(Matx14d(TRUE_PLANE.val))));
    EXPECT_EQ("", checkParameterization(planes, Model(Matx14d(3, 0.1, -0.2, 5))));
    const std::vector<Point3d> points = scene(300, 200, 0.01);
    EXPECT_EQ("", checkProblem(makePtr<VaryingPlaneProblem>(), points));
    for (const NamedPreset& preset : allPresets())
    {
        SCOPED_TRACE(preset.name);
        Params params = preset.params;
        params.threshold = 0.04;
        params.maxIterations = 5000;
        Mat models[2], masks[2];
        models[0] = Usac::create(makePtr<PlaneProblem>(), points, noArray(), params)->run(masks[0]);
        models[1] = Usac::create(makePtr<VaryingPlaneProblem>(), points, noArray(), params)
                        ->run(masks[1]);
        ASSERT_EQ(Size(4, 1), models[1].size());
        EXPECT_LE(errorOf(models[1]), 0.02);
        EXPECT_LE(std::abs(countNonZero(masks[0]) - countNonZero(masks[1])), 2);
    }
}

//! Planes perpendicular to an axis, as the ground is. Report::chance is computed from the errors of
//! artificial wrong points. If each of these combined coordinates of different points, a fifth of
//! them would be on the plane, as many as of the given points, and the plane would look like a
//! result of chance.
TEST(Usac_CustomPlane, parallelToTheAxes)
{
    for (int axis = 0; axis < 3; ++axis)
        for (bool estimated : {false, true})
        {
            RNG rng(11);
            std::vector<Point3d> points;
            for (int i = 0; i < 3000; ++i)
            {
                Vec3d p = uniformVector(rng, -5., 5.);
                if (i < 600)
                    p[axis] = 2 + rng.gaussian(0.01);
                points.push_back(Point3d(p));
            }
            Params params = estimated ? Params::automatic() : Params();
            params.threshold = estimated ? 0.2 : 0.03;
            Mat mask;
            Report report;
            const Mat plane = Usac::create(makePtr<PlaneProblem>(), points, noArray(), params)
                                  ->run(mask, &report);
            ASSERT_EQ(Size(4, 1), plane.size()) << axis << " " << estimated;
            EXPECT_LE(report.chance, 1e-6) << axis << " " << estimated;
            EXPECT_NEAR(1, std::abs(plane.at<double>(axis)), 1e-4);
            EXPECT_NEAR(600, report.inliers, 45);
            if (estimated)
            {
                EXPECT_NEAR(0.01, report.sigma, 0.002);
            }
        }
}

//! A problem whose points and model are single numbers. The model is the mean of the inliers.
class Location : public Problem
{
public:
    class Distance : public Residual
    {
    public:
        void squaredErrors(const Correspondences& p, const Model& model, int begin, int end,
                           float* errors) const CV_OVERRIDE
        {
            for (int i = begin; i < end; ++i)
                errors[i - begin] = (float)square(p.exact[0][i] - model.val[0]);
        }
        void squaredErrors(const Model& model, const double* const* c, int count,
                           double* errors) const CV_OVERRIDE
        {
            for (int i = 0; i < count; ++i)
                errors[i] = square(c[0][i] - model.val[0]);
        }

    private:
        static double square(double x) { return x * x; }
    };

    class Point : public MinimalSolver
    {
    public:
        int sampleSize() const CV_OVERRIDE { return 1; }
        int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
        {
            models[0] = Model(Matx<double, 1, 1>(p.exact[0][sample[0]]));
            return 1;
        }
    };

    class Mean : public NonMinimalSolver
    {
    public:
        bool fit(const Correspondences& p, const int* indices, int count, const double* weights,
                 Model& model, int) const CV_OVERRIDE
        {
            double sum = 0, all = 0;
            for (int k = 0; k < count; ++k)
            {
                const double w = weights ? weights[k] : 1;
                sum += w * p.exact[0][indices[k]];
                all += w;
            }
            model = Model(Matx<double, 1, 1>(sum / all));
            return all > 0;
        }
    };

    String name() const CV_OVERRIDE { return "location"; }
    int dimension() const CV_OVERRIDE { return 1; }
    int errorDimension() const CV_OVERRIDE { return 1; }
    int coordinates(int array) const CV_OVERRIDE { return array == 0 ? 1 : 0; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(1, 1); }
    int normalization(int) const CV_OVERRIDE { return SCALE_NONE; }
    bool toInput(const Model& model, const Correspondences&, Model& result) const CV_OVERRIDE
    {
        result = model;
        return true;
    }
    Ptr<Residual> createResidual(int) const CV_OVERRIDE { return makePtr<Distance>(); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE { return makePtr<Point>(); }
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>&) const CV_OVERRIDE
    {
        return makePtr<Mean>();
    }
};

//! All inliers are near one number, and must nevertheless count as independent of each other. If
//! all numbers are random, the number with the most inliers must look like a result of chance.
TEST(Usac_CustomPlane, locationOfNumbers)
{
    RNG rng(5);
    for (bool exists : {true, false})
    {
        std::vector<double> numbers;
        for (int i = 0; i < 1000; ++i)
            numbers.push_back(exists && i < 300 ? 412 + rng.gaussian(0.5) : rng.uniform(0., 1000.));
        Params params;
        params.threshold = 1.5;
        params.spatialWeight = 0;
        params.significance = exists ? 0.01 : 1;
        Report report;
        const Mat found = Usac::create(makePtr<Location>(), numbers, noArray(), params)
                              ->run(noArray(), &report);
        ASSERT_FALSE(found.empty()) << exists;
        if (exists)
        {
            EXPECT_NEAR(412, found.at<double>(0), 0.1);
            EXPECT_LE(report.chance, 1e-6);
            EXPECT_EQ(report.inliers, report.independentInliers);
        }
        else
            EXPECT_GE(report.chance, 1e-3);
    }
}

//! A wrong solver, whose model has 0 rows and 0 columns. The run must raise an exception.
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

}  // namespace
}  // namespace opencv_test
