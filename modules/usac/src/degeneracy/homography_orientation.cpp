// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "degeneracy/degeneracy.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Twice the signed area of the triangle i, j, k.
double area(const double* x, const double* y, int i, int j, int k)
{
    return (x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i]);
}

/** Points of a plane seen by two cameras keep the orientation of all their triangles, or reverse that of all of them if
one image is mirrored: a sample in which some triangles turn over has no homography that a camera could see
@cite chum2004epipolar. A near-singular matrix maps the image to a line and is no model either. */
class HomographyOrientation : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* s) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        static const int triangles[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
        int same = 0;
        for (int t = 0; t < 4; ++t)
        {
            const int i = s[triangles[t][0]], j = s[triangles[t][1]], k = s[triangles[t][2]];
            same += area(p.dx1, p.dy1, i, j, k) * area(p.dx2, p.dy2, i, j, k) > 0;
        }
        return same == 0 || same == 4;
    }

    bool validModel(const Context&, const int*, const Model& model) const CV_OVERRIDE
    {
        const double size = norm(model);
        return std::abs(determinant(model)) > 1e-7 * size * size * size;
    }
};

} // namespace

Ptr<Degeneracy> createHomographyOrientation()
{
    return makePtr<HomographyOrientation>();
}

} // namespace usacv20
} // namespace cv
