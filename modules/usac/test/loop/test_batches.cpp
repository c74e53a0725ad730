// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

namespace opencv_test {
namespace {

//! A uniform sampler with a prelude, which records the sizes of the batches.
class BatchRecorder : public Sampler
{
public:
    explicit BatchRecorder(int prelude_) : before(prelude_), models(-1) {}

    void sample(const Context& context, State& state, int* out) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           out);
        if (state.report.models != models)  // the models of the previous batch have been computed
            sizes.push_back(0);
        models = state.report.models;
        ++sizes.back();
    }
    int prelude(const Context&) const CV_OVERRIDE { return before; }

    std::vector<int> sizes;

private:
    const int before;
    int models;
};

//! After the prelude, batches must begin small again.
TEST(Usac_Batches, begin_anew_after_a_prelude)
{
    const struct
    {
        int prelude, maxIterations;
        std::vector<int> expected;
    } cases[] = {{0, 60, {8, 16, 32, 4}},
                 {5, 60, {5, 8, 16, 31}},
                 {20, 60, {8, 12, 8, 16, 16}},
                 {100, 20, {8, 12}}};
    for (const auto& c : cases)
    {
        Params params;
        params.termination = 0;
        params.maxIterations = c.maxIterations;
        const Ptr<Usac> usac = createUsac(makeScene(HOMOGRAPHY), params);
        const Ptr<BatchRecorder> recorder = makePtr<BatchRecorder>(c.prelude);
        usac->components().sampler = recorder;
        EXPECT_FALSE(usac->run().empty());
        EXPECT_EQ(c.expected, recorder->sizes) << "prelude " << c.prelude;
    }
}

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

//! The verifier must not be adapted to the models of the prelude.
TEST(Usac_Batches, verifier_is_adapted_after_the_prelude)
{
    Params params;
    params.termination = 0;
    params.maxIterations = 60;
    const Ptr<Usac> usac = createUsac(makeScene(HOMOGRAPHY), params);
    const Ptr<AdaptRecorder> recorder = makePtr<AdaptRecorder>();
    usac->components().sampler = makePtr<BatchRecorder>(20);
    usac->components().verifier = recorder;
    EXPECT_FALSE(usac->run().empty());
    EXPECT_EQ(std::vector<int>({0, 28, 44, 60}), recorder->after);
}

}  // namespace
}  // namespace opencv_test
