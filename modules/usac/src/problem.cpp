// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

Problem::~Problem() {}

bool Problem::ambiguous() const { return false; }
double Problem::toModelCoordinates(double*, double*, double*, double*, int) const { return 1; }
int Problem::normalization(int) const { return SCALE_NONE; }
Model Problem::closest(const Model& model) const { return model; }
void Problem::createDegeneracies(int, const Correspondences&, std::vector<Ptr<Degeneracy>>&) const {}

double Problem::outlierExtent(const Correspondences& points) const
{
    double side[4];
    for (int k = 0; k < 4; ++k)
        side[k] = std::max((double)points.upper[k] - points.lower[k], 0.0);
    const double second = std::sqrt(side[2] * side[3]);
    return errorDimension() > 1 ? second : std::sqrt(std::sqrt(side[0] * side[1]) * second);
}

double Problem::randomInlierRatio(const Correspondences& points) const
{
    const double t = points.threshold, width = points.upper[2] - points.lower[2],
                 height = points.upper[3] - points.lower[3];
    // Sampson's distance is that to the line in image 2 divided by sqrt(2), if the errors in both images are equal
    const double within = errorDimension() > 1 ? CV_PI * t * t
                                               : 2 * std::sqrt(2.) * t * std::sqrt(width * width + height * height);
    return within < width * height ? within / (width * height) : 1;
}

}  // namespace usacv20
}  // namespace cv
