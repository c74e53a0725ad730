// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "call.hpp"

#include "module_method.hpp"
#include "stopwatch.hpp"

namespace benchmark {

namespace {

//! Estimates the same model as ModuleMethod::run, but also gets the report.
void runModule(const ModuleMethod& method, const ImagePair& pair, Estimate& estimate, bool& limited)
{
    cv::usacv20::Report report;
    estimate.model = method.estimator(pair)->run(estimate.mask, &report);
    estimate.iterations = report.iterations;
    limited = report.stop == cv::usacv20::STOP_MAX_ITERATIONS;
}

}  // namespace

Call::Call(Method& method, const ImagePair& pair, const Settings& settings, const cv::Mat& initial)
    : cpuUs(0), limited(false)
{
    ModuleMethod* const own = dynamic_cast<ModuleMethod*>(&method);
    method.prepare(pair, settings);
    if (own && !initial.empty())
        own->beginWith(initial);
    const Stopwatch watch;
    try
    {
        if (own)
            runModule(*own, pair, estimate, limited);
        else
            method.run(pair, estimate);
    }
    catch (const cv::Exception&)
    {
        estimate = Estimate();
    }
    cpuUs = watch.cpuMs() * 1e3;
}

}  // namespace benchmark
