// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/unit_norm.hpp"
#include "problems/homography/homography.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! H of unit norm is near-singular if the magnitude of its determinant is at most this value.
constexpr double SINGULAR = 1e-7;

//! Twice the signed areas of the four triangles of four points.
void areas(const double* x, const double* y, const int* s, double* area)
{
    double dx[3], dy[3];  // vectors from the last point to the others
    for (int k = 0; k < 3; ++k)
    {
        dx[k] = x[s[k]] - x[s[3]];
        dy[k] = y[s[k]] - y[s[3]];
    }
    area[0] = dx[1] * dy[2] - dx[2] * dy[1];
    area[1] = dx[0] * dy[2] - dx[2] * dy[0];
    area[2] = dx[0] * dy[1] - dx[1] * dy[0];
    area[3] = (dx[1] - dx[0]) * (dy[2] - dy[0]) - (dx[2] - dx[0]) * (dy[1] - dy[0]);
}

/** Between two images of a plane, either all triangles of points keep their orientation, or, if one
image is mirrored, all triangles reverse it. If only some triangles of a sample reverse their
orientation, two cameras cannot produce the homography of this sample @cite chum2004epipolar. A
near-singular matrix, which nearly maps the image to a line, is rejected as well. */
class HomographyOrientation : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* s) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        double area1[4], area2[4];
        areas(p.exact[X1], p.exact[Y1], s, area1);
        areas(p.exact[X2], p.exact[Y2], s, area2);
        int same = 0;
        for (int t = 0; t < 4; ++t)
            same += area1[t] * area2[t] > 0;
        return same == 0 || same == 4;
    }

    bool validModel(const Context&, const int*, const Model& model) const CV_OVERRIDE
    {
        const Matx33d H = model;
        const double size = frobeniusNorm(H);
        return std::abs(determinant(H)) > SINGULAR * size * size * size;
    }
};

}  // namespace

Ptr<Degeneracy> createHomographyOrientation() { return makePtr<HomographyOrientation>(); }

}  // namespace usacv20
}  // namespace cv
