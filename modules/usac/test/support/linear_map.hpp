// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_LINEAR_MAP_HPP
#define OPENCV_USACV20_TEST_LINEAR_MAP_HPP

#include "test_precomp.hpp"

namespace opencv_test {

//! The affinity or similarity that minimizes the (weighted) sum of squared distances in image 2, as
//! the least-squares solution of linear equations.
inline Matx23d linearMap(ProblemType problem, const std::vector<Point2d>& points1,
                         const std::vector<Point2d>& points2,
                         const std::vector<double>& weights = std::vector<double>())
{
    const bool affine = problem == AFFINITY;
    const int count = (int)points1.size();
    Mat design(2 * count, affine ? 6 : 4, CV_64F), target(2 * count, 1, CV_64F), solution;
    for (int i = 0; i < count; ++i)
    {
        const double s = weights.empty() ? 1 : std::sqrt(weights[i]), x = points1[i].x * s,
                     y = points1[i].y * s;
        const double rows[2][2][6] = {{{x, -y, s, 0}, {y, x, 0, s}},
                                      {{x, y, s, 0, 0, 0}, {0, 0, 0, x, y, s}}};
        for (int row = 0; row < 2; ++row)
        {
            std::copy(rows[affine][row], rows[affine][row] + design.cols,
                      design.ptr<double>(2 * i + row));
            target.at<double>(2 * i + row) = (row ? points2[i].y : points2[i].x) * s;
        }
    }
    cv::solve(design, target, solution, DECOMP_QR);
    const double* const s = solution.ptr<double>();
    return affine ? Matx23d(s) : Matx23d(s[0], -s[1], s[2], s[1], s[0], s[3]);
}

}  // namespace opencv_test

#endif
