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
        int size;  //!< correspondences
    };

    std::string name;
    ProblemType problem;
    std::vector<PairInfo> pairs;
    std::vector<std::vector<Run>>
        runs;  //!< one vector a method, in their order; empty if it does not solve the problem
};

/** Runs all methods on the pairs of a list.

For each pair and each repeat all methods run one after the other, so that a disturbance of the
machine hurts all alike, and in an order drawn anew, so that none always follows one of its kin,
which leaves it warm caches. The orders are the same each time. Each method runs once on the first
pair before anything is measured. Messages about pairs that cannot be read go to the standard error.
*/
class Runner
{
public:
    Runner(const std::vector<cv::Ptr<Method>>& methods, const Options& options, Progress& progress);

    ListResult run(const PairList& list);
    //! Pairs that could not be read so far.
    int unreadable() const { return unreadablePairs; }

private:
    bool read(const PairList& list, const PairList::Entry& entry, ImagePair& pair);
    //! Numbers of the methods.
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
