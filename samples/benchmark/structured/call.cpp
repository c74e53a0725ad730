// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "call.hpp"

#include "module_method.hpp"
#include "opencv2/usac.hpp"
#include "stopwatch.hpp"

namespace benchmark {

namespace {

//! The same call as ModuleMethod::run makes, with its report.
void runModule(const ModuleMethod& method, const ImagePair& pair, ProblemType problem, Estimate& estimate, bool& limited)
{
    cv::usacv20::Report report;
    const cv::Ptr<cv::usacv20::Usac> usac =
        problem == cv::usacv20::ESSENTIAL
            ? cv::usacv20::Usac::create(problem, pair.points1, pair.points2, method.parameters(), pair.K1, pair.K2)
            : cv::usacv20::Usac::create(problem, pair.points1, pair.points2, method.parameters());
    estimate.model = usac->run(estimate.mask, &report);
    estimate.iterations = report.iterations;
    limited = report.stop == cv::usacv20::STOP_MAX_ITERATIONS;
}

} // namespace

Call::Call(Method& method, const ImagePair& pair, const Settings& settings) : cpuUs(0), limited(false)
{
    const ModuleMethod* const own = dynamic_cast<const ModuleMethod*>(&method);
    method.prepare(pair, settings);
    const Stopwatch watch;
    try
    {
        if (own)
            runModule(*own, pair, settings.problem, estimate, limited);
        else
            method.run(pair, estimate);
    }
    catch (const cv::Exception&)
    {
        estimate = Estimate();
    }
    cpuUs = watch.cpuMs() * 1e3;
}

} // namespace benchmark
