// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

// Tests of least squares at the limits of the range of double, and at a minimum.

namespace opencv_test {
namespace {

//! Matches of a similarity with some noise.
struct Matches
{
    Matches()
    {
        RNG rng(2);
        for (int i = 0; i < 12; ++i)
        {
            points1.push_back(uniformPoint(rng, -1., 1.));
            points2.push_back(0.8 * points1.back() + gaussianPoint(rng, 0.05));
            indices.push_back(i);
        }
    }

    bool fit(Model& model, const double* weights = 0, int iterations = 10) const
    {
        const OwnPoints points(HOMOGRAPHY, points1, points2);
        return createLeastSquaresSolver(HOMOGRAPHY, Formula::TRANSFER)
            ->fit(points.view(), indices.data(), (int)indices.size(), weights, model, iterations);
    }

    std::vector<Point2d> points1, points2;
    std::vector<int> indices;
};

//! If errors, or only their derivatives, leave the range of double, the fit must fail and leave the
//! model unchanged.
TEST(Usac_LeastSquares_Limits, largeErrorsLeaveTheModel)
{
    const double denominators[] = {0, 1e-170, 1e-150};
    for (int i = 0; i < 3; ++i)
    {
        const Model before = Matx33d(1, 0, 0, 0, 1, 0, 0, 0, denominators[i]);
        Model model = before;
        EXPECT_FALSE(Matches().fit(model)) << denominators[i];
        EXPECT_EQ(before, model) << denominators[i];
    }
}

//! If all weights are the smallest positive number, rounding makes the normal equations singular.
//! The fit must fail and leave the model unchanged.
TEST(Usac_LeastSquares_Limits, smallWeightsLeaveTheModel)
{
    const std::vector<double> weights(12, std::numeric_limits<double>::denorm_min());
    const Model before = Matx33d(0.1, 0, 3, 0, 0.1, 3, 0, 0, 1);
    Model model = before;
    EXPECT_FALSE(Matches().fit(model, weights.data()));
    EXPECT_EQ(before, model);
}

}  // namespace
}  // namespace opencv_test
