// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "problems/registry.hpp"
#include "significance/model_cases.hpp"
#include "support/contracts.hpp"
#include "../../../../samples/affine_problem.hpp"

// Tests of checkProblem() and of the normalizations that a program's own problem can have.

namespace opencv_test {
namespace {

//! What is wrong with a LineProblem.
enum Fault {
    NO_FAULT,
    DIMENSION,
    NORMALIZATION,
    LONG_SAMPLE,
    MANY_MODELS,
    NO_MODELS,
    OTHER_MODEL,
    NOT_SQUARED,
    ERROR_DIMENSION,
    CHANGES_MODEL,
    DOUBLE_BEHIND,
    SINGLE_BEHIND,
    SINGLE_NOT_SQUARED,
    ERROR_BEHIND,
    OTHER_ERROR,
    DERIVATIVE_BEHIND,
    LINEARIZED_ERROR,
    DERIVATIVE,
    NOT_HOMOGENEOUS,
    FEW_PARAMETERS,
    WRONG_TANGENT,
    MIRRORED,
    NOT_FINITE,
    NO_SCALE,
    FLOAT_OUTPUT,
    FROM_OUTPUT,
    OF_OUTPUT,
    FAULTS
};

//! The beginning of what checkProblem() returns for each fault.
const char* const MESSAGES[FAULTS] = {"",
                                      "dimension: it is 1, but that of createParameterization() is",
                                      "normalization: 7 is not",
                                      "createMinimalSolver: samples of 1 to 8 points",
                                      "createMinimalSolver: solve() has to fill at most",
                                      "createMinimalSolver: solve() has found no model",
                                      "createMinimalSolver: points have errors",
                                      "squaredErrors: near a model, they do not grow",
                                      "errorDimension: it is not the number",
                                      "closest: it changes the errors",
                                      "squaredErrors: in double precision, it has to write",
                                      "squaredErrors: in single precision, it has to write",
                                      "squaredErrors: the versions in single and double",
                                      "error: it has to return",
                                      "error: its squared length",
                                      "linearize: it has to write",
                                      "linearize: its error",
                                      "linearize: its derivative",
                                      "homogeneous: it is true",
                                      "createParameterization: dimension: 1, but plus() uses more",
                                      "createParameterization: tangent: column 0 is not",
                                      "createParameterization: plus() with parameters 0",
                                      "toInput: it has to return true",
                                      "toInput: the errors",
                                      "toOutput: it has to return",
                                      "fromOutput: it changes",
                                      "ofOutput: it changes"};

class LineDistance : public Residual
{
public:
    explicit LineDistance(int fault_) : fault(fault_) {}

    void squaredErrors(const Correspondences& p, const Model& line, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        for (int i = begin; i < end; ++i)
        {
            const double d = distance(line, p.column[0][i], p.column[1][i]);
            errors[fault == SINGLE_BEHIND ? i : i - begin] = (float)(fault == SINGLE_NOT_SQUARED
                                                                         ? std::abs(d)
                                                                         : square(d));
        }
    }

    void squaredErrors(const Model& line, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
            errors[i] = square(distance(line, c[0][i], c[1][i]));
        if (fault == DOUBLE_BEHIND && count > 1)
            errors[count] = 0;
    }

    int error(const Model& line, const double* point, double* out) const CV_OVERRIDE
    {
        out[0] = distance(line, point[0], point[1]) * (fault == OTHER_ERROR ? 2 : 1);
        if (fault == NOT_SQUARED)
            out[0] = std::sqrt(std::abs(out[0]));
        if (fault == ERROR_BEHIND)
            out[1] = 0;
        return 1;
    }

    int linearize(const Model& line, const double* point, double* out,
                  double* derivative) const CV_OVERRIDE
    {
        if (fault == NOT_SQUARED || fault == NOT_HOMOGENEOUS)
            return Residual::linearize(line, point, out, derivative);
        const double length = std::hypot(line.val[0], line.val[1]);
        error(line, point, out);
        for (int k = 0; k < 2; ++k)
            derivative[k] = (point[k] - out[0] * line.val[k] / length) / length;
        derivative[2] = (fault == DERIVATIVE ? -1 : 1) / length;
        if (fault == LINEARIZED_ERROR)
            out[0] *= -1;
        if (fault == DERIVATIVE_BEHIND)
            derivative[3] = 0;
        return 1;
    }

private:
    double square(double d) const { return fault == NOT_SQUARED ? std::abs(d) : d * d; }
    double distance(const Model& line, double x, double y) const
    {
        const double* const v = line.val;
        const double length = fault == NOT_HOMOGENEOUS ? 1 : std::hypot(v[0], v[1]);
        return (v[0] * x + v[1] * y + v[2]) / length;
    }

    const int fault;
};

class LineSolver : public MinimalSolver
{
public:
    explicit LineSolver(int fault_) : fault(fault_) {}
    int sampleSize() const CV_OVERRIDE { return fault == LONG_SAMPLE ? 9 : 2; }
    int solve(const Correspondences& p, const int* sample, Model* models) const CV_OVERRIDE
    {
        const double *const x = p.exact[0], *const y = p.exact[1];
        const int a = sample[0], b = sample[1];
        const double length = std::hypot(x[b] - x[a], y[b] - y[a]);
        const Vec2d n((y[b] - y[a]) / length, (x[a] - x[b]) / length);
        const double shift = fault == OTHER_MODEL ? 0.1 : 0;
        models[0] = Matx13d(n[0], n[1], shift - n[0] * x[a] - n[1] * y[a]);
        if (fault == MANY_MODELS)
            std::fill(models + 1, models + MAX_MODELS + 1, models[0]);
        return fault == NO_MODELS ? 0 : fault == MANY_MODELS ? MAX_MODELS + 1 : length > 0;
    }

private:
    const int fault;
};

//! Lines with a normal of unit length; the parameters turn the normal and move the line.
class Lines : public cv::usacv20::Parameterization
{
public:
    explicit Lines(int fault_) : fault(fault_) {}
    int dimension() const CV_OVERRIDE { return fault == FEW_PARAMETERS ? 1 : 2; }

    bool tangent(const Model& line, double* basis) const CV_OVERRIDE
    {
        const Matx<double, 3, 2> columns((fault == WRONG_TANGENT ? 1 : -1) * line.val[1], 0,
                                         line.val[0], 0, 0, 1);
        std::copy(columns.val, columns.val + 6, basis);
        return true;
    }

    Model plus(const Model& line, const double* x) const CV_OVERRIDE
    {
        const double a = fault == MIRRORED ? std::abs(line.val[0]) : line.val[0],
                     angle = std::atan2(line.val[1], a) + x[0];
        const double offset = line.val[2] / std::hypot(line.val[0], line.val[1]);
        return Matx13d(std::cos(angle), std::sin(angle), offset + x[1]);
    }

private:
    const int fault;
};

//! A line through points of the plane, with one array of points.
class LineProblem : public Problem
{
public:
    explicit LineProblem(int fault_, int normalization = SCALE_EACH)
        : fault(fault_), scaling(fault == NORMALIZATION ? 7 : normalization)
    {}

    String name() const CV_OVERRIDE { return "line"; }
    int dimension() const CV_OVERRIDE
    {
        return fault == DIMENSION || fault == FEW_PARAMETERS ? 1 : 2;
    }
    int errorDimension() const CV_OVERRIDE { return fault == ERROR_DIMENSION ? 2 : 1; }
    int coordinates(int array) const CV_OVERRIDE { return array ? 0 : 2; }
    SampleCost sampleCost() const CV_OVERRIDE { return SampleCost(20, 1); }
    int normalization(int) const CV_OVERRIDE { return scaling; }

    bool toInput(const Model& model, const Correspondences& points, Model& result) const CV_OVERRIDE
    {
        const Frame& frame = points.frame[0];
        const double* const v = model.val;
        result = Matx13d(v[0], v[1],
                         v[2] / (fault == NO_SCALE ? 1 : frame.scale) - v[0] * frame.center[0] -
                             v[1] * frame.center[1]);
        return fault != NOT_FINITE && checkRange(Mat(1, 3, CV_64F, result.val));
    }

    Mat toOutput(const Model& model) const CV_OVERRIDE
    {
        Mat output = Problem::toOutput(model);
        if (fault == FLOAT_OUTPUT)
            output.convertTo(output, CV_32F);
        return output;
    }

    bool fromOutput(const std::vector<double>& v, const Correspondences& points,
                    Model& model) const CV_OVERRIDE
    {
        const Frame& frame = points.frame[0];
        const double c = v[2] + v[0] * frame.center[0] + v[1] * frame.center[1];
        model = Matx13d(v[0], v[1], c * (fault == FROM_OUTPUT ? 1 : frame.scale));
        return true;
    }

    Model ofOutput(const Mat& output) const CV_OVERRIDE
    {
        const double* const v = output.ptr<double>();
        return Matx13d(v[0], v[1], fault == OF_OUTPUT ? -v[2] : v[2]);
    }

    Model closest(const Model& model) const CV_OVERRIDE
    {
        const double* const v = model.val;
        return fault == CHANGES_MODEL ? Model(Matx13d(v[1], v[0], v[2])) : model;
    }

    Ptr<Residual> createResidual(int) const CV_OVERRIDE { return makePtr<LineDistance>(fault); }
    Ptr<MinimalSolver> createMinimalSolver() const CV_OVERRIDE
    {
        return makePtr<LineSolver>(fault);
    }
    Ptr<cv::usacv20::Parameterization> createParameterization() const CV_OVERRIDE
    {
        return makePtr<Lines>(fault);
    }

private:
    const int fault, scaling;
};

//! 60 points near a line, then 30 elsewhere, in a box that is far from the origin.
std::vector<Point2d> pointsOfLine()
{
    RNG rng(3);
    std::vector<Point2d> points;
    for (int i = 0; i < 90; ++i)
    {
        const double x = rng.uniform(300., 900.);
        points.push_back(
            Point2d(x, i < 60 ? 0.5 * x + 100 + rng.gaussian(1) : rng.uniform(200., 600.)));
    }
    return points;
}

TEST(Usac_CheckProblem, faultsAreFound)
{
    for (int fault = 0; fault < FAULTS; ++fault)
    {
        const String found = checkProblem(makePtr<LineProblem>(fault), pointsOfLine());
        EXPECT_EQ(0u, found.find(MESSAGES[fault])) << fault << ": " << found;
        EXPECT_EQ(fault == NO_FAULT, found.empty()) << fault << ": " << found;
    }
}

TEST(Usac_CheckProblem, wrongArguments)
{
    const Ptr<Problem> line = makePtr<LineProblem>(NO_FAULT);
    const std::vector<Point2d> points = pointsOfLine(), one(1);
    expectException([&]() { checkProblem(Ptr<Problem>(), points); }, "problem: it is empty");
    expectException([&]() { checkProblem(line, one); }, "points1: at least 2");
    expectException([&]() { checkProblem(line, points, points); }, "points2: ");
    for (int fault : {DIMENSION, NORMALIZATION, LONG_SAMPLE})
        expectException([&]() { Usac::create(makePtr<LineProblem>(fault), points, noArray()); },
                        String("problem line: ") + MESSAGES[fault]);
}

//! All built-in problems, for points with wrong matches.
TEST(Usac_CheckProblem, builtInProblems)
{
    for (int problem : ALL_PROBLEMS)
        for (int seed = 1; seed <= 5; ++seed)
        {
            const Case scene = makeCase(
                problem == TRANSLATION_2D ? SIMILARITY : (ProblemType)problem, seed);
            EXPECT_EQ("", checkProblem(createProblem((ProblemType)problem, scene.camera, noArray(),
                                                     noArray(), noArray()),
                                       scene.points1, scene.points2))
                << problem << " " << seed;
        }
}

//! The affine map of samples/custom_problem.cpp with any normalization.
class ScaledAffineProblem : public custom::AffineProblem
{
public:
    explicit ScaledAffineProblem(int normalization) : scaling(normalization) {}
    int normalization(int) const CV_OVERRIDE { return scaling; }

private:
    const int scaling;
};

//! Problems with one and with two arrays of points must find the same inliers with each
//! normalization.
TEST(Usac_CheckProblem, normalizations)
{
    const std::vector<Point2d> line = pointsOfLine();
    std::vector<Point2d> mapped;
    RNG rng(5);
    for (size_t i = 0; i < line.size(); ++i)
        mapped.push_back(i < 60 ? Point2d(3 * line[i].x + line[i].y - 200, 2 * line[i].y) +
                                      gaussianPoint(rng, 1)
                                : uniformPoint(rng, 0., 3000., 0., 1000.));
    std::vector<Point2d> spread = line;
    for (size_t i = 0; i < line.size(); ++i)
    {
        const Point2d shift(0, rng.uniform(-200., 200.));
        spread[i] += shift;
        mapped[i] += i < 60 ? Point2d(shift.y, 2 * shift.y) : Point2d();
    }
    Params params;
    params.threshold = 4;
    for (int normalization = SCALE_NONE; normalization <= SCALE_FIRST; ++normalization)
    {
        SCOPED_TRACE(normalization);
        const Ptr<Problem> one = makePtr<LineProblem>(NO_FAULT, normalization),
                           two = makePtr<ScaledAffineProblem>(normalization);
        EXPECT_EQ("", checkProblem(one, line));
        EXPECT_EQ("", checkProblem(two, spread, mapped));
        for (int arrays = 1; arrays <= 2; ++arrays)
        {
            Mat mask;
            const Ptr<Usac> usac = arrays == 1 ? Usac::create(one, line, noArray(), params)
                                               : Usac::create(two, spread, mapped, params);
            EXPECT_FALSE(usac->run(mask).empty());
            EXPECT_GE(countNonZero(mask.rowRange(0, 60)), 58) << arrays;
        }
    }
}

}  // namespace
}  // namespace opencv_test
