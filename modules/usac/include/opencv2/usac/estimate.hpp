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

#ifndef OPENCV_BINDING_PARSER  // the packages for other languages call #estimateModel instead

/** @brief Estimates the homography that maps image 1 to image 2.

@param points1 N points of image 1 in any layout and depth that some function of OpenCV accepts: a
matrix with 2 channels (Nx1, 1xN or any other shape), or with 1 channel, Nx2 or 2xN; vector<Point>,
vector<Point2f>, vector<Point2d> etc. With 3 coordinates instead of 2 (vector<Point3f>, Nx3, 3xN)
the points are homogeneous; a point whose third coordinate is 0 is at infinity and never an inlier.
Rows (x, y, size) or (x, y, confidence) cannot be distinguished from homogeneous points and are
divided by the third number, too. Of 4 or more numbers per point, the first two are used. With 1
channel, the longer side is the number of points; if both sides are equal, each row is a point; a
single row or column is one point.
@param points2 their N counterparts in image 2; layout and depth can differ from those of `points1`.
@param params options; `threshold` is the maximum distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned H is at most the
threshold, else 0.
@param report output, statistics of the run.
@return 3x3, CV_64F, with h33 = 1 (unit Frobenius norm if h33 is nearly 0); empty if there is none,
and `report` says why.

Points with NaN or infinite coordinates are never inliers. Raises cv::Exception for lists of
different lengths, points of the wrong shape and invalid parameters. @cite ivashechkin2021usacv20
*/
CV_EXPORTS Mat estimateHomography(InputArray points1, InputArray points2, const Params& params,
                                  OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateHomography(InputArray points1, InputArray points2,
                                  const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the affine map from image 1 to image 2, x2 = A x1 + t.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the maximum distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, statistics of the run.
@return 2x3, CV_64F, [A t], as returned by cv::estimateAffine2D and used by cv::warpAffine; empty if
there is none, and `report` says why.
*/
CV_EXPORTS Mat estimateAffinity2D(InputArray points1, InputArray points2, const Params& params,
                                  OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateAffinity2D(InputArray points1, InputArray points2,
                                  const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the similarity (rotation, uniform scale and translation) from image 1 to image
2.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the maximum distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, statistics of the run.
@return 2x3, CV_64F, rows (a, -b, x) and (b, a, y), as returned by cv::estimateAffinePartial2D;
empty if there is none, and `report` says why.
*/
CV_EXPORTS Mat estimateSimilarity2D(InputArray points1, InputArray points2, const Params& params,
                                    OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateSimilarity2D(InputArray points1, InputArray points2,
                                    const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the fundamental matrix F with x2^T F x1 = 0.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the maximum Sampson distance in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the Sampson distance under the returned F is at most
the threshold, else 0.
@param report output, statistics of the run.
@return 3x3, CV_64F, rank 2, unit Frobenius norm; empty if there is none, and `report` says why.
*/
CV_EXPORTS Mat estimateFundamental(InputArray points1, InputArray points2, const Params& params,
                                   OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateFundamental(InputArray points1, InputArray points2,
                                   const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the essential matrix E with (K2^-1 x2)^T E (K1^-1 x1) = 0.

@param points1 N points of image 1 in pixels, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param cameraMatrix1 3x3 camera matrix of image 1, of any depth, with the last row (0, 0, 1), or a
multiple of such a matrix; skew is allowed. A transposed matrix raises cv::Exception.
@param cameraMatrix2 3x3 camera matrix of image 2; empty: that of image 1.
@param distCoeffs1 4, 5, 8, 12 or 14 coefficients of the distortion of camera 1, as in
cv::undistortPoints; empty: none.
@param distCoeffs2 distortion of camera 2; empty: none.
@param params options; `threshold` is the maximum Sampson distance in pixels. On the normalized
image planes, a pixel is the mean of 1 / f over both cameras, with f = (fx + fy) / 2. If the cameras
differ, it is thus smaller than a pixel of the camera with the shorter focal length and larger than
that of the other.
@param mask output, Nx1, CV_8U: 1 exactly where the Sampson distance of the normalized points under
the returned E is at most threshold times the mean of 1 / f, else 0.
@param report output, statistics of the run.
@return 3x3, CV_64F, singular values (1, 1, 0)/sqrt(2); empty if there is none, and `report` says
why.
*/
CV_EXPORTS Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix1,
                                 InputArray cameraMatrix2, InputArray distCoeffs1,
                                 InputArray distCoeffs2, const Params& params, OutputArray mask,
                                 Report& report);
//! @overload
CV_EXPORTS Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                 const Params& params = Params(), OutputArray mask = noArray());
//! @overload
CV_EXPORTS Mat estimateEssential(InputArray points1, InputArray points2, InputArray cameraMatrix,
                                 const Params& params, OutputArray mask, Report& report);

/** @brief Estimates the pose of a calibrated camera from 3-D points and their images: x ~ K (R X +
t).

@param objectPoints N 3-D points: N x 3 or 3 x N with 1 channel, or with 3 channels, any depth.
@param imagePoints their N images in pixels, in the layouts of #estimateHomography.
@param cameraMatrix 3x3 camera matrix K.
@param distCoeffs 4, 5, 8, 12 or 14 coefficients of the distortion, as for cv::projectPoints; empty:
none.
@param params options; `threshold` is the maximum reprojection error in pixels, in the original
(distorted) image.
@param mask output, Nx1, CV_8U: 1 exactly where a point is in front of the camera and its
reprojection error, distortion included, is at most the threshold, else 0.
@param report output, statistics of the run.
@return 3x4, CV_64F, [R t]; empty if there is none, and `report` says why. cv::Rodrigues turns R
into a vector.

Minimal samples have three points @cite persson2018lambda @cite ding2023revisiting. If
Params::degeneracy contains #DEGENERACY_REPEATED, as by default, correspondences that share a 3-D
point or an image point are never in the same sample. Coplanar points need no special treatment. The
search uses undistorted points; the final polishing and the mask use the points of the original
image. */
CV_EXPORTS Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints,
                                    InputArray cameraMatrix, InputArray distCoeffs,
                                    const Params& params, OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateAbsolutePose(InputArray objectPoints, InputArray imagePoints,
                                    InputArray cameraMatrix, InputArray distCoeffs = noArray(),
                                    const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the rigid motion that maps 3-D points to their counterparts: X2 = R X1 + t.

@param points1 N 3-D points: N x 3 or 3 x N with 1 channel, or with 3 channels, any depth.
@param points2 their N counterparts, in the same unit.
@param params options; `threshold` is the maximum distance between R X1 + t and X2, in the unit of
the points; the default 1.5 is therefore rarely suitable.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned motion is at most
the threshold, else 0.
@param report output, statistics of the run.
@return 3x4, CV_64F, [R t]; empty if there is none, and `report` says why.

Minimal samples have three points @cite horn1987closed; many points are fitted in closed form
@cite umeyama1991least. Collinear points do not determine a rotation. Points with NaN or infinite
coordinates, which depth cameras produce, are never inliers. */
CV_EXPORTS Mat estimateRigid3D(InputArray points1, InputArray points2, const Params& params,
                               OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateRigid3D(InputArray points1, InputArray points2,
                               const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the similarity (rotation, uniform scale and translation) between 3-D points: X2
= s R X1 + t, s > 0.

An example is the map from a reconstruction of unknown scale to measured points.

@param points1 N 3-D points, as in #estimateRigid3D, in any unit.
@param points2 their N counterparts.
@param params options; `threshold` is the maximum distance between s R X1 + t and X2, in the unit
of `points2`.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, statistics of the run.
@return 3x4, CV_64F, [s R t]; empty if there is none, and `report` says why. */
CV_EXPORTS Mat estimateSimilarity3D(InputArray points1, InputArray points2, const Params& params,
                                    OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateSimilarity3D(InputArray points1, InputArray points2,
                                    const Params& params = Params(), OutputArray mask = noArray());

/** @brief Estimates the translation from image 1 to image 2, x2 = x1 + t.

@param points1 N points of image 1, as in #estimateHomography.
@param points2 their N counterparts in image 2.
@param params options; `threshold` is the maximum distance in image 2 in pixels.
@param mask output, Nx1, CV_8U: 1 exactly where the distance under the returned map is at most the
threshold, else 0.
@param report output, statistics of the run.
@return 2x3, CV_64F, rows (1, 0, x) and (0, 1, y), as used by cv::warpAffine and of the form of
#estimateAffinity2D; cv::estimateTranslation2D of OpenCV 5 returns its last column. Empty if there
is none, and `report` says why.

A minimal sample is one correspondence; a fit to many correspondences is their mean displacement. */
CV_EXPORTS Mat estimateTranslation2D(InputArray points1, InputArray points2, const Params& params,
                                     OutputArray mask, Report& report);
//! @overload
CV_EXPORTS Mat estimateTranslation2D(InputArray points1, InputArray points2,
                                     const Params& params = Params(), OutputArray mask = noArray());

#endif  // OPENCV_BINDING_PARSER

/** @brief Estimates a model of any kind, like #estimateHomography and similar functions, for a
program that selects the problem at run time.

@param problem what to estimate
@param points1 N points, in the layouts that the function of the problem accepts; #ABSOLUTE_POSE:
3-D points
@param points2 their N counterparts; #ABSOLUTE_POSE: image points
@param params options
@param mask output, N x 1, CV_8U: 1 exactly where the error of a point under the returned model is
at most the threshold
@param report output, statistics of the run.
@param cameraMatrix1 3x3, for #ESSENTIAL and #ABSOLUTE_POSE
@param cameraMatrix2 3x3, for #ESSENTIAL; empty: the same as `cameraMatrix1`
@param distCoeffs1 distortion of camera 1, for #ESSENTIAL and #ABSOLUTE_POSE; empty: none
@param distCoeffs2 distortion of camera 2, for #ESSENTIAL; empty: none
@return the model as the function of the problem returns it; empty if there is none, and `report`
says why. */
CV_EXPORTS_W Mat estimateModel(ProblemType problem, InputArray points1, InputArray points2,
                               const Params& params, OutputArray mask, CV_OUT Report& report,
                               InputArray cameraMatrix1 = noArray(),
                               InputArray cameraMatrix2 = noArray(),
                               InputArray distCoeffs1 = noArray(),
                               InputArray distCoeffs2 = noArray());

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
