// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/kernels.hpp"
#include "problems/noise_of_matches.hpp"
#include "residual/weighted_residual.hpp"

namespace cv {
namespace usacv20 {

//! The version of `residual` that uses the covariances of the points; empty if there is no such
//! version, or if `residual` uses the covariances already.
static Ptr<Residual> whitenedResidual(const Residual& residual)
{
    if (hasFormula<TransferError>(residual))
        return createResidualOf<WhitenedTransferError>();
    if (hasFormula<SampsonError>(residual))
        return createResidualOf<WhitenedSampsonError>();
    if (hasFormula<ReprojectionError>(residual))
        return createResidualOf<WhitenedReprojectionError>();
    return Ptr<Residual>();
}

Ptr<Residual> residualWithNoise(const Ptr<Residual>& residual, const Correspondences& points)
{
    if (points.noise == 0)
        return residual;
    if (points.noise == 1)
        return weightedResidual(residual, points.columns());
    const Ptr<Residual> whitened = whitenedResidual(*residual);
    if (!whitened)
        CV_Error_(Error::StsBadArg,
                  ("sigmas: covariances need one of the built-in problems for image points and "
                   "RESIDUAL_STANDARD; the problem %s with this residual takes one number for each "
                   "correspondence",
                   points.problem->name().c_str()));
    return whitened;
}

Ptr<Residual> imageResidualWithNoise(const Problem& problem, const Ptr<Residual>& residual,
                                     const Correspondences& points)
{
    if (points.noise > 1)
    {
        const Ptr<Residual> whitened = whitenedResidual(*residual);
        return problem.createImageResidual(whitened ? whitened : residual);
    }
    const Ptr<Residual> image = problem.createImageResidual(residual);
    return image ? residualWithNoise(image, points) : image;
}

void checkNoise(const Residual& residual, const Correspondences& points)
{
    const ResidualKernels* const kernels = residual.kernels();
    if (points.noise > 1 && kernels && kernels->columns != points.numbers())
        CV_Error(Error::StsBadArg,
                 "components().residual: this built-in residual does not use the covariances in "
                 "sigmas");
}

}  // namespace usacv20
}  // namespace cv
