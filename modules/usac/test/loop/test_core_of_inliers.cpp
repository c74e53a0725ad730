// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "significance/inlier_noise.hpp"

#include <cfloat>

// Tests of the step of #THRESHOLD_ESTIMATED that looks for a core: a model that explains many of
// the inliers of a model with wide noise by much smaller errors.

namespace opencv_test {
namespace {

//! A solver for which every sample is degenerate. Counts the samples that are drawn with less than
//! half of the widest threshold, as those of a core are.
class UnsolvedSamples : public MinimalSolver
{
public:
    UnsolvedSamples(int size_, double widest_) : size(size_), widest(widest_), narrow(0) {}

    int sampleSize() const CV_OVERRIDE { return size; }
    int solve(const Correspondences& points, const int*, Model*) const CV_OVERRIDE
    {
        narrow += points.threshold < widest / 2;
        return 0;
    }

    const int size;
    const double widest;
    mutable int narrow;
};

//! The errors of another residual; notices if it is asked for the errors of a missing model.
class NeedsAModel : public Residual
{
public:
    explicit NeedsAModel(const Ptr<Residual>& inner_) : inner(inner_), missing(0) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        missing += model.size() == 0;
        inner->squaredErrors(points, model, begin, end, errors);
    }
    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        missing += model.size() == 0;
        inner->squaredErrors(model, columns, count, errors);
    }
    int error(const Model& model, const double* datum, double* errors) const CV_OVERRIDE
    {
        return inner->error(model, datum, errors);
    }

    const Ptr<Residual> inner;
    mutable int missing;
};

//! The noise of the initial model is wide, so that a core is looked for, but no sample gives a
//! model. There is then no core that could be polished, and the initial model must be kept.
TEST(Usac_Core, isNotPolishedIfNoSampleGivesAModel)
{
    SceneOptions options;
    options.outliers = 50;
    options.noise = 1.5;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    Params params = Params::automatic();
    params.threshold = 4.5;
    params.maxIterations = 10;
    params.setInitialModel(Mat(scene.model));
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<UnsolvedSamples> none = makePtr<UnsolvedSamples>(4, usac->points().threshold);
    const Ptr<NeedsAModel> residual = makePtr<NeedsAModel>(usac->components().residual);
    usac->components().minimalSolver = none;
    usac->components().residual = residual;
    Mat mask;
    Report report;
    const Mat model = usac->run(mask, &report);
    EXPECT_GT(none->narrow, 0) << "a core was not looked for";
    EXPECT_EQ(0, residual->missing);
    EXPECT_LT(modelError(scene, model), 1);
    EXPECT_GT(report.threshold, params.threshold / 3);
}

//! Number of points of AtTheLimit without an error.
const int EXACT = 4;

/** Under any model, right matches have an error that exceeds the widest threshold by rounding only.
A match is right if its points in both images are equal; those with x < 10 have no error. */
class AtTheLimit : public Residual
{
public:
    void start(const Context& context) CV_OVERRIDE
    {
        const double widest = context.points.threshold / context.params.reach;
        const Frame& frame = context.points.frame[0];
        left = (10 - frame.center[0]) * frame.scale;
        if (limit > 0)  // the guess narrows the threshold after the first call
            return;
        limit = (float)(widest * widest);
        while (!(limit > widest * widest))
            limit = std::nextafter(limit, FLT_MAX);
    }

    void squaredErrors(const Correspondences& p, const Model&, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
            errors[i - begin] = square(p.exact[X1][i], p.exact[Y1][i], p.exact[X2][i],
                                       p.exact[Y2][i]);
    }
    void squaredErrors(const Model&, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
            errors[i] = square(c[X1][i], c[Y1][i], c[X2][i], c[Y2][i]);
    }

    float limit = 0;

private:
    float square(double x1, double y1, double x2, double y2) const
    {
        return x1 != x2 || y1 != y2 ? (float)INFINITY : x1 < left ? 0 : limit;
    }

    double left = 0;
};

//! Notices samples that consist of the points without an error.
class WatchesSamples : public MinimalSolver
{
public:
    explicit WatchesSamples(const Ptr<MinimalSolver>& inner_) : inner(inner_), exact(0) {}

    int sampleSize() const CV_OVERRIDE { return inner->sampleSize(); }
    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        int found = 0;
        for (int k = 0; k < EXACT; ++k)
            found += p.inputIndex[sample[k]] < EXACT;
        exact += found == EXACT;
        return inner->solve(p, sample, models);
    }

    const Ptr<MinimalSolver> inner;
    mutable int exact;
};

/** The noise is estimated from histograms in single precision, in which errors at the widest
threshold can be within it. Then only the points of one sample are inliers of the model. There is no
choice of samples that could give a core, so that this sample must not be drawn. */
TEST(Usac_Core, needsMoreInliersThanAMinimalSample)
{
    RNG rng(1);
    std::vector<Point2d> points;
    for (int i = 0; i < 100; ++i)
        points.push_back(uniformPoint(rng, i < EXACT ? 0. : 20., i < EXACT ? 9. : 640., 0., 480.));
    int rounded = 0;
    for (int k = 0; k < 40; ++k)
    {
        Params params = Params::automatic();
        params.threshold = 2 + 0.01 * k;
        params.maxIterations = 20;
        params.localOptimization = LOCAL_OPTIMIZATION_NONE;
        params.polishing = POLISHING_NONE;
        const Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points, points, params);
        const Ptr<AtTheLimit> residual = makePtr<AtTheLimit>();
        const Ptr<WatchesSamples> solver = makePtr<WatchesSamples>(
            usac->components().minimalSolver);
        usac->components().residual = residual;
        usac->components().minimalSolver = solver;
        const RunContext context(usac->points(), usac->components(), params);
        const double widest = usac->points().threshold / params.reach;
        const InlierNoise noise = roughNoise(context, Matx33d::eye(), widest, 300, true);
        rounded += noise.threshold == widest;
        usac->run();
        EXPECT_EQ(0, solver->exact) << params.threshold;
    }
    EXPECT_GT(rounded, 0);
}

}  // namespace
}  // namespace opencv_test
