// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "lanes/lane_kernels.hpp"
#include "numeric/unit_norm.hpp"
#include "problems/homography/homography.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! H of unit norm is near-singular if the magnitude of its determinant is at most this value.
constexpr double SINGULAR = 1e-7;

/** Between two images of a plane, either all triangles of points keep their orientation, or, if one
image is mirrored, all triangles reverse it. If only some triangles of a sample reverse their
orientation, two cameras cannot produce the homography of this sample @cite chum2004epipolar. A
near-singular matrix, which nearly maps the image to a line, is rejected as well. */
class HomographyOrientation : public Degeneracy
{
public:
    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        bool valid = true;
        validSamples(context, &sample, 1, &valid);
        return valid;
    }

    void validSamples(const Context& context, const int* const* samples, int count,
                      bool* valid) const CV_OVERRIDE
    {
        lanes::kernelsFor(count).orientation(context.points, samples, count, valid);
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
