// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/problem_objects.hpp"

#include <map>
#include "problems/kernels.hpp"
#include "problems/registry.hpp"

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

const Problem& problemObject(ProblemType type)
{
    static std::map<ProblemType, Ptr<Problem>> objects;
    static Mutex mutex;
    const AutoLock lock(mutex);
    Ptr<Problem>& object = objects[type];
    if (!object)
        object = createProblem(type, Matx33d::eye(), noArray(), noArray(), noArray());
    return *object;
}

Ptr<Residual> residualOf(Formula::Kind kind)
{
    switch (kind)
    {
    case Formula::TRANSFER: return createResidualOf<TransferError>();
    case Formula::SYMMETRIC_TRANSFER: return createResidualOf<SymmetricTransferError>();
    case Formula::SAMPSON: return createResidualOf<SampsonError>();
    default: return createResidualOf<SymmetricEpipolarError>();
    }
}

Ptr<NonMinimalSolver> createLeastSquaresSolver(ProblemType type, Formula::Kind kind)
{
    return problemObject(type).createNonMinimalSolver(residualOf(kind));
}

Parameterization::Parameterization(ProblemType type, const Model& model)
    : rule(problemObject(type).createParameterization()), given(model)
{}
Parameterization::Parameterization(const Problem* problem, const Model& model)
    : rule(problem->createParameterization()), given(model)
{}

bool Parameterization::hasFullRank() const
{
    double basis[MAX_MODEL_SIZE * MAX_MODEL_SIZE];
    return rule->tangent(given, basis);
}

int Parameterization::dimension() const { return rule->dimension(); }

Parameterization::Basis Parameterization::tangent() const
{
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> basis(given.size(),
                                                                                 dimension());
    rule->tangent(given, basis.data());
    return basis;
}

Parameterization Parameterization::plus(const Step& step) const
{
    Parameterization result(*this);
    result.given = rule->plus(given, step.data());
    return result;
}

Model Parameterization::model() const
{
    const Step zero = Step::Zero(dimension());
    return rule->plus(given, zero.data());
}

}  // namespace opencv_test
