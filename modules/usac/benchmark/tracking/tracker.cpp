// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tracker.hpp"

#include <algorithm>
#include <limits>
#include "problems/problem_kind.hpp"
#include "stopwatch.hpp"

namespace benchmark {

namespace {

double median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

int inliersOf(const Estimate& estimate)
{
    return estimate.mask.empty() ? 0 : cv::countNonZero(estimate.mask);
}

}  // namespace

Tracker::Tracker(ProblemType problem_, Beginning beginning_, int maxIterations)
    : problem(problem_), beginning(beginning_), lastInliers(0), samples(0), cpuMs(0), failed(0),
      sequences(0), lost(0), isLost(true)
{
    params.threshold = kindOf(problem).threshold;
    params.maxIterations = maxIterations;
}

void Tracker::restart()
{
    last.release();
    lastInliers = 0;
    isLost = true;
    ++sequences;
}

Estimate Tracker::estimate(const ImagePair& frame, const cv::usacv20::Params& with)
{
    Estimate result;
    const Stopwatch watch;
    kindOf(problem).callModule(frame, with, result);
    cpuMs += watch.cpuMs();
    return result;
}

void Tracker::count(const ImagePair& frame, const cv::usacv20::Params& with)
{
    cv::usacv20::Report
        report;  // filled in a run that is not timed, since counting independent inliers is slow
    cv::Mat mask;
    kindOf(problem).estimator(frame, with)->run(mask, &report);
    samples += report.iterations;
}

void Tracker::track(const ImagePair& frame, int seed, bool afterJump)
{
    const ProblemKind& kind = kindOf(problem);
    cv::usacv20::Params anew = params;
    anew.seed = params.seed = seed;
    anew.initialModel.clear();
    anew.maxIterations = kind.maxIterations;
    if (beginning != BEGIN_ANEW)
        params.setInitialModel(last);
    const bool mayRepeat = beginning == BEGIN_WITH_LAST_OR_AGAIN;
    Estimate found;
    if (!mayRepeat || !last.empty())
    {
        found = estimate(frame, params);
        count(frame, params);
    }
    if (mayRepeat && (found.model.empty() || 2 * inliersOf(found) < lastInliers))
    {
        found = estimate(frame, anew);
        count(frame, anew);
    }
    judge(frame, found, afterJump);
    last = found.model;
    lastInliers = inliersOf(found);
}

void Tracker::judge(const ImagePair& frame, const Estimate& found, bool afterJump)
{
    const ProblemKind& kind = kindOf(problem);
    const double error = kind.modelError(frame, found.model);
    const bool wrong = kind.failed(frame, error, kind.centerError(frame, found.model));
    errors.push_back(wrong ? std::numeric_limits<double>::infinity() : error);
    failed += wrong;
    if (!afterJump)
        return;
    isLost = isLost && wrong;
    lost += isLost;
}

double Tracker::medianError() const { return median(errors); }

double Tracker::failures() const { return 100. * failed / frames(); }

double Tracker::meanSamples() const { return samples / frames(); }

double Tracker::meanCpuMs() const { return cpuMs / frames(); }

double Tracker::meanRecovery() const { return (double)lost / sequences; }

}  // namespace benchmark
