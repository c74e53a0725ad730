// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures how the time of robust estimators grows with the number of matches and with the fraction
// of outliers on synthetic scenes.
//
//     usac_scale --csv=scale.csv > scale.md
//     python3 modules/usac/benchmark/plot_scale.py scale.csv --out=pictures

#include <iostream>
#include "program.hpp"
#include "scale_options.hpp"
#include "sweep.hpp"

using namespace benchmark;

namespace {

void runSweeps(const ScaleOptions& options, const std::vector<cv::Ptr<Method>>& methods,
               std::ofstream& csv)
{
    std::vector<Sweep> sweeps;
    size_t scenes = 0;
    for (size_t p = 0; p < options.problems.size(); ++p)
    {
        if (options.sweepSizes)
            sweeps.push_back(Sweep(Sweep::OVER_SIZE, options.problems[p], options));
        if (options.sweepInliers)
            sweeps.push_back(Sweep(Sweep::OVER_INLIERS, options.problems[p], options));
    }
    for (size_t i = 0; i < sweeps.size(); ++i)
        scenes += sweeps[i].size();
    if (csv.is_open())
        Sweep::csvHeader(csv);
    Progress progress((int)scenes);
    Meter meter(progress);
    for (size_t i = 0; i < sweeps.size(); ++i)
    {
        sweeps[i].run(methods, meter, progress);
        progress.clear();
        sweeps[i].markdown(std::cout);
        std::cout.flush();
        if (csv.is_open())
            sweeps[i].csv(csv);
    }
}

void run(const ScaleOptions& options)
{
    std::ofstream csv;
    openOutput(csv, options.csv);
    std::vector<cv::Ptr<Method>> methods;
    for (size_t i = 0; i < options.methods.size(); ++i)
        methods.push_back(createMethod(options.methods[i]));
    cv::setNumThreads(options.threads);
    std::cout
        << "# Scale\n\nOpenCV " << cv::getVersionString() << "; synthetic scenes, noise "
        << options.noise << " px, " << options.repeats << " of each kind, seed " << options.seed
        << ", threads " << options.threads
        << ".\n\nEntries of tables of times: median CPU time of a call, ms / median error, px / "
           "failures, %; -: not run, because the median call on easier scenes took more than "
        << options.limit << " ms.\n";
    runSweeps(options, methods, csv);
}

int program(int argc, char** argv)
{
    ScaleOptions options;
    if (options.parse(argc, argv))
        run(options);
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
