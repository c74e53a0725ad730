// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/tails.hpp"
#include "termination/non_randomness.hpp"

namespace cv {
namespace usacv20 {

double chanceOf(int inliers, int n, int m, double randomRatio)
{
    if (inliers <= m)
        return 1;
    if (inliers > n || !(randomRatio > 0))
        return 0;
    return randomRatio < 1 ? binomialTail(inliers - m, n - m, randomRatio) : 1;
}

}  // namespace usacv20
}  // namespace cv
