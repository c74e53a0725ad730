// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "structured_options.hpp"

#include <algorithm>
#include <cmath>

namespace benchmark {

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{mode           |search| search: how often methods miss the true model; accuracy: "
         "errors compared with those of least squares over the right matches; random: how often "
         "methods return a model if all matches are wrong }"
         "{methods        |USACV20| names separated by commas, as for usac_benchmark; with scores "
         "(see --orders), methods that cannot use scores are left out }"
         "{problems       |H,F,E| H homography, F and E fundamental and essential matrix; random: "
         "also A affinity, S similarity }"
         "{motions        | | motions of the camera (default: search: general; accuracy: "
         "general,forward,forward0,sideways,rectified,planar,"
         "car,narrow,aerial); also rotation, frontal, baseline1 to baseline100 }"
         "{kinds          | | kinds of wrong matches and of repetitions (default: search: "
         "generic,clustered,plane80,plane95,duplicates,copies,second,manyToOne,targets,line; "
         "random: clusters,center,window,border); also local, partSecond, plane1 to plane100, "
         "shift1 to shift100, moving1 to moving100, place1 to place100 }"
         "{sizes          | | numbers of matches (default: search: "
         "15,20,30,50,100,300,1000,10000; accuracy: 300; random: 100,200) }"
         "{ratios         | | fractions of right matches (default: search: "
         "0.3,0.5,0.6,0.7,0.9,0.95; accuracy: 0.7, with the motion aerial 0.9) }"
         "{orders         |none,0.95,0.8,0.5,0.05| search: the scores. none: no scores; a number: "
         "the probability that a right match has a better score than a wrong one; second: wrong "
         "matches of a second motion have the best scores; place: right matches in a small square "
         "of image 1 have the best scores; near: the nearer a match is to one point of image 1, "
         "the better its score }"
         "{by             |problem,kind,order| search: the table has a row for each combination of "
         "the values of these properties: some of problem, motion, kind, size, ratio, order }"
         "{table          |full| search: full: all figures, a row for each method; brief: only "
         "the search failures, a column for each method }"
         "{judge          |cost| search: which models are search failures. cost: those whose cost "
         "is clearly above that of the true model and that lose some of its inliers; start: of "
         "these, only those for which the same call returns the true model if it starts from it "
         "(Params::initialModel; methods of this module only) }"
         "{noise          |0.5| search: standard deviation of the noise of each coordinate of the "
         "right matches, pixels }"
         "{noises         |0,0.0333333,0.1,0.333333,1| accuracy: standard deviations of this "
         "noise, divided by the threshold }"
         "{threshold      |1.5| inlier threshold, pixels }"
         "{confidence     |0.99| confidence of the termination criterion }"
         "{maxIters       |100000| limit of iterations }"
         "{maxItersInverted |5000| limit of iterations for orders below 0.5; raised to three times "
         "the number of uniform samples that the confidence requires if that is more }"
         "{spare          |3| search: minimum number of different right matches in addition to "
         "those of a minimal sample; cells with fewer are left out }"
         "{runs           |20| number of scenes of each cell, each with its own seed }"
         "{seed           |1| seed of the first scene; each further scene adds 1 }"
         "{threads        |1| argument of cv::setNumThreads; -1: all processors }"
         "{csv            | | CSV file for the figures of each cell }";

const char SEARCH_SIZES[] = "15,20,30,50,100,300,1000,10000",
           SEARCH_RATIOS[] = "0.3,0.5,0.6,0.7,0.9,0.95";
const char SEARCH_KINDS
    [] = "generic,clustered,plane80,plane95,duplicates,copies,second,manyToOne,targets,line",
    RANDOM_KINDS[] = "clusters,center,window,border";
const char
    ACCURACY_MOTIONS[] = "general,forward,forward0,sideways,rectified,planar,car,narrow,aerial";
const char* const OF_SEARCH[] = {"orders", "by",    "table",           "judge",
                                 "noise",  "spare", "maxItersInverted"};
const char* const AXES[] = {"problem", "motion", "kind", "size", "ratio", "order"};

std::vector<double> numbersOf(const std::vector<std::string>& texts, const std::string& option,
                              double most)
{
    std::vector<double> numbers;
    for (size_t i = 0; i < texts.size(); ++i)
    {
        numbers.push_back(toNumber(texts[i], option));
        require(numbers[i] >= 0 && numbers[i] <= most,
                "--" + option + ": " + texts[i] + " is out of range");
    }
    return numbers;
}

}  // namespace

Settings StructuredOptions::settings(const Cell& cell) const
{
    Settings result(cell.problem);
    result.threshold = threshold;
    result.confidence = confidence;
    result.maxIterations = maxIterations;
    result.seed = seed;
    opencv_test::SceneOptions scene;
    if (cell.scored() && setOrder(cell.order, scene) && scene.scoreInformation < 0.5)
    {
        const double good = std::pow(cell.ratio, sampleSizeOf(cell.problem));
        const double needed = good < 1 ? std::log(1 - confidence) / std::log1p(-good) : 1;
        result.maxIterations = (int)std::max((double)maxIterationsInverted,
                                             std::min(3 * needed, 1e9));
    }
    return result;
}

void StructuredOptions::parseGrid(const cv::CommandLineParser& parser, const Arguments& arguments)
{
    const std::vector<std::string> letters = namesOf(parser, arguments, "problems");
    for (size_t i = 0; i < letters.size(); ++i)
    {
        ProblemType problem = cv::usacv20::HOMOGRAPHY;
        require(letters[i].size() == 1 && problemOf(letters[i][0], problem) &&
                    problem <= (random ? cv::usacv20::SIMILARITY : cv::usacv20::ESSENTIAL),
                random ? "--problems: expected H, F, E, A, S" : "--problems: expected H, F, E");
        problems.push_back(problem);
    }
    methods = namesOf(parser, arguments, "methods");
    motions = namesOf(parser, arguments, "motions", accuracy ? ACCURACY_MOTIONS : "general");
    kinds = namesOf(parser, arguments, "kinds", random ? RANDOM_KINDS : SEARCH_KINDS);
    orders = namesOf(parser, arguments, "orders");
    by = namesOf(parser, arguments, "by");
    const std::vector<std::string> counts = namesOf(parser, arguments, "sizes",
                                                    search   ? SEARCH_SIZES
                                                    : random ? "100,200"
                                                             : "300");
    for (size_t i = 0; i < counts.size(); ++i)
    {
        sizes.push_back(toInteger(counts[i], "sizes"));
        require(sizes[i] > 0 && sizes[i] <= 1000000, "--sizes: expected numbers from 1 to 1000000");
    }
    ratios = numbersOf(namesOf(parser, arguments, "ratios", search ? SEARCH_RATIOS : "0.7"),
                       "ratios", 1);
    ratiosGiven = !arguments.all("ratios").empty();
    noises = numbersOf(namesOf(parser, arguments, "noises"), "noises", 100);
    opencv_test::SceneOptions unused;
    for (size_t i = 0; i < motions.size(); ++i)
        require(setMotion(motions[i], unused), "--motions: " + motions[i] + " is unknown");
    for (size_t i = 0; i < kinds.size(); ++i)
        require(setKind(kinds[i], unused), "--kinds: " + kinds[i] + " is unknown");
    for (size_t i = 0; i < by.size(); ++i)
        require(std::find(AXES, AXES + 6, by[i]) != AXES + 6, "--by: " + by[i] + " is unknown");
    for (size_t i = 0; i < orders.size(); ++i)
    {
        require(orders[i] == "none" || setOrder(orders[i], unused),
                "--orders: expected none, second, place, near or numbers above 0 up to 1, not " +
                    orders[i]);
    }
}

void StructuredOptions::parseNumbers(const cv::CommandLineParser& parser)
{
    noise = numberOf(parser, "noise");
    threshold = numberOf(parser, "threshold");
    confidence = numberOf(parser, "confidence");
    maxIterations = integerOf(parser, "maxIters");
    maxIterationsInverted = integerOf(parser, "maxItersInverted");
    spare = integerOf(parser, "spare");
    runs = integerOf(parser, "runs");
    seed = integerOf(parser, "seed");
    threads = integerOf(parser, "threads");
    const std::string table = parser.get<cv::String>("table");
    brief = table == "brief";
    require(brief || table == "full", "--table: expected full or brief");
    const std::string judged = parser.get<cv::String>("judge");
    startsTrue = judged == "start";
    require(startsTrue || judged == "cost", "--judge: expected cost or start");
    csv = parser.get<cv::String>("csv");
    require(noise >= 0, "--noise: expected 0 or more");
    require(threshold > 0, "--threshold: expected a number above 0");
    require(confidence > 0 && confidence < 1, "--confidence: expected a number between 0 and 1");
    require(maxIterations > 0 && maxIterationsInverted > 0,
            "--maxIters, --maxItersInverted: expected numbers above 0");
    require(spare >= 0 && runs > 0 && seed >= 0,
            "--spare, --seed: expected 0 or more; --runs: above 0");
}

bool StructuredOptions::parse(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about("Measures search failures and accuracy on synthetic scenes with the structure of "
                 "real ones.\n"
                 "Methods: " +
                 knownMethods() + ".");
    if (parser.has("help") || argc == 1)
    {
        parser.printMessage();
        return false;
    }
    const std::string mode = parser.get<cv::String>("mode");
    search = mode == "search";
    accuracy = mode == "accuracy";
    random = mode == "random";
    require(search || accuracy || random, "--mode: expected search, accuracy or random");
    for (const char* option : OF_SEARCH)
        require(search || arguments.all(option).empty(),
                std::string("--") + option + ": for --mode=search only");
    require(accuracy || arguments.all("noises").empty(), "--noises: for --mode=accuracy only");
    require(!accuracy || arguments.all("kinds").empty(), "--kinds: not for --mode=accuracy");
    for (const char* option : {"motions", "ratios"})
        require(!random || arguments.all(option).empty(),
                std::string("--") + option + ": not for --mode=random");
    parseGrid(parser, arguments);
    parseNumbers(parser);
    return true;
}

}  // namespace benchmark
