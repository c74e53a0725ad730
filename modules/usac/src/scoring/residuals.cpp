// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "core/indices.hpp"
#include "scoring/formulas.hpp"
#include "scoring/kernels.hpp"
#include "scoring/residuals.hpp"

namespace cv {
namespace usacv20 {

namespace {

template <class Error, int... K>
void errorsOf(const double* m, const double* const* columns, int count, double* errors,
              Indices<K...>)
{
    for (int i = 0; i < count; ++i)
        errors[i] = Error::squared(m, columns[K][i]...);
}

/** The residual of a formula, with its kernels; one pass over the points. */
template <class Error, Residual::Kind KIND>
class FormulaResidual : public Residual
{
public:
    void squaredErrors(const Correspondences& points, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        float m[MAX_MODEL_SIZE];
        toFloat(model, m, homogeneous());
        kernels().errors[KIND](points, m, begin, end, errors);
    }

    void squaredErrors(const Model& model, const double* const* columns, int count,
                       double* errors) const CV_OVERRIDE
    {
        errorsOf<Error>(model.val, columns, count, errors,
                        typename IndicesTo<Error::COLUMNS>::Type());
    }

    Kind kind() const CV_OVERRIDE { return KIND; }
};

class SpaceTransferResidual : public FormulaResidual<SpaceTransferError, Residual::SPACE_TRANSFER>
{
public:
    bool homogeneous() const CV_OVERRIDE { return false; }
};

//! Defines the signed error: the square root of the squared error has no sign, and no derivative
//! at 0.
class SampsonResidual : public FormulaResidual<SampsonError, Residual::SAMPSON>
{
public:
    int error(const Model& model, const double* datum, double* error) const CV_OVERRIDE
    {
        const EpipolarLines<double> l(model.val, datum[0], datum[1], datum[2], datum[3]);
        *error = l.r / std::sqrt(l.a * l.a + l.b * l.b + l.d * l.d + l.e * l.e);
        return 1;
    }

    int linearize(const Model& model, const double* datum, double* error,
                  double* derivative) const CV_OVERRIDE
    {
        const EpipolarLines<double> l(model.val, datum[0], datum[1], datum[2], datum[3]);
        const double square = l.a * l.a + l.b * l.b + l.d * l.d + l.e * l.e,
                     root = std::sqrt(square);
        const double x1[3] = {datum[0], datum[1], 1}, x2[3] = {datum[2], datum[3], 1};
        const double line1[3] = {l.d, l.e, 0}, line2[3] = {l.a, l.b, 0};
        const double inverse = 1 / root, factor = l.r / square;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                derivative[3 * i + j] = inverse * (x2[i] * x1[j] -
                                                   factor * (line2[i] * x1[j] + line1[j] * x2[i]));
        *error = l.r / root;
        return 1;
    }
};

}  // namespace

Ptr<Residual> createTransferResidual()
{
    return makePtr<FormulaResidual<TransferError, Residual::TRANSFER>>();
}

Ptr<Residual> createSampsonResidual() { return makePtr<SampsonResidual>(); }

Ptr<Residual> createSymmetricTransferResidual()
{
    return makePtr<FormulaResidual<SymmetricTransferError, Residual::SYMMETRIC_TRANSFER>>();
}

Ptr<Residual> createSymmetricEpipolarResidual()
{
    return makePtr<FormulaResidual<SymmetricEpipolarError, Residual::SYMMETRIC_EPIPOLAR>>();
}

Ptr<Residual> createReprojectionResidual()
{
    return makePtr<FormulaResidual<ReprojectionError, Residual::REPROJECTION>>();
}

Ptr<Residual> createSpaceTransferResidual() { return makePtr<SpaceTransferResidual>(); }

}  // namespace usacv20
}  // namespace cv
