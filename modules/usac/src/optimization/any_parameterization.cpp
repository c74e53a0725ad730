// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "optimization/any_parameterization.hpp"
#include "numeric/decompositions.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! The pivot of a step of the Cholesky decomposition in callerBasis() is the first diagonal entry
//! that is smaller than the largest diagonal entry by at most this fraction. If E or F is
//! antisymmetric (a motion without rotation), some diagonal entries of the matrix that projects
//! onto the tangent space are equal except for rounding errors, which would make the choice of the
//! pivot arbitrary.
constexpr double TIED = 1e-6;

}  // namespace

bool callerBasis(const Parameterization& rule, const Model& model,
                 AnyParameterization::Basis& basis)
{
    const int n = model.size(), d = rule.dimension();
    basis.resize(n, d);
    if (!rule.tangent(model, basis.data()))
        return false;
    if (rule.smooth() || !basis.allFinite())
        return basis.allFinite();
    const Eigen::MatrixXd Q = orthonormalBasis(basis);
    Eigen::MatrixXd rest = Q * Q.transpose();
    for (int k = 0; k < d; ++k)
    {
        const double most = rest.diagonal().maxCoeff();
        int pivot = 0;
        while (!(rest(pivot, pivot) >= (1 - TIED) * most))
            ++pivot;
        basis.col(k) = rest.col(pivot) / std::sqrt(rest(pivot, pivot));
        rest -= basis.col(k) * basis.col(k).transpose();
    }
    return true;
}

}  // namespace usacv20
}  // namespace cv
