// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_RUNNER_HPP
#define OPENCV_USACV20_BENCHMARK_RUNNER_HPP

#include <string>
#include <vector>
#include "meter.hpp"
#include "options.hpp"
#include "pair_list.hpp"

namespace benchmark {

//! All runs on one list.
struct ListResult
{
    struct PairInfo
    {
        std::string name;
        int size;  //!< number of correspondences
    };

    std::string name;
    ProblemType problem;
    std::vector<PairInfo> pairs;
    std::vector<std::vector<Run>>
        runs;  //!< the runs of each method; none if the method does not solve the problem
};

/** Runs all methods on the pairs of a list.

For each pair and each repeat all methods run one after the other, so that a disturbance of the
machine affects all methods. Their order is drawn at random each time, so that no method always runs
after a similar one that leaves useful data in the caches. The orders are reproducible. On the first
pair of a list, each method first runs once as a warm-up, whose results are dropped. Messages about
unreadable pairs go to the standard error.
*/
class Runner
{
public:
    Runner(const std::vector<cv::Ptr<Method>>& methods, const Options& options, Progress& progress);

    ListResult run(const PairList& list);
    //! Number of pairs that could not be read so far.
    int unreadable() const { return unreadablePairs; }

private:
    bool read(const PairList& list, const PairList::Entry& entry, ImagePair& pair);
    //! Indices of the methods in random order.
    std::vector<size_t> shuffledOrder();

    const std::vector<cv::Ptr<Method>>& methods;
    const Options& options;
    Progress& progress;
    Meter meter;
    cv::RNG rng;
    int unreadablePairs;
};

}  // namespace benchmark

#endif
