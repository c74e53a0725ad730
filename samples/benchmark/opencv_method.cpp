// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "opencv_method.hpp"

#include <algorithm>
#include <stdexcept>
#include "opencv2/calib3d.hpp"
#include "opencv2/imgproc.hpp"

namespace benchmark {

typedef std::vector<cv::Point2f> Points;

namespace {

struct Flag
{
    const char* name;
    int value;
};

const Flag FLAGS[] = {
    {"RANSAC", cv::RANSAC},
    {"LMEDS", cv::LMEDS},
    {"RHO", cv::RHO},
    {"USAC_DEFAULT", cv::USAC_DEFAULT},
    {"USAC_PARALLEL", cv::USAC_PARALLEL},
    {"USAC_FM_8PTS", cv::USAC_FM_8PTS},
    {"USAC_FAST", cv::USAC_FAST},
    {"USAC_ACCURATE", cv::USAC_ACCURATE},
    {"USAC_PROSAC", cv::USAC_PROSAC},
    {"USAC_MAGSAC", cv::USAC_MAGSAC},
};

const int ITERATIONS_OF_TWO_CAMERAS = 1000;

//! What calib3d makes of a USAC flag for E.
cv::UsacParams usacParamsOf(int flag, const Settings& settings)
{
    cv::UsacParams params;
    params.threshold = settings.threshold;
    params.confidence = settings.confidence;
    params.maxIterations = settings.maxIterations;
    params.sampler = flag == cv::USAC_PROSAC ? cv::SAMPLING_PROSAC : cv::SAMPLING_UNIFORM;
    params.score = flag == cv::USAC_MAGSAC ? cv::SCORE_METHOD_MAGSAC : cv::SCORE_METHOD_MSAC;
    params.isParallel = flag == cv::USAC_PARALLEL;
    params.loSampleSize = flag == cv::USAC_MAGSAC ? 50 : flag == cv::USAC_ACCURATE ? 20 : 16;
    params.loIterations = flag == cv::USAC_MAGSAC     ? 10
                          : flag == cv::USAC_ACCURATE ? 25
                          : flag == cv::USAC_FAST     ? 5
                                                      : 15;
    params.loMethod = flag == cv::USAC_MAGSAC                             ? cv::LOCAL_OPTIM_SIGMA
                      : flag == cv::USAC_ACCURATE                         ? cv::LOCAL_OPTIM_GC
                      : flag == cv::USAC_DEFAULT || flag == cv::USAC_FAST ? cv::LOCAL_OPTIM_INNER_AND_ITER_LO
                                                                          : cv::LOCAL_OPTIM_INNER_LO;
    return params;
}

//! Points of a camera as the camera `mean` sees them.
cv::Mat toCamera(const Points& points, const cv::Matx33d& K, const cv::Matx33d& mean)
{
    cv::Mat result;
    cv::undistortPoints(points, result, K, cv::noArray(), cv::noArray(), mean);
    return result;
}

}  // namespace

OpenCVMethod::OpenCVMethod(const std::string& name, const std::string& flagName, bool scores)
    : Method(name), flag(-1), sortPoints(scores)
{
    for (const Flag& candidate : FLAGS)
        if (flagName == candidate.name)
            flag = candidate.value;
    if (flag < 0)
        throw std::runtime_error(name + ": no such method; there are " + knownMethods());
    if (scores && flag != cv::USAC_PROSAC)
        throw std::runtime_error(name + ": of OpenCV's flags only cv:USAC_PROSAC makes use of scores");
}

bool OpenCVMethod::solves(ProblemType problem) const
{
    if (flag == cv::RHO)
        return problem == cv::usacv20::HOMOGRAPHY;
    if (flag == cv::USAC_FM_8PTS)
        return problem == cv::usacv20::FUNDAMENTAL;
    return true;
}

void OpenCVMethod::prepare(const ImagePair&, const Settings& settings_) { settings = settings_; }

void OpenCVMethod::run(const ImagePair& pair, Estimate& estimate)
{
    if (sortPoints)
        runSorted(pair, estimate);
    else
        find(pair, pair.points1, pair.points2, estimate);
}

void OpenCVMethod::runSorted(const ImagePair& pair, Estimate& estimate) const
{
    const size_t count = pair.points1.size();
    std::vector<int> order(count);
    for (size_t i = 0; i < count; ++i)
        order[i] = (int)i;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return pair.scores[a] < pair.scores[b]; });

    Points points1(count), points2(count);
    for (size_t i = 0; i < count; ++i)
    {
        points1[i] = pair.points1[order[i]];
        points2[i] = pair.points2[order[i]];
    }
    find(pair, points1, points2, estimate);

    if (estimate.mask.total() != count)
        return;
    const cv::Mat sorted = estimate.mask.clone();
    for (size_t i = 0; i < count; ++i)
        estimate.mask.at<uchar>(order[i]) = sorted.at<uchar>((int)i);
}

void OpenCVMethod::find(const ImagePair& pair, const Points& points1, const Points& points2, Estimate& estimate) const
{
    const double threshold = settings.threshold, confidence = settings.confidence;
    const int maxIters = settings.maxIterations;
    const cv::Mat noDistortion;
    if (settings.problem == cv::usacv20::HOMOGRAPHY)
        estimate.model = cv::findHomography(points1, points2, flag, threshold, estimate.mask, maxIters, confidence);
    else if (settings.problem == cv::usacv20::FUNDAMENTAL)
        estimate.model = cv::findFundamentalMat(points1, points2, flag, threshold, confidence, maxIters, estimate.mask);
    else if (maxIters == ITERATIONS_OF_TWO_CAMERAS)
        estimate.model = cv::findEssentialMat(points1, points2, pair.K1, noDistortion, pair.K2, noDistortion, flag,
                                              confidence, threshold, estimate.mask);
    else if (flag == cv::RANSAC || flag == cv::LMEDS)
    {
        const cv::Matx33d mean = (pair.K1 + pair.K2) * 0.5;
        estimate.model = cv::findEssentialMat(toCamera(points1, pair.K1, mean), toCamera(points2, pair.K2, mean), mean,
                                              flag, confidence, threshold, maxIters, estimate.mask);
    }
    else
        estimate.model = cv::findEssentialMat(points1, points2, pair.K1, pair.K2, noDistortion, noDistortion,
                                              estimate.mask, usacParamsOf(flag, settings));
}

std::string OpenCVMethod::names()
{
    std::string result;
    for (const Flag& candidate : FLAGS)
        result += (result.empty() ? "cv:" : ", cv:") + std::string(candidate.name);
    return result;
}

}  // namespace benchmark
