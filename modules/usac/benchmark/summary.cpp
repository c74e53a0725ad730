// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "problems/problem_kind.hpp"

namespace benchmark {

namespace {

const double NOT_KNOWN = std::numeric_limits<double>::quiet_NaN();

//! The figures whose average is the arithmetic mean over all lists on which they are known.
double Summary::*const MEANS[] = {&Summary::failures, &Summary::medianCpu,
                                  &Summary::meanCpu,  &Summary::medianWall,
                                  &Summary::meanWall, &Summary::auc1,
                                  &Summary::auc5,     &Summary::auc10,
                                  &Summary::auc20,    &Summary::medianIterations};

double median(std::vector<double> values)
{
    if (values.empty())
        return NOT_KNOWN;
    std::sort(values.begin(), values.end());
    const size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double mean(const std::vector<double>& values)
{
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i)
        sum += values[i];
    return values.empty() ? NOT_KNOWN : sum / values.size();
}

//! The values of one figure of one method on all lists on which the figure is known.
std::vector<double> collect(const std::vector<std::vector<Summary>>& lists, size_t method,
                            double Summary::*figure)
{
    std::vector<double> values;
    for (size_t i = 0; i < lists.size(); ++i)
        if (!std::isnan(lists[i][method].*figure))
            values.push_back(lists[i][method].*figure);
    return values;
}

//! For each pair, the median of a figure over its repeats. The runs of a pair must be consecutive.
std::vector<double> medianPerPair(const std::vector<Run>& runs, double Run::*figure)
{
    std::vector<double> result, ofPair;
    for (size_t i = 0; i < runs.size(); ++i)
    {
        ofPair.push_back(runs[i].*figure);
        if (i + 1 < runs.size() && runs[i + 1].pair == runs[i].pair)
            continue;
        result.push_back(median(ofPair));
        ofPair.clear();
    }
    return result;
}

//! Area under the cumulative distribution of the pose error from 0 to `threshold` degrees, in
//! percent of the threshold. Runs without a known pose error are left out.
double areaUnderCurve(const std::vector<Run>& runs, double threshold)
{
    std::vector<double> parts;
    for (size_t i = 0; i < runs.size(); ++i)
        if (runs[i].poseError >= 0)
            parts.push_back(std::max(0., 1 - runs[i].poseError / threshold));
    return 100 * mean(parts);
}

Summary summarizeRuns(const std::vector<Run>& runs, ProblemType problem)
{
    Summary summary;
    if (runs.empty())
        return summary;
    std::vector<double> errors, centers, iterations;
    int failures = 0;
    for (size_t i = 0; i < runs.size(); ++i)
    {
        failures += runs[i].failed;
        errors.push_back(runs[i].failed ? std::numeric_limits<double>::infinity() : runs[i].error);
        if (runs[i].centerError >= 0)
            centers.push_back(runs[i].failed ? std::numeric_limits<double>::infinity()
                                             : runs[i].centerError);
        if (runs[i].iterations >= 0)
            iterations.push_back(runs[i].iterations);
    }
    const std::vector<double> cpu = medianPerPair(runs, &Run::cpuMs),
                              wall = medianPerPair(runs, &Run::wallMs);
    summary.lists = summary.errorLists = 1;
    summary.medianError = median(errors);
    summary.medianCenter = median(centers);
    summary.failures = 100. * failures / runs.size();
    summary.medianCpu = median(cpu);
    summary.meanCpu = mean(cpu);
    summary.medianWall = median(wall);
    summary.meanWall = mean(wall);
    if (kindOf(problem).inPixels())
    {
        summary.auc5 = areaUnderCurve(runs, 5);
        summary.auc10 = areaUnderCurve(runs, 10);
        summary.auc20 = areaUnderCurve(runs, 20);
    }
    else
        summary.auc1 = areaUnderCurve(runs, 1);
    summary.medianIterations = median(iterations);
    return summary;
}

//! True if every method that ran has a finite median error.
bool allSucceed(const std::vector<Summary>& summaries)
{
    for (size_t i = 0; i < summaries.size(); ++i)
        if (summaries[i].lists && !std::isfinite(summaries[i].medianError))
            return false;
    return true;
}

}  // namespace

Summary::Summary() : lists(0), errorLists(0), medianError(NOT_KNOWN), medianCenter(NOT_KNOWN)
{
    for (double Summary::*figure : MEANS)
        this->*figure = NOT_KNOWN;
}

std::vector<Summary> summarize(const ListResult& result)
{
    std::vector<Summary> summaries;
    for (size_t m = 0; m < result.runs.size(); ++m)
        summaries.push_back(summarizeRuns(result.runs[m], result.problem));
    return summaries;
}

std::vector<Summary> average(const std::vector<std::vector<Summary>>& lists)
{
    std::vector<std::vector<Summary>> solved;
    for (size_t i = 0; i < lists.size(); ++i)
        if (allSucceed(lists[i]))
            solved.push_back(lists[i]);

    std::vector<Summary> result(lists.empty() ? 0 : lists[0].size());
    for (size_t m = 0; m < result.size(); ++m)
    {
        for (size_t i = 0; i < lists.size(); ++i)
            result[m].lists += lists[i][m].lists;
        const std::vector<double> errors = collect(solved, m, &Summary::medianError);
        result[m].errorLists = (int)errors.size();
        result[m].medianError = mean(errors);
        result[m].medianCenter = mean(collect(solved, m, &Summary::medianCenter));
        for (double Summary::*figure : MEANS)
            result[m].*figure = mean(collect(lists, m, figure));
    }
    return result;
}

}  // namespace benchmark
