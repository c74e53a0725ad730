// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "meter.hpp"

#include <iostream>
#include "problems/problem_kind.hpp"
#include "stopwatch.hpp"

namespace benchmark {

Run Meter::measure(Method& method, const ImagePair& pair, Settings settings, int repeat)
{
    Run run = Run();
    Estimate estimate;
    settings.seed += repeat;
    method.prepare(pair, settings);
    if (cold)
        other.work();
    const Stopwatch watch;
    try
    {
        method.run(pair, estimate);
        run.cpuMs = watch.cpuMs();
        run.wallMs = watch.wallMs();
        method.tell(pair, estimate);
    }
    catch (const std::exception& error)
    {
        run.cpuMs = watch.cpuMs();
        run.wallMs = watch.wallMs();
        estimate = Estimate();
        complain(method, settings.problem, pair, error.what());
    }
    run.repeat = repeat;
    const ProblemKind& kind = kindOf(settings.problem);
    run.error = kind.modelError(pair, estimate.model);
    run.centerError = kind.centerError(pair, estimate.model);
    run.failed = kind.failed(pair, run.error, run.centerError);
    run.poseError = kind.poseError(pair, estimate);
    run.cost = kind.modelCost(pair, estimate.model, settings.threshold);
    run.iterations = estimate.iterations;
    run.inliers = estimate.mask.empty() ? 0 : cv::countNonZero(estimate.mask);
    return run;
}

void Meter::complain(const Method& method, ProblemType problem, const ImagePair& pair,
                     const std::string& what)
{
    if (!complaints.insert(method.name() + letterOf(problem)).second)
        return;
    progress.clear();
    std::cerr << method.name() << " threw on " << pair.name << " (" << letterOf(problem)
              << "), which counts as a failure (reported only once): "
              << what.substr(0, what.find_last_not_of(" \n") + 1) << std::endl;
}

}  // namespace benchmark
