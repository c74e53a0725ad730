// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace benchmark {

namespace {

//! A number for a table: "-" where it is not known.
std::string cell(double value, const char* format = "%.3f")
{
    if (std::isnan(value))
        return "-";
    if (std::isinf(value))
        return "inf";
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

//! A number for a CSV file: empty where it is not known.
std::string field(double value)
{
    return std::isnan(value) ? std::string() : cell(value, "%.6g");
}

//! Names hold commas.
std::string quoted(const std::string& text)
{
    return '"' + text + '"';
}

//! NaN where one of both is infinite.
double ratio(double value, double reference)
{
    const double result = value / reference;
    return std::isfinite(result) && std::isfinite(reference) ? result : std::nan("");
}

void header(std::ostream& out, const std::vector<std::string>& columns)
{
    for (size_t i = 0; i < columns.size(); ++i)
        out << "| " << columns[i] << " ";
    out << "|\n";
    for (size_t i = 0; i < columns.size(); ++i)
        out << (i == 0 ? "|---" : "|---:");
    out << "|\n";
}

} // namespace

Tables::Tables(const Options& options_, const std::vector<ListResult>& results_)
    : options(options_), results(results_), baseline(0)
{
    const std::vector<std::string>& methods = options.methods;
    baseline = (int)(std::find(methods.begin(), methods.end(), options.baseline) - methods.begin());
    for (size_t i = 0; i < results.size(); ++i)
    {
        summaries.push_back(std::vector<Summary>());
        for (size_t m = 0; m < methods.size(); ++m)
            summaries.back().push_back(summarise(results[i], (int)m));
    }
}

void Tables::markdown(std::ostream& out) const
{
    out << "# USAC benchmark\n\nOpenCV " << cv::getVersionString() << "; " << options.repeats << " repeats, seed "
        << options.seed << ", threads " << options.threads << ".\n"
        << "Median error in pixels with failures as infinite; failures in percent of the runs; times in ms of the call alone "
           "(the median over the repeats of a pair, then over pairs); CPU: process time of all threads; AUC of the pose error "
           "in percent; iterations: median. Ratios compare with " << options.baseline << ", below 1 is better.\n";
    for (size_t i = 0; i < results.size(); ++i)
        markdownList(out, i);

    markdownAverages(out, "Averages over all lists", summaries);
    for (int problem = cv::usacv20::HOMOGRAPHY; problem <= cv::usacv20::ESSENTIAL; ++problem)
        markdownAverages(out, std::string("Averages over the lists of ") + letterOf((ProblemType)problem),
                         ofProblem((ProblemType)problem));
}

void Tables::markdownList(std::ostream& out, size_t list) const
{
    const ListResult& result = results[list];
    const Settings settings = options.settings(result.problem);
    bool posed = false;
    for (size_t m = 0; m < summaries[list].size(); ++m)
        posed = posed || summaries[list][m].hasPose;

    out << "\n## " << result.name << " (" << letterOf(result.problem) << ", " << result.pairs.size() << " pairs, threshold "
        << settings.threshold << ", " << settings.maxIterations << " iterations, confidence " << settings.confidence << ")\n\n";
    std::vector<std::string> columns = { "method", "median error", "failures", "CPU median", "CPU mean", "wall median" };
    if (posed)
        columns.insert(columns.end(), { "AUC@5", "AUC@10", "AUC@20" });
    columns.insert(columns.end(), { "iterations", "error ratio", "CPU median ratio", "CPU mean ratio" });
    header(out, columns);

    const Summary& reference = summaries[list][baseline];
    for (size_t m = 0; m < summaries[list].size(); ++m)
    {
        const Summary& s = summaries[list][m];
        if (!s.ran)
            continue;
        out << "| " << options.methods[m] << " | " << cell(s.medianError) << " | " << cell(s.failures, "%.1f") << " | "
            << cell(s.medianCpu) << " | " << cell(s.meanCpu) << " | " << cell(s.medianWall) << " | ";
        for (int k = 0; k < POSE_THRESHOLDS && posed; ++k)
            out << cell(s.auc[k], "%.1f") << " | ";
        out << cell(s.medianIterations < 0 ? std::nan("") : s.medianIterations, "%.0f") << " | ";
        if (reference.ran)
            out << cell(ratio(s.medianError, reference.medianError)) << " | "
                << cell(ratio(s.medianCpu, reference.medianCpu)) << " | "
                << cell(ratio(s.meanCpu, reference.meanCpu)) << " |\n";
        else
            out << "- | - | - |\n";
    }
}

void Tables::markdownAverages(std::ostream& out, const std::string& title, const Summaries& chosen) const
{
    if (chosen.empty())
        return;
    out << "\n## " << title << "\n\nError: mean of the medians over the lists where no method failed on half of the runs "
                               "or more. Ratios: geometric means.\n\n";
    header(out, { "method", "lists", "error", "(lists)", "failures", "CPU median", "CPU mean", "wall median", "AUC@5", "AUC@10",
                  "AUC@20", "error ratio", "CPU median ratio", "CPU mean ratio" });
    for (size_t m = 0; m < options.methods.size(); ++m)
    {
        const Average a = average(chosen, (int)m, baseline);
        if (!a.lists)
            continue;
        out << "| " << options.methods[m] << " | " << a.lists << " | " << cell(a.error) << " | " << a.errorLists << " | "
            << cell(a.failures, "%.1f") << " | " << cell(a.medianCpu) << " | " << cell(a.meanCpu) << " | "
            << cell(a.medianWall) << " | ";
        for (int k = 0; k < POSE_THRESHOLDS; ++k)
            out << cell(a.auc[k], "%.1f") << " | ";
        out << cell(a.errorRatio) << " | " << cell(a.medianCpuRatio) << " | " << cell(a.meanCpuRatio) << " |\n";
    }
}

void Tables::csv(std::ostream& out) const
{
    out << "list,problem,pairs,method,median_error,failures_percent,median_cpu_ms,mean_cpu_ms,median_wall_ms,"
           "auc5,auc10,auc20,median_iterations,error_ratio,median_cpu_ratio,mean_cpu_ratio\n";
    for (size_t i = 0; i < results.size(); ++i)
        for (size_t m = 0; m < options.methods.size(); ++m)
        {
            const Summary& s = summaries[i][m];
            const Summary& reference = summaries[i][baseline];
            if (!s.ran)
                continue;
            out << quoted(results[i].name) << ',' << letterOf(results[i].problem) << ',' << results[i].pairs.size() << ','
                << quoted(options.methods[m]) << ',' << field(s.medianError) << ',' << field(s.failures) << ','
                << field(s.medianCpu) << ',' << field(s.meanCpu) << ',' << field(s.medianWall) << ',';
            for (int k = 0; k < POSE_THRESHOLDS; ++k)
                out << field(s.auc[k]) << ',';
            out << field(s.medianIterations < 0 ? std::nan("") : s.medianIterations) << ',';
            if (reference.ran)
                out << field(ratio(s.medianError, reference.medianError)) << ','
                    << field(ratio(s.medianCpu, reference.medianCpu)) << ',' << field(ratio(s.meanCpu, reference.meanCpu));
            else
                out << ",,";
            out << '\n';
        }
    csvAverages(out, "average", "", summaries);
    for (int problem = cv::usacv20::HOMOGRAPHY; problem <= cv::usacv20::ESSENTIAL; ++problem)
    {
        const std::string letter(1, letterOf((ProblemType)problem));
        csvAverages(out, "average." + letter, letter, ofProblem((ProblemType)problem));
    }
}

void Tables::csvAverages(std::ostream& out, const std::string& name, const std::string& letter,
                         const Summaries& chosen) const
{
    for (size_t m = 0; m < options.methods.size() && !chosen.empty(); ++m)
    {
        const Average a = average(chosen, (int)m, baseline);
        if (!a.lists)
            continue;
        out << name << ',' << letter << ",," << quoted(options.methods[m]) << ',' << field(a.error) << ','
            << field(a.failures) << ',' << field(a.medianCpu) << ',' << field(a.meanCpu) << ',' << field(a.medianWall) << ',';
        for (int k = 0; k < POSE_THRESHOLDS; ++k)
            out << field(a.auc[k]) << ',';
        out << ',' << field(a.errorRatio) << ',' << field(a.medianCpuRatio) << ',' << field(a.meanCpuRatio) << '\n';
    }
}

void Tables::runsCsv(std::ostream& out) const
{
    out << "list,problem,pair,correspondences,method,repeat,error,failed,pose_error,cpu_ms,wall_ms,iterations,inliers\n";
    for (size_t i = 0; i < results.size(); ++i)
        for (size_t m = 0; m < results[i].runs.size(); ++m)
            for (size_t k = 0; k < results[i].runs[m].size(); ++k)
            {
                const Run& run = results[i].runs[m][k];
                const ListResult::PairInfo& pair = results[i].pairs[run.pair];
                out << quoted(results[i].name) << ',' << letterOf(results[i].problem) << ',' << quoted(pair.name) << ','
                    << pair.size << ',' << quoted(options.methods[m]) << ',' << run.repeat << ',' << field(run.error) << ','
                    << run.failed << ',' << (run.poseError < 0 ? std::string() : field(run.poseError)) << ','
                    << field(run.cpuMs) << ',' << field(run.wallMs) << ','
                    << (run.iterations < 0 ? std::string() : field(run.iterations)) << ',' << run.inliers << '\n';
            }
}

Tables::Summaries Tables::ofProblem(ProblemType problem) const
{
    Summaries chosen;
    for (size_t i = 0; i < results.size(); ++i)
        if (results[i].problem == problem)
            chosen.push_back(summaries[i]);
    return chosen;
}

} // namespace benchmark
