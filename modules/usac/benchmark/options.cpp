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
         "{list           | | file with a list of pairs, <dataset>.<letter of the problem>.list; "
         "may be repeated }"
         "{data           | | folder of data; all lists in its folder 'lists' are used; may be "
         "repeated }"
         "{problem        | | H, F, E, A, S, P, R, M or T: problem of all lists (default: the "
         "letter in the name of each list); from --data, only the lists of this problem are used }"
         "{methods        "
         "|USACV20,USACV20_FAST,USACV20_ACCURATE,cv:USAC_DEFAULT,cv:USAC_MAGSAC,cv:RANSAC"
         "| names separated by commas; may be repeated; see below }"
         "{threshold      | | inlier threshold in pixels; R and M: in the unit of the points of "
         "space 2 (default: H 2; F and E 1; A, S and T 3; P 4; R and M 3) }"
         "{maxIters       | | limit of iterations (default: H, R and M 10000; F, E and P 1000; "
         "A, S and T 2000) }"
         "{confidence     |0.99| confidence of the termination criterion }"
         "{repeats        |5| runs of each method on each pair }"
         "{seed           |1| seed of the first repeat; each further repeat adds 1 }"
         "{threads        |1| argument of cv::setNumThreads; -1: all processors }"
         "{cold           |0| 1: before each timed call, 32 MB are touched and 40 000 numbers "
         "sorted, so that neither caches nor branch predictors know the call, as in a program that "
         "does other work between its calls }"
         "{csv            | | CSV file for the tables }"
         "{runs           | | CSV file for the individual runs }";

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
    parser.about(
        "Runs robust estimators on lists of image pairs and reports accuracy and time.\n"
        "Methods: " +
        knownMethods() +
        ".\n"
        "+scores after a name passes the scores of the matches; {field=value,...} after a "
        "name sets fields of cv::usacv20::Params or, for a custom: method, its own "
        "fields.\n"
        "Problems: H homography, F and E fundamental and essential matrix, A affinity, S "
        "similarity, T translation, P absolute pose, R rigid motion of 3D space, M the same "
        "with a scale.");
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
    csv = parser.get<cv::String>("csv");
    runsCsv = parser.get<cv::String>("runs");

    threshold = parser.has("threshold") ? numberOf(parser, "threshold") : 0;
    maxIterations = parser.has("maxIters") ? integerOf(parser, "maxIters") : 0;
    confidence = numberOf(parser, "confidence");
    repeats = integerOf(parser, "repeats");
    seed = integerOf(parser, "seed");
    threads = integerOf(parser, "threads");
    cold = integerOf(parser, "cold") != 0;
    require(threshold > 0 || !parser.has("threshold"), "--threshold: expected a number above 0");
    require(maxIterations > 0 || !parser.has("maxIters"), "--maxIters: expected a number above 0");
    require(confidence > 0 && confidence < 1, "--confidence: expected a number between 0 and 1");
    require(repeats > 0, "--repeats: expected a number above 0");
    return true;
}

}  // namespace benchmark
