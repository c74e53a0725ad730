// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tracking_options.hpp"

#include "arguments.hpp"

namespace benchmark {

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

}  // namespace

bool TrackingOptions::parse(int argc, char** argv)
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
        problems.push_back(problem);
    }
    for (const std::string& ratio : namesOf(parser, arguments, "ratios"))
    {
        ratios.push_back(toNumber(ratio, "ratios"));
        require(ratios.back() > 0 && ratios.back() <= 1,
                "--ratios: expected numbers above 0 up to 1");
    }
    for (const std::string& limit : namesOf(parser, arguments, "limits"))
    {
        limits.push_back(toInteger(limit, "limits"));
        require(limits.back() > 0, "--limits: expected numbers above 0");
    }
    frames = integerOf(parser, "frames");
    size = integerOf(parser, "size");
    sequences = integerOf(parser, "sequences");
    seed = integerOf(parser, "seed");
    noise = numberOf(parser, "noise");
    speed = numberOf(parser, "speed");
    csv = parser.get<cv::String>("csv");
    require(frames > 1 && size > 0 && sequences > 0,
            "--frames: expected 2 or more; --size, --sequences: expected 1 or more");
    require(noise >= 0 && speed >= 0 && seed >= 0, "--noise, --speed, --seed: expected 0 or more");
    return true;
}

}  // namespace benchmark
