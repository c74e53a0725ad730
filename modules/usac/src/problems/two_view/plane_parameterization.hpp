// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PLANE_PARAMETERIZATION_HPP
#define OPENCV_USACV20_PLANE_PARAMETERIZATION_HPP

#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

/** @brief A map of the plane, as a 3x3 matrix with the last row (0, 0, 1), whose entries are affine
functions of its parameters. Maps near this map are parameterized by increments of its parameters;
zero increments give the map itself.

The class `Map` defines the parameters p:
- DIMENSION is the number of parameters;
- read(m, p) writes to p the parameters of the map that is nearest to a given matrix m (9 entries,
row by row);
- write(p, m) writes to m the first two rows of the matrix with the parameters p;
- isRegular(p) is false if the map with the parameters p maps the plane to a line or a point. */
template <class Map>
class PlaneParameterization
{
public:
    enum { DIMENSION = Map::DIMENSION, NUMBERS = 9, SMOOTH = 1 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! The parameterization around the map that is nearest to `model`, after the last entry of
    //! `model` has been scaled to 1.
    explicit PlaneParameterization(const Model& model)
    {
        Map::read(model.val, parameters.data());
        parameters /= model.val[8];
    }

    static int dimension() { return DIMENSION; }
    //! False if the plane is mapped to a line or a point.
    bool hasFullRank() const { return Map::isRegular(parameters.data()); }
    bool wellConditioned() const { return hasFullRank(); }

    //! Derivatives of the nine entries of the model (row by row) with respect to the parameters.
    Basis tangent() const
    {
        const Step zero = Step::Zero();
        double origin[6], moved[6];
        Map::write(zero.data(), origin);
        Basis basis = Basis::Zero();
        for (int k = 0; k < DIMENSION; ++k)
        {
            const Step unit = Step::Unit(k);
            Map::write(unit.data(), moved);
            for (int i = 0; i < 6; ++i)
                basis(i, k) = moved[i] - origin[i];
        }
        return basis;
    }

    //! Converts normal equations in the entries of the model to normal equations in the parameters.
    void project(const NormalEquations& sums, Matrix& A, Step& b) const
    {
        if (DIMENSION == 6)  // the parameters are the first six entries of the model
        {
            A = sums.JtJ.template topLeftCorner<DIMENSION, DIMENSION>();
            b = sums.Jtr.template head<DIMENSION>();
        }
        else
            projectOnTangents<DIMENSION>(sums, tangent(), A, b);
    }

    PlaneParameterization plus(const Step& step) const
    {
        PlaneParameterization result(*this);
        result.parameters += step;
        return result;
    }

    Model model() const
    {
        Matx33d map = Matx33d::eye();
        Map::write(parameters.data(), map.val);
        return map;
    }

private:
    Step parameters;
};

}  // namespace usacv20
}  // namespace cv

#endif
