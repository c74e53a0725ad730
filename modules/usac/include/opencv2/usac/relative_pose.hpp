// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RELATIVE_POSE_HPP
#define OPENCV_USACV20_RELATIVE_POSE_HPP

#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

//! Results of #estimateRelativePose other than the motion.
struct CV_EXPORTS_W_SIMPLE RelativePose
{
    CV_WRAP RelativePose();

    //! Report on the search for the essential matrix. Its `inliers` and `independentInliers` count
    //! only inliers in front of both cameras, like the mask. If the returned motion is not that of
    //! the model found, but the second motion that explains a dominant plane, then `sigma`,
    //! `covariance` and `cost` belong to the second motion (with an estimated threshold: to its own
    //! threshold), `sample` is empty, and `priorChance` is 0.
    CV_PROP_RW Report report;
    //! The essential matrix [t]x R, 3x3, CV_64F, singular values (1, 1, 0)/sqrt(2); empty if there
    //! is none.
    CV_PROP_RW Mat essential;
    //! Number of inliers of the essential matrix whose triangulated points are not in front of both
    //! cameras; their rows of the mask are 0.
    CV_PROP_RW int behind;
    //! Number of inliers on a dominant plane (more than 80 % of all inliers); 0 if there is none,
    //! if the camera has only rotated, or if the run was stopped before the end of the search for
    //! the plane (`report.stop` is then #STOP_TIME or #STOP_CANCELLED).
    CV_PROP_RW int onPlane;
    //! Of the two motions that are compatible with a dominant plane, rotation of the motion that is
    //! not returned, 3x3, CV_64F. Empty if there is no such motion.
    CV_PROP_RW Mat otherR;
    //! Translation of the same motion, 3x1, CV_64F, unit length; empty if `otherR` is empty.
    CV_PROP_RW Mat otherT;
    //! Number of inliers of the same motion in front of both cameras.
    CV_PROP_RW int otherInliers;
};

/** @brief Estimates the motion of a calibrated camera between two views: X2 = R X1 + t up to the
length of t.

@param points1 N points of the original (distorted) image 1 in pixels; layouts as in
#estimateHomography
@param points2 their N counterparts in image 2
@param cameraMatrix1 3x3 camera matrix of image 1
@param distCoeffs1 4, 5, 8, 12 or 14 distortion coefficients of camera 1; empty: none
@param cameraMatrix2 3x3 camera matrix of image 2; empty: that of image 1
@param distCoeffs2 distortion of camera 2; empty: none
@param params options; `threshold` is the maximum Sampson distance in pixels, as in
#estimateEssential
@param R output, 3x3, CV_64F, a rotation; empty if there is no model
@param t output, 3x1, CV_64F, unit length: two views do not determine the scale
@param mask output, N x 1, CV_8U: 1 where the Sampson distance is at most the threshold and the
triangulated point is in front of both cameras; a point that could be at infinity within the noise
counts as in front
@param pose output: the report, the essential matrix, and for a dominant plane the other motion
@return true if there is a model.

Of the four motions that are compatible with an essential matrix, the function returns the one
with the most inliers in front of both cameras (@cite nister2004efficient), of at most 500
inliers; unlike in cv::recoverPose, points at any distance count. A plane is compatible with two
motions (@cite ma2004invitation). If there is a dominant plane, the motion with the smaller sum of
truncated squared errors over all points is returned, so that the points off the plane decide; the
other motion is in `pose`. If there are no points off the plane, the two motions have about the
same number of inliers. */
CV_EXPORTS_W bool estimateRelativePose(InputArray points1, InputArray points2,
                                       InputArray cameraMatrix1, InputArray distCoeffs1,
                                       InputArray cameraMatrix2, InputArray distCoeffs2,
                                       const Params& params, OutputArray R, OutputArray t,
                                       OutputArray mask, CV_OUT RelativePose& pose);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
