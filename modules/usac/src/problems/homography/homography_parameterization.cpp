// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/homography/homography_parameterization.hpp"
#include "optimization/inner_product.hpp"

namespace cv {
namespace usacv20 {

//! H counts as a matrix of rank 3 if the magnitude of its determinant is above this fraction of the
//! sum of the magnitudes of the six products that form the determinant. The rounding error of the
//! fraction is about 1e-16. Unlike the determinant itself, the fraction does not depend on the
//! units of the coordinates.
constexpr double RANK_TWO = 1e-12;
//! In the normalized coordinates of Correspondences, an H of unit norm counts as well-conditioned
//! if the magnitude of its determinant is above this value.
constexpr double LEAST_DETERMINANT = 1e-9;

HomographyParameterization::HomographyParameterization(const Model& model)
    : h(Eigen::Map<const Eigen::Matrix<double, 9, 1>>(model.val).normalized())
{}

bool HomographyParameterization::hasFullRank() const
{
    const double first = std::abs(h[4] * h[8]) + std::abs(h[5] * h[7]),
                 second = std::abs(h[3] * h[8]) + std::abs(h[5] * h[6]),
                 third = std::abs(h[3] * h[7]) + std::abs(h[4] * h[6]);
    const double terms = std::abs(h[0]) * first + std::abs(h[1]) * second + std::abs(h[2]) * third;
    return std::abs(determinant(Matx33d(h.data()))) > RANK_TWO * terms;
}

bool HomographyParameterization::wellConditioned() const
{
    return std::abs(determinant(Matx33d(h.data()))) > LEAST_DETERMINANT;
}

HomographyParameterization::Basis HomographyParameterization::tangent() const
{
    Basis basis;
    Eigen::Matrix<double, 9, 1> v;
    const double factor = reflection(v);
    for (int k = 0; k < DIMENSION; ++k)
    {
        basis.col(k) = -factor * v[k] * v;
        basis(k, k) += 1;
    }
    return basis;
}

void HomographyParameterization::project(const NormalEquations& sums, Matrix& A, Step& b) const
{
    Eigen::Matrix<double, 9, 1> v;
    const double factor = reflection(v);
    const Eigen::Matrix<double, 9, 1> image = sums.JtJ.lazyProduct(v);
    const Eigen::Matrix<double, 9, 1> r = factor * image -
                                          (0.5 * factor * factor * innerProduct(v, image)) * v;
    for (int j = 0; j < DIMENSION; ++j)
        for (int i = 0; i < DIMENSION; ++i)
            A(i, j) = sums.JtJ(j, i) - (v[i] * r[j] + r[i] * v[j]);
    b = (sums.Jtr - (factor * innerProduct(v, sums.Jtr)) * v).head<DIMENSION>();
}

HomographyParameterization HomographyParameterization::plus(const Step& step) const
{
    HomographyParameterization result(*this);
    Eigen::Matrix<double, 9, 1> v;
    const double factor = reflection(v);
    result.h = h - (factor * innerProduct(v.head<DIMENSION>(), step)) * v;
    result.h.head<DIMENSION>() += step;
    result.h.normalize();
    return result;
}

Model HomographyParameterization::model() const { return Matx33d(h.data()); }

}  // namespace usacv20
}  // namespace cv
