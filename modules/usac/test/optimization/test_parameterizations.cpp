// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "opencv2/usac/least_squares.hpp"
#include "optimization/any_parameterization.hpp"
#include "support/problem_objects.hpp"
#include "problems/registry.hpp"

namespace opencv_test {
namespace {

typedef cv::usacv20::Parameterization Rule;

//! Calls `test` for each problem with random matrices, from which the parameterization makes valid
//! models.
void forEachProblem(const std::function<void(const Problem&, const Model&)>& test)
{
    const Matx33d K(1.2, 0, 0.1, 0, 1.3, -0.2, 0, 0, 1);
    RNG rng(3);
    for (int type : ALL_PROBLEMS)
        for (int repeat = 0; repeat < 5; ++repeat)
        {
            const Ptr<Problem> problem = createProblem((ProblemType)type, K, noArray(), noArray(),
                                                       noArray());
            const bool space = problem->coordinates(0) == 3;
            Model model(3, space ? 4 : 3);
            for (int i = 0; i < model.size(); ++i)
                model.val[i] = rng.uniform(-1., 1.) + (i % (model.cols + 1) == 0);
            test(*problem, model);
        }
}

TEST(Usac_Parameterization, builtInOnesFulfillTheLaws)
{
    forEachProblem([](const Problem& problem, const Model& model) {
        const Ptr<Rule> rule = problem.createParameterization();
        ASSERT_TRUE(rule);
        EXPECT_EQ(problem.dimension(), rule->dimension());
        EXPECT_EQ("", checkParameterization(*rule, model)) << problem.name();
    });
}

//! A circle of radius 2 around the origin. `fault` selects an error that checkParameterization()
//! must find.
class Circle : public Rule
{
public:
    enum Fault {
        NONE,
        TOO_MANY,
        OFF,
        LEAVES,
        WRONG_SIGN,
        NO_TANGENT,
        DEPENDENT,
        OTHER_SHAPE,
        TOO_FEW,
        BEHIND
    };

    explicit Circle(int fault_) : fault(fault_) {}

    int dimension() const CV_OVERRIDE { return fault == TOO_MANY ? 3 : fault == DEPENDENT ? 2 : 1; }

    bool tangent(const Model& model, double* basis) const CV_OVERRIDE
    {
        const double angle = angleOf(model), sign = fault == WRONG_SIGN ? -1 : 1;
        const Vec2d derivative(-2 * std::sin(angle), 2 * std::cos(angle) * sign);
        for (int row = 0; row < 2; ++row)
            for (int col = 0; col < dimension(); ++col)
                basis[row * dimension() + col] = derivative[row];
        if (fault == BEHIND)  // as if there were two columns
            basis[2] = basis[3] = 0;
        return fault != NO_TANGENT;
    }

    Model plus(const Model& model, const double* x) const CV_OVERRIDE
    {
        const double change = fault == DEPENDENT || fault == TOO_FEW ? x[0] + x[1] : x[0],
                     angle = angleOf(model) + change + (fault == OFF ? 0.1 : 0),
                     radius = fault == LEAVES ? 2 + x[0] * x[0] : 2;
        Model result(fault == OTHER_SHAPE ? 1 : 2, fault == OTHER_SHAPE ? 2 : 1);
        result.val[0] = radius * std::cos(angle);
        result.val[1] = radius * std::sin(angle);
        return result;
    }

private:
    static double angleOf(const Model& model) { return std::atan2(model.val[1], model.val[0]); }

    const int fault;
};

TEST(Usac_Parameterization, faultsAreFound)
{
    const char* const words[] = {"",
                                 "dimension: 3, the model has 2 entries",
                                 "plus: zero parameters change the model",
                                 "plus: the result is not valid",
                                 "tangent: column 0 is not the derivative of plus()",
                                 "tangent: the model is degenerate",
                                 "tangent: the columns are linearly dependent",
                                 "plus: a model of 2 x 1 entries has become one of 1 x 2",
                                 "dimension: 1, but plus() uses more parameters",
                                 "tangent: 2 x 1 numbers are expected"};
    Model model(2, 1);
    model.val[0] = 1.5;
    model.val[1] = 1;
    for (int fault = Circle::NONE; fault <= Circle::BEHIND; ++fault)
    {
        const String found = checkParameterization(Circle(fault), model);
        EXPECT_EQ(0u, found.find(words[fault])) << fault << ": " << found;
        EXPECT_EQ(words[fault][0] == 0, found.empty()) << fault << ": " << found;
    }
}

//! Parameterization::smooth is true by default. The result of callerBasis(), which is the basis of
//! the parameters of Report::covariance, must then be the columns of tangent() themselves, not an
//! orthonormal basis. For a degenerate model, callerBasis() must return false.
TEST(Usac_Parameterization, tangentsOfTheCaller)
{
    Model model(2, 1);
    model.val[0] = 1.2;
    model.val[1] = 1.6;
    AnyParameterization::Basis basis;
    EXPECT_TRUE(Circle(Circle::NONE).smooth());
    ASSERT_TRUE(callerBasis(Circle(Circle::NONE), model, basis));
    ASSERT_EQ(2, basis.rows());
    ASSERT_EQ(1, basis.cols());
    EXPECT_NEAR(-1.6, basis(0, 0), 1e-12);
    EXPECT_NEAR(1.2, basis(1, 0), 1e-12);
    EXPECT_FALSE(callerBasis(Circle(Circle::NO_TANGENT), model, basis));
}

//! The solver for parameterizations of any size must find the same minimum as the solver whose
//! sizes are known at compile time.
TEST(Usac_Parameterization, sameMinimumAsTheBuiltInFit)
{
    const ProblemType problems[] = {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL};
    for (ProblemType type : problems)
    {
        SceneOptions options;
        options.outliers = 0;
        options.noise = 1;
        const Scene scene = makeScene(type, options);
        const Ptr<Usac> usac = createUsac(scene, Params());
        const Correspondences& points = usac->points();
        std::vector<int> all(points.size);
        std::vector<double> weights(points.size);
        RNG rng(2);
        for (int i = 0; i < points.size; ++i)
        {
            all[i] = i;
            weights[i] = rng.uniform(0.5, 2.);
        }
        const Ptr<Residual> residual = usac->components().residual;
        const Ptr<NonMinimalSolver> fits[] = {
            usac->components().nonMinimalSolver,
            createLeastSquares(residual, points.problem->errorDimension(),
                               points.problem->createParameterization())};
        Model models[2];
        for (int k = 0; k < 2; ++k)
        {
            models[k] = toInternal(points, scene.model);
            ASSERT_TRUE(
                fits[k]->fit(points, all.data(), points.size, weights.data(), models[k], 50));
            EXPECT_NE(models[k], toInternal(points, scene.model));
        }
        const double sign = models[0].val[0] * models[1].val[0] > 0 ? 1 : -1;
        for (int i = 0; i < 9; ++i)
            EXPECT_NEAR(models[0].val[i], sign * models[1].val[i], 1e-8) << (int)type;
        EXPECT_FALSE(fits[1]->fit(points, all.data(), 3 - (type == HOMOGRAPHY), 0, models[1], 5));
    }
}

}  // namespace
}  // namespace opencv_test
