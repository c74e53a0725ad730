// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_USAC_HPP
#define OPENCV_USACV20_PYTHON_USAC_HPP

// Only the Python bindings see this file: cv2.usacv20.find* with the arguments, their order and their defaults of the
// Python functions cv2.find*. The functions of usac.hpp cannot be bound themselves: they have the names of calib3d's, and
// the generator would try calib3d's first, which take a flag of this module for an int.

#include "opencv2/usac.hpp"

namespace cv {
namespace usacv20 {

/** @brief cv::findHomography with a flag of this module, or with usacv20::Params.
@param srcPoints points of image 1
@param dstPoints their counterparts in image 2
@param method one of #UsacV20Method
@param ransacReprojThreshold inlier threshold in pixels
@param mask output, Nx1, 1 for inliers
@param maxIters upper bound of the number of samples
@param confidence probability that the result is the best model
*/
CV_EXPORTS_W inline Mat findHomography(InputArray srcPoints, InputArray dstPoints, int method = USACV20,
                                       double ransacReprojThreshold = 3, OutputArray mask = noArray(),
                                       const int maxIters = 2000, const double confidence = 0.995)
{
    return cv::findHomography(srcPoints, dstPoints, methodFromInt(method), ransacReprojThreshold, mask, maxIters,
                              confidence);
}

//! @overload
CV_EXPORTS_W inline Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                                       const Params& params)
{
    return cv::findHomography(srcPoints, dstPoints, mask, params);
}

/** @brief cv::findFundamentalMat with a flag of this module, or with usacv20::Params.
@param points1 points of image 1
@param points2 their counterparts in image 2
@param method one of #UsacV20Method
@param ransacReprojThreshold inlier threshold in pixels
@param confidence probability that the result is the best model
@param maxIters upper bound of the number of samples; its default makes a None in this place, meant for `mask`, harmless
@param mask output, Nx1, 1 for inliers
*/
CV_EXPORTS_W inline Mat findFundamentalMat(InputArray points1, InputArray points2, int method,
                                           double ransacReprojThreshold, double confidence, int maxIters = 1000,
                                           OutputArray mask = noArray())
{
    return cv::findFundamentalMat(points1, points2, methodFromInt(method), ransacReprojThreshold, confidence, maxIters,
                                  mask);
}

//! @overload
CV_EXPORTS_W inline Mat findFundamentalMat(InputArray points1, InputArray points2, int method = USACV20,
                                           double ransacReprojThreshold = 3., double confidence = 0.99,
                                           OutputArray mask = noArray())
{
    return cv::findFundamentalMat(points1, points2, methodFromInt(method), ransacReprojThreshold, confidence, mask);
}

//! @overload
CV_EXPORTS_W inline Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                           const Params& params)
{
    return cv::findFundamentalMat(points1, points2, mask, params);
}

/** @brief cv::findEssentialMat with a flag of this module, or with usacv20::Params.
@param points1 points of image 1
@param points2 their counterparts in image 2
@param cameraMatrix camera matrix of both images
@param method one of #UsacV20Method
@param prob probability that the result is the best model
@param threshold inlier threshold in pixels
@param maxIters upper bound of the number of samples
@param mask output, Nx1, 1 for inliers
*/
CV_EXPORTS_W inline Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                         int method = USACV20, double prob = 0.999, double threshold = 1.0,
                                         int maxIters = 1000, OutputArray mask = noArray())
{
    return cv::findEssentialMat(points1, points2, cameraMatrix, methodFromInt(method), prob, threshold, maxIters, mask);
}

//! @overload
CV_EXPORTS_W inline Mat findEssentialMat(InputArray points1, InputArray points2, double focal = 1.0,
                                         Point2d pp = Point2d(0, 0), int method = USACV20, double prob = 0.999,
                                         double threshold = 1.0, int maxIters = 1000, OutputArray mask = noArray())
{
    return cv::findEssentialMat(points1, points2, focal, pp, methodFromInt(method), prob, threshold, maxIters, mask);
}

//! @overload
CV_EXPORTS_W inline Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                         InputArray distCoeffs1, InputArray cameraMatrix2, InputArray distCoeffs2,
                                         int method = USACV20, double prob = 0.999, double threshold = 1.0,
                                         OutputArray mask = noArray())
{
    return cv::findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2,
                                methodFromInt(method), prob, threshold, mask);
}

//! @overload
CV_EXPORTS_W inline Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                         InputArray cameraMatrix2, InputArray dist_coeff1, InputArray dist_coeff2,
                                         OutputArray mask, const Params& params)
{
    return cv::findEssentialMat(points1, points2, cameraMatrix1, cameraMatrix2, dist_coeff1, dist_coeff2, mask, params);
}

} // namespace usacv20
} // namespace cv

#endif
