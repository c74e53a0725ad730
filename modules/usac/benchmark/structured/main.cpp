// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures how often robust estimators miss the true model, and how accurate they are, on synthetic
// scenes with the structure of real ones: typical camera motions, planes, repeated matches,
// structured wrong matches, and scores of different quality.
//
//     usac_structured --mode=search --methods=USACV20,cv:USAC_ACCURATE --runs=50 --csv=search.csv >
//     search.md
//     usac_structured --mode=accuracy --methods=USACV20,cv:USAC_ACCURATE --runs=200 > accuracy.md
//     usac_structured --mode=random --methods=USACV20,cv:USAC_ACCURATE --runs=60 > random.md

#include <iostream>
#include "accuracy_table.hpp"
#include "false_alarm_table.hpp"
#include "program.hpp"
#include "search_grid.hpp"

using namespace benchmark;

namespace {

void heading(const StructuredOptions& options, const char* title)
{
    std::cout << "# " << title << "\n\nOpenCV " << cv::getVersionString() << "; threshold "
              << options.threshold << " px, confidence " << options.confidence << ", at most "
              << options.maxIterations << " iterations, " << options.runs
              << " scenes of each cell, seed " << options.seed << ".\n";
}

int program(int argc, char** argv)
{
    StructuredOptions options;
    if (!options.parse(argc, argv))
        return 0;
    cv::setNumThreads(options.threads);
    std::ofstream csv;
    openOutput(csv, options.csv);
    if (options.search)
    {
        SearchGrid grid(options);
        grid.run(csv.is_open() ? &csv : 0);
        heading(options, "Search");
        grid.markdown(std::cout);
        return 0;
    }
    if (options.random)
    {
        FalseAlarmTable table(options);
        heading(options, "Models of wrong matches");
        table.run(std::cout, csv.is_open() ? &csv : 0);
        return 0;
    }
    AccuracyTable table(options);
    heading(options, "Accuracy");
    table.run(std::cout, csv.is_open() ? &csv : 0);
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
