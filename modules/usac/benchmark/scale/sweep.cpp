// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "sweep.hpp"

#include <cmath>
#include "scene_pair.hpp"

namespace benchmark {

namespace {

const char* const NAMES[] = {"size", "inliers"};

//! A number as text for a CSV file; empty if it is NaN.
std::string field(double value)
{
    return std::isnan(value) ? std::string() : cv::format("%.6g", value);
}

}  // namespace

Sweep::Sweep(Kind kind_, ProblemType problem_, const ScaleOptions& options_)
    : kind(kind_), problem(problem_), options(options_)
{
    const size_t count = kind == OVER_SIZE ? options.sizes.size() : options.inliers.size();
    for (size_t i = 0; i < count; ++i)
    {
        const Point point = {kind == OVER_SIZE ? options.sizes[i] : options.size,
                             kind == OVER_SIZE ? options.part : options.inliers[i],
                             std::vector<Summary>()};
        points.push_back(point);
    }
}

void Sweep::run(const std::vector<cv::Ptr<Method>>& methods, Meter& meter, Progress& progress)
{
    std::vector<bool> active(methods.size());
    for (size_t m = 0; m < methods.size(); ++m)
        active[m] = methods[m]->solves(problem);
    const ImagePair first = toImagePair(options.scene(problem, options.size, options.part, 0));
    for (size_t m = 0; m < methods.size(); ++m)
        if (active[m])
            meter.measure(*methods[m], first, options.settings(problem), 0);  // warm-up
    for (size_t i = 0; i < points.size(); ++i)
    {
        progress.step(std::string(1, letterOf(problem)) + " " + label(points[i]));
        measure(points[i], methods, active, meter);
    }
}

void Sweep::measure(Point& point, const std::vector<cv::Ptr<Method>>& methods,
                    std::vector<bool>& active, Meter& meter) const
{
    ListResult result;
    result.problem = problem;
    result.runs.resize(methods.size());
    for (int repeat = 0; repeat < options.repeats; ++repeat)
    {
        const ImagePair pair = toImagePair(options.scene(problem, point.size, point.part, repeat));
        for (size_t m = 0; m < methods.size(); ++m)
            if (active[m])
            {
                result.runs[m].push_back(
                    meter.measure(*methods[m], pair, options.settings(problem), repeat));
                result.runs[m].back().pair = repeat;
            }
    }
    point.rows = summarize(result);
    for (size_t m = 0; m < methods.size(); ++m)
        active[m] = active[m] && point.rows[m].medianCpu <= options.limit;
}

std::string Sweep::label(const Point& point) const
{
    return kind == OVER_SIZE ? cv::format("%d", point.size) : cv::format("%g", point.part);
}

void Sweep::markdown(std::ostream& out) const
{
    const Settings settings = options.settings(problem);
    out << "\n## " << letterOf(problem) << ": time over the "
        << (kind == OVER_SIZE
                ? "number of matches, part of right ones " + cv::format("%g", options.part)
                : "part of right matches, " + cv::format("%d", options.size) + " matches")
        << "\n\nThreshold " << settings.threshold << ", " << settings.maxIterations
        << " iterations.\n\n| " << (kind == OVER_SIZE ? "matches" : "right") << " |";
    for (size_t m = 0; m < options.methods.size(); ++m)
        out << " " << options.methods[m] << " |";
    out << "\n|---:|";
    for (size_t m = 0; m < options.methods.size(); ++m)
        out << "---:|";
    out << "\n";
    for (size_t i = 0; i < points.size(); ++i)
    {
        out << "| " << label(points[i]) << " |";
        for (size_t m = 0; m < points[i].rows.size(); ++m)
        {
            const Summary& row = points[i].rows[m];
            out << (row.lists ? cv::format(" %.3g / %.3g / %.0f |", row.medianCpu, row.medianError,
                                           row.failures)
                              : " - |");
        }
        out << "\n";
    }
}

void Sweep::csvHeader(std::ostream& out)
{
    out << "sweep,problem,size,inliers,method,runs,median_cpu_ms,median_wall_ms,median_error,"
           "failures_percent,"
           "median_iterations\n";
}

void Sweep::csv(std::ostream& out) const
{
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t m = 0; m < points[i].rows.size(); ++m)
        {
            const Summary& row = points[i].rows[m];
            if (row.lists)
                out << NAMES[kind] << ',' << letterOf(problem) << ',' << points[i].size << ','
                    << points[i].part << ",\"" << options.methods[m] << "\"," << options.repeats
                    << ',' << field(row.medianCpu) << ',' << field(row.medianWall) << ','
                    << field(row.medianError) << ',' << field(row.failures) << ','
                    << field(row.medianIterations) << '\n';
        }
}

}  // namespace benchmark
