// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace opencv_test {
namespace {

//! The density of outliers follows from the extent of the points. The extent in one image is the
//! geometric mean of the sides of their bounding box. For H, that in image 2 is used; for F, the
//! geometric mean of the extents in both images.
TEST(Usac_Statistics, outlierExtent)
{
    std::vector<Point2d> points1, points2;
    for (int i = 0; i < 2; ++i)
    {
        points1.push_back(Point2d(10 * i, 40 * i));
        points2.push_back(Point2d(5 + 100 * i, -400 * i));
    }
    const OwnPoints H(HOMOGRAPHY, points1, points2), F(FUNDAMENTAL, points1, points2);
    EXPECT_NEAR(200, H.view().problem->outlierExtent(H.view()), 1e-6);
    EXPECT_NEAR(std::sqrt(20. * 200.), F.view().problem->outlierExtent(F.view()), 1e-6);
    const OwnPoints line(HOMOGRAPHY, points1, std::vector<Point2d>(2));
    EXPECT_EQ(0, line.view().problem->outlierExtent(line.view()));
    EXPECT_NEAR(std::log(200 / (std::sqrt(2 * CV_PI) * 0.5)), logDensityRatio(200, 0.5, 2), 1e-12);
    // if the extent is 0, an error at the threshold is equally likely for inliers and outliers
    for (int degrees = 1; degrees <= 2; ++degrees)
    {
        const double k = thresholdInSigmas(degrees);
        EXPECT_NEAR(1, std::exp(degrees * logDensityRatio(0, 0.5, degrees) - k * k / 2), 1e-12);
    }
}

}
}  // namespace
