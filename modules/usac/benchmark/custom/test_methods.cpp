// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Methods for test_custom.py, test_problems.py, test_views.py and test_spaces.py; their results are
// known beforehand. With the single argument "mistakes", the program makes invalid registrations
// and factories, which must raise exceptions, and prints the message of each exception on a line.

#include <iostream>
#include <stdexcept>
#include "benchmark.hpp"
#include "components_method.hpp"
#include "estimator_method.hpp"
#include "problems/problem_kind.hpp"
#include "program.hpp"

namespace {

using namespace benchmark;
using cv::usacv20::Params;

//! Draws uniform samples exactly as the module's own uniform sampler does.
class SameSampler : public cv::usacv20::Sampler
{
public:
    void sample(const cv::usacv20::Context& context, cv::usacv20::State& state,
                int* sample) CV_OVERRIDE
    {
        state.rng.distinct(context.points.size, context.components.minimalSolver->sampleSize(),
                           sample);
    }
};

void sameSampler(cv::usacv20::Usac& usac)
{
    usac.components().sampler = cv::makePtr<SameSampler>();
}

void noSampler(cv::usacv20::Usac& usac) { usac.components().sampler.reset(); }

//! Returns the identity, and encodes some of the task's settings and data in the number of
//! iterations.
Estimate echo(const Task& task)
{
    const Settings& s = task.settings;
    Estimate estimate;
    estimate.model = cv::Mat::eye(3, 3, CV_64F);
    estimate.mask = cv::Mat::ones((int)task.points1.size(), 1, CV_8U);
    estimate.iterations = (int)task.fields.at("number") + 10 * s.seed + 1000 * s.maxIterations +
                          (task.scores.size() == task.points1.size() ? 100000 : 0) +
                          (task.K1 == cv::Matx33d::eye() ? 0 : 200000);
    return estimate;
}

//! Returns the identity (or its first rows) for any matches, with a mask in which all matches are
//! inliers.
Estimate identity(const Task& task)
{
    Estimate estimate;
    estimate.model = cv::Mat::eye(kindOf(task.settings.problem).modelSize, CV_64F);
    estimate.mask = cv::Mat::ones((int)(task.points2.size() + task.spacePoints2.size()), 1, CV_8U);
    return estimate;
}

Estimate complain(const Task&) { throw std::runtime_error("not today"); }

Estimate shortMask(const Task&)
{
    Estimate estimate;
    estimate.model = cv::Mat::eye(3, 3, CV_64F);
    estimate.mask = cv::Mat::ones(1, 1, CV_8U);
    return estimate;
}

Estimate smallModel(const Task&)
{
    Estimate estimate;
    estimate.model = cv::Mat::eye(2, 2, CV_64F);
    return estimate;
}

cv::Ptr<Method> nothing(const MethodName&) { return cv::Ptr<Method>(); }

void registerAll()
{
    EstimatorTraits traits("HE", true);
    traits.fields["number"] = 3;
    registerMethod("custom:same", withComponents(Params::ransac(), sameSampler, "HF"));
    registerMethod("custom:echo", wholeEstimator(echo, traits));
    registerMethod("custom:identity", wholeEstimator(identity, EstimatorTraits("ASPRMT")));
    registerMethod("custom:noSampler", withComponents(Params::ransac(), noSampler));
    registerMethod("custom:complain", wholeEstimator(complain));
    registerMethod("custom:shortMask", wholeEstimator(shortMask));
    registerMethod("custom:smallModel", wholeEstimator(smallModel));
    registerMethod("custom:nothing", nothing);
}

template <class Attempt>
void printRefusal(Attempt attempt)
{
    try
    {
        attempt();
        std::cout << "accepted" << std::endl;
    }
    catch (const std::runtime_error& error)
    {
        std::cout << error.what() << std::endl;
    }
}

void printMistakes()
{
    printRefusal([] { registerMethod("custom:same", nothing); });
    for (const char* name :
         {"mine", "custom:", "custom:a,b", "custom:a{b", "custom:a+scores", "Custom:a"})
        printRefusal([=] { registerMethod(name, nothing); });
    printRefusal([] { registerMethod("custom:empty", MethodFactory()); });
    printRefusal([] { withComponents(Params(), ComponentChange()); });
    printRefusal([] { wholeEstimator(Estimator()); });
    printRefusal([] { withComponents(Params(), noSampler, "HX"); });
    printRefusal([] { withComponents(Params(), noSampler, ""); });
}

int program(int argc, char** argv)
{
    registerAll();
    if (argc != 2 || std::string(argv[1]) != "mistakes")
        return runBenchmark(argc, argv);
    printMistakes();
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
