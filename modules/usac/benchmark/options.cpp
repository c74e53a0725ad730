// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "options.hpp"

#include "arguments.hpp"
#include "pair_list.hpp"
#include "problems/problem_kind.hpp"

namespace benchmark {

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{list           | | list of pairs, <dataset>.<letter of its problem>.list; may be "
         "repeated }"
         "{data           | | folder of data: all lists in its folder 'lists'; may be repeated }"
         "{problem        | | H, F, E, A, S, P, R, M or T: problem of all lists (default: as the "
         "name "
         "of each list "
         "tells); of --data only its lists }"
         "{methods        "
         "|USACV20,USACV20_FAST,USACV20_ACCURATE,cv:USAC_DEFAULT,cv:USAC_MAGSAC,cv:RANSAC"
         "| names with commas; may be repeated; see below }"
         "{baseline       | | method that times and errors are compared with (default: the first "
         "cv: "
         "method, else the first) }"
         "{threshold      | | inlier threshold in pixels, R and M: units of length (default: H 2, "
         "F and E 1, A, S and T 3, P "
         "4, R and M 3) }"
         "{maxIters       | | most iterations (default: H, R and M 10000, F, E and P 1000, A, S "
         "and T "
         "2000) }"
         "{confidence     |0.99| confidence }"
         "{repeats        |5| runs of each method on each pair }"
         "{seed           |1| seed of the first repeat, the next ones count up }"
         "{threads        |1| given to cv::setNumThreads; -1: all processors }"
         "{csv            | | file for the tables }"
         "{runs           | | file for all single runs }";

std::string defaultBaseline(const std::vector<std::string>& methods)
{
    for (size_t i = 0; i < methods.size(); ++i)
        if (methods[i].compare(0, 3, "cv:") == 0)
            return methods[i];
    return methods.empty() ? std::string() : methods[0];
}

}  // namespace

Settings Options::settings(ProblemType of) const
{
    Settings result(of);
    if (threshold > 0)
        result.threshold = threshold;
    if (maxIterations > 0)
        result.maxIterations = maxIterations;
    result.confidence = confidence;
    result.seed = seed;
    return result;
}

bool Options::parse(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about("Runs robust estimators on lists of image pairs and reports accuracy and time.\n"
                 "Methods: " +
                 knownMethods() +
                 ".\n"
                 "+scores behind a name hands over the scores; {field=value,...} sets fields of "
                 "cv::usacv20::Params"
                 " or what a custom: method has.");
    if (parser.has("help") || argc == 1)
    {
        parser.printMessage();
        return false;
    }

    const std::string letter = parser.get<cv::String>("problem");
    ProblemType ignored;
    require(letter.empty() || (letter.size() == 1 && problemOf(letter[0], ignored)),
            "--problem: expected one of the letters " + problemLetters());
    problem = letter.empty() ? '\0' : letter[0];

    lists = arguments.all("list");
    const std::vector<std::string> folders = arguments.all("data");
    for (size_t i = 0; i < folders.size(); ++i)
    {
        const std::vector<std::string> more = findLists(folders[i], problem);
        lists.insert(lists.end(), more.begin(), more.end());
    }
    require(!lists.empty(), "no lists: give --list=... or --data=... (see --help)");
    methods = arguments.all("methods");
    if (methods.empty())
        methods = splitNames(parser.get<cv::String>("methods"));
    baseline = parser.has("baseline") ? std::string(parser.get<cv::String>("baseline"))
                                      : defaultBaseline(methods);
    csv = parser.get<cv::String>("csv");
    runsCsv = parser.get<cv::String>("runs");

    threshold = parser.has("threshold") ? numberOf(parser, "threshold") : 0;
    maxIterations = parser.has("maxIters") ? integerOf(parser, "maxIters") : 0;
    confidence = numberOf(parser, "confidence");
    repeats = integerOf(parser, "repeats");
    seed = integerOf(parser, "seed");
    threads = integerOf(parser, "threads");
    require(threshold > 0 || !parser.has("threshold"), "--threshold: expected a number above 0");
    require(maxIterations > 0 || !parser.has("maxIters"), "--maxIters: expected a number above 0");
    require(confidence > 0 && confidence < 1, "--confidence: expected a number between 0 and 1");
    require(repeats > 0, "--repeats: expected a number above 0");
    bool known = false;
    for (size_t i = 0; i < methods.size(); ++i)
        known = known || methods[i] == baseline;
    require(known, "--baseline: '" + baseline + "' is not one of the methods");
    return true;
}

}  // namespace benchmark
