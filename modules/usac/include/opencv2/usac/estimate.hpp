// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_ESTIMATE_HPP
#define OPENCV_USACV20_ESTIMATE_HPP

#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief Estimates the homography that maps image 1 to image 2.

@param points1 N points of image 1 in any layout and depth that OpenCV takes with one flag or
another: a matrix with 2 channels (Nx1, 1xN, any), or with 1 channel, Nx2 or 2xN; vector<Point>,
vector<Point2f>, vector<Point2d> etc. 3 in the place of 2 (vector<Point3f>, Nx3, 3xN): homogeneous
coordinates; a third one of 0 is a point at infinity and never an inlier. (x, y, size) and (x, y,
confidence) cannot be told from these for certain, and are divided, too. 4 or more: the first two
count. With 1 channel the longer side counts the points, with equal sides the rows do; one row or
column is one point.
@param points2 their N counterparts in image 2; layout and depth may differ.
@param params options; `threshold` is the distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned H is at most the
threshold, else 0.
@param report output, what the run learned.
@return 3x3, CV_64F, with h33 = 1 (unit Frobenius norm where h33 is 0); empty if there is none, and
`report` says why.

Points with NaN or infinite coordinates are never inliers. Raises cv::Exception for lists of
different lengths, points of a wrong shape and wrong parameters. @cite ivashechkin2021usacv20
*/
CV_EXPORTS_W Mat estimateHomography(InputArray points1, InputArray points2, const Params& params,
                                    OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateHomography(InputArray points1, InputArray points2,
                                  const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the affine map of image 1 to image 2, x2 = A x1 + t.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, what the run learned.
@return 2x3, CV_64F, [A t], as cv::estimateAffine2D and cv::warpAffine have it; empty if there is
none, and `report` says why.
*/
CV_EXPORTS_W Mat estimateAffinity2D(InputArray points1, InputArray points2, const Params& params,
                                    OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateAffinity2D(InputArray points1, InputArray points2,
                                  const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the rotation, uniform scale and translation of image 1 to image 2.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, what the run learned.
@return 2x3, CV_64F, rows a -b x and b a y, as of cv::estimateAffinePartial2D; empty if there is
none, and `report` says why.
*/
CV_EXPORTS_W Mat estimateSimilarity2D(InputArray points1, InputArray points2, const Params& params,
                                      OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateSimilarity2D(InputArray points1, InputArray points2,
                                    const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the fundamental matrix F with x2^T F x1 = 0.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the Sampson distance in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the Sampson distance under the returned F is at most
the threshold, else 0.
@param report output, what the run learned.
@return 3x3, CV_64F, rank 2, unit Frobenius norm; empty if there is none, and `report` says why.
*/
CV_EXPORTS_W Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params,
                                     OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateFundamental(InputArray points1, InputArray points2,
                                   const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

@param points1 N points of image 1 in pixels, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param cameraMatrix1 3x3 camera matrix of image 1, of any depth, with the last row 0 0 1 or a
multiple of such a matrix; skew is allowed. A transposed one is refused.
@param cameraMatrix2 3x3 camera matrix of image 2; empty: that of image 1.
@param distCoeffs1 4, 5, 8, 12 or 14 coefficients of the distortion of camera 1, as in
cv::undistortPoints; empty: none.
@param distCoeffs2 distortion of camera 2; empty: none.
@param params options; `threshold` is the Sampson distance in pixels: it is divided by the mean of
the four focal lengths.
@param mask output, Nx1, CV_8U: 1 exactly where the Sampson distance of the normalized points under
the returned E is at most threshold / mean focal length, else 0.
@param report output, what the run learned.
@return 3x3, CV_64F, singular values (1, 1, 0)/sqrt(2); empty if there is none, and `report` says
why.
*/
CV_EXPORTS_W Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                   InputArray cameraMatrix2, InputArray distCoeffs1,
                                   InputArray distCoeffs2, const Params& params, OutputArray mask,
                                   CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                 const Params& params = Params(), OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                 const Params& params, OutputArray mask, Report& report);

/** @brief Estimates the pose of a calibrated camera from points of space and their images: x ~ K (R
X + t).

@param objectPoints N points of space: N x 3 or 3 x N with 1 channel, or with 3 channels, any depth.
@param imagePoints their N images in pixels, as the points of #estimateHomography.
@param cameraMatrix 3x3 camera matrix K.
@param distCoeffs 4, 5, 8, 12 or 14 coefficients of the distortion, as for cv::projectPoints; empty:
none.
@param params options; `threshold` is the reprojection error in pixels, in the image as it was
taken.
@param mask output, Nx1, CV_8U: 1 exactly where a point is in front of the camera and its
reprojection error, distortion included, is at most the threshold, else 0.
@param report output, what the run learned.
@return 3x4, CV_64F, [R t]; empty if there is none, and `report` says why. cv::Rodrigues turns R
into a vector.

Minimal samples have three points @cite persson2018lambda @cite ding2023revisiting. Points that
share a point of space or of the image are not in one sample. A plane of points is no special case.
The search takes the distortion off the points; the last polishing and the mask see them as they
were taken. */
CV_EXPORTS_W Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints,
                                      InputArray cameraMatrix, InputArray distCoeffs,
                                      const Params& params, OutputArray mask,
                                      CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints,
                                    InputArray cameraMatrix, InputArray distCoeffs = noArray(),
                                    const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the rotation and translation of space that take points to their counterparts:
X2 = R X1 + t.

@param points1 N points of space 1: N x 3 or 3 x N with 1 channel, or with 3 channels, any depth.
@param points2 their N counterparts in space 2, in the same unit.
@param params options; `threshold` is the distance in space 2, in the unit of the points, so that
its default will rarely do.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned motion is at most
the threshold, else 0.
@param report output, what the run learned.
@return 3x4, CV_64F, [R t]; empty if there is none, and `report` says why.

Minimal samples have three points @cite horn1987closed; many points are fitted in closed form
@cite umeyama1991least. Points on a line determine no rotation. Points with NaN or infinite
coordinates, as depth cameras give them, are never inliers. */
CV_EXPORTS_W Mat estimateRigid3D(InputArray points1, InputArray points2, const Params& params,
                                 OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateRigid3D(InputArray points1, InputArray points2,
                               const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates rotation, uniform scale and translation of space: X2 = s R X1 + t, s > 0.

As of a reconstruction whose unit is unknown to points that were measured.

@param points1 N points of space 1, as in #estimateRigid3D, in any unit.
@param points2 their N counterparts in space 2.
@param params options; `threshold` is the distance in space 2, in the unit of `points2`.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, what the run learned.
@return 3x4, CV_64F, [s R t]; empty if there is none, and `report` says why. */
CV_EXPORTS_W Mat estimateSimilarity3D(InputArray points1, InputArray points2, const Params& params,
                                      OutputArray mask, CV_OUT Report& report);
//! @overload
CV_EXPORTS Mat estimateSimilarity3D(InputArray points1, InputArray points2,
                                    const Params& params = Params(), OutputArray mask = noArray());

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
