// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/written.hpp"
#include "numeric/decompositions.hpp"
#include "optimization/any_parameterization.hpp"
#include "optimization/least_squares.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! Permitted deviations, relative to the largest entry: SAME for models that should be equal,
//! DERIVATIVE for derivatives compared with central differences of step STEP. These deviations are
//! far above the numerical errors of correct formulas (1e-16 and 1e-10) and far below the
//! deviations of wrong formulas.
constexpr double SAME = 1e-9, DERIVATIVE = 1e-5, STEP = 1e-5;
//! The columns of tangent() count as linearly dependent if the ratio of their smallest to their
//! largest singular value is at most this number.
constexpr double DEPENDENT = 1e-10;
//! Largest absolute value of a parameter in the test of whether plus() returns a valid model.
constexpr double FAR = 0.1;

//! Parameters of a Parameterization, 0 beyond its dimension.
typedef Eigen::Matrix<double, MAX_MODEL_SIZE, 1> Parameters;
typedef Eigen::Map<const Eigen::VectorXd> Entries;

double difference(const Model& a, const Model& b)
{
    const Entries x(a.val, a.size()), y(b.val, b.size());
    return (x - y).cwiseAbs().maxCoeff() / x.cwiseAbs().maxCoeff();
}

String broken(const char* law, double deviation)
{
    return format("%s (deviation %.3g)", law, deviation);
}

String checkTangent(const Parameterization& rule, const Model& here)
{
    const int dimension = rule.dimension(), size = here.size();
    Written<double> basis(size * dimension);
    if (!rule.tangent(here, basis.data()))
        return "tangent: the model is degenerate";
    if (!basis.exactly(size * dimension))
        return format("tangent: %d x %d numbers are expected; more or fewer have been written",
                      size, dimension);
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;
    const Eigen::MatrixXd columns = Eigen::Map<const Rows>(basis.data(), size, dimension);
    for (int k = 0; k < dimension; ++k)
    {
        const Parameters x = Parameters::Unit(k) * STEP, opposite = -x;
        const Model after = rule.plus(here, x.data()), before = rule.plus(here, opposite.data());
        const Eigen::VectorXd expected = (Entries(after.val, size) - Entries(before.val, size)) /
                                         (2 * STEP);
        const double deviation = (expected - columns.col(k)).cwiseAbs().maxCoeff() /
                                 columns.col(k).cwiseAbs().maxCoeff();
        if (!(deviation <= DERIVATIVE))
            return format("tangent: column %d is not the derivative of plus() (deviation %.3g)", k,
                          deviation);
    }
    const Eigen::VectorXd singular = singularValues(columns);
    const double ratio = singular[dimension - 1] / singular[0];
    return ratio > DEPENDENT ? String()
                             : broken("tangent: the columns are linearly dependent", ratio);
}

}  // namespace

Parameterization::~Parameterization() {}
bool Parameterization::smooth() const { return true; }

Ptr<NonMinimalSolver> createLeastSquares(const Ptr<Residual>& residual, int errorDimension,
                                         const Ptr<Parameterization>& parameterization)
{
    CV_Assert(residual && parameterization && errorDimension >= 1);
    typedef LeastSquaresSolver<AnyParameterization, AnyParameterization::Around> Fit;
    return makePtr<Fit>(residual, errorDimension, AnyParameterization::Around(parameterization));
}

String checkParameterization(const Parameterization& rule, const Model& model)
{
    const int dimension = rule.dimension();
    if (dimension < 1 || dimension > model.size())
        return format("dimension: %d, the model has %d entries", dimension, model.size());
    const Parameters zero = Parameters::Zero();
    const Model here = rule.plus(model, zero.data());
    if (here.rows != model.rows || here.cols != model.cols)
        return format("plus: a model of %d x %d entries has become one of %d x %d", model.rows,
                      model.cols, here.rows, here.cols);
    double deviation = difference(here, rule.plus(here, zero.data()));
    if (!(deviation <= SAME))
        return broken("plus: zero parameters change the model", deviation);
    Parameters more = zero;
    more.tail(MAX_MODEL_SIZE - dimension).setOnes();
    if (rule.plus(model, more.data()) != here)
        return format("dimension: %d, but plus() uses more parameters", dimension);
    const String wrong = checkTangent(rule, here);
    if (!wrong.empty())
        return wrong;
    for (int k = 0; k < dimension; ++k)
    {
        Parameters x = zero;
        x.head(dimension).setConstant(FAR / 2);
        x[k] = -FAR;
        const Model there = rule.plus(here, x.data());
        deviation = difference(there, rule.plus(there, zero.data()));
        if (!(deviation <= SAME))
            return broken("plus: the result is not valid", deviation);
    }
    return String();
}

}  // namespace usacv20
}  // namespace cv
