// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Measures how well Report::covariance describes the errors of models on synthetic scenes with
// known true models. The squared Mahalanobis distance of the true model, divided by the number of
// parameters, should be 1 on average, and the 95 % confidence regions should contain 95 % of the
// true models.
//
//     usac_covariance --scenes=10000 > covariance.md

#include <iostream>
#include <map>
#include "arguments.hpp"
#include "calibration.hpp"
#include "image_pair.hpp"
#include "program.hpp"

using namespace benchmark;
using namespace cv::usacv20;

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{problems       |H,F,E,A,S,P,R,M| H homography, F and E fundamental and essential "
         "matrix, A affinity, S similarity, T translation, P absolute pose, R rigid motion of "
         "3D space, M the same with a scale }"
         "{shapes         |plane,cloud,general,forward,plane50,plane95| kinds of scenes; H, A, "
         "S, T: plane; F: general, forward (motion along the optical axis), plane50 (half of "
         "the points on a plane); E: the same, and plane95; P, R, M: cloud, plane }"
         "{sizes          |20,100,1000| numbers of matches }"
         "{ratios         |0.1,0.3,0.5,0.7,0.95| fractions of right matches }"
         "{noises         |0.1,0.3,1| standard deviations of each component of the error, "
         "divided by the threshold }"
         "{spread         |1| noise of every second match, divided by that of the others; if it "
         "is not 1, the estimator gets these ratios as Params::sigmas, and its error is "
         "compared with that without sigmas }"
         "{directed       |0| 1: --spread is the noise of each point of an image in a random "
         "direction, divided by that across it; the estimator gets the covariances of the "
         "points. Not for R and M }"
         "{least          |6| minimum number of right matches in addition to those of a minimal "
         "sample; cells with fewer, and cells for F and E with a fraction of right matches "
         "below 0.3, are left out }"
         "{scenes         |10000| minimum number of scenes of each problem; each cell of a "
         "problem gets the same number }"
         "{preset         |USACV20| USACV20, USACV20_AUTO (with three times the threshold), "
         "USACV20_MAGSAC, leastSquares (USACV20 with POLISHING_LEAST_SQUARES) }"
         "{by             |problem,shape,size,ratio,noise| properties of scenes; a table for "
         "each }"
         "{seed           |1| seed of the first scene of each cell; each further scene adds 1 }"
         "{threads        |1| argument of cv::setNumThreads; -1: all processors }";

struct Options
{
    std::vector<std::string> problems, shapes, by;
    std::vector<int> sizes;
    std::vector<double> ratios, noises;
    int least, scenes, seed;
    double spread;
    bool directed;
    double widening;  //!< ratio of the estimator's threshold to that of the cell
    Params params;
};

std::vector<double> numbers(const cv::CommandLineParser& parser, const Arguments& arguments,
                            const std::string& name, double most)
{
    std::vector<double> result;
    for (const std::string& text : namesOf(parser, arguments, name))
    {
        result.push_back(toNumber(text, name));
        require(result.back() > 0 && result.back() <= most,
                "--" + name + ": " + text + " is out of range");
    }
    return result;
}

Params presetOf(const std::string& name)
{
    if (name == "USACV20_AUTO")
        return Params::automatic();
    if (name == "USACV20_MAGSAC")
        return Params::magsacPlusPlus();
    Params params;
    if (name == "leastSquares")
        params.polishing = POLISHING_LEAST_SQUARES;
    else
        require(name == "USACV20", "--preset: " + name + " is unknown");
    return params;
}

bool parse(int argc, char** argv, Options& options)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about(
        "Measures on synthetic scenes how well Report::covariance describes the errors of models.");
    if (parser.has("help"))
    {
        parser.printMessage();
        return false;
    }
    options.problems = namesOf(parser, arguments, "problems");
    options.shapes = namesOf(parser, arguments, "shapes");
    options.by = namesOf(parser, arguments, "by");
    for (double size : numbers(parser, arguments, "sizes", 1e6))
        options.sizes.push_back((int)size);
    options.ratios = numbers(parser, arguments, "ratios", 1);
    options.noises = numbers(parser, arguments, "noises", 10);
    options.spread = numbers(parser, arguments, "spread", 1000)[0];
    const int directed = integerOf(parser, "directed");
    require(directed == 0 || directed == 1, "--directed: expected 0 or 1");
    options.directed = directed != 0;
    options.least = integerOf(parser, "least");
    options.scenes = integerOf(parser, "scenes");
    options.seed = integerOf(parser, "seed");
    require(options.least >= 1 && options.scenes >= 1 && options.seed >= 0,
            "--least, --scenes: expected 1 or more; --seed: 0 or more");
    const std::string preset = parser.get<cv::String>("preset");
    options.params = presetOf(preset);
    options.widening = preset == "USACV20_AUTO" ? 3 : 1;
    cv::setNumThreads(integerOf(parser, "threads"));
    return true;
}

int sampleSizeOf(ProblemType problem)
{
    const int sizes[] = {4, 7, 5, 3, 2, 3, 3, 3, 1};
    return sizes[problem];
}

double thresholdOf(ProblemType problem)
{
    const bool space = problem == RIGID_3D || problem == SIMILARITY_3D;
    return space ? 0.035 : problem == FUNDAMENTAL || problem == ESSENTIAL ? 1.5 : 2;
}

std::vector<SceneCell> cellsOf(const Options& options, ProblemType problem)
{
    std::vector<SceneCell> cells;
    const bool epipolar = problem == FUNDAMENTAL || problem == ESSENTIAL;
    for (const std::string& shape : options.shapes)
        for (int size : options.sizes)
            for (double ratio : options.ratios)
                for (double noise : options.noises)
                {
                    if (!KnownScene::has(problem, shape) || (epipolar && ratio < 0.3) ||
                        cvRound(size * ratio) < sampleSizeOf(problem) + options.least)
                        continue;
                    const SceneCell cell = {problem,        shape,           size,
                                            ratio,          noise,           thresholdOf(problem),
                                            options.spread, options.directed};
                    cells.push_back(cell);
                }
    return cells;
}

//! The first entries of the table row in which the scenes of a cell are counted. `by` is the
//! property that all cells of a row share.
std::string rowOf(const std::string& letter, const SceneCell& cell, const std::string& by)
{
    const std::string start = "| " + letter + " | ";
    if (by == "problem")
        return start + "all";
    if (by == "shape")
        return start + cell.shape;
    if (by == "size")
        return start + cv::format("%d matches", cell.size);
    if (by == "ratio")
        return start + cv::format("%g right", cell.ratio);
    require(by == "noise", "--by: " + by + " is unknown");
    return start + cv::format("noise %g", cell.noise);
}

typedef std::vector<std::pair<std::string, Calibration>> Table;

void addTo(Table& table, const std::string& row, const Calibration& calibration)
{
    for (std::pair<std::string, Calibration>& known : table)
        if (known.first == row)
        {
            known.second.add(calibration);
            return;
        }
    table.push_back(std::make_pair(row, calibration));
}

int program(int argc, char** argv)
{
    Options options;
    if (!parse(argc, argv, options))
        return 0;
    std::vector<Table> tables(options.by.size());
    for (const std::string& letter : options.problems)
    {
        ProblemType problem = HOMOGRAPHY;
        require(letter.size() == 1 && problemOf(letter[0], problem),
                "--problems: " + letter + " is unknown");
        require(!options.directed || (problem != RIGID_3D && problem != SIMILARITY_3D),
                "--directed: the points of " + letter + " are not in images");
        const std::vector<SceneCell> cells = cellsOf(options, problem);
        const int runs = cells.empty() ? 0 : (options.scenes - 1) / (int)cells.size() + 1;
        for (const SceneCell& cell : cells)
        {
            Calibration calibration;
            for (int i = 0; i < runs; ++i)
                calibration.add(cell, options.seed + i, options.params, options.widening);
            for (size_t k = 0; k < tables.size(); ++k)
                addTo(tables[k], rowOf(letter, cell, options.by[k]), calibration);
        }
    }
    for (const Table& table : tables)
    {
        std::cout << "\n| problem | scenes of |" << Calibration::header(options.spread != 1)
                  << "\n";
        for (const std::pair<std::string, Calibration>& row : table)
            std::cout << row.first << " |" << row.second.row(options.spread != 1) << "\n";
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(program, argc, argv); }
