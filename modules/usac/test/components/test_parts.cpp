// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// Tests of how the main loop treats components that the caller has replaced.

namespace opencv_test {
namespace {

Params allOf(int iterations)
{
    Params params;
    params.termination = 0;
    params.maxIterations = iterations;
    return params;
}

//! A solver that returns one wrong model for the first sample and none for the others (`models_`
//! 1), or no model at all (0).
class FirstSample : public MinimalSolver
{
public:
    explicit FirstSample(int models_) : models(models_) {}

    int sampleSize() const CV_OVERRIDE { return 4; }
    int solve(const Correspondences&, const int*, Model* model) const CV_OVERRIDE
    {
        *model = Matx33d(1, 0, 1e3, 0, 1, 1e3, 0, 0, 1);
        return models > 0 ? models-- : 0;
    }

private:
    mutable int models;
};

//! A run with a termination criterion must end after a million samples if none of them has yielded
//! a model. Without a criterion, or if a sample has yielded a model, the run must end after
//! maxIterations. The model of FirstSample has no inliers, so that the run returns no model.
TEST(Usac_Parts, hopeless)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params = Params::ransac();
    params.maxIterations = 1100000;
    for (int models = 0; models < 2; ++models)
        for (int criteria = 0; criteria < 2; ++criteria)
        {
            params.termination = criteria ? TERMINATION_STANDARD : 0;
            const Ptr<Usac> usac = createUsac(scene, params);
            usac->components().minimalSolver = makePtr<FirstSample>(models);
            Report report;
            EXPECT_TRUE(usac->run(noArray(), &report).empty());
            EXPECT_EQ((int)STOP_NO_MODEL, report.stop);
            EXPECT_EQ(models, report.models);
            EXPECT_EQ(criteria && models == 0 ? 1000000 : 1100000, report.iterations)
                << models << " " << criteria;
        }
}

//! A degeneracy check that rejects either all models of samples (`fromSample`) or all models of the
//! local optimization.
class Refusal : public Degeneracy
{
public:
    explicit Refusal(bool fromSample_) : fromSample(fromSample_) {}
    bool recover(const Context&, State&, const int* sample, Model&, Quality&) CV_OVERRIDE
    {
        return (sample != 0) != fromSample;
    }

private:
    const bool fromSample;
};

TEST(Usac_Parts, refusedModelsAreDropped)
{
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int fromSample = 0; fromSample < 2; ++fromSample)
        {
            Params params = allOf(300);
            params.polishing = POLISHING_NONE;
            const Scene scene = makeScene((ProblemType)problem);
            const Ptr<Usac> usac = createUsac(scene, params);
            usac->components().degeneracies.assign(1, makePtr<Refusal>(fromSample != 0));
            Report report;
            EXPECT_EQ(fromSample != 0, usac->run(noArray(), &report).empty());
            EXPECT_EQ(fromSample == 0, report.localOptimizations > 0);
            EXPECT_EQ(0, report.localImprovements);
        }
}

//! A local optimizer that returns a worse model but reports an improvement. This model must have no
//! effect on the result.
class Worsener : public LocalOptimizer
{
public:
    bool optimize(const Context&, State&, Model& model, Quality& quality) CV_OVERRIDE
    {
        model = Matx33d::eye();
        quality.cost += 1;
        return true;
    }
};

TEST(Usac_Parts, worseModelsAreNotBelieved)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    Params params = allOf(300);
    params.degeneracy = 0;
    const Ptr<Usac> usac = createUsac(scene, params);
    usac->components().localOptimizer = makePtr<Worsener>();
    Mat mask, plainMask;
    Report report;
    const Mat model = usac->run(mask, &report);
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    const Mat plain = estimate(scene, params, plainMask);
    EXPECT_GT(report.localOptimizations, 1);
    EXPECT_EQ(0, report.localImprovements);
    EXPECT_EQ(0, cvtest::norm(plain, model, NORM_INF));
    EXPECT_EQ(0, cvtest::norm(plainMask, mask, NORM_INF));
}

//! Polishing needs a non-minimal solver. A run with neither polishing nor local optimization needs
//! none.
TEST(Usac_Parts, fitsNeedASolver)
{
    const Scene scene = makeScene(HOMOGRAPHY);
    for (int polishing = POLISHING_NONE; polishing <= POLISHING_ROBUST; ++polishing)
    {
        Params params = Params::ransac();
        params.polishing = (PolishingType)polishing;
        const Ptr<Usac> usac = createUsac(scene, params);
        usac->components().nonMinimalSolver.release();
        if (polishing == POLISHING_NONE)
            EXPECT_FALSE(usac->run().empty());
        else
            EXPECT_THROW(usac->run(), cv::Exception) << polishing;
    }
}

}  // namespace
}  // namespace opencv_test
