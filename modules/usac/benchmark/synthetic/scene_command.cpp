// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scene_command.hpp"

#include <stdexcept>
#include "arguments.hpp"

namespace benchmark {

using namespace opencv_test;

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{out            | | folder of data to write to; made if it does not exist }"
         "{scene          |general| general: for F and E (fundamental and essential matrix), "
         "points at any depth; plane: for F and E, many points on one plane; planar: for H "
         "(homography); affinity: for A; similarity: for S; translation: for T; view: for P "
         "(absolute pose), object points at any depth; viewPlane: for P, object points on a "
         "plane; rigid: for R (rigid motion), points of 3D space; rigidScaled: for M, the same "
         "with a scale }"
         "{name           | | name of the data set (default: synthetic_<scene>) }"
         "{pairs          |10| number of pairs }"
         "{size           |1000| number of matches of a pair }"
         "{inliers        |0.5| fraction of the matches that are right, above 0 }"
         "{noise          |0.5| standard deviation of the noise of each coordinate of the right "
         "matches, pixels; R, M: only in space 2, where the cloud of points is 200 * scale "
         "wide }"
         "{planeFraction  |0.8| --scene=plane: fraction of the right matches that are on the "
         "plane }"
         "{thickness      |0| --scene=viewPlane: standard deviation of the distances of the "
         "object points from the plane, divided by the distance of the plane from the camera; "
         "R, M: if given, the cloud is flat, and this is the standard deviation of the "
         "distances from its plane, divided by the width of the cloud (without this option, "
         "the cloud is a cube) }"
         "{distortion     |0| P: first radial distortion coefficient of the camera, -0.5 to "
         "0.5 }"
         "{duplicates     |0| fraction of the right matches that are copies of other right "
         "matches }"
         "{angle          |12| angle of the rotation between the cameras, degrees; not for P, R "
         "and M, whose poses and motions have random rotations }"
         "{outliers       |uniform| the wrong matches. uniform: anywhere; local: right matches "
         "displaced in image 2 by 5 to 50 pixels; manyToOne: about ten wrong matches share the "
         "image 2 point of a right match; clustered: from one square of side 80 pixels to "
         "another; second: they agree with another model, within a square of side 160 pixels of "
         "image 1 (P, R, M: at most half as many as right matches; the other wrong ones are "
         "uniform). local and manyToOne: not for P, R and M; R, M: instead of squares, cubes "
         "whose sides are an eighth (clustered) and a quarter (second) of the width of the "
         "cloud }"
         "{scores         |0.5| probability that a right match has a better score than a wrong "
         "one; 0.5: scores are not informative; 1: all right matches have better scores }"
         "{seed           |1| seed of the first pair; each further pair adds 1 }";

bool isPart(double value) { return value >= 0 && value <= 1; }

//! A kind of scene and its problems.
struct SceneKind
{
    const char* name;
    ProblemType problem;  //!< argument of makeScene(); unused for views and motions of space
    const char* letters;
};

const SceneKind SCENES[] = {
    {"general", cv::usacv20::FUNDAMENTAL, "FE"},
    {"plane", cv::usacv20::FUNDAMENTAL, "FE"},
    {"planar", cv::usacv20::HOMOGRAPHY, "H"},
    {"affinity", cv::usacv20::AFFINITY, "A"},
    {"similarity", cv::usacv20::SIMILARITY, "S"},
    {"view", cv::usacv20::HOMOGRAPHY, "P"},
    {"viewPlane", cv::usacv20::HOMOGRAPHY, "P"},
    {"rigid", cv::usacv20::HOMOGRAPHY, "R"},
    {"rigidScaled", cv::usacv20::HOMOGRAPHY, "M"},
    {"translation", cv::usacv20::TRANSLATION_2D, "T"},
};

struct OutlierKind
{
    const char* name;
    OutlierModel model;
};

const OutlierKind OUTLIERS[] = {
    {"uniform", OUTLIERS_UNIFORM},       {"local", OUTLIERS_LOCAL},
    {"manyToOne", OUTLIERS_MANY_TO_ONE}, {"clustered", OUTLIERS_CLUSTERED},
    {"second", OUTLIERS_SECOND_MODEL},
};

//! The element of `kinds` with the given name. Raises std::runtime_error with all known names if
//! there is no such element. @param option the option that the error message names
template <class Kind, size_t count>
const Kind& find(const Kind (&kinds)[count], const std::string& name, const char* option)
{
    std::string names;
    for (const Kind& kind : kinds)
    {
        if (name == kind.name)
            return kind;
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    }
    throw std::runtime_error(std::string("--") + option + ": expected one of " + names);
}

//! Raises std::runtime_error for options that do not apply to the chosen kind of scene.
void requireKinds(const std::string& scene, const SceneCommand& command, const Arguments& arguments)
{
    require(scene == "plane" || arguments.all("planeFraction").empty(),
            "--planeFraction: for --scene=plane only");
    require(scene == "viewPlane" || command.isSpace() || arguments.all("thickness").empty(),
            "--thickness: for --scene=viewPlane, rigid and rigidScaled only");
    require(command.isView() || arguments.all("distortion").empty(),
            "--distortion: for --scene=view and viewPlane only");
    require(!(command.isView() || command.isSpace()) || arguments.all("angle").empty(),
            "--angle: for pairs of images only");
}

//! Reads the options of image pairs; views and motions of space share most of these.
void readImages(const cv::CommandLineParser& parser, const std::string& scene,
                SceneOptions& options)
{
    const int size = integerOf(parser, "size"), seed = integerOf(parser, "seed");
    const double inliers = numberOf(parser, "inliers"), duplicates = numberOf(parser, "duplicates");
    options.noise = numberOf(parser, "noise");
    options.planeFraction = scene == "plane" ? numberOf(parser, "planeFraction") : 0;
    options.angle = numberOf(parser, "angle");
    options.outlierModel = find(OUTLIERS, parser.get<cv::String>("outliers"), "outliers").model;
    options.scoreInformation = numberOf(parser, "scores");
    options.seed = seed;
    require(options.noise >= 0, "--noise: expected 0 or more");
    require(seed >= 0, "--seed: expected 0 or more");
    require(options.angle >= 0 && options.angle <= 60,
            "--angle: expected a number between 0 and 60");
    require(isPart(inliers) && isPart(options.planeFraction) && duplicates >= 0 && duplicates < 1,
            "--inliers, --planeFraction, --duplicates: expected numbers between 0 and 1");
    require(options.scoreInformation > 0 && options.scoreInformation <= 1,
            "--scores: expected a number above 0 up to 1");
    options.setSize(size, inliers);
    options.duplicates = (int)(options.inliers * duplicates);
    require(options.inliers > 0 && options.outliers >= 0,
            "--size, --inliers: there is no right match");
}

//! Copies the options that views and motions of space share with image pairs. Raises
//! std::runtime_error for kinds of wrong matches that exist for image pairs only.
template <class Options>
void readMatches(const SceneOptions& images, Options& options)
{
    options.inliers = images.inliers;
    options.outliers = images.outliers;
    options.duplicates = images.duplicates;
    options.noise = images.noise;
    options.outlierModel = images.outlierModel;
    options.scoreInformation = images.scoreInformation;
    options.seed = images.seed;
    require(images.outlierModel != OUTLIERS_LOCAL && images.outlierModel != OUTLIERS_MANY_TO_ONE,
            "--outliers: local and manyToOne are for pairs of images only");
}

double readThickness(const cv::CommandLineParser& parser)
{
    const double thickness = numberOf(parser, "thickness");
    require(thickness >= 0 && thickness <= 0.5, "--thickness: expected a number between 0 and 0.5");
    return thickness;
}

//! Reads the options of views. @param images options of image pairs, some of which views share
void readView(const cv::CommandLineParser& parser, const std::string& scene,
              const SceneOptions& images, ViewOptions& options)
{
    readMatches(images, options);
    options.onPlane = scene == "viewPlane";
    options.thickness = readThickness(parser);
    options.distortion = numberOf(parser, "distortion");
    require(options.distortion >= -0.5 && options.distortion <= 0.5,
            "--distortion: expected a number between -0.5 and 0.5");
}

}  // namespace

bool SceneCommand::parse(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about("Writes synthetic scenes with exact ground truth as data for usac_benchmark. The "
                 "same options always write the same files.");
    if (parser.has("help") || argc == 1)
    {
        parser.printMessage();
        return false;
    }
    const std::string scene = parser.get<cv::String>("scene");
    const SceneKind& kind = find(SCENES, scene, "scene");
    folder = parser.get<cv::String>("out");
    name = parser.has("name") ? std::string(parser.get<cv::String>("name")) : "synthetic_" + scene;
    problem = kind.problem;
    letters = kind.letters;
    pairs = integerOf(parser, "pairs");
    require(!folder.empty(), "--out: expected a folder");
    require(name.find_first_of("/\\") == std::string::npos,
            "--name: expected a name without folders");
    require(pairs > 0, "--pairs: expected a number above 0");
    requireKinds(scene, *this, arguments);
    readImages(parser, scene, images);
    if (isView())
        readView(parser, scene, images, view);
    if (isSpace())
    {
        readMatches(images, space);
        space.scaled = letters == "M";
        space.flat = !arguments.all("thickness").empty();
        space.thickness = readThickness(parser);
    }
    return true;
}

}  // namespace benchmark
