// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"

#include <map>
#include "problems/registry.hpp"

namespace opencv_test {

namespace {

Ptr<Problem> problemObjectOf(int problem)
{
    return createProblem((ProblemType)problem, Matx33d::eye(), noArray(), noArray(), noArray());
}

}  // namespace

const char* nameOf(ProblemType problem)
{
    static std::map<int, String> names;
    return names.insert(std::make_pair((int)problem, problemObjectOf(problem)->name()))
        .first->second.c_str();
}

bool hasFlags(ProblemType problem)
{
    return std::find(std::begin(FLAG_PROBLEMS), std::end(FLAG_PROBLEMS), problem) !=
           std::end(FLAG_PROBLEMS);
}

int sampleSizeOf(int problem)
{
    return problemObjectOf(problem)->createMinimalSolver()->sampleSize();
}

Matx33d sceneCamera() { return makeScene(ESSENTIAL).K; }

Mat estimatePoints(ProblemType problem, InputArray points1, InputArray points2,
                   const Params& params, OutputArray mask, Report& report, InputArray K)
{
#define USACV20_IMAGES(NAME) estimate##NAME(points1, points2, params, mask, report)
#define USACV20_SPACES(NAME) estimate##NAME(points1, points2, params, mask, report)
#define USACV20_CAMERAS(NAME) estimate##NAME(points1, points2, K, params, mask, report)
#define USACV20_POSE(NAME) estimate##NAME(points1, points2, K, noArray(), params, mask, report)
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS)                                             \
    case TYPE: return USACV20_##ARGUMENTS(NAME);
    switch (problem)
    {
#include "problems/registry.inl.hpp"
    }
    return Mat();
}

bool sameBits(const Mat& a, const Mat& b)
{
    if (a.empty() || b.empty())
        return a.empty() && b.empty();
    const Mat x = a.clone(), y = b.clone();  // so that they are continuous
    return x.type() == y.type() && x.size() == y.size() &&
           std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0;
}

EstimatorCall callOf(const Scene& scene, const Params& params)
{
    EstimatorCall call;
    call.problem = scene.problem;
    call.points1 = scene.points1;
    call.points2 = scene.points2;
    call.params = params;
    if (scene.problem == ESSENTIAL)
        call.K1 = Mat(scene.K, true);
    return call;
}

void checkResult(ProblemType problem, const std::vector<Point2d>& points1,
                 const std::vector<Point2d>& points2, double pixels, const Mat& model,
                 const Mat& mask, const Report& report, const Matx33d& K, double widestReach)
{
    Scene scene;
    scene.problem = problem;
    scene.points1 = points1;
    scene.points2 = points2;
    scene.K = K;
    checkResult(scene, pixels, model, mask, report, widestReach);
}

void checkResult(const Scene& scene, double pixels, const Mat& model, const Mat& mask,
                 const Report& report, double widestReach)
{
    Params params;
    params.widestReach = widestReach;  // above 1, a correct model is allowed to have no inliers
    params.threshold = pixels;
    EXPECT_EQ("", brokenResult(callOf(scene, params), model, mask, report));
    if (scene.problem == HOMOGRAPHY && !model.empty())
    {
        Mat rows = model.clone();
        for (int i = 0; i < 3; ++i)
            rows.row(i) *= 1 / cvtest::norm(rows.row(i), NORM_INF);
        EXPECT_GT(std::abs(determinant(rows)),
                  0);  // the determinant of the model itself could underflow
    }
}

std::vector<NamedPreset> allPresets()
{
    const NamedPreset all[] = {
        {"usacV20", Params::usacV20()},     {"fast", Params::fast()},
        {"accurate", Params::accurate()},   {"sorted", Params::sorted()},
        {"parallel", Params::parallel()},   {"ransac", Params::ransac()},
        {"msac", Params::msac()},           {"lmeds", Params::lmeds()},
        {"mlesac", Params::mlesac()},       {"prosac", Params::prosac()},
        {"loRansac", Params::loRansac()},   {"floRansac", Params::floRansac()},
        {"gcRansac", Params::gcRansac()},   {"usac2013", Params::usac2013()},
        {"magsac", Params::magsac()},       {"magsacPlusPlus", Params::magsacPlusPlus()},
        {"automatic", Params::automatic()}, {"paper", Params::paper()}};
    return std::vector<NamedPreset>(all, all + sizeof(all) / sizeof(all[0]));
}

std::vector<NamedPreset> allPresets(ProblemType problem)
{
    std::vector<NamedPreset> all = allPresets();
    for (size_t i = 0; i < all.size(); ++i)
        if (problem != HOMOGRAPHY && problem != FUNDAMENTAL && problem != ESSENTIAL &&
            (all[i].name == std::string("usac2013") || all[i].name == std::string("paper")))
            all[i].params.degeneracy = DEGENERACY_REPEATED;
    return all;
}

namespace {

//! Calls OpenCV's function for the problem with a flag, for E also with a focal length instead of a
//! camera matrix. The results must equal those of the estimate function. Problems without flags are
//! skipped.
void checkFlag(UsacV20Method flag, ProblemType problem, InputArray points1, InputArray points2,
               const Params& params, const Matx33d& K, const Mat& model, const Mat& mask)
{
    if (!hasFlags(problem))
        return;
    Mat m, other;
    if (problem == HOMOGRAPHY)
        m = findHomography(points1, points2, flag, params.threshold, other, params.maxIterations,
                           params.confidence);
    else if (problem == FUNDAMENTAL)
        m = findFundamentalMat(points1, points2, flag, params.threshold, params.confidence,
                               params.maxIterations, other);
    else if (problem == AFFINITY)
        m = estimateAffine2D(points1, points2, other, flag, params.threshold, params.maxIterations,
                             params.confidence, params.polishingSteps);
    else if (problem == SIMILARITY)
        m = estimateAffinePartial2D(points1, points2, other, flag, params.threshold,
                                    params.maxIterations, params.confidence, params.polishingSteps);
    else
        m = findEssentialMat(points1, points2, K, flag, params.confidence, params.threshold,
                             params.maxIterations, other);
    EXPECT_TRUE(sameBits(model, m) && sameBits(mask, other)) << "flag " << (int)flag;
    if (problem == ESSENTIAL && K(0, 0) == K(1, 1) && K(0, 1) == 0)
    {
        m = findEssentialMat(points1, points2, K(0, 0), Point2d(K(0, 2), K(1, 2)), flag,
                             params.confidence, params.threshold, params.maxIterations, other);
        EXPECT_TRUE(sameBits(model, m) && sameBits(mask, other))
            << "flag " << (int)flag << ", focal length";
    }
}

}  // namespace

std::vector<Mat> checkEveryWay(ProblemType problem, const std::vector<Point2d>& points1,
                               const std::vector<Point2d>& points2, double pixels,
                               int maxIterations, const Matx33d& K)
{
    const std::vector<NamedPreset> presets = allPresets(problem);
    std::vector<Mat> models;
    for (size_t i = 0; i < presets.size(); ++i)
    {
        SCOPED_TRACE(cv::format("%s, preset %s", nameOf(problem), presets[i].name));
        Params params = presets[i].params;
        params.threshold = pixels;
        params.maxIterations = maxIterations;
        Mat mask, other;
        Report report;
        models.push_back(estimatePoints(problem, points1, points2, params, mask, report, K));
        const bool found = findsThreshold(params);
        checkResult(problem, points1, points2, found ? report.threshold : pixels, models[i], mask,
                    report, K, params.widestReach);
        EXPECT_TRUE(found || report.threshold == pixels) << report.threshold;
        EXPECT_TRUE(
            sameBits(models[i], Usac::create(problem, points1, points2, params, K)->run(other)));
        EXPECT_TRUE(sameBits(mask, other)) << "Usac::create";
        const UsacV20Method flags[] = {USACV20,        USACV20_FAST,   USACV20_ACCURATE,
                                       USACV20_PROSAC, USACV20_MAGSAC, USACV20_PARALLEL,
                                       USACV20_AUTO};
        const char* names[] = {"usacV20",        "fast",     "accurate", "sorted",
                               "magsacPlusPlus", "parallel", "automatic"};
        for (int f = 0; f < 7; ++f)
            if (std::string(names[f]) == presets[i].name)
                checkFlag(flags[f], problem, points1, points2, params, K, models[i], mask);
    }
    return models;
}

}  // namespace opencv_test
