// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FORMULA_RESIDUAL_HPP
#define OPENCV_USACV20_FORMULA_RESIDUAL_HPP

#include "residual/kernels.hpp"

namespace cv {
namespace usacv20 {

/* The formula of an error is written once, in the folder of its problem, as a type:

struct SomeError
{
    enum {
        COLUMNS,      // number of coordinates of a datum
        NUMBERS,      // number of entries of a model
        COMPONENTS,   // number of components of the error vector
        HOMOGENEOUS,  // see Residual::homogeneous
        PROJECTION    // 1: the error of a projection, summed by ProjectionSums; 0: another error
    };
    template <class T> struct At  // T: float or double
    {
        At(const T* m, T x, ...);  // evaluates one datum under a model given row by row
        T squared() const;         // squared error; NaN or infinite where it is not defined
        T cost() const;            // squared error for fits; finite at epipoles and behind cameras
        // for T = double: writes the error vector, out.error(component), and its derivative with
        // respect to the entries of the model, out.derivative(component, number)
        template <class Out> void linearize(Out& out) const;
    };
};

For each formula in the list of problems/errors.hpp, the kernels are compiled for each instruction
set: the loops that compute errors and scores (kernels.inl.hpp) and the sums for fits
(sums.inl.hpp). FormulaResidual is the Residual component of a formula.

Formulas and all templates that use them are inside unnamed namespaces, because they are compiled
several times for different instruction sets, and the linker would keep only one version of an
inline function with external linkage. For the same reason, formulas call sqrtf() and fabsf()
instead of std::sqrt() and std::abs() for float. */

namespace {

//! Receives the error of a datum and its derivative from a formula, for Residual::linearize().
template <class Error>
struct ErrorAndDerivative
{
    double *const errors, *const derivatives;

    double& error(int component) { return errors[component]; }
    double& derivative(int component, int number)
    {
        return derivatives[Error::NUMBERS * component + number];
    }
};

//! Receives only the error of a datum from a formula; the derivative is discarded.
struct ErrorOnly
{
    double* const errors;
    double unused;

    double& error(int component) { return errors[component]; }
    double& derivative(int, int) { return unused; }
};

//! The residual whose error is given by a formula.
template <class Error>
class FormulaResidual : public Residual
{
public:
    explicit FormulaResidual(const ResidualKernels& kernels_) : loops(kernels_) {}

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        float m[MAX_MODEL_SIZE];
        toFloat(model, m, homogeneous());
        loops.errors(points, m, begin, end, errors);
    }

    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
            errors[i] = at(model, columns, i, Columns()).squared();
    }

    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE
    {
        ErrorOnly out = {error, 0};
        at(model, datum, Columns()).linearize(out);
        return Error::COMPONENTS;
    }

    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        ErrorAndDerivative<Error> out = {error, derivative};
        at(model, datum, Columns()).linearize(out);
        return Error::COMPONENTS;
    }

    const ResidualKernels* kernels() const CV_OVERRIDE { return &loops; }
    bool homogeneous() const CV_OVERRIDE { return Error::HOMOGENEOUS != 0; }

private:
    typedef typename Error::template At<double> At;
    typedef typename IndicesTo<Error::COLUMNS>::Type Columns;

    template <int... K>
    static At at(const Model& model, const double* const* columns, int i, Indices<K...>)
    {
        return At(model.val, columns[K][i]...);
    }

    template <int... K>
    static At at(const Model& model, const double* datum, Indices<K...>)
    {
        return At(model.val, datum[K]...);
    }

    const ResidualKernels& loops;
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
