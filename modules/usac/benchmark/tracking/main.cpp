// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures how the model of the previous frame, as Params::initialModel, helps a tracker. In each
// sequence, a camera moves smoothly and jumps once. Trackers run with and without this model, for
// several limits of the number of samples.
//
//     usac_tracking --problems=P --ratios=0.2,0.6 --limits=1,32 > tracking.md

#include <iostream>
#include "arguments.hpp"
#include "problems/problem_kind.hpp"
#include "program.hpp"
#include "sequence.hpp"
#include "tracker.hpp"

using namespace benchmark;

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{problems       |P,H| P absolute pose, H homography }"
         "{ratios         |0.2,0.35,0.6| fractions of right matches }"
         "{limits         |1,8,32,128| limits of iterations per frame; the default limit of the "
         "problem is measured, too }"
         "{frames         |300| frames of a sequence; the camera jumps just before the middle "
         "frame }"
         "{size           |1000| matches of a frame }"
         "{noise          |0.5| standard deviation of the noise of each image coordinate of the "
         "right matches, pixels }"
         "{speed          |2| speed of the camera; 1: image points move by about 1.4 pixels per "
         "frame }"
         "{sequences      |3| number of sequences, each with its own seed }"
         "{seed           |1| seed of the first sequence; each further sequence adds 1 }"
         "{csv            | | CSV file for the figures }";

struct TrackingOptions
{
    std::vector<ProblemType> problems;
    std::vector<double> ratios;
    std::vector<int> limits;
    int frames, size, sequences, seed;
    double noise, speed;
    std::string csv;  //!< output file; empty: none
};

//! Reads the command line. @return false if the command line asks for help; the help text has then
//! been printed. Wrong options raise std::runtime_error.
bool parse(int argc, char** argv, TrackingOptions& options)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about(
        "Measures how the model of the previous frame, as initial model, helps a tracker.");
    if (parser.has("help"))
    {
        parser.printMessage();
        return false;
    }
    for (const std::string& letter : namesOf(parser, arguments, "problems"))
    {
        ProblemType problem = cv::usacv20::HOMOGRAPHY;
        require(letter == "P" || letter == "H", "--problems: expected P, H");
        problemOf(letter[0], problem);
        options.problems.push_back(problem);
    }
    for (const std::string& ratio : namesOf(parser, arguments, "ratios"))
    {
        options.ratios.push_back(toNumber(ratio, "ratios"));
        require(options.ratios.back() > 0 && options.ratios.back() <= 1,
                "--ratios: expected numbers above 0 up to 1");
    }
    for (const std::string& limit : namesOf(parser, arguments, "limits"))
    {
        options.limits.push_back(toInteger(limit, "limits"));
        require(options.limits.back() > 0, "--limits: expected numbers above 0");
    }
    options.frames = integerOf(parser, "frames");
    options.size = integerOf(parser, "size");
    options.sequences = integerOf(parser, "sequences");
    options.seed = integerOf(parser, "seed");
    options.noise = numberOf(parser, "noise");
    options.speed = numberOf(parser, "speed");
    options.csv = parser.get<cv::String>("csv");
    require(options.frames > 1 && options.size > 0 && options.sequences > 0,
            "--frames: expected 2 or more; --size, --sequences: expected 1 or more");
    require(options.noise >= 0 && options.speed >= 0 && options.seed >= 0,
            "--noise, --speed, --seed: expected 0 or more");
    return true;
}

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
    if (!parse(argc, argv, options))
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
