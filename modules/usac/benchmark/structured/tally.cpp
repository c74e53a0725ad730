// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tally.hpp"

#include <algorithm>
#include <cmath>

namespace benchmark {

namespace {

//! Quantile of the normal distribution for a two-sided 95 % interval.
const double QUANTILE = 1.959964;

double median(std::vector<float> values)
{
    if (values.empty())
        return 0;
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

std::string percent(int count, int of)
{
    return of ? cv::format("%.1f", 100. * count / of) : std::string("-");
}

}  // namespace

Proportion::Proportion(int count, int of_) : of(of_), value(0), low(0), high(1)
{
    if (of == 0)
        return;
    const double n = of, z2 = QUANTILE * QUANTILE;
    value = count / n;
    const double center = (value + z2 / (2 * n)) / (1 + z2 / n);
    const double half = QUANTILE / (1 + z2 / n) *
                        std::sqrt(value * (1 - value) / n + z2 / (4 * n * n));
    low = count == 0 ? 0 : center - half;
    high = count == of ? 1 : center + half;
}

std::string Proportion::text() const
{
    return of ? cv::format("%.2f", 100 * value) : std::string("-");
}

Tally::Tally()
    : calls(0), limited(0), failed(0), limitedFailed(0), worse(0), wrong(0), none(0), iterations(0),
      tells(true)
{}

void Tally::add(const Call& call, const Verdict& verdict)
{
    ++calls;
    limited += call.limited;
    failed += verdict.failed;
    limitedFailed += call.limited && verdict.failed;
    worse += verdict.worse;
    wrong += verdict.wrong;
    none += verdict.none;
    iterations += call.estimate.iterations;
    tells = tells && call.estimate.iterations >= 0;
    times.push_back((float)call.cpuUs);
}

void Tally::add(const Tally& cell)
{
    calls += cell.calls;
    limited += cell.limited;
    failed += cell.failed;
    limitedFailed += cell.limitedFailed;
    worse += cell.worse;
    wrong += cell.wrong;
    none += cell.none;
    iterations += cell.iterations;
    tells = tells && cell.tells;
    times.insert(times.end(), cell.times.begin(), cell.times.end());
}

double Tally::meanIterations() const { return tells && calls > 0 ? iterations / calls : -1; }

std::string Tally::markdownHeader()
{
    return "calls | search failures, % | higher cost, % | wrong, % | mean iterations | "
           "median CPU, us |";
}

std::string Tally::markdown() const
{
    const std::string loops = meanIterations() < 0 ? "-" : cv::format("%.0f", meanIterations());
    return cv::format("%d | ", calls) + brief() + " | " + percent(worse, calls) + " | " +
           percent(wrong, calls) + " | " + loops + cv::format(" | %.0f |", median(times));
}

std::string Tally::brief() const
{
    return failures().text() +
           (limitedFailed ? " + " + percent(limitedFailed, calls) : std::string());
}

std::string Tally::csvHeader()
{
    return "calls,failures,failures_low,failures_high,limited,limited_failures,worse,wrong,no_"
           "model,mean_iterations,"
           "median_cpu_us";
}

std::string Tally::csv() const
{
    const Proportion p = failures();
    return cv::format("%d,%d,%.6g,%.6g,%d,%d,%d,%d,%d,%.6g,%.6g", calls, failed - limitedFailed,
                      p.low, p.high, limited, limitedFailed, worse, wrong, none, meanIterations(),
                      median(times));
}

}  // namespace benchmark
