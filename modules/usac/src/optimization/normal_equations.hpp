// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_NORMAL_EQUATIONS_HPP
#define OPENCV_USACV20_NORMAL_EQUATIONS_HPP

#include <Eigen/Core>
#include "optimization/point_chunks.hpp"

namespace cv {
namespace usacv20 {

/** Gauss-Newton sums of an error in the entries of the model, `SIZE` of them: JtJ, Jtr and the cost
r^T r. A parameterization projects them onto its tangent space afterwards, so that the work of a
point is the same for all. */
template <int SIZE>
struct NormalEquationsOf
{
    Eigen::Matrix<double, SIZE, SIZE, Eigen::RowMajor> JtJ;
    Eigen::Matrix<double, SIZE, 1> Jtr;
    double cost;

    //! Sums over the points, by a kernel or, for residuals of a program's own, by
    //! Residual::linearize().
    void accumulate(const Residual& residual, const PointChunks& points, const Model& model);

    //! The cost alone, for a fraction of the time.
    static double costOf(const Residual& residual, const PointChunks& points, const Model& model);
};

//! Of a 3x3 matrix, and of the 3x4 matrix of a camera or of a motion of space.
typedef NormalEquationsOf<9> NormalEquations;
typedef NormalEquationsOf<12> SpaceEquations;

}  // namespace usacv20
}  // namespace cv

#endif
