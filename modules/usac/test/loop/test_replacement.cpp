// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/sample_statistics.hpp"
#include "../../../../samples/line_distance.hpp"

// A component that the caller has replaced must take effect everywhere. An unsuitable component
// must raise an exception that names it.

namespace opencv_test {
namespace {

//! The residual of the sample program: the distance to the epipolar line in image 2. Its derivative
//! is computed analytically or (if `derived` is false) by finite differences.
class LineDistance : public custom::LineDistance
{
public:
    explicit LineDistance(bool derived_) : derived(derived_) {}

    int linearize(const Model& F, const double* match, double* out,
                  double* derivative) const CV_OVERRIDE
    {
        return derived ? custom::LineDistance::linearize(F, match, out, derivative)
                       : Residual::linearize(F, match, out, derivative);
    }

private:
    const bool derived;
};

//! Root mean square distance in pixels of the marked matches to their epipolar lines in image 2.
double lineError(const Scene& scene, const Mat& model, const Mat& mask)
{
    const Matx33d F((const double*)model.ptr());
    double sum = 0;
    for (int i = 0; i < scene.size(); ++i)
        if (mask.at<uchar>(i))
        {
            const Vec3d line = F * Vec3d(scene.points1[i].x, scene.points1[i].y, 1);
            const double d = line.dot(Vec3d(scene.points2[i].x, scene.points2[i].y, 1)) /
                             std::hypot(line[0], line[1]);
            sum += d * d;
        }
    return std::sqrt(sum / countNonZero(mask));
}

Scene zoomedScene()
{
    SceneOptions options;
    options.motion = MOTION_FORWARD;
    options.outliers = 60;
    options.noise = 1;
    return makeScene(FUNDAMENTAL, options);
}

//! A replaced residual must be used for scores, fits and the mask: the mask must agree with this
//! residual, and no nearby F of rank 2 must have a smaller error over the matches in the mask.
TEST(Usac_Replacement, residual)
{
    const Scene scene = zoomedScene();
    Params params;
    params.threshold = 3;
    params.polishing = POLISHING_LEAST_SQUARES;
    params.polishingSteps = 100;
    Mat models[2];
    for (int derived = 0; derived < 2; ++derived)
    {
        const Ptr<Usac> usac = createUsac(scene, params);
        const Ptr<Residual> residual = makePtr<LineDistance>(derived != 0);
        usac->components().residual = residual;
        Mat mask;
        models[derived] = usac->run(mask);
        ASSERT_FALSE(models[derived].empty());
        const double found = lineError(scene, models[derived], mask);
        for (int i = 0; i < scene.size(); ++i)
        {
            Mat one = Mat::zeros(scene.size(), 1, CV_8U);
            one.at<uchar>(i) = 1;
            EXPECT_EQ(lineError(scene, models[derived], one) <= params.threshold,
                      mask.at<uchar>(i) != 0)
                << i;
        }
        RNG rng(5);
        for (int i = 0; i < 200; ++i)  // compares with nearby models of rank 2
        {
            Matx33d other((const double*)models[derived].ptr());
            for (int k = 0; k < 9; ++k)
                other.val[k] *= 1 + rng.gaussian(1e-3);
            Matx33d U, Vt;
            Vec3d w;
            SVD::compute(other, w, U, Vt);
            const Mat near(U * Matx33d::diag(Vec3d(w[0], w[1], 0)) * Vt, true);
            EXPECT_GE(lineError(scene, near, mask), found * (1 - 1e-9));
        }
    }
    EXPECT_LE(cv::norm(models[0], models[1]), 1e-6);
    const Mat sampson = estimate(scene, params);
    EXPECT_GT(cv::norm(models[0], sampson), 1e-5) << "the two residuals have the same minimum";
}

//! If the first residual is restored, the fits must use it again.
TEST(Usac_Replacement, residualAndBack)
{
    const Scene scene = zoomedScene();
    const Params params;
    const Ptr<Usac> usac = createUsac(scene, params);
    const Ptr<Residual> given = usac->components().residual;
    usac->components().residual = makePtr<LineDistance>(true);
    const Mat first = usac->run();
    EXPECT_EQ(0, cv::norm(first, usac->run(), NORM_INF));
    usac->components().residual = given;
    const Mat back = usac->run();
    EXPECT_EQ(0, cv::norm(back, estimate(scene, params), NORM_INF));
    EXPECT_GT(cv::norm(first, back), 1e-5);
}

//! Draws uniform samples, whatever Params::sampler is. With `mistake` 1 to 3, the samples are
//! invalid.
class OwnSampler : public Sampler
{
public:
    explicit OwnSampler(int mistake_ = 0) : mistake(mistake_) {}

    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        state.rng.distinct(context.points.size, m, out);
        if (mistake == 1)
            out[1] = context.points.size;
        if (mistake == 2)
            out[1] = out[0];
        if (mistake == 3)
            out[0] = -1;
    }

private:
    const int mistake;
};

//! The score of QUALITY_INLIERS, as a caller would write it.
class InliersOnly : public Score
{
public:
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            sum.inliers += squaredErrors[i] <= squaredThreshold;
            sum.cost += !(squaredErrors[i] <= squaredThreshold);
        }
    }
    bool countsInliers() const CV_OVERRIDE { return true; }
};

//! A caller's score that needs the errors of all points in each call of accumulate(), as a score
//! with a value for each point would. `wrong` counts the calls with another number of errors.
class OwnNumbers : public Score
{
public:
    OwnNumbers() : calls(0), wrong(0) {}
    void start(const Context& context) CV_OVERRIDE { size = context.points.size; }
    bool wholeModel() const CV_OVERRIDE { return true; }
    void accumulate(float* squaredErrors, int count, float squaredThreshold,
                    Quality& sum) const CV_OVERRIDE
    {
        ++calls;
        wrong += count != size;
        InliersOnly().accumulate(squaredErrors, count, squaredThreshold, sum);
    }
    int size;
    mutable int calls, wrong;
};

//! If Score::wholeModel() returns true, each call of accumulate() must get the errors of all
//! points, also in the check of the score before the search.
TEST(Usac_Replacement, scoreOfAllPoints)
{
    for (int size : {0, 3, 300})
    {
        const Scene scene = makeScene(HOMOGRAPHY, size, 0);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Ptr<OwnNumbers> score = makePtr<OwnNumbers>();
        usac->components().score = score;
        EXPECT_EQ(size < 4, usac->run().empty());
        EXPECT_EQ(size > 0, score->calls > 0) << size;
        EXPECT_EQ(0, score->wrong) << size;
    }
}

//! How a run uses a score must depend on the score itself and not on Params::quality. The result
//! must be that of QUALITY_INLIERS.
TEST(Usac_Replacement, score)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        SceneOptions options;
        options.setSize(60, 0.4);
        const Scene scene = makeScene((ProblemType)problem, options);
        Params params;
        const Ptr<Usac> replaced = createUsac(scene, params);
        replaced->components().score = makePtr<InliersOnly>();
        params.quality = QUALITY_INLIERS;
        Mat masks[2];
        Report reports[2];
        const Mat model = replaced->run(masks[0], &reports[0]);
        EXPECT_EQ(0,
                  cv::norm(model, createUsac(scene, params)->run(masks[1], &reports[1]), NORM_INF));
        EXPECT_EQ(0, cv::norm(masks[0], masks[1], NORM_INF));
        EXPECT_EQ(reports[1].iterations, reports[0].iterations);
        EXPECT_EQ(reports[1].chance, reports[0].chance);
    }
}

//! With a caller's uniform sampler, the standard criterion must end the run after the number of
//! samples that theory requires. PROSAC's criterion must not end it, because it does not apply to
//! uniform samples.
TEST(Usac_Replacement, uniformSampler)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    for (int sorted = 0; sorted < 2; ++sorted)
    {
        int asComputed = 0;
        for (int seed = 0; seed < 20; ++seed)
        {
            Params params = Params::prosac();
            params.sampler = sorted ? SAMPLER_PROSAC : SAMPLER_P_NAPSAC;
            params.termination = TERMINATION_STANDARD | TERMINATION_EXACT | TERMINATION_PROSAC;
            params.polishing = POLISHING_NONE;
            params.maxIterations = 100000;
            params.seed = seed;
            const Ptr<Usac> usac = createUsac(scene, params);
            usac->components().sampler = makePtr<OwnSampler>();
            Report report;
            EXPECT_FALSE(usac->run(noArray(), &report).empty());
            EXPECT_EQ((int)STOP_STANDARD, report.stop);
            const double good = goodSampleProbability(report.inliers, scene.size(), 4);
            const int needed = samplesNeeded(good, std::log(1 - params.confidence));
            EXPECT_GE(report.iterations, needed);
            asComputed += report.iterations == needed;  // otherwise the best model was found later
        }
        EXPECT_GE(asComputed, 15);
    }
}

//! A score that counts no inliers, whose cost is out of range, or that overwrites the sums.
class BadScore : public Score
{
public:
    explicit BadScore(int mistake_) : mistake(mistake_) {}

    void accumulate(float*, int count, float, Quality& sum) const CV_OVERRIDE
    {
        if (mistake == 3)
            sum.cost = 0;
        if (mistake == 4)
            sum.inliers = 0;
        sum.cost += mistake == 0 ? 0.5 * count : mistake == 1 ? 2. * count : mistake == 2 ? -1 : 0;
        sum.inliers += mistake == 0 ? 0 : count;
    }

private:
    const int mistake;
};

//! The message of the exception that a run raises, or "" if it raises none.
std::string complaint(const Ptr<Usac>& usac)
{
    try
    {
        usac->run();
    }
    catch (const cv::Exception& e)
    {
        return e.err;
    }
    return "";
}

#define EXPECT_COMPLAINT(name, usac)                                                               \
    EXPECT_EQ(0u, complaint(usac).find("components()." name)) << complaint(usac)

TEST(Usac_Replacement, mistakesAreNamed)
{
    for (int problem : TWO_VIEW_PROBLEMS)
    {
        if (sampleSizeOf(problem) == 1)
            continue;
        const Scene scene = makeScene((ProblemType)problem);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Components given = usac->components();
        Components& parts = usac->components();
        parts.residual.release();
        EXPECT_COMPLAINT("residual", usac);
        parts = given;
        parts.score.release();
        EXPECT_COMPLAINT("score", usac);
        parts = given;
        parts.sampler.release();
        EXPECT_COMPLAINT("sampler", usac);
        parts = given;
        parts.minimalSolver.release();
        EXPECT_COMPLAINT("minimalSolver", usac);
        parts = given;
        parts.degeneracies.push_back(Ptr<Degeneracy>());
        EXPECT_COMPLAINT("degeneracies[", usac);
        parts = given;
        parts.terminations.push_back(Ptr<Termination>());
        EXPECT_COMPLAINT("terminations[", usac);
        for (int mistake = 1; mistake <= 3; ++mistake)
        {
            parts = given;
            parts.sampler = makePtr<OwnSampler>(mistake);
            EXPECT_COMPLAINT("sampler", usac);
        }
        for (int mistake = 0; mistake <= 4; ++mistake)
        {
            parts = given;
            parts.score = makePtr<BadScore>(mistake);
            EXPECT_COMPLAINT("score", usac);
        }
        parts = given;
        parts.nonMinimalSolver.release();
        EXPECT_COMPLAINT("nonMinimalSolver", usac);
        parts = given;
        parts.neighborhood.release();
        EXPECT_COMPLAINT("neighborhood", usac);
        parts = createUsac(scene, Params())->components();
        EXPECT_EQ("", complaint(usac)) << "all components are valid again";
    }
}

//! A null problem must raise an exception.
TEST(Usac_Replacement, problem)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    EXPECT_THROW(Usac::create(Ptr<Problem>(), scene.points1, scene.points2), cv::Exception);
}

//! The score InliersOnly with a given inlierPart(), the fraction of the threshold up to which
//! errors count as those of inliers. Valid fractions are above 0 and at most 1.
class PartlyInliers : public InliersOnly
{
public:
    explicit PartlyInliers(double part_) : part(part_) {}
    double inlierPart() const CV_OVERRIDE { return part; }

private:
    const double part;
};

//! A minimal solver with a given sample size, which never finds a model.
class NoModels : public MinimalSolver
{
public:
    explicit NoModels(int size_) : size(size_) {}
    int sampleSize() const CV_OVERRIDE { return size; }
    int solve(const Correspondences&, const int*, Model*) const CV_OVERRIDE { return 0; }

private:
    const int size;
};

TEST(Usac_Replacement, numbersOutOfRangeAreNamed)
{
    Params params;
    params.maxIterations = 100;
    const Scene scene = makeScene(HOMOGRAPHY);
    for (double part : {0., 0.5, 1., 1.5, (double)NAN})
    {
        SCOPED_TRACE(part);
        const Ptr<Usac> usac = createUsac(scene, params);
        usac->components().score = makePtr<PartlyInliers>(part);
        if (part > 0 && part <= 1)
            EXPECT_EQ("", complaint(usac));
        else
            EXPECT_COMPLAINT("score: inlierPart() is ", usac);
    }
    for (int size : {-1, 0, 1, (int)MAX_SAMPLE_SIZE, MAX_SAMPLE_SIZE + 1})
    {
        SCOPED_TRACE(size);
        const Ptr<Usac> usac = createUsac(scene, params);
        usac->components().minimalSolver = makePtr<NoModels>(size);
        if (size >= 1 && size <= MAX_SAMPLE_SIZE)
            EXPECT_EQ("", complaint(usac));
        else
            EXPECT_COMPLAINT("minimalSolver: samples of 1 to 8 points", usac);
    }
}

//! A polisher without Polisher::support(), so that it is unknown what it minimizes.
class SilentPolisher : public Polisher
{
public:
    explicit SilentPolisher(const Ptr<Polisher>& given_) : given(given_) {}
    void start(const Context& context) CV_OVERRIDE { given->start(context); }
    void polish(const Context& context, Model& model) CV_OVERRIDE { given->polish(context, model); }

private:
    const Ptr<Polisher> given;
};

//! If it is unknown what the polisher minimizes, all entries of the covariance must be NaN.
TEST(Usac_Replacement, covarianceWithAPolisherOfTheCaller)
{
    Params params;
    params.covariance = 1;
    const Scene scene = makeScene(HOMOGRAPHY);
    const Ptr<Usac> usac = createUsac(scene, params);
    Report told, silent;
    const Mat model = usac->run(noArray(), &told);
    usac->components().polisher = makePtr<SilentPolisher>(usac->components().polisher);
    EXPECT_EQ(0, cv::norm(model, usac->run(noArray(), &silent), NORM_INF));
    ASSERT_EQ(Size(8, 8), told.covariance.size());
    ASSERT_EQ(Size(8, 8), silent.covariance.size());
    for (int i = 0; i < 64; ++i)
    {
        EXPECT_FALSE(cvIsNaN(told.covariance.at<double>(i / 8, i % 8))) << i;
        EXPECT_TRUE(cvIsNaN(silent.covariance.at<double>(i / 8, i % 8))) << i;
    }
    EXPECT_GT(told.sigma, 0);
    EXPECT_EQ(0, silent.sigma);
}

}  // namespace
}  // namespace opencv_test
