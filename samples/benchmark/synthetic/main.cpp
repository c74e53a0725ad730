// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Writes synthetic scenes with exact truth as data for usac_benchmark. The generator is that of the module's tests.
//
//     usac_synthetic --out=<folder> --scene=plane --planeFraction=0.9 --pairs=20 --size=2000 --inliers=0.3
//     usac_benchmark --data=<folder>

#include "arguments.hpp"
#include "pair_writer.hpp"
#include "program.hpp"

using namespace benchmark;
using namespace opencv_test;

namespace {

const char KEYS[] =
    "{help h usage ? | | print this }"
    "{out            | | folder of data to write to; made if it is not there }"
    "{scene          |general| general: F and E; plane: F and E, many points on one plane; planar: H }"
    "{name           | | of the data set (default: synthetic_<scene>) }"
    "{pairs          |10| number of pairs }"
    "{size           |1000| matches of a pair }"
    "{inliers        |0.5| part of them that is right, above 0 }"
    "{noise          |0.5| standard deviation of the right matches in each coordinate, pixels }"
    "{planeFraction  |0.8| --scene=plane: part of the right matches that is on the plane }"
    "{duplicates     |0| part of the right matches that repeats others }"
    "{angle          |12| rotation between the cameras, degrees }"
    "{outliers       |uniform| wrong matches; uniform: anywhere; local: right but for 5 to 50 pixels in image 2; "
    "manyToOne: about ten with the same point of image 2, that of a right match }"
    "{scores         |0.5| probability that a right match has a better score than a wrong one; 0.5: scores tell "
    "nothing, "
    "1: all }"
    "{seed           |1| of the first pair, the next ones count up }";

struct Command
{
    std::string folder, name;
    bool planar;
    int pairs;
    SceneOptions options;
};

bool isPart(double value) { return value >= 0 && value <= 1; }

OutlierModel outlierModelOf(const std::string& name)
{
    require(name == "uniform" || name == "local" || name == "manyToOne",
            "--outliers: expected uniform, local or manyToOne");
    return name == "uniform" ? OUTLIERS_UNIFORM : name == "local" ? OUTLIERS_LOCAL : OUTLIERS_MANY_TO_ONE;
}

//! @return false if only help was asked for.
bool parse(int argc, char** argv, Command& command)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about(
        "Writes synthetic scenes with exact truth as data for usac_benchmark. The same options write the same files.");
    if (parser.has("help") || argc == 1)
    {
        parser.printMessage();
        return false;
    }
    const std::string scene = parser.get<cv::String>("scene");
    const int size = integerOf(parser, "size"), seed = integerOf(parser, "seed");
    const double inliers = numberOf(parser, "inliers"), duplicates = numberOf(parser, "duplicates");
    SceneOptions& options = command.options;
    command.folder = parser.get<cv::String>("out");
    command.name = parser.has("name") ? std::string(parser.get<cv::String>("name")) : "synthetic_" + scene;
    command.planar = scene == "planar";
    command.pairs = integerOf(parser, "pairs");
    options.noise = numberOf(parser, "noise");
    options.planeFraction = scene == "plane" ? numberOf(parser, "planeFraction") : 0;
    options.angle = numberOf(parser, "angle");
    options.outlierModel = outlierModelOf(parser.get<cv::String>("outliers"));
    options.scoreInformation = numberOf(parser, "scores");
    options.seed = seed;
    require(!command.folder.empty(), "--out: expected a folder");
    require(command.name.find_first_of("/\\") == std::string::npos, "--name: expected a name without folders");
    require(scene == "general" || scene == "plane" || scene == "planar", "--scene: expected general, plane or planar");
    require(scene == "plane" || arguments.all("planeFraction").empty(), "--planeFraction: for --scene=plane only");
    require(command.pairs > 0, "--pairs: expected a number above 0");
    require(options.noise >= 0, "--noise: expected 0 or more");
    require(seed >= 0, "--seed: expected 0 or more");
    require(options.angle >= 0 && options.angle <= 60, "--angle: expected a number between 0 and 60");
    require(isPart(inliers) && isPart(options.planeFraction) && duplicates >= 0 && duplicates < 1,
            "--inliers, --planeFraction, --duplicates: expected numbers between 0 and 1");
    require(options.scoreInformation > 0 && options.scoreInformation <= 1,
            "--scores: expected a number above 0 up to 1");
    options.setSize(size, inliers);
    options.duplicates = (int)(options.inliers * duplicates);
    require(options.inliers > 0 && options.outliers >= 0, "--size, --inliers: there is no right match");
    return true;
}

int run(int argc, char** argv)
{
    Command command;
    if (!parse(argc, argv, command))
        return 0;
    PairWriter writer(command.folder, command.name, command.planar ? "H" : "FE");
    for (int i = 0; i < command.pairs; ++i, ++command.options.seed)
        writer.write(makeScene(command.planar ? cv::usacv20::HOMOGRAPHY : cv::usacv20::FUNDAMENTAL, command.options));
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(run, argc, argv); }
