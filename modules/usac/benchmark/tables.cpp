// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include "problems/problem_kind.hpp"

namespace benchmark {

namespace {

struct Column
{
    const char *title, *csvName, *format;  //!< a null title omits the column in Markdown tables
    double Summary::*figure;
    bool ofAll;  //!< false: a CSV file has the column only if the results contain a problem whose
                 //!< error is in degrees (P, R, M)
};

const Column COLUMNS[] = {
    {"median error", "median_error", "%.3f", &Summary::medianError, true},
    {"center error", "median_center_percent", "%.3f", &Summary::medianCenter, false},
    {"failures", "failures_percent", "%.1f", &Summary::failures, true},
    {"CPU median", "median_cpu_ms", "%.3f", &Summary::medianCpu, true},
    {"CPU mean", "mean_cpu_ms", "%.3f", &Summary::meanCpu, true},
    {"wall median", "median_wall_ms", "%.3f", &Summary::medianWall, true},
    {0, "mean_wall_ms", "%.3f", &Summary::meanWall, true},
    {"AUC@1", "auc1", "%.1f", &Summary::auc1, false},
    {"AUC@5", "auc5", "%.1f", &Summary::auc5, true},
    {"AUC@10", "auc10", "%.1f", &Summary::auc10, true},
    {"AUC@20", "auc20", "%.1f", &Summary::auc20, true},
    {"iterations", "median_iterations", "%.0f", &Summary::medianIterations, true},
};

//! A number as text; `unknown` if it is NaN.
std::string print(double value, const char* format, const char* unknown)
{
    if (std::isnan(value))
        return unknown;
    if (std::isinf(value))
        return "inf";
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

//! A number for a CSV file; empty if it is NaN.
std::string field(double value) { return print(value, "%.6g", ""); }

//! Quotation marks are needed, since names can contain commas.
std::string quoted(const std::string& text) { return '"' + text + '"'; }

//! True if the column has a title and its figure is known for at least one method.
bool isShown(const std::vector<Summary>& rows, const Column& column)
{
    for (size_t m = 0; m < rows.size() && column.title; ++m)
        if (!std::isnan(rows[m].*column.figure))
            return true;
    return false;
}

}  // namespace

Tables::Tables(const Options& options_, const std::vector<ListResult>& results_)
    : options(options_), results(results_), inPixels(false), inDegrees(false)
{
    for (const ListResult& result : results)
        (kindOf(result.problem).inPixels() ? inPixels : inDegrees) = true;
    for (size_t i = 0; i < results.size(); ++i)
        addList(results[i]);
    addAverages("");
    for (char letter : problemLetters())
        addAverages(std::string(1, letter));
}

void Tables::addList(const ListResult& result)
{
    const Settings settings = options.settings(result.problem);
    Table table;
    table.name = result.name;
    table.problem = letterOf(result.problem);
    table.pairs = (int)result.pairs.size();
    table.rows = summarize(result);
    std::ostringstream title;
    title << table.name << " (" << table.problem << ", " << table.pairs << " pairs, threshold "
          << settings.threshold << ", " << settings.maxIterations << " iterations, confidence "
          << settings.confidence << ")";
    table.title = title.str();
    tables.push_back(table);
}

void Tables::addAverages(const std::string& problem)
{
    Table table;
    table.name = problem.empty() ? "average" : "average." + problem;
    table.problem = problem;
    table.title = problem.empty() ? "Averages over all lists"
                                  : "Averages over the lists of " + problem;
    table.pairs = 0;
    std::vector<std::vector<Summary>> chosen;
    for (size_t i = 0; i < results.size(); ++i)
    {
        if (!problem.empty() && tables[i].problem != problem)
            continue;
        chosen.push_back(tables[i].rows);
        if (problem.empty() && inPixels && !kindOf(results[i].problem).inPixels())
            for (Summary& row : chosen.back())
                row.medianError = std::numeric_limits<double>::quiet_NaN();  // degrees must not be
                                                                             // averaged with pixels
        table.pairs += tables[i].pairs;
    }
    table.rows = average(chosen);
    const bool sameAsAll = !problem.empty() && chosen.size() == results.size();
    if (!chosen.empty() && !sameAsAll)
        tables.push_back(table);
}

void Tables::markdown(std::ostream& out) const
{
    out << "# USAC benchmark\n\nOpenCV " << cv::getVersionString() << "; " << options.repeats
        << " repeats, seed " << options.seed << ", threads " << options.threads
        << ".\n\n"
           "Error: median in pixels; a failure counts as infinite. Failures: percent of the runs. "
           "Times: milliseconds of the call alone; a pair's time is the median over its repeats, "
           "median and mean are over the pairs; CPU: processor time of the process, the sum over "
           "all threads. AUC@5 and so on: area under the cumulative distribution of the pose error "
           "up to this number of degrees, in percent. Iterations: median.\n\n"
           "Averages: arithmetic means over lists. The error is "
           "averaged only over lists on which every method succeeded in more than half of the "
           "runs; the number of these lists is in brackets.\n";
    if (inDegrees)
        out << "\nP, R, M: the error is that of the rotation in degrees, so it is left out of "
               "averages that include lists of other problems. Center error: P: distance between "
               "the estimated and the true camera center, in percent of the depth of the scene; R, "
               "M: RMS distance between the right points moved by the estimated and by the true "
               "motion, in percent of the size of the scene. AUC: of the error of the rotation.\n";
    for (size_t i = 0; i < tables.size(); ++i)
        markdownTable(out, tables[i]);
}

void Tables::markdownTable(std::ostream& out, const Table& table) const
{
    const bool averages = table.name.compare(0, 7, "average") == 0;
    std::string head = "| method |", rule = "|---|";
    if (averages)
    {
        head += " lists |";
        rule += "---:|";
    }
    for (const Column& column : COLUMNS)
        if (isShown(table.rows, column))
        {
            head += std::string(" ") + column.title + " |";
            rule += "---:|";
        }
    out << "\n## " << table.title << "\n\n" << head << "\n" << rule << "\n";

    for (size_t m = 0; m < table.rows.size(); ++m)
    {
        const Summary& row = table.rows[m];
        if (!row.lists)
            continue;
        out << "| " << options.methods[m] << " |";
        if (averages)
            out << " " << row.lists << " (" << row.errorLists << ") |";
        for (const Column& column : COLUMNS)
            if (isShown(table.rows, column))
                out << " " << print(row.*column.figure, column.format, "-") << " |";
        out << "\n";
    }
}

void Tables::csv(std::ostream& out) const
{
    out << "list,problem,pairs,method";
    for (const Column& column : COLUMNS)
        if (column.ofAll || inDegrees)
            out << ',' << column.csvName;
    out << '\n';
    for (size_t i = 0; i < tables.size(); ++i)
        for (size_t m = 0; m < tables[i].rows.size(); ++m)
        {
            if (!tables[i].rows[m].lists)
                continue;
            out << quoted(tables[i].name) << ',' << tables[i].problem << ',' << tables[i].pairs
                << ',' << quoted(options.methods[m]);
            for (const Column& column : COLUMNS)
                if (column.ofAll || inDegrees)
                    out << ',' << field(tables[i].rows[m].*column.figure);
            out << '\n';
        }
}

void Tables::runsCsv(std::ostream& out) const
{
    out << "list,problem,pair,correspondences,method,repeat,error,failed,pose_error,cpu_ms,wall_ms,"
           "iterations,inliers,"
           "cost"
        << (inDegrees ? ",center_error\n" : "\n");
    for (size_t i = 0; i < results.size(); ++i)
        for (size_t m = 0; m < results[i].runs.size(); ++m)
            for (size_t k = 0; k < results[i].runs[m].size(); ++k)
            {
                const Run& run = results[i].runs[m][k];
                const ListResult::PairInfo& pair = results[i].pairs[run.pair];
                out << quoted(results[i].name) << ',' << letterOf(results[i].problem) << ','
                    << quoted(pair.name) << ',' << pair.size << ',' << quoted(options.methods[m])
                    << ',' << run.repeat << ',' << field(run.error) << ',' << run.failed << ','
                    << (run.poseError < 0 ? std::string() : field(run.poseError)) << ','
                    << field(run.cpuMs) << ',' << field(run.wallMs) << ','
                    << (run.iterations < 0 ? std::string() : field(run.iterations)) << ','
                    << run.inliers << ',' << field(run.cost);
                if (inDegrees)
                    out << ',' << (run.centerError < 0 ? std::string() : field(run.centerError));
                out << '\n';
            }
}

}  // namespace benchmark
