// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ANY_PARAMETERIZATION_HPP
#define OPENCV_USACV20_ANY_PARAMETERIZATION_HPP

#include "opencv2/usac/least_squares.hpp"
#include "optimization/least_squares.hpp"
#include "optimization/tangent_space.hpp"

namespace cv {
namespace usacv20 {

//! A Parameterization around a fixed model, with the types and methods that LeastSquaresSolver
//! needs.
class AnyParameterization
{
public:
    enum { NUMBERS = Eigen::Dynamic };
    typedef Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MAX_MODEL_SIZE, 1> Step;
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, MAX_MODEL_SIZE, MAX_MODEL_SIZE>
        Matrix;

    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, MAX_MODEL_SIZE,
                          MAX_MODEL_SIZE>
        Basis;

    //! Function object that creates the parameterization around a model.
    struct Around
    {
        explicit Around(const Ptr<Parameterization>& rule_) : rule(rule_) {}
        AnyParameterization operator()(const Model& model) const
        {
            return AnyParameterization(*rule, model);
        }

        Ptr<Parameterization> rule;
    };

    AnyParameterization(const Parameterization& rule_, const Model& model)
        : rule(&rule_), here(rule_.plus(model, Step::Zero(rule_.dimension()).eval().data())),
          basis(here.size(), rule_.dimension())
    {
        regular = rule->tangent(here, basis.data());
    }

    int dimension() const { return (int)basis.cols(); }
    bool wellConditioned() const { return regular; }
    void project(const NormalEquationsOf<Eigen::Dynamic>& sums, Matrix& A, Step& b) const
    {
        const Basis image = sums.JtJ.lazyProduct(basis);
        A = basis.transpose().lazyProduct(image);
        b = basis.transpose().lazyProduct(sums.Jtr);
    }
    AnyParameterization plus(const Step& step) const
    {
        return AnyParameterization(*rule, rule->plus(here, step.data()));
    }
    Model model() const { return here; }

private:
    const Parameterization* rule;
    Model here;
    bool regular;
    Basis basis;
};

/** @brief The Parameterization of a built-in problem. `Here` is the class of the parameterization
around a fixed model, with sizes that are known at compile time. */
template <class Here, class Around = AroundModel<Here>>
class BuiltInParameterization : public Parameterization
{
public:
    explicit BuiltInParameterization(const Around& around_ = Around()) : around(around_) {}

    int dimension() const CV_OVERRIDE { return Here::DIMENSION; }
    bool smooth() const CV_OVERRIDE { return Here::SMOOTH; }

    bool tangent(const Model& model, double* basis) const CV_OVERRIDE
    {
        const Here here = around(model);
        typedef Eigen::Matrix<double, Here::NUMBERS, Here::DIMENSION, Eigen::RowMajor> Rows;
        Eigen::Map<Rows> rows(basis);
        rows = here.tangent();
        return here.hasFullRank();
    }

    Model plus(const Model& model, const double* x) const CV_OVERRIDE
    {
        return around(model).plus(Eigen::Map<const typename Here::Step>(x)).model();
    }

private:
    const Around around;
};

/** @brief The derivatives of the entries of a model with respect to the parameters of
Report::covariance. They are the result of Parameterization::tangent, unless this basis of the
tangent space depends on singular vectors, which rounding errors can rotate
(Parameterization::smooth is false). The basis is then replaced with an orthonormal basis that
depends only on the tangent space: the columns of the factor of the pivoted Cholesky decomposition
of the matrix that projects onto this space.
@param rule the parameterization
@param model as Parameterization::plus returns it, up to scale
@param basis output, Model::size() x Parameterization::dimension()
@return false if the model is degenerate or the basis is not finite */
bool callerBasis(const Parameterization& rule, const Model& model,
                 AnyParameterization::Basis& basis);

}  // namespace usacv20
}  // namespace cv

#endif
