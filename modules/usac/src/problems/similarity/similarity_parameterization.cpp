// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/similarity/similarity_parameterization.hpp"
#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

SimilarityParameterization::SimilarityParameterization(const Model& model)
{
    const double* const m = model.val;
    parameters << (m[0] + m[4]) / 2, (m[3] - m[1]) / 2, m[2], m[5];
    parameters /= m[8];
}

bool SimilarityParameterization::hasFullRank() const
{
    return parameters[0] != 0 || parameters[1] != 0;
}

SimilarityParameterization::Basis SimilarityParameterization::tangent() const
{
    Basis basis = Basis::Zero();
    basis(0, 0) = basis(4, 0) = basis(3, 1) = basis(2, 2) = basis(5, 3) = 1;
    basis(1, 1) = -1;
    return basis;
}

void SimilarityParameterization::project(const NormalEquations& sums, Matrix& A, Step& b) const
{
    projectOnTangents<DIMENSION>(sums, tangent(), A, b);
}

SimilarityParameterization SimilarityParameterization::plus(const Step& step) const
{
    SimilarityParameterization result(*this);
    result.parameters += step;
    return result;
}

Model SimilarityParameterization::model() const
{
    const Step& p = parameters;
    return Matx33d(p[0], -p[1], p[2], p[1], p[0], p[3], 0, 0, 1);
}

}  // namespace usacv20
}  // namespace cv
