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

/** @name The functions of calib3d with a flag of this module Every signature of cv::findHomography,
cv::findFundamentalMat and cv::findEssentialMat, with the same meaning, order and defaults of the
arguments. Overload resolution picks these for a #UsacV20Method, and the old ones for an `int`; an
`int` that may hold a flag of this module is for usacv20::findHomography,
usacv20::findFundamentalMat and usacv20::findEssentialMat. Results are those of
usacv20::estimateHomography, usacv20::estimateFundamental and usacv20::estimateEssential. A flag
does not tell whether `maxIters` ended the search: one of these three functions does, called with
the flag's options (usacv20::Params::fromMethod), by usacv20::Report::stop ==
usacv20::STOP_MAX_ITERATIONS.

A mistake raises a cv::Exception whose message begins with the name of the argument in these
signatures; a field of a Params has the name that it has there.
@{ */
//! A homography; arguments and result as of usacv20::findHomography.
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method,
                              double ransacReprojThreshold = 3, OutputArray mask = noArray(),
                              const int maxIters = 2000, const double confidence = 0.995);
//! @overload
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              UsacV20Method method, double ransacReprojThreshold = 3);
//! With all options, as usacv20::estimateHomography.
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              const usacv20::Params& params);
//! The same, in the order of Python.
inline Mat findHomography(InputArray srcPoints, InputArray dstPoints, const usacv20::Params& params,
                          OutputArray mask = noArray())
{
    return findHomography(srcPoints, dstPoints, mask, params);
}

//! A fundamental matrix; arguments and result as of usacv20::findFundamentalMat.
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
//! With all options, as usacv20::estimateFundamental.
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                  const usacv20::Params& params);
//! The same, in the order of Python.
inline Mat findFundamentalMat(InputArray points1, InputArray points2, const usacv20::Params& params,
                              OutputArray mask = noArray())
{
    return findFundamentalMat(points1, points2, mask, params);
}

//! An essential matrix; arguments and result as of usacv20::findEssentialMat.
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
//! With all options, as usacv20::estimateEssential.
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                InputArray cameraMatrix2, InputArray dist_coeff1,
                                InputArray dist_coeff2, OutputArray mask,
                                const usacv20::Params& params);
//! The same, in the order of Python.
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

/** @name The functions of calib3d with any flag, known only at run time Every signature of
cv::findHomography, cv::findFundamentalMat and cv::findEssentialMat that has an `int method`, with
the same meaning, order and defaults of the arguments, but UsacV20Method::USACV20 for a `method`
that is left out. The method is the value of a #UsacV20Method, and the result that of
cv::findHomography and its kin with this flag; or it is one of OpenCV's own flags, and the call is
handed on to calib3d as it is. A number that is neither (OpenCV's flags are among 0 .. 63) raises a
cv::Exception that names `method`.

Below `using namespace cv` and `using namespace cv::usacv20` together, a call with an `int` has to
name the namespace, `usacv20::findHomography(...)`: calib3d's function is as good a match.
@{ */
/** @brief cv::findHomography with a flag of this module or of OpenCV.
@param srcPoints N points of image 1
@param dstPoints their counterparts in image 2
@param method value of one of #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold in pixels
@param mask output, Nx1, CV_8U, 1 for inliers
@param maxIters upper bound of the number of samples
@param confidence probability that the result is the best model
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
@param method value of one of #UsacV20Method, or a flag of OpenCV
@param ransacReprojThreshold inlier threshold in pixels
@param confidence probability that the result is the best model
@param maxIters upper bound of the number of samples; its default in Python makes a None in this
place, meant for `mask`, harmless
@param mask output, Nx1, CV_8U, 1 for inliers
@return 3x3, CV_64F (with OpenCV's flags and seven points up to three of them in 9x3); empty if
there is none
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
@param method value of one of #UsacV20Method, or a flag of OpenCV
@param prob probability that the result is the best model
@param threshold inlier threshold in pixels
@param maxIters upper bound of the number of samples
@param mask output, Nx1, CV_8U, 1 for inliers
@return 3x3, CV_64F (with OpenCV's flags and five points up to ten of them in 30x3); empty if there
is none
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
@param method value of one of #UsacV20Method, or a flag of OpenCV
@param prob probability that the result is the best model
@param threshold inlier threshold in pixels
@param maxIters upper bound of the number of samples
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
@param method value of one of #UsacV20Method, or a flag of OpenCV
@param prob probability that the result is the best model
@param threshold inlier threshold in pixels
@param mask output, Nx1, CV_8U, 1 for inliers
*/
CV_EXPORTS_W Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                  InputArray distCoeffs1, InputArray cameraMatrix2,
                                  InputArray distCoeffs2, int method = (int)USACV20,
                                  double prob = 0.999, double threshold = 1.0,
                                  OutputArray mask = noArray());
//! Does not compile: an `int` in the third place is a flag for which the camera has been forgotten,
//! not a focal length.
Mat findEssentialMat(InputArray points1, InputArray points2, int method) = delete;
//! @}

/** @name The same with a flag that is known when the program is compiled They call
cv::findHomography, cv::findFundamentalMat and cv::findEssentialMat with the same arguments. They
are templates, which keeps a call without a namespace below both using-directives from being
ambiguous.
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
