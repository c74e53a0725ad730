// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The box that contains nearly all points of an array.
class Box
{
public:
    Box(const Correspondences& points, int array) : dimensions(points.coordinates[array])
    {
        const int first = array ? points.coordinates[0] : 0;
        for (int k = 0; k < dimensions; ++k)
            side[k] = std::max((double)points.upper[first + k] - points.lower[first + k], 0.0);
    }

    double volume() const
    {
        double product = 1;
        for (int k = 0; k < dimensions; ++k)
            product *= side[k];
        return product;
    }

    double meanSide() const
    {
        return dimensions == 2 ? std::sqrt(volume()) : std::pow(volume(), 1. / dimensions);
    }

    //! Upper bound of the length of a line or the area of a plane inside the box. `codimension` is
    //! the dimension of the box minus that of the line or plane. If the codimension equals the
    //! dimension of the box, the section is a point, and the result is 1.
    double largestSection(int codimension) const
    {
        double squares = 0;
        for (int k = 0; k < dimensions; ++k)
            squares += side[k] * side[k];
        return std::pow(std::sqrt(squares), dimensions - codimension);
    }

private:
    const int dimensions;
    double side[3];
};

}  // namespace

Problem::~Problem() {}

int Problem::coordinates(int) const { return 2; }
String Problem::arrayName(int array) const { return array ? "points2" : "points1"; }
bool Problem::commonUnit() const { return true; }
bool Problem::ambiguous() const { return false; }
bool Problem::leavesFree(const Context&, const Model&) const { return false; }
double Problem::toModelCoordinates(double* const*, int) const { return 1; }
String Problem::doubt(const double* const*, int) const { return String(); }
void Problem::toImageCoordinates(double* const*, int) const {}
Ptr<Residual> Problem::createImageResidual(const Ptr<Residual>&) const { return Ptr<Residual>(); }
int Problem::normalization(int) const { return SCALE_NONE; }
Ptr<Parameterization> Problem::createParameterization() const { return Ptr<Parameterization>(); }
Ptr<NonMinimalSolver> Problem::createNonMinimalSolver(const Ptr<Residual>& residual) const
{
    const Ptr<Parameterization> parameterization = createParameterization();
    if (!parameterization)
        return Ptr<NonMinimalSolver>();
    return createLeastSquares(residual, errorDimension(), parameterization);
}
Mat Problem::toOutput(const Model& model) const
{
    return Mat(model.rows, model.cols, CV_64F, (void*)model.val).clone();
}

bool Problem::fromOutput(const std::vector<double>&, const Correspondences&, Model&) const
{
    return false;
}
Model Problem::ofOutput(const Mat&) const { return Model(); }
Model Problem::closest(const Model& model) const { return model; }
void Problem::createDegeneracies(int, std::vector<Ptr<Degeneracy>>&) const {}

double Problem::outlierExtent(const Correspondences& points) const
{
    const Box last(points, points.coordinates[1] ? 1 : 0);
    if (errorDimension() > 1 || points.coordinates[1] == 0)
        return last.meanSide();
    return std::sqrt(Box(points, 0).meanSide() * last.meanSide());
}

double Problem::randomInlierRatio(const Correspondences& points) const
{
    const Box last(points, points.coordinates[1] ? 1 : 0);
    const double t = points.threshold;
    // factor sqrt(2): if the distances to the epipolar lines are equal in both images, the Sampson
    // distance is this distance divided by sqrt(2)
    const double around = errorDimension() == 3 ? 4 * CV_PI / 3 * t * t * t
                          : errorDimension() == 2
                              ? CV_PI * t * t
                              : 2 * (points.coordinates[1] ? std::sqrt(2.) : 1.) * t;
    const double within = around * last.largestSection(errorDimension()), whole = last.volume();
    return within < whole ? within / whole : 1;
}

}  // namespace usacv20
}  // namespace cv
