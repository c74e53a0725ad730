// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/selection.hpp"
#include "input/read_arrays.hpp"
#include "two_view/watermark.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! BORDER: width of the image border as a fraction of the diagonal. WATERMARK: fraction of the
//! inliers that must lie in the borders of both images and have nearly the same motion. The values
//! are those of COLMAP.
constexpr double BORDER = 0.1, WATERMARK = 0.7;

bool inBorder(const double* point, const Size& size)
{
    const double margin = BORDER * std::hypot((double)size.width, (double)size.height),
                 x = point[0], y = point[1];
    return x < margin || y < margin || x > size.width - margin || y > size.height - margin;
}

Vec2d medianOf(const std::vector<Vec2d>& motions)
{
    Vec2d result;
    std::vector<double> values(motions.size());
    for (int k = 0; k < 2; ++k)
    {
        for (size_t i = 0; i < motions.size(); ++i)
            values[i] = motions[i][k];
        result[k] = median(values.data(), (int)values.size());
    }
    return result;
}

}  // namespace

bool isWatermark(const TwoViewPair& pair, const Mat& mask, double reach)
{
    const Size &size1 = pair.imageSize1, &size2 = pair.imageSize2;
    if (size1.width <= 0 || size1.height <= 0 || size2.width <= 0 || size2.height <= 0)
        return false;
    Arena arena;
    Arena::Scope scope(arena);
    const Mat taken1 = readPoints(pair.taken1.empty() ? pair.points1 : pair.taken1, 2, "taken1",
                                  scope);
    const Mat taken2 = readPoints(pair.taken2.empty() ? pair.points2 : pair.taken2, 2, "taken2",
                                  scope);
    int inliers = 0;
    std::vector<Vec2d> motions;  // displacements of the inliers in the borders of both images
    for (int i = 0; i < mask.rows; ++i)
    {
        const double *p = taken1.ptr<double>(i), *q = taken2.ptr<double>(i);
        inliers += mask.at<uchar>(i) != 0;
        if (mask.at<uchar>(i) && inBorder(p, size1) && inBorder(q, size2))
            motions.push_back(Vec2d(q[0] - p[0], q[1] - p[1]));
    }
    if (motions.empty() || motions.size() < WATERMARK * inliers || !checkRange(motions))
        return false;
    const Vec2d common = medianOf(motions);
    int same = 0;
    for (const Vec2d& motion : motions)
        same += norm(motion - common) <= reach;
    return same >= WATERMARK * inliers;
}

}  // namespace usacv20
}  // namespace cv
