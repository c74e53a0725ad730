// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

#include "opencv2/core/optim.hpp"

namespace opencv_test {
namespace {

//! Sum of the squared errors of all points as a function of a step on the manifold from a model.
class SumOfSquares : public MinProblemSolver::Function
{
public:
    SumOfSquares(const Correspondences& points_, const Residual& residual_, const Model& model)
        : points(points_), residual(residual_), here(points.problem, model), errors(points.size)
    {}

    int getDims() const CV_OVERRIDE { return here.dimension(); }

    double calc(const double* x) const CV_OVERRIDE
    {
        Parameterization::Step step(here.dimension());
        for (int i = 0; i < here.dimension(); ++i)
            step[i] = x[i];
        residual.squaredErrors(here.plus(step).model(), points.exact, points.size, errors.data());
        double sum = 0;
        for (size_t i = 0; i < errors.size(); ++i)
            sum += errors[i];
        return sum;
    }

private:
    const Correspondences& points;
    const Residual& residual;
    const Parameterization here;
    mutable std::vector<double> errors;
};

//! The test parameters are a problem and a residual.
typedef testing::TestWithParam<std::tuple<int, int>> Usac_LeastSquares_Minimum;

//! The method of Nelder and Mead, which needs no derivatives, must find no clearly smaller sum near
//! the result of the fit. From a start near this result, the method must reach about the same sum.
TEST_P(Usac_LeastSquares_Minimum, isThatOfAGenericOptimizer)
{
    for (uint64 seed = 1; seed <= 3; ++seed)
    {
        SceneOptions options;
        options.inliers = 40;
        options.outliers = 0;
        options.noise = 1;
        options.seed = seed;
        const Scene scene = makeScene((ProblemType)std::get<0>(GetParam()), options);
        Params params;
        params.residual = (ResidualType)std::get<1>(GetParam());
        const Ptr<Usac> usac = createUsac(scene, params);
        const Correspondences& points = usac->points();
        const Components& parts = usac->components();
        std::vector<int> all(points.size);
        for (int i = 0; i < points.size; ++i)
            all[i] = i;
        Model model = toInternal(points, scene.model);
        ASSERT_TRUE(parts.nonMinimalSolver->fit(points, all.data(), points.size, 0, model, 50));

        const Ptr<SumOfSquares> sum = makePtr<SumOfSquares>(points, *parts.residual, model);
        Mat x = Mat::zeros(1, sum->getDims(), CV_64F);
        const double reached = sum->calc(x.ptr<double>());
        for (int start = 0; start < 2; ++start)
        {
            x = start == 0 ? 0. : 1e-4;  // at the minimum, and near it
            const Mat step(1, sum->getDims(), CV_64F, Scalar(1e-4));
            const double generic = DownhillSolver::create(
                                       sum, step,
                                       TermCriteria(TermCriteria::COUNT + TermCriteria::EPS, 20000,
                                                    1e-16))
                                       ->minimize(x);
            EXPECT_GE(generic, reached * (1 - 1e-3)) << "seed " << seed;
            EXPECT_LE(generic, reached * (1 + 1e-2))
                << "the generic optimizer did not converge, seed " << seed;
        }
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_LeastSquares_Minimum,
                        testing::Combine(testing::Range(0, 3), testing::Range(0, 2)));

}  // namespace
}  // namespace opencv_test
