// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/seen_points.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Tangent of 80 degrees, squared.
constexpr double ASIDE_SQUARED = 32.16;
/** Distance of the principal point from a corner of the box, as a fraction of the sides. With 0.1,
no camera of 120 pairs of photographs is at the same corner in both images, also with few matches;
if only the matches of a window with 0.1 to 0.6 of the sides of image 1 are used, 0.6 % are. With
the camera matrix of images twice as large, 84 % are. With 0.2, these are 3.6 % and 90 %. */
constexpr double AT_CORNER = 0.1;

}  // namespace

const char* const SeenPoints::ASIDE = "most points are more than 80 degrees off the axis of the "
                                      "camera: is the camera matrix in pixels?";

SeenPoints::SeenPoints(const double* x, const double* y, int count)
{
    double low[2] = {DBL_MAX, DBL_MAX}, high[2] = {-DBL_MAX, -DBL_MAX};
    int beyond = 0;
    for (int i = 0; i < count; ++i)
    {
        beyond += x[i] * x[i] + y[i] * y[i] > ASIDE_SQUARED;
        low[0] = std::min(low[0], x[i]);  // NaN changes nothing
        low[1] = std::min(low[1], y[i]);
        high[0] = std::max(high[0], x[i]);
        high[1] = std::max(high[1], y[i]);
    }
    aside = 2 * beyond > count;
    int end[2];
    for (int k = 0; k < 2; ++k)
    {
        const double most = AT_CORNER * (high[k] - low[k]);
        end[k] = std::abs(low[k]) < most ? 1 : std::abs(high[k]) < most ? 2 : 0;
    }
    corner = end[0] && end[1] ? 2 * end[0] + end[1] - 2 : 0;
}

}  // namespace usacv20
}  // namespace cv
