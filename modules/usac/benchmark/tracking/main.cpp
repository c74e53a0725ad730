// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures how the model of the previous frame, as Params::initialModel, helps a tracker. In each
// sequence, a camera moves smoothly and jumps once. Trackers run with and without this model, for
// several limits of the number of samples.
//
//     usac_tracking --problems=P --ratios=0.2,0.6 --limits=1,32 > tracking.md

#include <iostream>
#include "problems/problem_kind.hpp"
#include "program.hpp"
#include "sequence.hpp"
#include "tracker.hpp"
#include "tracking_options.hpp"

using namespace benchmark;

namespace {

//! Names of the enumerators of Beginning in the tables.
const char* const BEGINNINGS[] = {"no", "yes", "yes or again"};

//! Runs all trackers on each frame in turn, so that a disturbance of the machine affects all
//! trackers. The tracker that runs first changes from frame to frame.
void runAll(const TrackingOptions& options, SequenceOptions sequence,
            std::vector<Tracker>& trackers)
{
    for (int k = 0; k < options.sequences; ++k)
    {
        sequence.seed = options.seed + k;
        const Sequence frames(sequence);
        for (Tracker& tracker : trackers)
            tracker.restart();
        for (int f = 0; f < options.frames; ++f)
        {
            const ImagePair frame = frames.frame(f);
            for (size_t i = 0; i < trackers.size(); ++i)
                trackers[(i + f) % trackers.size()].track(frame, f, f >= sequence.jump);
        }
    }
}

void write(char letter, double ratio, const std::vector<Tracker>& trackers, std::ostream* csv)
{
    for (const Tracker& tracker : trackers)
    {
        const double time = tracker.meanCpuMs(), part = time / trackers[0].meanCpuMs();
        std::cout << cv::format("| %c | %g | %s | %d | %.3f | %.1f | %.1f | %.3f | %.2f | %.1f |\n",
                                letter, ratio, BEGINNINGS[tracker.begins()], tracker.limit(),
                                tracker.medianError(), tracker.failures(), tracker.meanSamples(),
                                time, part, tracker.meanRecovery());
        if (csv)
            *csv << cv::format("%c,%g,%s,%d,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", letter, ratio,
                               BEGINNINGS[tracker.begins()], tracker.limit(), tracker.frames(),
                               tracker.medianError(), tracker.failures(), tracker.meanSamples(),
                               time, part, tracker.meanRecovery());
    }
    std::cout << std::flush;
}

int program(int argc, char** argv)
{
    TrackingOptions options;
    if (!options.parse(argc, argv))
        return 0;
    cv::setNumThreads(1);
    std::ofstream csv;
    openOutput(csv, options.csv);
    if (csv.is_open())
        csv << "problem,ratio,initial_model,limit,frames,median_error,failures_percent,mean_"
               "samples,mean_cpu_ms,"
               "cpu_ratio,recovery\n";
    std::cout
        << "| problem | right | initial model | most samples | median error | failures, % | "
           "samples | CPU, ms | "
           "ratio | frames lost after the jump |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (ProblemType problem : options.problems)
        for (double ratio : options.ratios)
        {
            const ProblemKind& kind = kindOf(problem);
            std::vector<Tracker> trackers;
            trackers.push_back(Tracker(problem, BEGIN_ANEW, kind.maxIterations));
            trackers.push_back(Tracker(problem, BEGIN_WITH_LAST, kind.maxIterations));
            for (int limit : options.limits)
                for (Beginning beginning : {BEGIN_ANEW, BEGIN_WITH_LAST, BEGIN_WITH_LAST_OR_AGAIN})
                    trackers.push_back(Tracker(problem, beginning, limit));
            const SequenceOptions sequence = {problem,       options.size,  ratio,
                                              options.noise, options.speed, options.frames / 2,
                                              options.seed};
            runAll(options, sequence, trackers);
            write(kind.letter, ratio, trackers, csv.is_open() ? &csv : 0);
        }
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
