// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_FIND_HPP
#define OPENCV_USACV20_FIND_HPP

#include <utility>
#include "opencv2/usac/geometry.hpp"
#include "opencv2/usac/params.hpp"

namespace cv {

//! @addtogroup usacv20
//! @{

/** @name The functions of calib3d with a flag of this module
There is an overload for every signature of cv::findHomography, cv::findFundamentalMat and
cv::findEssentialMat, with the same meaning, order and defaults of the arguments. Overload
resolution picks these functions for a #UsacV20Method, and those of calib3d for an `int`. If an
`int` can hold a flag of this module, call usacv20::findHomography, usacv20::findFundamentalMat and
usacv20::findEssentialMat instead. The results are those of usacv20::estimateHomography,
usacv20::estimateFundamental and usacv20::estimateEssential. The functions with a flag do not report
whether `maxIters` ended the search. To find out, call an `estimate` function with the options of
the flag (usacv20::Params::fromMethod), and compare usacv20::Report::stop with
usacv20::STOP_MAX_ITERATIONS.

An invalid argument raises a cv::Exception whose message begins with the name of the argument in
these signatures, or with the name of the field of Params.
@{ */
//! A homography; arguments and result as in usacv20::findHomography.
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method,
                              double ransacReprojThreshold = 3, OutputArray mask = noArray(),
                              const int maxIters = 2000, const double confidence = 0.995);
//! @overload
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              UsacV20Method method, double ransacReprojThreshold = 3);
//! With all options, like usacv20::estimateHomography.
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              const usacv20::Params& params);
//! The same, with the argument order of Python.
inline Mat findHomography(InputArray srcPoints, InputArray dstPoints, const usacv20::Params& params,
                          OutputArray mask = noArray())
{
    return findHomography(srcPoints, dstPoints, mask, params);
}

//! A fundamental matrix; arguments and result as in usacv20::findFundamentalMat.
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                                  double ransacReprojThreshold, double confidence, int maxIters,
                                  OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                                  double ransacReprojThreshold = 3., double confidence = 0.99,
                                  OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                  UsacV20Method method, double ransacReprojThreshold = 3.,
                                  double confidence = 0.99);
//! With all options, like usacv20::estimateFundamental.
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                  const usacv20::Params& params);
//! The same, with the argument order of Python.
inline Mat findFundamentalMat(InputArray points1, InputArray points2, const usacv20::Params& params,
                              OutputArray mask = noArray())
{
    return findFundamentalMat(points1, points2, mask, params);
}

//! An essential matrix; arguments and result as in usacv20::findEssentialMat.
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                UsacV20Method method, double prob = 0.999, double threshold = 1.0,
                                int maxIters = 1000, OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                UsacV20Method method, double prob, double threshold,
                                OutputArray mask);
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                                UsacV20Method method, double prob = 0.999, double threshold = 1.0,
                                int maxIters = 1000, OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                                UsacV20Method method, double prob, double threshold,
                                OutputArray mask);
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                InputArray distCoeffs1, InputArray cameraMatrix2,
                                InputArray distCoeffs2, UsacV20Method method, double prob = 0.999,
                                double threshold = 1.0, OutputArray mask = noArray());
//! With all options, like usacv20::estimateEssential.
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                InputArray cameraMatrix2, InputArray dist_coeff1,
                                InputArray dist_coeff2, OutputArray mask,
                                const usacv20::Params& params);
//! The same, with the argument order of Python.
inline Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                            InputArray cameraMatrix2, InputArray dist_coeff1,
                            InputArray dist_coeff2, const usacv20::Params& params,
                            OutputArray mask = noArray())
{
    return findEssentialMat(points1, points2, cameraMatrix1, cameraMatrix2, dist_coeff1,
                            dist_coeff2, mask, params);
}
//! @}

namespace usacv20 {

/** @name The functions of calib3d with an `int` flag, of this module or of OpenCV
There is a function for every signature of cv::findHomography, cv::findFundamentalMat and
cv::findEssentialMat that has an `int method`, with the same meaning, order and defaults of the
arguments, except that an omitted `method` is UsacV20Method::USACV20. If `method` is the value of a
#UsacV20Method, the result is that of cv::findHomography and similar functions with this flag; if it
is one of OpenCV's own flags, the call is passed on to calib3d unchanged. Any other number outside
0..63, the range of OpenCV's flags, raises a cv::Exception that names `method`.

After both `using namespace cv` and `using namespace cv::usacv20`, a call with an `int` must name
the namespace, `usacv20::findHomography(...)`, because calib3d's function matches equally well.
@{ */
/** @brief cv::findHomography with a flag of this module or of OpenCV.
@param srcPoints N points of image 1
@param dstPoints their counterparts in image 2
@param method value of a #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold in pixels
@param mask output, Nx1, CV_8U, 1 for inliers
@param maxIters maximum number of samples
@param confidence confidence of the search, see usacv20::Params::confidence
@return 3x3, CV_64F; empty if there is none
*/
CV_EXPORTS_W Mat findHomography(InputArray srcPoints, InputArray dstPoints,
                                int method = (int)USACV20, double ransacReprojThreshold = 3,
                                OutputArray mask = noArray(), const int maxIters = 2000,
                                const double confidence = 0.995);
//! @overload
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              int method = (int)USACV20, double ransacReprojThreshold = 3);

/** @brief cv::findFundamentalMat with a flag of this module or of OpenCV.
@param points1 N points of image 1
@param points2 their counterparts in image 2
@param method value of a #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold in pixels
@param confidence confidence of the search, see usacv20::Params::confidence
@param maxIters maximum number of samples. In Python, its default is 1000, so that None at this
position, meant for `mask`, does not raise an error
@param mask output, Nx1, CV_8U, 1 for inliers
@return 3x3, CV_64F (with OpenCV's flags and seven points up to three matrices, stacked as 9x3);
empty if there is none
*/
CV_EXPORTS_W Mat findFundamentalMat(InputArray points1, InputArray points2, int method,
                                    double ransacReprojThreshold, double confidence,
                                    int maxIters CV_WRAP_DEFAULT(1000),
                                    OutputArray mask = noArray());
//! @overload
CV_EXPORTS_W Mat findFundamentalMat(InputArray points1, InputArray points2,
                                    int method = (int)USACV20, double ransacReprojThreshold = 3.,
                                    double confidence = 0.99, OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                  int method = (int)USACV20, double ransacReprojThreshold = 3.,
                                  double confidence = 0.99);

/** @brief cv::findEssentialMat with a flag of this module or of OpenCV.
@param points1 N points of image 1 in pixels
@param points2 their counterparts in image 2
@param cameraMatrix 3x3 camera matrix of both images
@param method value of a #UsacV20Method, or a flag of OpenCV
@param prob confidence of the search, see usacv20::Params::confidence
@param threshold inlier threshold in pixels
@param maxIters maximum number of samples
@param mask output, Nx1, CV_8U, 1 for inliers
@return 3x3, CV_64F (with OpenCV's flags and five points up to ten matrices, stacked as 30x3); empty
if there is none
*/
CV_EXPORTS_W Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                  int method = (int)USACV20, double prob = 0.999,
                                  double threshold = 1.0, int maxIters = 1000,
                                  OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                int method, double prob, double threshold, OutputArray mask);
/** @overload
@param points1 N points of image 1 in pixels
@param points2 their counterparts in image 2
@param focal focal length of both cameras in pixels
@param pp principal point of both cameras in pixels
@param method value of a #UsacV20Method, or a flag of OpenCV
@param prob confidence of the search, see usacv20::Params::confidence
@param threshold inlier threshold in pixels
@param maxIters maximum number of samples
@param mask output, Nx1, CV_8U, 1 for inliers
*/
CV_EXPORTS_W Mat findEssentialMat(InputArray points1, InputArray points2, double focal = 1.0,
                                  Point2d pp = Point2d(0, 0), int method = (int)USACV20,
                                  double prob = 0.999, double threshold = 1.0, int maxIters = 1000,
                                  OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                                int method, double prob, double threshold, OutputArray mask);
/** @overload
@param points1 N points of image 1 in pixels
@param points2 their counterparts in image 2
@param cameraMatrix1 3x3 camera matrix of image 1
@param distCoeffs1 distortion of camera 1, as in cv::undistortPoints; empty: none
@param cameraMatrix2 3x3 camera matrix of image 2
@param distCoeffs2 distortion of camera 2; empty: none
@param method value of a #UsacV20Method, or a flag of OpenCV
@param prob confidence of the search, see usacv20::Params::confidence
@param threshold inlier threshold in pixels
@param mask output, Nx1, CV_8U, 1 for inliers
*/
CV_EXPORTS_W Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                  InputArray distCoeffs1, InputArray cameraMatrix2,
                                  InputArray distCoeffs2, int method = (int)USACV20,
                                  double prob = 0.999, double threshold = 1.0,
                                  OutputArray mask = noArray());
//! Deleted, because an `int` as third argument would be converted to a focal length, although it is
//! probably a flag in a call without a camera.
Mat findEssentialMat(InputArray points1, InputArray points2, int method) = delete;
//! @}

/** @name The same functions with a flag that is known at compile time
They call cv::findHomography, cv::findFundamentalMat and cv::findEssentialMat with the same
arguments. They are templates so that a call without a namespace is not ambiguous after `using
namespace cv` and `using namespace cv::usacv20`.
@{ */
//! cv::findHomography with the same arguments.
template <typename... Others>
Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method,
                   Others&&... others)
{
    return cv::findHomography(srcPoints, dstPoints, method, std::forward<Others>(others)...);
}

//! cv::findHomography with the same arguments.
template <typename... Others>
Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                   UsacV20Method method, Others&&... others)
{
    return cv::findHomography(srcPoints, dstPoints, mask, method, std::forward<Others>(others)...);
}

//! cv::findFundamentalMat with the same arguments.
template <typename... Others>
Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                       Others&&... others)
{
    return cv::findFundamentalMat(points1, points2, method, std::forward<Others>(others)...);
}

//! cv::findFundamentalMat with the same arguments.
template <typename... Others>
Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                       UsacV20Method method, Others&&... others)
{
    return cv::findFundamentalMat(points1, points2, mask, method, std::forward<Others>(others)...);
}

//! cv::findEssentialMat with the same arguments.
template <typename... Others>
Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                     UsacV20Method method, Others&&... others)
{
    return cv::findEssentialMat(points1, points2, cameraMatrix, method,
                                std::forward<Others>(others)...);
}

//! cv::findEssentialMat with the same arguments.
template <typename... Others>
Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                     UsacV20Method method, Others&&... others)
{
    return cv::findEssentialMat(points1, points2, focal, pp, method,
                                std::forward<Others>(others)...);
}

//! cv::findEssentialMat with the same arguments.
template <typename... Others>
Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                     InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
                     UsacV20Method method, Others&&... others)
{
    return cv::findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2,
                                distCoeffs2, method, std::forward<Others>(others)...);
}
//! @}

}  // namespace usacv20

//! @}

}  // namespace cv

#endif
