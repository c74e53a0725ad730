// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_HOMOGRAPHY_PARAMETERIZATION_HPP
#define OPENCV_USACV20_HOMOGRAPHY_PARAMETERIZATION_HPP

#include "residual/normal_equations.hpp"

namespace cv {
namespace usacv20 {

/** @brief A homography, as a unit 9-vector, and a minimal parameterization around it. The
parameters are the components of a step along 8 directions orthogonal to this vector. Zero
parameters give the homography itself. */
class HomographyParameterization
{
public:
    enum { DIMENSION = 8, NUMBERS = 9, SMOOTH = 1 };
    typedef Eigen::Matrix<double, 9, DIMENSION> Basis;
    typedef Eigen::Matrix<double, DIMENSION, 1> Step;
    typedef Eigen::Matrix<double, DIMENSION, DIMENSION> Matrix;

    //! The parameterization around `model`, which is scaled to unit norm.
    explicit HomographyParameterization(const Model& model);

    static int dimension() { return DIMENSION; }
    //! False if H maps the plane to a line or a point, up to rounding.
    bool hasFullRank() const;
    //! False if H nearly maps the plane to a line or a point. Only for the normalized coordinates
    //! of Correspondences, because the limit depends on the unit of length.
    bool wellConditioned() const;
    //! Derivatives of the model, as a 9-vector row by row, with respect to the parameters at 0.
    Basis tangent() const;
    //! Converts normal equations in the entries of the model to normal equations in the
    //! parameters: B^T JtJ B and B^T Jtr with B = tangent().
    void project(const NormalEquations& sums, Matrix& A, Step& b) const;
    //! The parameterization around the model with the parameters `step`.
    HomographyParameterization plus(const Step& step) const;
    Model model() const;

private:
    /** Computes v and `factor` of the Householder reflection I - factor v v^T that maps the last of
    the 9 axes, that of h33, to h or -h, and thus the other axes to the orthogonal complement of h.
    @return factor */
    double reflection(Eigen::Matrix<double, 9, 1>& v) const
    {
        v = h;
        v[8] += h[8] < 0 ? -1 : 1;
        return 2 / v.squaredNorm();
    }

    Eigen::Matrix<double, 9, 1> h;
};

}  // namespace usacv20
}  // namespace cv

#endif
