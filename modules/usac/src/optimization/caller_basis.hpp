// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CALLER_BASIS_HPP
#define OPENCV_USACV20_CALLER_BASIS_HPP

#include "opencv2/usac/problem.hpp"
#include "optimization/any_parameterization.hpp"

namespace cv {
namespace usacv20 {

/** @brief The derivatives of the entries of a model by the parameters of Report::covariance: those
of the parameterization. If its basis of the tangent space depends on how rounding turns singular
vectors (Parameterization::smooth is false), it is replaced by an orthonormal one that depends on
the tangent space alone: the rows of the pivoted Cholesky decomposition of the projection onto it.
@param model as Parameterization::plus returns it
@param basis output, Model::size() x Parameterization::dimension()
@return false if the model is degenerate */
bool callerBasis(const Parameterization& rule, const Model& model,
                 AnyParameterization::Basis& basis);

}  // namespace usacv20
}  // namespace cv

#endif
