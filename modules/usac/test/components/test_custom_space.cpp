// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/contracts.hpp"

// Tests of a custom problem whose errors have three dimensions: a translation is fitted to pairs of
// 3-D points. The model has three numbers.

namespace opencv_test {
namespace {

class TranslationError : public Residual
{
public:
    void squaredErrors(const Correspondences& p, const Model& t, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
        {
            double square = 0;
            for (int k = 0; k < 3; ++k)
                square += std::pow(p.exact[k][i] + t.val[k] - p.exact[3 + k][i], 2);
            errors[i - begin] = (float)square;
        }
    }

    void squaredErrors(const Model& t, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            errors[i] = 0;
            for (int k = 0; k < 3; ++k)
                errors[i] += std::pow(c[k][i] + t.val[k] - c[3 + k][i], 2);
        }
    }

    bool homogeneous() const CV_OVERRIDE { return false; }
};

Model meanTranslation(const Correspondences& p, const int* indices, int count,
                      const double* weights)
{
    Model t(3, 1);
    double sum = 0;
    for (int i = 0; i < count; ++i)
    {
        const double w = weights ? weights[i] : 1;
        for (int k = 0; k < 3; ++k)
            t.val[k] += w * (p.exact[3 + k][indices[i]] - p.exact[k][indices[i]]);
        sum += w;
    }
    for (int k = 0; k < 3; ++k)
        t.val[k] /= sum;
    return t;
}

class TranslationSolver : public MinimalSolver
{
public:
    int sampleSize() const CV_OVERRIDE { return 1; }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        models[0] = meanTranslation(points, sample, 1, 0);
        return 1;
    }
};

class TranslationFit : public NonMinimalSolver
{
public:
    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int) const CV_OVERRIDE
    {
        model = meanTranslation(points, indices, count, weights);
        return checkRange(Mat(3, 1, CV_64F, model.val));
    }
};

class TranslationProblem : public Problem
{
public:
    explicit TranslationProblem(int errorDimension_ = 3, int coordinates_ = 3)
        : errorDimensions(errorDimension_), coordinatesOfAPoint(coordinates_)
    {}

    String name() const CV_OVERRIDE { return "translation"; }
    int dimension() const CV_OVERRIDE { return 3; }
    int errorDimension() const CV_OVERRIDE { return errorDimensions; }
    int coordinates(int) const CV_OVERRIDE { return coordinatesOfAPoint; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(10, 1); }
    bool toInput(const Model& model, const Correspondences&, Model& result) const CV_OVERRIDE
    {
        result = model;
        return checkRange(Mat(3, 1, CV_64F, result.val));
    }
    Ptr<Residual> createResidual(int) const CV_OVERRIDE { return makePtr<TranslationError>(); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return makePtr<TranslationSolver>();
    }
    Ptr<NonMinimalSolver> createNonMinimalSolver(const Ptr<Residual>&) const CV_OVERRIDE
    {
        return makePtr<TranslationFit>();
    }

private:
    const int errorDimensions, coordinatesOfAPoint;
};

TEST(Usac_CustomSpace, everyPreset)
{
    const Vec3d truth(0.7, -2, 0.3);
    std::vector<Point3d> points1, points2;
    RNG rng(2);
    for (int i = 0; i < 300; ++i)
    {
        const Vec3d a = uniformVector(rng, -3., 3.);
        const Vec3d noise = gaussianVector(rng, 0.01);
        points1.push_back(Point3d(a));
        points2.push_back(i % 3 ? Point3d(a + truth + noise)
                                : Point3d(uniformVector(rng, -5., 5.)));
    }
    EXPECT_EQ("", checkProblem(makePtr<TranslationProblem>(), points1, points2));
    for (const NamedPreset& preset : allPresets())
    {
        SCOPED_TRACE(preset.name);
        Params params = preset.params;
        params.threshold = 0.035;
        Mat mask;
        Report report;
        const Mat t = Usac::create(makePtr<TranslationProblem>(), points1, points2, params)
                          ->run(mask, &report);
        ASSERT_EQ(Size(1, 3), t.size());
        EXPECT_LE(cv::norm(Vec3d(t.ptr<double>()) - truth), 0.006);
        EXPECT_EQ(report.inliers, countNonZero(mask));
        EXPECT_LE(report.chance, 1e-6);
        if (!findsThreshold(params))
        {
            EXPECT_NEAR(198, report.inliers, 4);
        }
    }
}

//! Errors with more than three dimensions, with none, or with more dimensions than the points have
//! must be refused.
TEST(Usac_CustomSpace, dimensionsThatCannotBe)
{
    const Mat space = Mat::eye(10, 3, CV_64F), plane = Mat::eye(10, 2, CV_64F);
    expectException([&]() { Usac::create(makePtr<TranslationProblem>(4), space, space); },
                    "errors of 1 to 3 dimensions");
    expectException([&]() { Usac::create(makePtr<TranslationProblem>(0), space, space); },
                    "errors of 1 to 3 dimensions");
    expectException([&]() { Usac::create(makePtr<TranslationProblem>(3, 2), plane, plane); },
                    "not of 3");
    EXPECT_FALSE(Usac::create(makePtr<TranslationProblem>(), space, space).empty());
}

}  // namespace
}  // namespace opencv_test
