// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "residual/kernels.hpp"
#include "residual/weighted_residual.hpp"

namespace cv {
namespace usacv20 {

namespace {

class WeightedResidual : public Residual
{
public:
    WeightedResidual(const Ptr<Residual>& inner_, int factor_)
        : inner(inner_), factor(factor_), sums()
    {
        if (!inner->kernels())
            return;
        sums = *inner->kernels();
        sums.errors = 0;
        sums.msac = sums.inliers = 0;
    }

    void start(const Context& context) CV_OVERRIDE { inner->start(context); }

    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(points, model, begin, end, errors);
        const float* const factors = points.column[factor] + begin;
        for (int i = 0; i < end - begin; ++i)
            errors[i] *= factors[i] * factors[i];
    }

    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        inner->squaredErrors(model, columns, count, errors);
        const double* const factors = columns[factor];
        for (int i = 0; i < count; ++i)
            errors[i] *= factors[i] * factors[i];
    }

    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE
    {
        const int components = inner->error(model, datum, error);
        for (int k = 0; k < components; ++k)
            error[k] *= datum[factor];
        return components;
    }

    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        const int components = inner->linearize(model, datum, error, derivative);
        for (int k = 0; k < components; ++k)
            error[k] *= datum[factor];
        for (int k = 0; k < components * model.size(); ++k)
            derivative[k] *= datum[factor];
        return components;
    }

    //! Only the kernels for fits: `sums`, `cost` and `leverages`. They need no factors, because
    //! PointChunks multiplies the weights by the squared factors.
    const ResidualKernels* kernels() const CV_OVERRIDE { return sums.sums ? &sums : 0; }
    bool homogeneous() const CV_OVERRIDE { return inner->homogeneous(); }

private:
    const Ptr<Residual> inner;
    const int factor;
    ResidualKernels sums;
};

}  // namespace

Ptr<Residual> weightedResidual(const Ptr<Residual>& residual, int factor)
{
    return makePtr<WeightedResidual>(residual, factor);
}

}  // namespace usacv20
}  // namespace cv
