// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PUBLIC_LEAST_SQUARES_HPP
#define OPENCV_USACV20_PUBLIC_LEAST_SQUARES_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @brief How least squares varies the models of a problem: a parameterization of all valid models
near a given one, with as many parameters as these models have degrees of freedom.

A model usually has more entries than degrees of freedom, because the entries fulfill constraints
(an essential matrix has 9 entries and 5 degrees of freedom). Implementations must fulfill these
laws for every valid model M, where 0 is a vector of `dimension()` zeros; #checkParameterization
tests most of them:

1. plus(M, 0) is M itself (for homogeneous models up to a scale that the implementation chooses),
   and plus(plus(M, 0), 0) equals plus(M, 0).
2. plus(M, x) is valid again, whatever x is, and changes continuously with x.
3. The columns of tangent(M) are the derivatives of plus(M, x) with respect to x at 0. They are
   linearly independent.

If a model violates the constraints slightly, as models of solvers do, tangent() and plus() use a
valid model near it. All methods are `const` and can be called by several threads. */
class CV_EXPORTS Parameterization
{
public:
    virtual ~Parameterization();
    //! Degrees of freedom, 1 to #MAX_MODEL_SIZE.
    virtual int dimension() const = 0;
    /** @brief Derivatives of the entries of plus(model, x) with respect to the parameters at x = 0.
    @param model the model
    @param basis output, Model::size() rows of dimension() numbers
    @return false if the model is degenerate, so that there is no parameterization around it */
    virtual bool tangent(const Model& model, double* basis) const = 0;
    /** @brief The model with the parameters x in the parameterization around `model`.
    @param model the model that has the parameters 0
    @param x dimension() parameters */
    virtual Model plus(const Model& model, const double* x) const = 0;
    //! True (default): tangent() changes little if the model changes little. False: the columns of
    //! tangent() depend on singular vectors and might change to another basis of the same space.
    //! Report::covariance then refers to a basis that does not depend on these vectors, see
    //! #tangentOfModel.
    virtual bool smooth() const;
};

/** @brief Creates a solver for weighted least squares of a residual, by the Gauss-Newton method;
steps that would not lower the cost are repeated with Levenberg-Marquardt damping
@cite more1978levenberg.

A Problem needs such a solver for local optimization and polishing. Problem::createNonMinimalSolver
creates it by default if there is a Problem::createParameterization.
@param residual the error to minimize; Residual::linearize returns its derivative with respect to
the entries of a model
@param errorDimension Problem::errorDimension: a fit needs at least
Parameterization::dimension() / errorDimension points
@param parameterization parameterization of the models */
CV_EXPORTS Ptr<NonMinimalSolver> createLeastSquares(const Ptr<Residual>& residual,
                                                    int errorDimension,
                                                    const Ptr<Parameterization>& parameterization);

/** @brief Tests whether a parameterization fulfills its laws around a model; derivatives are
compared with central differences. Also found are methods that read or write more numbers than
dimension() says. Not tested: that plus(M, 0) is M, and that plus() is continuous.
For tests of a program that implements a parameterization.
@param parameterization the parameterization to test
@param model any valid model; call the function for several models
@return empty if no violation was found, otherwise a description of the first violated law, with the
deviation. A deviation of 1e-9 (laws 1 and 2) or 1e-5 (derivatives), relative to the largest entry
of the model or of the column, is permitted. */
CV_EXPORTS String checkParameterization(const Parameterization& parameterization,
                                        const Model& model);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
