// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scene_kind.hpp"

#include <cstdlib>

namespace benchmark {

using namespace opencv_test;

namespace {

const int COPIES = 5;
//! Kind `second`: number of matches of the other model divided by the number of right matches.
const double SECOND = 0.9;
//! Kind `partSecond`: the same ratio; if there are fewer wrong matches, all follow the other model.
const double PART_SECOND = 0.7;

struct NamedScores
{
    const char* name;
    ScoreModel model;
};

const NamedScores MISLEADING[] = {
    {"second", SCORES_OF_SECOND}, {"place", SCORES_OF_PLACE}, {"near", SCORES_NEAR}};

struct NamedMotion
{
    const char* name;
    Motion motion;
    double angle, baseline;
};

const NamedMotion MOTIONS[] = {
    {"general", MOTION_GENERAL, 12, 1},
    {"forward", MOTION_FORWARD, 2, 1},
    {"forward0", MOTION_FORWARD, 0, 1},
    {"sideways", MOTION_SIDEWAYS, 2, 1},
    {"rectified", MOTION_RECTIFIED, 0, 1},
    {"planar", MOTION_PLANAR, 12, 1},
    {"car", MOTION_CAR, 12, 1},
    {"narrow", MOTION_GENERAL, 12, 0.01},
    {"rotation", MOTION_GENERAL, 12, 0.001},
    {"frontal", MOTION_SIDEWAYS, 0, 1},
    {"aerial", MOTION_RECTIFIED, 0, 1},
};

struct NamedOutliers
{
    const char* name;
    OutlierModel model;
};

const NamedOutliers OUTLIERS[] = {
    {"generic", OUTLIERS_UNIFORM},     {"clustered", OUTLIERS_CLUSTERED},
    {"local", OUTLIERS_LOCAL},         {"manyToOne", OUTLIERS_MANY_TO_ONE},
    {"targets", OUTLIERS_TARGETS},     {"line", OUTLIERS_LINE},
    {"second", OUTLIERS_SECOND_MODEL}, {"duplicates", OUTLIERS_UNIFORM},
    {"copies", OUTLIERS_UNIFORM},      {"clusters", OUTLIERS_CLUSTERS},
    {"center", OUTLIERS_CENTER},       {"window", OUTLIERS_WINDOW},
    {"border", OUTLIERS_BORDER},
};

//! Kinds with wrong matches that agree with each other. The number of these matches, in percent of
//! all matches, is appended to the name.
const NamedOutliers AGREEING[] = {
    {"shift", OUTLIERS_SHIFT}, {"moving", OUTLIERS_PLANE}, {"place", OUTLIERS_PLACE}};

//! For a name that consists of `word` and an integer from 0 to 100 (percent), the integer as a
//! fraction; for any other name 0.
double partOf(const std::string& name, const std::string& word)
{
    const std::string number = name.compare(0, word.size(), word) == 0 ? name.substr(word.size())
                                                                       : std::string();
    const bool digits = !number.empty() && number.size() < 4 &&
                        number.find_first_not_of("0123456789") == std::string::npos;
    const int percent = digits ? std::atoi(number.c_str()) : 0;
    return percent <= 100 ? percent / 100. : 0;
}

double planeOf(const std::string& name) { return partOf(name, "plane"); }

}  // namespace

int sampleSizeOf(ProblemType problem)
{
    return problem == cv::usacv20::HOMOGRAPHY ? 4 : problem == cv::usacv20::FUNDAMENTAL ? 7 : 5;
}

bool setMotion(const std::string& name, SceneOptions& options)
{
    for (const NamedMotion& known : MOTIONS)
    {
        if (name != known.name)
            continue;
        options.motion = known.motion;
        options.angle = known.angle;
        options.baseline = known.baseline;
        if (name == "aerial")
        {
            options.nearest = 5.4;
            options.farthest = 6.6;
        }
        options.frontalPlane = name == "frontal";
        if (name == "frontal")
            options.planeFraction = 1;
        return true;
    }
    options.motion = MOTION_GENERAL;
    options.angle = 12;
    options.baseline = partOf(name, "baseline");
    return options.baseline > 0;
}

bool setKind(const std::string& name, SceneOptions& options)
{
    const double plane = planeOf(name);
    if (name == "partSecond")
    {
        options.second = std::min(cvRound(options.inliers * PART_SECOND), options.outliers);
        return true;
    }
    if (plane > 0)
    {
        options.planeFraction = plane;
        return true;
    }
    for (const NamedOutliers& known : AGREEING)
        if (partOf(name, known.name) > 0)
        {
            options.outlierModel = known.model;
            options.structured = cvRound((options.inliers + options.outliers) *
                                         partOf(name, known.name));
            return true;
        }
    for (const NamedOutliers& known : OUTLIERS)
        if (name == known.name)
        {
            options.outlierModel = known.model;
            options.duplicates = name == "duplicates" ? options.inliers / 2 : 0;
            options.copies = name == "copies" ? COPIES : 1;
            if (name == "second")
                options.outliers = cvRound(options.inliers * SECOND);
            return true;
        }
    return false;
}

bool setOrder(const std::string& name, SceneOptions& options)
{
    for (const NamedScores& known : MISLEADING)
        if (name == known.name)
        {
            options.scoreModel = known.model;
            return true;
        }
    char* end = 0;
    const double information = std::strtod(name.c_str(), &end);
    options.scoreInformation = information;
    return !name.empty() && *end == 0 && information > 0 && information <= 1;
}

bool Cell::options(int spare, SceneOptions& result) const
{
    result = SceneOptions();
    result.setSize(size, fixedRatio() ? 1 : ratio);
    if (!setMotion(motion, result) || !setKind(kind, result))
        return false;
    if (scored() && !setOrder(order, result))
        return false;
    if (result.scoreModel == SCORES_OF_SECOND && kind != "second" && kind != "partSecond")
        return false;  // no wrong matches follow a second model
    if (problem == cv::usacv20::HOMOGRAPHY && planeOf(kind) > 0)
        return false;  // all right matches of H are on a plane
    if (result.structured != INT_MAX && result.structured > result.outliers)
        return false;
    if (motion == "frontal" && problem == cv::usacv20::FUNDAMENTAL)
        return false;
    return result.inliers - result.duplicates >= sampleSizeOf(problem) + spare;
}

std::string Cell::value(const std::string& axis) const
{
    if (axis == "problem")
        return std::string(1, letterOf(problem));
    if (axis == "size")
        return cv::format("%d", size);
    if (axis == "ratio")
        return fixedRatio() ? std::string("-") : std::string(cv::format("%g", ratio));
    return axis == "motion" ? motion : axis == "kind" ? kind : order;
}

std::string Cell::name() const
{
    return value("problem") + " " + motion + " " + kind + " " + value("size") + " " +
           value("ratio") + " " + order;
}

}  // namespace benchmark
