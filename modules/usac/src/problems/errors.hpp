// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ERRORS_HPP
#define OPENCV_USACV20_ERRORS_HPP

#include "problems/absolute_pose/reprojection_error.hpp"
#include "problems/rigid_motion/space_transfer_error.hpp"
#include "problems/two_view/epipolar_error.hpp"
#include "problems/two_view/transfer_error.hpp"
#include "problems/two_view/whitened_transfer_error.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! A list of formulas of residuals, see residual/formula_residual.hpp.
template <class... Errors>
struct ErrorList
{
    enum { COUNT = sizeof...(Errors) };
};

//! All formulas for which kernels are compiled. A new formula must be added here.
typedef ErrorList<TransferError, SymmetricTransferError, SampsonError, SymmetricEpipolarError,
                  ReprojectionError, SpaceTransferError, WhitenedTransferError,
                  WhitenedSampsonError, WhitenedReprojectionError>
    Errors;

//! VALUE is the index of the formula `Error` in the list `List`.
template <class Error, class List>
struct PlaceOf;
template <class Error, class... More>
struct PlaceOf<Error, ErrorList<Error, More...>>
{
    enum { VALUE = 0 };
};
template <class Error, class First, class... More>
struct PlaceOf<Error, ErrorList<First, More...>>
{
    enum { VALUE = 1 + PlaceOf<Error, ErrorList<More...>>::VALUE };
};

}  // namespace

}  // namespace usacv20
}  // namespace cv

#endif
