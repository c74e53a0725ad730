// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "fuzz/fuzz_contracts.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>
#include "support/params_fields.hpp"

using namespace cv::usacv20;
using cv::Mat;
using cv::Matx33d;
using cv::Point2d;
using cv::Point3d;

namespace opencv_test {

namespace {

struct Answer
{
    Mat model, mask;
    Report report;
    std::string exception;
};

//! Calls the estimate function of the problem.
Mat callOf(const FuzzInput& input, const Params& params, Mat& mask, Report& report)
{
#define USACV20_IMAGES(NAME) estimate##NAME(input.points1, input.points2, params, mask, report)
#define USACV20_SPACES(NAME) estimate##NAME(input.object, input.space2, params, mask, report)
#define USACV20_CAMERAS(NAME)                                                                      \
    estimate##NAME(input.points1, input.points2, input.K1, input.K2, input.d1, input.d2, params,   \
                   mask, report)
#define USACV20_POSE(NAME)                                                                         \
    estimate##NAME(input.object, input.points2, input.K1, input.d1, params, mask, report)
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS)                                             \
    case TYPE: return USACV20_##ARGUMENTS(NAME);
    switch (input.problem)
    {
#include "problems/registry.inl.hpp"
    }
    return Mat();
}

Answer run(const FuzzInput& input, int threads)
{
    Answer answer;
    Params params = input.params;
    if (params.threads == 1)  // any other number is kept
        params.threads = threads;
    try
    {
        answer.model = callOf(input, params, answer.mask, answer.report);
    }
    catch (const cv::Exception& e)
    {
        answer.exception = e.err;
    }
    return answer;
}

//! Returns 1 if the camera matrix is invalid, 0 if it is valid or empty, and -1 if it is nearly
//! singular or its determinant is too large. With -1, the call is allowed, but not required, to
//! raise an exception.
int wrongCamera(const Mat& K)
{
    if (K.empty())
        return 0;
    const double *k = K.ptr<double>(), det = std::abs(cv::determinant(K)),
                 scale = std::abs(k[0] * k[4] * k[8]);
    if (!cv::checkRange(K) || k[0] == 0 || k[4] == 0 || k[8] == 0 || k[6] != 0 || k[7] != 0)
        return 1;
    return det > 1e-10 * scale && det <= DBL_MAX && scale <= DBL_MAX ? 0 : -1;
}

bool wrongDistortion(const Mat& d)
{
    return d.total() == 3 || !cv::checkRange(d);  // 3 is the only wrong length that is read
}

bool isSpace(ProblemType problem) { return problem == RIGID_3D || problem == SIMILARITY_3D; }

//! Returns 1 if the call must raise an exception, 0 if it must not, and -1 if both are allowed.
int wrongArguments(const FuzzInput& input)
{
    const bool space = isSpace(input.problem);
    const size_t count = space || input.problem == ABSOLUTE_POSE ? input.object.size()
                                                                 : input.points1.size();
    int wrong = count != (space ? input.space2.size() : input.points2.size());
    try
    {
        input.params.check((int)count);
    }
    catch (const cv::Exception&)
    {
        wrong = 1;
    }
    const int degeneracy = input.params.degeneracy;
    const bool plane = input.problem == HOMOGRAPHY || input.problem == FUNDAMENTAL ||
                       input.problem == ESSENTIAL;
    if (!plane && (degeneracy & DEGENERACY_DEGENSAC) && degeneracy != Params().degeneracy)
        wrong = 1;
    if ((space || input.problem == ABSOLUTE_POSE) && input.params.residual == RESIDUAL_SYMMETRIC)
        wrong = 1;
    if (wrong == 1 || (input.problem != ESSENTIAL && input.problem != ABSOLUTE_POSE))
        return wrong;
    const int camera1 = wrongCamera(input.K1), camera2 = wrongCamera(input.K2);
    if (camera1 == 1 || camera2 == 1)
        return 1;
    if (wrongDistortion(input.d1) || wrongDistortion(input.d2))
        return 1;
    return camera1 == 0 && camera2 == 0 ? 0 : -1;
}

bool namesAnArgument(const std::string& message)
{
    static const Fields fields;
    static const char* const others[] = {"points1",    "points2",      "cameraMatrix",
                                         "distCoeffs", "objectPoints", "imagePoints"};
    std::vector<std::string> names = fields.names;
    names.insert(names.end(), others, others + sizeof(others) / sizeof(others[0]));
    for (size_t i = 0; i < names.size(); ++i)
        if (message.compare(0, names[i].size(), names[i]) == 0)
            return true;
    return false;
}

bool sameBits(const Mat& a, const Mat& b)
{
    if (a.empty() || b.empty())
        return a.empty() && b.empty();
    return a.size() == b.size() && a.type() == b.type() &&
           std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

template <class Point>
bool sameBits(const std::vector<Point>& a, const std::vector<Point>& b)
{
    return a.size() == b.size() &&
           (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

std::string brokenRepetition(const Answer& a, const Answer& b)
{
    const Report &r = a.report, &s = b.report;
    if (a.exception != b.exception)
        return "another exception the second time: " + b.exception;
    if (!sameBits(a.model, b.model) || !sameBits(a.mask, b.mask))
        return "another result the second time";
    const bool same = r.stop == s.stop && r.iterations == s.iterations && r.models == s.models &&
                      r.inliers == s.inliers && r.independentInliers == s.independentInliers &&
                      r.cost == s.cost && r.chance == s.chance && r.threshold == s.threshold &&
                      r.localOptimizations == s.localOptimizations;
    return same ? "" : "another report the second time: " + s.describe();
}

std::string brokenAnswer(const FuzzInput& input, const Answer& answer)
{
    const int wrong = wrongArguments(input);
    if (!answer.exception.empty())
        return wrong == 0 ? "refused without a reason: " + answer.exception
               : !namesAnArgument(answer.exception) ? "no argument is named: " + answer.exception
                                                    : "";
    return wrong == 1 ? "a wrong argument is not refused"
                      : brokenResult(input, answer.model, answer.mask, answer.report);
}

}  // namespace

std::string brokenContract(const FuzzInput& input)
{
    const std::vector<Point2d> before1 = input.points1, before2 = input.points2;
    const std::vector<Point3d> object = input.object, space2 = input.space2;
    const Mat K1 = input.K1.clone(), d1 = input.d1.clone(), K2 = input.K2.clone(),
              d2 = input.d2.clone();
    const Answer first = run(input, 1), second = run(input, input.otherThreads);
    if (!sameBits(before1, input.points1) || !sameBits(before2, input.points2) ||
        !sameBits(K1, input.K1) || !sameBits(K2, input.K2) || !sameBits(object, input.object) ||
        !sameBits(space2, input.space2) || !sameBits(d1, input.d1) || !sameBits(d2, input.d2))
        return "the input has changed";
    const std::string broken = brokenAnswer(input, first);
    return broken.empty() ? brokenRepetition(first, second) : broken;
}

}  // namespace opencv_test
