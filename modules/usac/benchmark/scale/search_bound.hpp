// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SEARCH_BOUND_HPP
#define OPENCV_USACV20_BENCHMARK_SEARCH_BOUND_HPP

#include <ostream>
#include <string>
#include "opencv2/usac.hpp"
#include "scale_options.hpp"

namespace benchmark {

/** Compares the time of a run's search (Report::searchMs: the hypothesize-and-verify loop without
local optimization) with a lower bound: the time of the minimal solver for the samples that it
solved, plus the time of the kernel (the computation of errors) for the points that the models were
tested with, each without the rest of the search.

The solver is timed on the samples of the run; the kernel is timed on models of the run with all
points. A run with counting components determines the numbers of samples and points; the same run
without these components is timed. Each time is the minimum of several measurements: these execute
the same instructions, so longer times are due to disturbances. All runs use one thread. */
class SearchBound
{
public:
    SearchBound(const std::string& method, ProblemType problem, double part,
                const ScaleOptions& options);

    //! Measures all scenes. Raises std::runtime_error if the points that the method tests cannot be
    //! counted, or if the counting components change the run.
    void run(const cv::usacv20::Params& params);

    static void markdownHeader(std::ostream& out);
    void markdown(std::ostream& out) const;
    static void csvHeader(std::ostream& out);
    void csv(std::ostream& out) const;

private:
    void addScene(const opencv_test::Scene& scene, const cv::usacv20::Params& params);
    double boundMs() const { return solverMs + kernelMs; }

    const std::string method;
    const ProblemType problem;
    const double part;
    const ScaleOptions& options;
    // sums over the scenes
    int64 samples, solved, models, points;
    double searchMs, solverMs, kernelMs,
        allSolverMs;  //!< allSolverMs: time of the solver if all drawn samples had been solved
};

}  // namespace benchmark

#endif
