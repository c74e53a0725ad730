// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_MANIFOLD_HPP
#define OPENCV_USACV20_MANIFOLD_HPP

#include <Eigen/Core>
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

/** @brief A model as a point of the manifold of its kind, with a minimal parameterisation around it.

- H: unit 9-vectors; 8 directions orthogonal to it.
- F: U diag(cos a, sin a, 0) V^T; 3 rotations of U, 3 of V and a: 7.
- E: U diag(1, 1, 0) V^T / sqrt(2); 3 rotations of U, 2 of V (the third moves E like one of U): 5 @cite helmke2007essential. */
class Manifold
{
public:
    typedef Eigen::Matrix<double, 9, Eigen::Dynamic, Eigen::ColMajor, 9, 8> Basis;
    typedef Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 8, 1> Step;

    //! The point of the manifold closest to `model`.
    Manifold(ProblemType problem, const Model& model);

    int dimension() const { return problem == HOMOGRAPHY ? 8 : problem == FUNDAMENTAL ? 7 : 5; }
    //! Derivatives of the model, as a 9-vector row by row, by the parameters at zero.
    Basis tangent() const;
    //! The point reached by a step from here.
    Manifold moved(const Step& step) const;
    Model model() const;

private:
    ProblemType problem;
    Eigen::Matrix<double, 9, 1> h;  //!< H
    Eigen::Matrix3d U, V;           //!< F, E
    double angle;                   //!< F: a. E: pi / 4
};

} // namespace usacv20
} // namespace cv

#endif
