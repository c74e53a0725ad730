// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RESIDUALS_HPP
#define OPENCV_USACV20_RESIDUALS_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! H: transfer error in image 2, see TransferError.
Ptr<Residual> createTransferResidual();
//! F, E: Sampson distance, see SampsonError.
Ptr<Residual> createSampsonResidual();
//! H: transfer errors in both images, see SymmetricTransferError.
Ptr<Residual> createSymmetricTransferResidual();
//! F, E: distances to both epipolar lines, see SymmetricEpipolarError.
Ptr<Residual> createSymmetricEpipolarResidual();
//! Absolute pose: error in the image, see ReprojectionError.
Ptr<Residual> createReprojectionResidual();
//! Rigid motion: distance in space 2, see SpaceTransferError.
Ptr<Residual> createSpaceTransferResidual();

}  // namespace usacv20
}  // namespace cv

#endif
