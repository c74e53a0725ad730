// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/run_context.hpp"
#include "significance/inlier_noise.hpp"

#include <cfloat>

// Tests of AutomaticThreshold::findCore(), a step of #THRESHOLD_ESTIMATED. If the inliers of a
// model have wide noise, this step looks for the model of a core: another model that explains at
// least half of these inliers with much smaller errors (within a third of the widest threshold).

namespace opencv_test {
namespace {

//! A solver for which every sample is degenerate. It counts in `narrow` the samples that are drawn
//! while the threshold is less than half of the widest one, as in findCore().
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

//! Returns the errors of the residual `inner`, and counts in `missing` how often the squared errors
//! of an empty model are requested.
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

//! The inliers of the initial model have wide noise, so that a core is looked for, but no sample
//! gives a model. There is then no model of a core that could be polished, and the initial model
//! must be kept.
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

//! Number of points whose error is 0 under the residual AtTheLimit; they are the first ones.
const int EXACT = 4;

/** A residual whose errors are the same for all models. The squared error of a match with equal
points in both images is 0 if x < 10 pixels, otherwise the smallest number of type float above the
square of the widest threshold. The squared error of any other match is infinite; such matches are
those that the estimation of the noise makes for comparison, see wrongErrors(). */
class AtTheLimit : public Residual
{
public:
    void start(const Context& context) CV_OVERRIDE
    {
        const double widest = context.points.threshold / context.params.reach;
        const Frame& frame = context.points.frame[0];
        left = (10 - frame.center[0]) * frame.scale;
        if (limit > 0)  // in later calls, the threshold might have been narrowed
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

//! The solver `inner`; counts in `exact` the samples that consist of the points without an error.
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

/** The noise is estimated from a histogram of errors in single precision. Due to rounding, errors
slightly above the widest threshold can count as within it, so that the noise is estimated as wide,
and a core is looked for. But only the four points without an error really are within the threshold.
As these are not more than a minimal sample, findCore() must draw no sample. */
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
