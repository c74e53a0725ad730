// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "benchmark.hpp"

#include <fstream>
#include <iostream>
#include "options.hpp"
#include "pair_list.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "runner.hpp"
#include "tables.hpp"

namespace benchmark {

namespace {

std::vector<PairList> readLists(const Options& options)
{
    std::vector<PairList> lists;
    for (size_t i = 0; i < options.lists.size(); ++i)
        lists.push_back(readPairList(options.lists[i], options.problem));
    return lists;
}

std::vector<cv::Ptr<Method>> createMethods(const Options& options)
{
    std::vector<cv::Ptr<Method>> methods;
    for (size_t i = 0; i < options.methods.size(); ++i)
        methods.push_back(createMethod(options.methods[i]));
    return methods;
}

//! @return the exit code: 0, or 2 if some pairs could not be read.
int run(const Options& options)
{
    const std::vector<PairList> lists = readLists(options);
    const std::vector<cv::Ptr<Method>> methods = createMethods(options);
    std::ofstream csv, runsCsv;
    openOutput(csv, options.csv);
    openOutput(runsCsv, options.runsCsv);
    cv::setNumThreads(options.threads);

    int pairs = 0;
    for (size_t i = 0; i < lists.size(); ++i)
        pairs += (int)lists[i].entries.size();
    Progress progress(pairs);
    Runner runner(methods, options, progress);
    std::vector<ListResult> results;
    for (size_t i = 0; i < lists.size(); ++i)
        results.push_back(runner.run(lists[i]));
    progress.clear();

    const Tables tables(options, results);
    tables.markdown(std::cout);
    if (csv.is_open())
        tables.csv(csv);
    if (runsCsv.is_open())
        tables.runsCsv(runsCsv);
    return runner.unreadable() ? 2 : 0;
}

}  // namespace

int runBenchmark(int argc, char** argv)
{
    Options options;
    return options.parse(argc, argv) ? run(options) : 0;
}

}  // namespace benchmark
