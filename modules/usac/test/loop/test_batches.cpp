// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

namespace opencv_test {
namespace {

//! A uniform sampler that records the sizes of the batches.
class BatchRecorder : public Sampler
{
public:
    BatchRecorder() : models(-1) {}

    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           out);
        if (state.report.models != models)  // the models of the previous batch have been computed
            sizes.push_back(0);
        models = state.report.models;
        ++sizes.back();
    }

    std::vector<int> sizes;

private:
    int models;
};

//! A verifier that accepts all models and records when it is adapted.
class AdaptRecorder : public Verifier
{
public:
    int nextBlock(int) const CV_OVERRIDE { return INT_MAX; }
    bool proceed(int, int) const CV_OVERRIDE { return true; }
    void sampleTested(State&, int, int) CV_OVERRIDE {}
    void adapt(const Context&, State& state) CV_OVERRIDE { after.push_back(state.iteration); }

    std::vector<int> after;
};

//! Batches must grow, and the verifier must be adapted between them.
TEST(Usac_Batches, grow)
{
    Params params;
    params.termination = 0;
    params.maxIterations = 60;
    const Ptr<Usac> usac = createUsac(makeScene(HOMOGRAPHY), params);
    const Ptr<BatchRecorder> recorder = makePtr<BatchRecorder>();
    const Ptr<AdaptRecorder> verifier = makePtr<AdaptRecorder>();
    usac->components().sampler = recorder;
    usac->components().verifier = verifier;
    EXPECT_FALSE(usac->run().empty());
    EXPECT_EQ(std::vector<int>({8, 16, 32, 4}), recorder->sizes);
    EXPECT_EQ(std::vector<int>({0, 8, 24, 56, 60}), verifier->after);
}

}  // namespace
}  // namespace opencv_test
