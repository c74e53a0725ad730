// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "scoring/formulas.hpp"
#include "scoring/kernels.hpp"
#include "scoring/residuals.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** A residual is a formula and a name for its kernels; cost: one pass over the points. */
template <class Error, Residual::Kind KIND>
class FormulaResidual : public Residual
{
public:
    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        float m[MAX_MODEL_SIZE];
        toFloat(model, m);
        kernels().errors[KIND](points, m, begin, end, errors);
    }

    void squaredErrors(const Model& model, const double* const* columns, int count, double* errors) const CV_OVERRIDE
    {
        const double *x1 = columns[X1], *y1 = columns[Y1], *x2 = columns[X2], *y2 = columns[Y2];
        for (int i = 0; i < count; ++i)
            errors[i] = Error::squared(model.val, x1[i], y1[i], x2[i], y2[i]);
    }

    Kind kind() const CV_OVERRIDE { return KIND; }
};

}  // namespace

Ptr<Residual> createTransferResidual() { return makePtr<FormulaResidual<TransferError, Residual::TRANSFER>>(); }

Ptr<Residual> createSampsonResidual() { return makePtr<FormulaResidual<SampsonError, Residual::SAMPSON>>(); }

Ptr<Residual> createSymmetricTransferResidual()
{
    return makePtr<FormulaResidual<SymmetricTransferError, Residual::SYMMETRIC_TRANSFER>>();
}

Ptr<Residual> createSymmetricEpipolarResidual()
{
    return makePtr<FormulaResidual<SymmetricEpipolarError, Residual::SYMMETRIC_EPIPOLAR>>();
}

}  // namespace usacv20
}  // namespace cv
