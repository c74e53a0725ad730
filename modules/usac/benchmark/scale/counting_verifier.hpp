// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_COUNTING_VERIFIER_HPP
#define OPENCV_USACV20_BENCHMARK_COUNTING_VERIFIER_HPP

#include "opencv2/usac/components.hpp"

namespace benchmark {

/** A verifier that counts the points on which models of minimal samples are tested.

A run calls the verifier before and after each block of points, so the verifier can count all tested
points. Blocks and decisions are those of the wrapped verifier; if there is none, the blocks are
those of a run without a verifier, and no model is rejected. It is not thread-safe. */
class CountingVerifier : public cv::usacv20::Verifier
{
public:
    //! @param verifier_ the verifier to wrap; null: none
    explicit CountingVerifier(const cv::Ptr<cv::usacv20::Verifier>& verifier_)
        : verifier(verifier_), before(0), count(0)
    {}

    void start(const cv::usacv20::Context& context) CV_OVERRIDE
    {
        if (verifier)
            verifier->start(context);
    }

    bool preTest(const cv::usacv20::Context& context, const cv::usacv20::Model& model,
                 cv::usacv20::Rng& rng, int& inliers, int& tested) const CV_OVERRIDE
    {
        const bool passed = !verifier || verifier->preTest(context, model, rng, inliers, tested);
        count += tested;
        return passed;
    }

    int nextBlock(int tested) const CV_OVERRIDE
    {
        before = tested;
        return verifier ? verifier->nextBlock(tested) : (int)LARGEST_BLOCK;
    }

    bool proceed(int inliers, int tested) const CV_OVERRIDE
    {
        count += tested - before;
        return !verifier || verifier->proceed(inliers, tested);
    }

    void sampleTested(cv::usacv20::State& state, int inliers, int tested) CV_OVERRIDE
    {
        if (verifier)
            verifier->sampleTested(state, inliers, tested);
    }

    void adapt(const cv::usacv20::Context& context, cv::usacv20::State& state) CV_OVERRIDE
    {
        if (verifier)
            verifier->adapt(context, state);
    }

    double keptProbability(const cv::usacv20::Context& context, double inliers,
                           bool withoutRepetition) const CV_OVERRIDE
    {
        return verifier ? verifier->keptProbability(context, inliers, withoutRepetition) : 1;
    }

    //! Number of tested points so far, summed over all models.
    int64 tested() const { return count; }

private:
    enum { LARGEST_BLOCK = 256 };  //!< the same as BLOCK in src/scoring/rate.cpp

    const cv::Ptr<cv::usacv20::Verifier> verifier;
    mutable int before;
    mutable int64 count;
};

}  // namespace benchmark

#endif
