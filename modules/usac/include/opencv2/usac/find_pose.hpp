// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_POSE_HPP
#define OPENCV_USACV20_FIND_POSE_HPP

#include <utility>
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac/params.hpp"

namespace cv {

//! @addtogroup usacv20
//! @{

/** @name The pose of a camera by cv::solvePnPRansac with a flag of this module
These overloads of cv::solvePnPRansac accept a #UsacV20Method or a usacv20::Params; the meaning and
order of the other arguments are the same. If the flag is stored in an `int`, call
usacv20::solvePnPRansac instead. The results are those of usacv20::estimateAbsolutePose: the
reprojection error is measured in the original image, distortion included, and points behind the
camera are not inliers.
@{ */
/** @brief The pose of a calibrated camera.
@param objectPoints N 3-D points
@param imagePoints their images in pixels
@param cameraMatrix 3x3 camera matrix
@param distCoeffs 4, 5, 8, 12 or 14 coefficients of the distortion; empty: none
@param rvec output, 3x1, CV_64F, the rotation as a vector (cv::Rodrigues); with `useExtrinsicGuess`
also input, 3 numbers
@param tvec output, 3x1, CV_64F, the translation; with `useExtrinsicGuess` also input
@param useExtrinsicGuess true: `rvec` and `tvec` hold an initial pose, which is scored and optimized
before the first sample
@param iterationsCount maximum number of samples
@param reprojectionError inlier threshold in pixels
@param confidence confidence of the search, see usacv20::Params::confidence
@param inliers output, Mx1, CV_32S, the indices of the M inliers in ascending order; empty if there
are none
@param flags a #UsacV20Method
@return false if there is no pose; `rvec` and `tvec` are then unchanged. */
CV_EXPORTS bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints,
                               InputArray cameraMatrix, InputArray distCoeffs, OutputArray rvec,
                               OutputArray tvec, bool useExtrinsicGuess, int iterationsCount,
                               float reprojectionError, double confidence, OutputArray inliers,
                               UsacV20Method flags);
//! @overload
CV_EXPORTS bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints,
                               InputArray cameraMatrix, InputArray distCoeffs, OutputArray rvec,
                               OutputArray tvec, OutputArray inliers,
                               const usacv20::Params& params);
//! @}

namespace usacv20 {

/** @brief cv::solvePnPRansac with a flag of this module or of OpenCV, known only at run time.

As for usacv20::findHomography, a call with one of OpenCV's own flags is passed on to calib3d
unchanged, any other number outside 0..63 raises a cv::Exception that names `flags`, and after
`using namespace cv` and `using namespace cv::usacv20` the call must name the namespace. The
defaults are those of calib3d, except that an omitted `flags` is UsacV20Method::USACV20.
@param objectPoints N 3-D points
@param imagePoints their images in pixels
@param cameraMatrix 3x3 camera matrix
@param distCoeffs coefficients of the distortion; empty: none
@param rvec output, 3x1, CV_64F, the rotation as a vector; with `useExtrinsicGuess` also input
@param tvec output, 3x1, CV_64F, the translation; with `useExtrinsicGuess` also input
@param useExtrinsicGuess `rvec` and `tvec` hold an initial pose
@param iterationsCount maximum number of samples
@param reprojectionError inlier threshold in pixels
@param confidence confidence of the search, see usacv20::Params::confidence
@param inliers output, Mx1, CV_32S, the indices of the inliers
@param flags value of a #UsacV20Method, or a flag of OpenCV
@return false if there is no pose */
CV_EXPORTS_W bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints,
                                 InputArray cameraMatrix, InputArray distCoeffs, OutputArray rvec,
                                 OutputArray tvec, bool useExtrinsicGuess = false,
                                 int iterationsCount = 100, float reprojectionError = 8.0,
                                 double confidence = 0.99, OutputArray inliers = noArray(),
                                 int flags = (int)USACV20);

//! The same with a flag that is known at compile time. It is a template so that a call without a
//! namespace is not ambiguous after `using namespace cv` and `using namespace cv::usacv20`.
template <typename... Others>
bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                    InputArray distCoeffs, OutputArray rvec, OutputArray tvec,
                    bool useExtrinsicGuess, int iterationsCount, float reprojectionError,
                    double confidence, OutputArray inliers, UsacV20Method flags, Others&&... others)
{
    return cv::solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                              useExtrinsicGuess, iterationsCount, reprojectionError, confidence,
                              inliers, flags, std::forward<Others>(others)...);
}

}  // namespace usacv20

//! @}

}  // namespace cv

#endif
