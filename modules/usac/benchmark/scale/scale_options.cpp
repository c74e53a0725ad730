// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scale_options.hpp"

#include <algorithm>
#include <functional>

namespace benchmark {

namespace {

const char KEYS[] = "{help h usage ? | | print this }"
                    "{measure        |size,inliers| what to measure. size: time as a "
                    "function of the number of matches; inliers: time as a function of the "
                    "fraction of right matches }"
                    "{problems       |H,F,E| H homography, F fundamental matrix, E essential "
                    "matrix }"
                    "{methods        |USACV20,USACV20_FAST,cv:USAC_FAST,cv:USAC_MAGSAC| names "
                    "separated by commas, as for usac_benchmark }"
                    "{sizes          "
                    "|50,100,200,500,1000,2000,5000,10000,20000,50000,100000,200000,500000,1000000|"
                    " size: numbers of matches }"
                    "{parts          |0.9,0.8,0.7,0.6,0.5,0.4,0.3,0.25,0.2,0.15,0.1,0.07,0.05| "
                    "inliers: fractions of right matches }"
                    "{size           |2000| inliers: number of matches }"
                    "{part           |0.5| size: fraction of right matches }"
                    "{noise          |0.5| standard deviation of the noise of each coordinate of "
                    "the right matches, pixels }"
                    "{repeats        |9| number of scenes of each kind, each with its own seed }"
                    "{limit          |2000| milliseconds; a method whose median call takes longer "
                    "is not run on harder scenes }"
                    "{maxIters       | | limit of iterations (default: H 10000, F and E 1000) }"
                    "{seed           |1| seed of the first scene; each further scene adds 1 }"
                    "{threads        |1| argument of cv::setNumThreads; -1: all processors }"
                    "{csv            | | CSV file for the times }";

bool isPart(double value) { return value > 0 && value <= 1; }

//! Parses inlier ratios and sorts them in descending order, so that the hardest scenes are last.
std::vector<double> partsOf(const std::vector<std::string>& texts, const std::string& option)
{
    std::vector<double> parts;
    for (size_t i = 0; i < texts.size(); ++i)
    {
        parts.push_back(toNumber(texts[i], option));
        require(isPart(parts[i]), "--" + option + ": expected numbers above 0 up to 1");
    }
    std::sort(parts.begin(), parts.end(), std::greater<double>());
    return parts;
}

bool has(const std::vector<std::string>& names, const std::string& name)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

opencv_test::Scene ScaleOptions::scene(ProblemType problem, int size_, double part_,
                                       int repeat) const
{
    opencv_test::SceneOptions options;
    options.setSize(size_, part_);
    options.noise = noise;
    options.seed = seed + repeat;
    return opencv_test::makeScene(problem, options);
}

Settings ScaleOptions::settings(ProblemType problem) const
{
    Settings result(problem);
    if (maxIterations > 0)
        result.maxIterations = maxIterations;
    result.seed = seed;
    return result;
}

void ScaleOptions::parseKinds(const cv::CommandLineParser& parser, const Arguments& arguments)
{
    const std::vector<std::string> what = namesOf(parser, arguments, "measure");
    sweepSizes = has(what, "size");
    sweepInliers = has(what, "inliers");
    require(what.size() == (size_t)(sweepSizes + sweepInliers),
            "--measure: expected size, inliers");
    const std::vector<std::string> letters = namesOf(parser, arguments, "problems");
    for (size_t i = 0; i < letters.size(); ++i)
    {
        ProblemType problem = cv::usacv20::HOMOGRAPHY;
        require(letters[i].size() == 1 && problemOf(letters[i][0], problem) &&
                    problem <= cv::usacv20::ESSENTIAL,
                "--problems: expected H, F, E");
        problems.push_back(problem);
    }
    methods = namesOf(parser, arguments, "methods");
}

void ScaleOptions::parseScenes(const cv::CommandLineParser& parser, const Arguments& arguments)
{
    const std::vector<std::string> counts = namesOf(parser, arguments, "sizes");
    for (size_t i = 0; i < counts.size(); ++i)
        sizes.push_back(toInteger(counts[i], "sizes"));
    std::sort(sizes.begin(), sizes.end());
    inliers = partsOf(namesOf(parser, arguments, "parts"), "parts");
    size = integerOf(parser, "size");
    part = numberOf(parser, "part");
    noise = numberOf(parser, "noise");
    seed = integerOf(parser, "seed");
    require(isPart(part), "--part: expected a number above 0 up to 1");
    require(noise >= 0, "--noise: expected 0 or more");
    require(seed >= 0, "--seed: expected 0 or more");
    require(size * inliers.back() >= 1 && sizes.front() * part >= 1,
            "--size, --sizes: there is no right match");
}

bool ScaleOptions::parse(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about(
        "Measures time as a function of the number of matches and of the fraction of right matches "
        "in synthetic scenes.\n"
        "Methods: " +
        knownMethods() + ".");
    if (parser.has("help") || argc == 1)
    {
        parser.printMessage();
        return false;
    }
    parseKinds(parser, arguments);
    parseScenes(parser, arguments);
    repeats = integerOf(parser, "repeats");
    limit = numberOf(parser, "limit");
    maxIterations = parser.has("maxIters") ? integerOf(parser, "maxIters") : 0;
    threads = integerOf(parser, "threads");
    csv = parser.get<cv::String>("csv");
    require(repeats > 0 && limit > 0, "--repeats, --limit: expected numbers above 0");
    require(maxIterations > 0 || !parser.has("maxIters"), "--maxIters: expected a number above 0");
    return true;
}

}  // namespace benchmark
