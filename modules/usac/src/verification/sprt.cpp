// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "verification/verification.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Points per block: FIRST_BLOCK until FIRST_BLOCKS_END points have been tested, then SECOND_BLOCK
//! until SECOND_BLOCKS_END points have been tested, then BLOCK.
constexpr int FIRST_BLOCK = 32, FIRST_BLOCKS_END = 64, SECOND_BLOCK = 64, SECOND_BLOCKS_END = 256,
              BLOCK = 256;
//! Prior value of delta, and its weight, expressed as a number of tested points.
constexpr double PRIOR_DELTA = 0.01, PRIOR_POINTS = 100;
//! Upper bounds of epsilon and of the ratio delta / epsilon. They keep the logarithms of the
//! likelihood ratios finite and away from 0.
constexpr double MOST_EPSILON = 0.99, MOST_DELTA = 0.8;
//! A new test is designed when epsilon has increased, or when delta has changed by more than this
//! fraction of its value @cite matas2005randomized.
constexpr double CHANGED = 0.05;
//! Steps of the fixed-point iteration for A. Each step divides the error of A by about A, which
//! exceeds 10 unless epsilon is small or close to delta.
constexpr int DESIGN_STEPS = 10;

/** @brief Wald's sequential probability ratio test on blocks of points @cite matas2005randomized
@cite chum2008optimal.

A point is an inlier of a good model with probability epsilon, and of a bad model with probability
delta. After t points, of which k are inliers, the likelihood ratio of a bad and a good model is
(delta / epsilon)^k ((1 - delta) / (1 - epsilon))^(t - k). A model is rejected when this ratio
exceeds A. The A that minimizes the expected time solves A = K + log A with K = 1 + C t_M / m_S.
Here C is the expected logarithm of the likelihood ratio of one point under a bad model, t_M is the
time to compute the models of a sample, in units of the time to test a point, and m_S is the number
of models per sample.

Epsilon and delta are estimated during the run. Epsilon is the inlier ratio of the best model of a
sample so far, before local optimization. Delta is the mean inlier ratio in the first blocks of all
models; the first block is tested in any case. Before there is such a model, no model is rejected.
The test changes only between batches of samples, so that it does not depend on the number of
threads. */
class SprtVerifier : public Verifier
{
public:
    explicit SprtVerifier(const SampleCost& cost_) : cost(cost_) { forget(); }

    void start(const Context&) CV_OVERRIDE { forget(); }

    int nextBlock(int tested) const CV_OVERRIDE
    {
        return tested < FIRST_BLOCKS_END    ? FIRST_BLOCK
               : tested < SECOND_BLOCKS_END ? SECOND_BLOCK
                                            : BLOCK;
    }

    bool proceed(int inliers, int tested) const CV_OVERRIDE
    {
        return inliers * inlierStep + (tested - inliers) * outlierStep <= logA;
    }

    void sampleTested(State& state, int inliers, int tested) CV_OVERRIDE
    {
        if (!state.tests.empty())
            state.tests.back().samples += state.counts;
        inliersSeen += inliers;
        pointsSeen += tested;
    }

    void adapt(const Context& context, State& state) CV_OVERRIDE
    {
        if (state.sampleQuality.inliers == 0)
            return;  // epsilon is not known yet: no model is rejected
        const double epsilon = std::min((double)state.sampleQuality.inliers / context.points.size,
                                        MOST_EPSILON);
        const double delta = std::min((PRIOR_POINTS * PRIOR_DELTA + inliersSeen) /
                                          (PRIOR_POINTS + pointsSeen),
                                      MOST_DELTA * epsilon);
        if (!state.tests.empty() && epsilon <= current.epsilon &&
            std::abs(delta - current.delta) <= CHANGED * current.delta)
            return;
        design(epsilon, delta);
        state.tests.push(context.arena, current);
    }

private:
    void forget()
    {
        current = SequentialTest();
        inlierStep = outlierStep = logA = inliersSeen = pointsSeen = 0;
    }

    void design(double epsilon, double delta)
    {
        inlierStep = std::log(delta / epsilon);
        outlierStep = std::log((1 - delta) / (1 - epsilon));
        const double C = (1 - delta) * outlierStep + delta * inlierStep;
        const double K = 1 + cost.time * C / cost.models;
        double A = K;
        for (int i = 0; i < DESIGN_STEPS; ++i)
            A = K + std::log(A);
        logA = std::log(A);
        current.epsilon = epsilon;
        current.delta = delta;
        current.A = A;
        current.samples = 0;
    }

    const SampleCost cost;
    SequentialTest current;
    double inlierStep, outlierStep, logA;
    double inliersSeen, pointsSeen;
};

}  // namespace

Ptr<Verifier> createSprtVerifier(const SampleCost& cost) { return makePtr<SprtVerifier>(cost); }

}  // namespace usacv20
}  // namespace cv
