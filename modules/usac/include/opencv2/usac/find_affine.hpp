// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_AFFINE_HPP
#define OPENCV_USACV20_FIND_AFFINE_HPP

#include <utility>
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac/params.hpp"

namespace cv {

//! @addtogroup usacv20
//! @{

/** @name Affine maps and similarities by calib3d's functions with a flag of this module
These overloads of cv::estimateAffine2D and cv::estimateAffinePartial2D accept a #UsacV20Method or a
usacv20::Params; the meaning, order and defaults of the other arguments are the same. (OpenCV itself
has no cv::estimateAffinePartial2D with all options in one object.) If the flag is stored in an
`int`, call usacv20::estimateAffine2D and usacv20::estimateAffinePartial2D instead. The results are
those of usacv20::estimateAffinity2D and usacv20::estimateSimilarity2D.

`refineIters` is the maximum number of steps of the final polishing
(usacv20::Params::polishingSteps); a preset with fewer steps keeps its own number. 0 turns polishing
off (usacv20::POLISHING_NONE): the model is then the result of the search, which local optimization
has already fitted to its inliers. (With OpenCV's flags, 0 gives the model of the minimal sample.)
For `refineIters` and `maxIters`, a negative number raises cv::Exception, because its conversion to
`size_t` gives a very large number.
@{ */
//! An affine map; arguments and result as in usacv20::estimateAffine2D.
CV_EXPORTS Mat estimateAffine2D(InputArray from, InputArray to, OutputArray inliers,
                                UsacV20Method method, double ransacReprojThreshold = 3,
                                size_t maxIters = 2000, double confidence = 0.99,
                                size_t refineIters = 10);
//! With all options, like usacv20::estimateAffinity2D.
CV_EXPORTS Mat estimateAffine2D(InputArray pts1, InputArray pts2, OutputArray inliers,
                                const usacv20::Params& params);
//! The same, with the argument order of Python.
inline Mat estimateAffine2D(InputArray pts1, InputArray pts2, const usacv20::Params& params,
                            OutputArray inliers = noArray())
{
    return estimateAffine2D(pts1, pts2, inliers, params);
}

//! A similarity; arguments and result as in usacv20::estimateAffinePartial2D.
CV_EXPORTS Mat estimateAffinePartial2D(InputArray from, InputArray to, OutputArray inliers,
                                       UsacV20Method method, double ransacReprojThreshold = 3,
                                       size_t maxIters = 2000, double confidence = 0.99,
                                       size_t refineIters = 10);
//! With all options, like usacv20::estimateSimilarity2D.
CV_EXPORTS Mat estimateAffinePartial2D(InputArray pts1, InputArray pts2, OutputArray inliers,
                                       const usacv20::Params& params);
//! The same, with the argument order of Python.
inline Mat estimateAffinePartial2D(InputArray pts1, InputArray pts2, const usacv20::Params& params,
                                   OutputArray inliers = noArray())
{
    return estimateAffinePartial2D(pts1, pts2, inliers, params);
}
//! @}

namespace usacv20 {

/** @name Affine maps and similarities with an `int` flag, of this module or of OpenCV
These functions have the signatures of cv::estimateAffine2D and cv::estimateAffinePartial2D with an
`int method`, except that an omitted `method` is UsacV20Method::USACV20. As for
usacv20::findHomography, a call with one of OpenCV's own flags is passed on to calib3d unchanged,
any other number outside 0..63 raises a cv::Exception that names `method`, and after `using
namespace cv` and `using namespace cv::usacv20` the call must name the namespace.
@{ */
/** @brief cv::estimateAffine2D with a flag of this module or of OpenCV.
@param from N points of image 1
@param to their counterparts in image 2
@param inliers output, Nx1, CV_8U, 1 for inliers
@param method value of a #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold, distance in image 2 in pixels
@param maxIters maximum number of samples
@param confidence confidence of the search, see usacv20::Params::confidence
@param refineIters maximum number of steps of the final polishing; 0: none
@return 2x3, CV_64F, the affine map [A t]; empty if there is none
*/
CV_EXPORTS_W Mat estimateAffine2D(InputArray from, InputArray to, OutputArray inliers = noArray(),
                                  int method = (int)USACV20, double ransacReprojThreshold = 3,
                                  size_t maxIters = 2000, double confidence = 0.99,
                                  size_t refineIters = 10);

/** @brief cv::estimateAffinePartial2D with a flag of this module or of OpenCV.
@param from N points of image 1
@param to their counterparts in image 2
@param inliers output, Nx1, CV_8U, 1 for inliers
@param method value of a #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold, distance in image 2 in pixels
@param maxIters maximum number of samples
@param confidence confidence of the search, see usacv20::Params::confidence
@param refineIters maximum number of steps of the final polishing; 0: none
@return 2x3, CV_64F, rows (a, -b, x) and (b, a, y): rotation, uniform scale and translation; empty
if there is none
*/
CV_EXPORTS_W Mat estimateAffinePartial2D(InputArray from, InputArray to,
                                         OutputArray inliers = noArray(), int method = (int)USACV20,
                                         double ransacReprojThreshold = 3, size_t maxIters = 2000,
                                         double confidence = 0.99, size_t refineIters = 10);
//! @}

/** @name The same functions with a flag that is known at compile time
They are templates so that a call without a namespace is not ambiguous after `using namespace cv`
and `using namespace cv::usacv20`.
@{ */
//! cv::estimateAffine2D with the same arguments.
template <typename... Others>
Mat estimateAffine2D(InputArray from, InputArray to, OutputArray inliers, UsacV20Method method,
                     Others&&... others)
{
    return cv::estimateAffine2D(from, to, inliers, method, std::forward<Others>(others)...);
}

//! cv::estimateAffinePartial2D with the same arguments.
template <typename... Others>
Mat estimateAffinePartial2D(InputArray from, InputArray to, OutputArray inliers,
                            UsacV20Method method, Others&&... others)
{
    return cv::estimateAffinePartial2D(from, to, inliers, method, std::forward<Others>(others)...);
}
//! @}

}  // namespace usacv20

//! @}

}  // namespace cv

#endif
