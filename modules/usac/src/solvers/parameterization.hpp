// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PARAMETERIZATION_HPP
#define OPENCV_USACV20_PARAMETERIZATION_HPP

#include <Eigen/Core>
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Smallest ratio of the two singular values of F, and smallest determinant of H of unit norm, that count as rank 2 and 3.
const double LEAST_RATIO = 1e-6, LEAST_DETERMINANT = 1e-9;

/** @brief A model and a minimal parameterization of its kind around it: parameters 0 are the model itself.

- H: unit 9-vectors; 8 directions orthogonal to it.
- F: U S V^T with rotations U and V and a 2x2 matrix, of unit norm, in the upper left corner of S. A tangent of the matrices
  of rank 2 has any entries in the place of S but the last one @cite vandereycken2013low; those of unit norm are orthogonal to S,
  too. That leaves 3 directions of the corner, 2 of the last column and 2 of the last row: 7, orthogonal, whatever the singular
  values are. (The angles of U and V are no such parameters: where both singular values are equal, as under a pure translation,
  turning both about the third axis leaves F as it is.)
- E: U diag(1, 1, 0) V^T / sqrt(2); 3 rotations of U, 2 of V (the third moves E like one of U): 5 @cite helmke2007essential. */
class Parameterization
{
public:
    typedef Eigen::Matrix<double, 9, Eigen::Dynamic, Eigen::ColMajor, 9, 8> Basis;
    typedef Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 8, 1> Step;

    //! Around the closest model (H: its multiple of unit norm) that fulfills the constraints.
    Parameterization(ProblemType problem, const Model& model);

    //! False for H that maps the plane to a line or a point, and for F of rank 1.
    bool hasFullRank() const;
    int dimension() const { return problem == HOMOGRAPHY ? 8 : problem == FUNDAMENTAL ? 7 : 5; }
    //! Derivatives of the model, as a 9-vector row by row, by the parameters at zero.
    Basis tangent() const;
    //! Normal equations in the parameters from those in the entries of the model: B^T JtJ B, B^T Jtr with B = tangent().
    template <int DIMENSION>
    void project(const Eigen::Matrix<double, 9, 9, Eigen::RowMajor>& JtJ, const Eigen::Matrix<double, 9, 1>& Jtr,
                 Eigen::Matrix<double, DIMENSION, DIMENSION>& A, Eigen::Matrix<double, DIMENSION, 1>& b) const;
    //! The parameterization around the model that has these parameters.
    Parameterization plus(const Step& step) const;
    Model model() const;

private:
    /** Householder's reflection I - factor v v^T that takes the axis of h33 to h or -h. It takes the other axes to the
    complement of h. */
    double reflection(Eigen::Matrix<double, 9, 1>& v) const
    {
        v = h;
        v[8] += h[8] < 0 ? -1 : 1;
        return 2 / v.squaredNorm();
    }

    //! The three directions of the corner: an orthonormal basis of the complement of its four entries.
    void cornerDirections(Eigen::Matrix2d (&directions)[3]) const;
    Parameterization plusFundamental(const Step& step) const;

    ProblemType problem;
    Eigen::Matrix<double, 9, 1> h;  //!< H
    Eigen::Matrix3d U, V;           //!< F, E; F: orthogonal, of either sign
    Eigen::Matrix2d corner;         //!< F: of S. E: half of the root of 2 on the diagonal
};

template <int DIMENSION>
void Parameterization::project(const Eigen::Matrix<double, 9, 9, Eigen::RowMajor>& JtJ, const Eigen::Matrix<double, 9, 1>& Jtr,
                       Eigen::Matrix<double, DIMENSION, DIMENSION>& A, Eigen::Matrix<double, DIMENSION, 1>& b) const
{
    if (DIMENSION == 8)
    {
        Eigen::Matrix<double, 9, 1> v;
        const double factor = reflection(v);
        const Eigen::Matrix<double, 9, 1> image = JtJ.lazyProduct(v);
        const Eigen::Matrix<double, 9, 1> r = factor * image - (0.5 * factor * factor * v.dot(image)) * v;
        for (int j = 0; j < DIMENSION; ++j)
            for (int i = 0; i < DIMENSION; ++i)
                A(i, j) = JtJ(j, i) - (v[i] * r[j] + r[i] * v[j]);
        b = (Jtr - (factor * v.dot(Jtr)) * v).template head<DIMENSION>();
        return;
    }
    const Eigen::Matrix<double, 9, DIMENSION> basis = tangent();
    const Eigen::Matrix<double, 9, DIMENSION> image = JtJ.lazyProduct(basis);
    for (int j = 0; j < DIMENSION; ++j)
        for (int i = j; i < DIMENSION; ++i)
            A(i, j) = A(j, i) = basis.col(i).dot(image.col(j));
    b = basis.transpose().lazyProduct(Jtr);
}

} // namespace usacv20
} // namespace cv

#endif
