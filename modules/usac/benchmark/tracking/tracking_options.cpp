// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "tracking_options.hpp"

#include "arguments.hpp"

namespace benchmark {

namespace {

const char KEYS
    [] = "{help h usage ? | | print this }"
         "{problems       |P,H| of the sequences }"
         "{ratios         |0.2,0.35,0.6| parts of right matches }"
         "{limits         |1,8,32,128| most samples, in addition to the default of the problem }"
         "{frames         |300| of a sequence; before the middle one the camera jumps }"
         "{size           |1000| matches of a frame }"
         "{noise          |0.5| standard deviation of the right matches in each "
         "coordinate, pixels }"
         "{speed          |2| 1: about 1.4 pixels a frame }"
         "{sequences      |3| with a seed of their own }"
         "{seed           |1| of the first sequence, the next ones count up }"
         "{csv            | | file for the figures }";

}  // namespace

bool TrackingOptions::parse(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv, KEYS);
    const Arguments arguments(argc, argv, parser);
    parser.about(
        "What the model of the frame before gives a tracker: sequences with and without it.");
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
            "--frames, --size, --sequences: expected numbers above 0, 1");
    require(noise >= 0 && speed >= 0 && seed >= 0, "--noise, --speed, --seed: expected 0 or more");
    return true;
}

}  // namespace benchmark
