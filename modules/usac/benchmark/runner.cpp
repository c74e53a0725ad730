// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "runner.hpp"

#include <iostream>

namespace benchmark {

Runner::Runner(const std::vector<cv::Ptr<Method>>& methods_, const Options& options_,
               Progress& progress_)
    : methods(methods_), options(options_), progress(progress_), meter(progress_, options_.cold),
      rng(1), unreadablePairs(0)
{}

ListResult Runner::run(const PairList& list)
{
    const Settings settings = options.settings(list.problem);
    ListResult result;
    result.name = list.name;
    result.problem = list.problem;
    result.runs.resize(methods.size());
    for (size_t i = 0; i < list.entries.size(); ++i)
    {
        ImagePair pair;
        progress.step(list.name + "." + letterOf(list.problem));
        if (!read(list, list.entries[i], pair))
            continue;

        const bool first = result.pairs.empty();
        const ListResult::PairInfo info = {pair.name, pair.size()};
        result.pairs.push_back(info);
        // repeat -1 is the warm-up
        for (int repeat = first ? -1 : 0; repeat < options.repeats; ++repeat)
            for (size_t m : shuffledOrder())
            {
                if (!methods[m]->solves(list.problem))
                    continue;
                Run run = meter.measure(*methods[m], pair, settings, repeat);
                run.pair = (int)result.pairs.size() - 1;
                if (repeat >= 0)
                    result.runs[m].push_back(run);
            }
    }
    return result;
}

std::vector<size_t> Runner::shuffledOrder()
{
    std::vector<size_t> order(methods.size());
    for (size_t i = 0; i < order.size(); ++i)
    {
        order[i] = i;
        std::swap(order[i], order[rng.uniform(0, (int)i + 1)]);
    }
    return order;
}

bool Runner::read(const PairList& list, const PairList::Entry& entry, ImagePair& pair)
{
    try
    {
        pair = readImagePair(entry.path, list.problem);
        return true;
    }
    catch (const std::exception& error)
    {
        progress.clear();
        std::cerr << list.file << ":" << entry.line << ": pair left out: " << error.what()
                  << std::endl;
        ++unreadablePairs;
        return false;
    }
}

}  // namespace benchmark
