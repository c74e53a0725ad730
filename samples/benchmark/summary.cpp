// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace benchmark {

namespace {

const double NOT_KNOWN = std::numeric_limits<double>::quiet_NaN();

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

//! For each pair the median of one figure over its repeats. The runs of a pair follow one another.
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

//! Geometric mean of the ratios that are finite and positive.
class RatioMean
{
public:
    RatioMean() : sum(0), count(0) {}

    void add(double value, double reference)
    {
        const double ratio = std::log(value / reference);
        if (!std::isfinite(ratio))
            return;
        sum += ratio;
        ++count;
    }

    double value() const { return count ? std::exp(sum / count) : NOT_KNOWN; }

private:
    double sum;
    int count;
};

//! True if every method that ran has a finite median error.
bool allSucceed(const std::vector<Summary>& summaries)
{
    for (size_t i = 0; i < summaries.size(); ++i)
        if (summaries[i].ran && !std::isfinite(summaries[i].medianError))
            return false;
    return true;
}

} // namespace

Summary summarise(const ListResult& result, int method)
{
    const std::vector<Run>& runs = result.runs[method];
    Summary summary = Summary();
    summary.ran = !runs.empty();
    std::vector<double> errors, iterations, aucs[POSE_THRESHOLDS];
    int failures = 0;
    for (size_t i = 0; i < runs.size(); ++i)
    {
        failures += runs[i].failed;
        errors.push_back(runs[i].failed ? std::numeric_limits<double>::infinity() : runs[i].error);
        if (runs[i].iterations >= 0)
            iterations.push_back(runs[i].iterations);
        for (int k = 0; k < POSE_THRESHOLDS && runs[i].poseError >= 0; ++k)
            aucs[k].push_back(std::max(0., 1 - runs[i].poseError / POSE_THRESHOLD[k]));
    }
    const std::vector<double> cpu = medianPerPair(runs, &Run::cpuMs);
    summary.medianError = median(errors);
    summary.failures = runs.empty() ? NOT_KNOWN : 100. * failures / runs.size();
    summary.medianCpu = median(cpu);
    summary.meanCpu = mean(cpu);
    summary.medianWall = median(medianPerPair(runs, &Run::wallMs));
    summary.hasPose = !aucs[0].empty();
    for (int k = 0; k < POSE_THRESHOLDS; ++k)
        summary.auc[k] = 100 * mean(aucs[k]);
    summary.medianIterations = iterations.empty() ? -1 : median(iterations);
    return summary;
}

Average average(const std::vector<std::vector<Summary> >& summaries, int method, int baseline)
{
    std::vector<double> errors, failures, medianCpu, meanCpu, medianWall, aucs[POSE_THRESHOLDS];
    RatioMean errorRatio, medianCpuRatio, meanCpuRatio;
    for (size_t i = 0; i < summaries.size(); ++i)
    {
        const Summary& own = summaries[i][method];
        const Summary& reference = summaries[i][baseline];
        if (!own.ran)
            continue;
        if (allSucceed(summaries[i]))
            errors.push_back(own.medianError);
        failures.push_back(own.failures);
        medianCpu.push_back(own.medianCpu);
        meanCpu.push_back(own.meanCpu);
        medianWall.push_back(own.medianWall);
        for (int k = 0; k < POSE_THRESHOLDS && own.hasPose; ++k)
            aucs[k].push_back(own.auc[k]);
        if (!reference.ran)
            continue;
        errorRatio.add(own.medianError, reference.medianError);
        medianCpuRatio.add(own.medianCpu, reference.medianCpu);
        meanCpuRatio.add(own.meanCpu, reference.meanCpu);
    }
    Average result = Average();
    result.lists = (int)failures.size();
    result.error = mean(errors);
    result.errorLists = (int)errors.size();
    result.failures = mean(failures);
    result.medianCpu = mean(medianCpu);
    result.meanCpu = mean(meanCpu);
    result.medianWall = mean(medianWall);
    result.hasPose = !aucs[0].empty();
    for (int k = 0; k < POSE_THRESHOLDS; ++k)
        result.auc[k] = mean(aucs[k]);
    result.errorRatio = errorRatio.value();
    result.medianCpuRatio = medianCpuRatio.value();
    result.meanCpuRatio = meanCpuRatio.value();
    return result;
}

} // namespace benchmark
