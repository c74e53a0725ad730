// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AFFINITY_PARAMETERIZATION_HPP
#define OPENCV_USACV20_AFFINITY_PARAMETERIZATION_HPP

#include "residual/normal_equations.hpp"

namespace cv {
namespace usacv20 {

//! @brief An affine map and a parameterization around it: increments of the entries of the first
//! two rows. Zero parameters give the model itself.
class AffinityParameterization
{
public:
    enum { DIMENSION = 6, NUMBERS = 9, SMOOTH = 1 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! Around the model, scaled so that its last row is 0 0 1.
    explicit AffinityParameterization(const Model& model);

    static int dimension() { return DIMENSION; }
    //! False for a map of the plane to a line or a point.
    bool hasFullRank() const;
    //! Derivatives of the model, as a 9-vector row by row, with respect to the parameters.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the parameters.
    void project(const NormalEquations& sums, Matrix& A, Step& b) const;
    AffinityParameterization plus(const Step& step) const;
    Model model() const;

private:
    Step parameters;
};

}  // namespace usacv20
}  // namespace cv

#endif
