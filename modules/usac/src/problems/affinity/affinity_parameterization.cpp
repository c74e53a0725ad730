// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/affinity/affinity_parameterization.hpp"

namespace cv {
namespace usacv20 {

//! The linear part is singular if its determinant is at most this part of the sum of its squared
//! entries, which rounding alone can cause.
constexpr double LEAST_DETERMINANT = 1e-9;

AffinityParameterization::AffinityParameterization(const Model& model)
    : parameters(Eigen::Map<const Step>(model.val) / model.val[8])
{}

bool AffinityParameterization::hasFullRank() const
{
    const double a = parameters[0], b = parameters[1], c = parameters[3], d = parameters[4];
    return std::abs(a * d - b * c) > LEAST_DETERMINANT * (a * a + b * b + c * c + d * d);
}

AffinityParameterization::Basis AffinityParameterization::tangent() const
{
    return Basis::Identity();
}

void AffinityParameterization::project(const NormalEquations& sums, Matrix& A, Step& b) const
{
    A = sums.JtJ.topLeftCorner<DIMENSION, DIMENSION>();
    b = sums.Jtr.head<DIMENSION>();
}

AffinityParameterization AffinityParameterization::plus(const Step& step) const
{
    AffinityParameterization result(*this);
    result.parameters += step;
    return result;
}

Model AffinityParameterization::model() const
{
    const Step& p = parameters;
    return Matx33d(p[0], p[1], p[2], p[3], p[4], p[5], 0, 0, 1);
}

}  // namespace usacv20
}  // namespace cv
