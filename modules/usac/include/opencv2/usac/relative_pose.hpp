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

//! What #estimateRelativePose learned beside the motion.
struct CV_EXPORTS_W_SIMPLE RelativePose
{
    CV_WRAP RelativePose();

    //! Of the search for the essential matrix. `inliers` counts those that are in front of both
    //! cameras, as the mask.
    CV_PROP_RW Report report;
    //! The essential matrix [t]x R, 3x3, CV_64F, singular values (1, 1, 0)/sqrt(2); empty: no
    //! model.
    CV_PROP_RW Mat essential;
    //! Inliers of the essential matrix that are behind a camera, and not in the mask.
    CV_PROP_RW int behind;
    //! Inliers on one plane, if these are most of them (more than 80 %); else 0.
    CV_PROP_RW int onPlane;
    //! Of a plane: the rotation of the other motion that it allows, 3x3, CV_64F; empty: there is
    //! none.
    CV_PROP_RW Mat otherR;
    //! And its translation, 3x1, CV_64F, unit length.
    CV_PROP_RW Mat otherT;
    //! Points in front of both cameras that this other motion has within the threshold.
    CV_PROP_RW int otherInliers;
};

/** @brief Estimates the motion of a calibrated camera between two views: X2 = R X1 + t up to the
length of t.

@param points1 N points of image 1 in pixels, as it was taken; layouts as of #estimateHomography
@param points2 their N counterparts in image 2
@param cameraMatrix1 3x3 camera matrix of image 1
@param distCoeffs1 4, 5, 8, 12 or 14 coefficients of its distortion; empty: none
@param cameraMatrix2 3x3 camera matrix of image 2; empty: that of image 1
@param distCoeffs2 its distortion; empty: none
@param params options; `threshold` is the Sampson distance in pixels, as of #estimateEssential
@param R output, 3x3, CV_64F, a rotation; empty if there is no model
@param t output, 3x1, CV_64F, unit length: two views do not show how long it is
@param mask output, N x 1, CV_8U: 1 where the Sampson distance is at most the threshold and the
point, triangulated, is in front of both cameras; points at infinity are
@param pose output: the report, the essential matrix, and of a plane the other motion
@return true if there is a model.

Of the four motions that an essential matrix stands for, the one with most inliers in front of both
cameras is returned (@cite nister2004efficient), whatever their distance is. A plane has two motions
(@cite ma2004invitation): the points off it choose, by their errors; the other one is in `pose`, and
where there are no points off the plane `pose.otherInliers` is about the number of inliers. */
CV_EXPORTS_W bool estimateRelativePose(InputArray points1, InputArray points2,
                                       InputArray cameraMatrix1, InputArray distCoeffs1,
                                       InputArray cameraMatrix2, InputArray distCoeffs2,
                                       const Params& params, OutputArray R, OutputArray t,
                                       OutputArray mask, CV_OUT RelativePose& pose);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
