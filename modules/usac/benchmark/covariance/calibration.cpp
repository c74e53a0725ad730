// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "calibration.hpp"

#include <cmath>

namespace benchmark {

using namespace cv::usacv20;

namespace {

//! A model counts as wrong if KnownScene::error() exceeds this many thresholds.
const double WRONG = 1;

//! The 0.95 quantiles of the chi-square distributions with 1 to 8 degrees of freedom.
const double QUANTILES[] = {3.8415, 5.9915, 7.8147, 9.4877, 11.0705, 12.5916, 14.0671, 15.5073};

//! A cell of a table; "-" for the mean over no scene, which is NaN.
std::string cellOf(const char* format, double value)
{
    return std::isnan(value) ? std::string(" - |") : cv::format(format, value);
}

}  // namespace

Calibration::Calibration()
    : scenes(0), none(0), wrong(0), unknown(0), determined(0), within(0), estimated(0), sum(0),
      sigmas(0), compared(0), logs()
{}

void Calibration::add(const SceneCell& cell, int seed, const Params& params, double widening)
{
    KnownScene scene(cell, seed);
    ++scenes;
    if (!scene.run(params, widening))
    {
        ++none;
        return;
    }
    const double error = scene.error();
    if (!(error <= WRONG))
    {
        ++wrong;
        return;
    }
    if (cell.spread != 1)
        compare(scene, error, params, widening);
    const Report& report = scene.report();
    if (report.sigma > 0)
    {
        sigmas += report.sigma / (cell.noise * cell.threshold);
        ++estimated;
    }
    const double square = scene.squaredDistance();
    if (!(square >= 0))
    {
        ++unknown;
        return;
    }
    ++determined;
    const int d = report.covariance.rows;
    sum += square / d;
    within += square <= QUANTILES[d - 1];
}

void Calibration::compare(const KnownScene& scene, double error, const Params& params,
                          double widening)
{
    const double without = scene.errorWithoutSigmas(params, widening), fit = scene.errorOfFit();
    if (!(without <= WRONG * 1e3 && fit > 0))
        return;
    logs[0] += std::log(error / fit);
    logs[1] += std::log(without / fit);
    ++compared;
}

void Calibration::add(const Calibration& other)
{
    scenes += other.scenes;
    none += other.none;
    wrong += other.wrong;
    unknown += other.unknown;
    determined += other.determined;
    within += other.within;
    estimated += other.estimated;
    sum += other.sum;
    sigmas += other.sigmas;
    compared += other.compared;
    logs[0] += other.logs[0];
    logs[1] += other.logs[1];
}

std::string Calibration::header(bool withErrors)
{
    const std::string more = withErrors ? " error | without sigmas |" : "",
                      line = withErrors ? "---:|---:|" : "";
    return " scenes | no model, % | wrong, % | not determined, % | mean / d | within 95 % | noise "
           "|" +
           more + "\n|---|---|---:|---:|---:|---:|---:|---:|---:|" + line;
}

std::string Calibration::row(bool withErrors) const
{
    const double part = 100. / scenes;
    std::string result = cv::format(" %d | %.1f | %.1f | %.1f |", scenes, none * part, wrong * part,
                                    unknown * part);
    result += cellOf(" %.3f |", mean()) + cellOf(" %.1f |", inside() * 100) +
              cellOf(" %.2f |", sigma());
    if (withErrors)
        result += cellOf(" %.3f |", relativeError()) +
                  cellOf(" %.3f |", relativeErrorWithoutSigmas());
    return result;
}

}  // namespace benchmark
