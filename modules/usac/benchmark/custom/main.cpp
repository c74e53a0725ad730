// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// The benchmark with user-defined methods in addition to those of usac_benchmark: two methods in
// which one component is replaced, and one method that does not use the module at all.
//
//     usac_custom_benchmark --data=<folder>
//     --methods=USACV20,custom:spread,custom:tukey,custom:ransac > tables.md
//
// The components are those of samples/custom_sampler.cpp and samples/custom_quality.cpp. See
// doc/benchmark.md, "Your own method".

#include "benchmark.hpp"
#include "components_method.hpp"
#include "estimator_method.hpp"
#include "opencv2/usac/geometry.hpp"
#include "program.hpp"
#include "spread_sampler.hpp"
#include "tukey_score.hpp"

namespace {

using namespace benchmark;

void spreadSamples(cv::usacv20::Usac& usac)
{
    usac.components().sampler = cv::makePtr<custom::SpreadSampler>();
}

void tukeyQuality(cv::usacv20::Usac& usac)
{
    usac.components().score = cv::makePtr<custom::TukeyScore>();
}

//! An example for wholeEstimator, which accepts any function that makes a model from points. This
//! one calls OpenCV's RANSAC, so its models are those of the method cv:RANSAC.
Estimate opencvRansac(const Task& task)
{
    const Settings& settings = task.settings;
    Estimate estimate;
    if (settings.problem == cv::usacv20::HOMOGRAPHY)
        estimate.model = cv::findHomography(task.points1, task.points2, cv::RANSAC,
                                            settings.threshold, estimate.mask,
                                            settings.maxIterations, settings.confidence);
    else
        estimate.model = cv::findFundamentalMat(task.points1, task.points2, cv::RANSAC,
                                                settings.threshold, settings.confidence,
                                                settings.maxIterations, estimate.mask);
    return estimate;
}

int program(int argc, char** argv)
{
    registerMethod("custom:spread", withComponents(cv::usacv20::Params::usacV20(), spreadSamples));
    registerMethod("custom:tukey", withComponents(cv::usacv20::Params::usacV20(), tukeyQuality));
    registerMethod("custom:ransac", wholeEstimator(opencvRansac, EstimatorTraits("HF")));
    return runBenchmark(argc, argv);
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
