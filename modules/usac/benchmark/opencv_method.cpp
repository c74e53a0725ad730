// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "opencv_method.hpp"

#include <algorithm>
#include <stdexcept>
#include "opencv2/usac/geometry.hpp"
#include "problems/rigid_motion.hpp"

namespace benchmark {

namespace {

struct OpenCVFlag
{
    const char* name;
    int value;
    const char* problems;  //!< letters of the problems that the flag can be used for
};

const OpenCVFlag OPENCV_FLAGS[] = {
    {"RANSAC", cv::RANSAC, "HFEAS"},
    {"LMEDS", cv::LMEDS, "HFEAS"},
    {"RHO", cv::RHO, "H"},
    {"USAC_DEFAULT", cv::USAC_DEFAULT, "HFEAP"},
    {"USAC_PARALLEL", cv::USAC_PARALLEL, "HFEAP"},
    {"USAC_FM_8PTS", cv::USAC_FM_8PTS, "F"},
    {"USAC_FAST", cv::USAC_FAST, "HFEAP"},
    {"USAC_ACCURATE", cv::USAC_ACCURATE, "HFEAP"},
    {"USAC_PROSAC", cv::USAC_PROSAC, "HFEAP"},
    {"USAC_MAGSAC", cv::USAC_MAGSAC, "HFEAP"},
    {"PNP_ITERATIVE", cv::SOLVEPNP_ITERATIVE, "P"},
    {"PNP_P3P", cv::SOLVEPNP_P3P, "P"},
    {"PNP_AP3P", cv::SOLVEPNP_AP3P, "P"},
    {"PNP_EPNP", cv::SOLVEPNP_EPNP, "P"},
    {"PNP_SQPNP", cv::SOLVEPNP_SQPNP, "P"},
    {"AFFINE3D", RigidMotion::AFFINE3D, "RM"},
    {"AFFINE3D_REFIT", RigidMotion::AFFINE3D_REFIT, "RM"},
};

}  // namespace

OpenCVMethod::OpenCVMethod(const std::string& name, const std::string& flagName, bool scores)
    : Method(name), flag(-1), sortPoints(scores)
{
    for (const OpenCVFlag& candidate : OPENCV_FLAGS)
        if (flagName == candidate.name)
        {
            flag = candidate.value;
            problems = candidate.problems;
        }
    if (flag < 0)
        throw std::runtime_error(name + ": no such method; there are " + knownMethods());
    if (scores && flag != cv::USAC_PROSAC)
        throw std::runtime_error(name +
                                 ": of OpenCV's flags only cv:USAC_PROSAC makes use of scores");
}

bool OpenCVMethod::solves(ProblemType problem) const
{
    return problems.find(letterOf(problem)) != std::string::npos;
}

void OpenCVMethod::prepare(const ImagePair&, const Settings& settings_) { settings = settings_; }

void OpenCVMethod::run(const ImagePair& pair, Estimate& estimate)
{
    if (sortPoints)
        runSorted(pair, estimate);
    else
        kindOf(settings.problem).callOpenCV(pair, flag, settings, estimate);
}

void OpenCVMethod::runSorted(const ImagePair& pair, Estimate& estimate) const
{
    const size_t count = pair.scores.size();
    std::vector<int> order(count);
    for (size_t i = 0; i < count; ++i)
        order[i] = (int)i;
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return pair.scores[a] < pair.scores[b]; });

    kindOf(settings.problem).callOpenCV(pair.reordered(order), flag, settings, estimate);

    if (estimate.mask.total() != count)
        return;
    const cv::Mat sorted = estimate.mask.clone();
    for (size_t i = 0; i < count; ++i)
        estimate.mask.at<uchar>(order[i]) = sorted.at<uchar>((int)i);
}

std::string OpenCVMethod::names()
{
    std::string result;
    for (const OpenCVFlag& candidate : OPENCV_FLAGS)
        result += (result.empty() ? "cv:" : ", cv:") + std::string(candidate.name);
    return result;
}

}  // namespace benchmark
