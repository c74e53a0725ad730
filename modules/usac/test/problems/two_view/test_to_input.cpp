// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"

// Tests of Problem::toInput, which converts a model from the coordinates of the search to the
// caller's coordinates, and to the scale in which it is returned.

namespace opencv_test {
namespace {

//! Checks that Problem::toInput returns false: the model cannot be converted.
void expectNoModel(ProblemType problem, const Matx33d& model, const Correspondences& points)
{
    Model result;
    EXPECT_FALSE(problemObject(problem).toInput(model, points, result)) << (int)problem;
}

//! F and E are determined up to scale; they must be returned with unit norm. If the sum of the
//! squared entries is 0, infinite or NaN in double precision, a matrix cannot be scaled, so that it
//! is no model.
TEST(Usac_ToInput, epipolarGeometryHasUnitNorm)
{
    const Matx33d E(0, -1, 2, 1, 0, -3, -2, 3, 0);
    Matx33d undefined = E;
    undefined(1, 2) = NAN;
    const Correspondences points = OwnPoints(FUNDAMENTAL, {}, {}).view();
    for (ProblemType problem : {FUNDAMENTAL, ESSENTIAL})
    {
        for (double scale : {1e-100, 1., 1e100})
        {
            Model result;
            ASSERT_TRUE(problemObject(problem).toInput(E * scale, points, result));
            EXPECT_LE(cvtest::norm(Matx33d(result), E * (1 / cv::norm(E)), NORM_INF), 1e-15);
        }
        expectNoModel(problem, E * 0, points);
        expectNoModel(problem, E * 1e-200, points);
        expectNoModel(problem, E * 1e200, points);
        expectNoModel(problem, undefined, points);
    }
}

//! If the coordinates of both images are about 1e-100, entries of F in these coordinates are about
//! 1e200, so that their squares overflow; if the coordinates are about 1e100, the entries are about
//! 1e-200, so that their squares underflow to 0.
TEST(Usac_ToInput, fundamentalMatrixOutOfRange)
{
    for (double scale : {1e-100, 1e100})
    {
        Correspondences points = OwnPoints(FUNDAMENTAL, {}, {}).view();
        points.frame[0].scale = points.frame[1].scale = scale;
        expectNoModel(FUNDAMENTAL, Matx33d(1, 0, 0, 0, -1, 0, 0, 0, 0), points);
    }
}

//! In the caller's coordinates, entries of the linear part of an affine map can be too small for
//! double precision and become 0. The map must be returned if at least one of the four entries is
//! not 0. If all are 0, it would map all points to the same point, so that it is no model.
TEST(Usac_ToInput, oneLinearEntryMakesAMap)
{
    Correspondences points = OwnPoints(AFFINITY, {}, {}).view();
    points.frame[0].scale = 1e-200;
    for (ProblemType problem : {AFFINITY, SIMILARITY})
    {
        const int entries[] = {0, 1, 3, 4};
        for (int kept : entries)
        {
            Matx33d map(1e-200, 1e-200, 7, 1e-200, 1e-200, 8, 0, 0, 1);
            map.val[kept] = 1;
            Model result;
            ASSERT_TRUE(problemObject(problem).toInput(map, points, result)) << kept;
            for (int entry : entries)
                EXPECT_EQ(entry == kept ? 1e-200 : 0, result.val[entry]) << kept;
        }
        expectNoModel(problem, Matx33d(1e-200, 1e-200, 7, 1e-200, 1e-200, 8, 0, 0, 1), points);
    }
}

}  // namespace
}  // namespace opencv_test
