// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_GIVEN_HPP
#define OPENCV_USACV20_GIVEN_HPP

#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @name Without a search What is known already is fitted, made better, or looked at: one function
each for all problems of #ProblemType. (For several calls with the same points, or a problem of the
caller's own: Usac::fit, Usac::refine, Usac::errors.)
@{ */

/** @brief Least squares over all points, or some: what OpenCV calls method 0.

@param problem what to fit
@param points1 N points, as #estimateHomography and its kin take them; #ABSOLUTE_POSE: points of
space
@param points2 their N counterparts; #ABSOLUTE_POSE: of the image
@param params `threshold` is that of the mask; `residual` the error that is minimized
@param mask output, N x 1, CV_8U: 1 exactly where the error of a point under the returned model is
at most the threshold
@param report output; `stop` is #STOP_NO_SEARCH, or says why there is no model
@param weights N numbers of at least 0, any depth, of the squared errors; empty: all 1
@param chosen N numbers, those of the points that take part are not 0 (a mask of inliers, say);
empty: all points
@param cameraMatrix1 3x3, for #ESSENTIAL and #ABSOLUTE_POSE
@param cameraMatrix2 3x3, for #ESSENTIAL; empty: as the first
@param distCoeffs1 distortion of camera 1, for #ESSENTIAL and #ABSOLUTE_POSE; empty: none
@param distCoeffs2 distortion of camera 2, for #ESSENTIAL; empty: none
@return the model as #estimateHomography and its kin return it; empty if the points determine none.

Wrong points pull at the model as far as they are off; nothing tells them from right ones here.
Raises cv::Exception for lists of different lengths, negative weights and wrong parameters. */
CV_EXPORTS_W Mat fitModel(ProblemType problem, InputArray points1, InputArray points2,
                          const Params& params, OutputArray mask, CV_OUT Report& report,
                          InputArray weights = noArray(), InputArray chosen = noArray(),
                          InputArray cameraMatrix1 = noArray(),
                          InputArray cameraMatrix2 = noArray(), InputArray distCoeffs1 = noArray(),
                          InputArray distCoeffs2 = noArray());

/** @brief Makes a known model better.

@param problem what the model is
@param model as #estimateHomography and its kin return it, any depth
@param points1, points2 as of #fitModel
@param params `threshold`, `residual`, `polishing` and `polishingSteps` count
@param mask, report as of #fitModel
@param chosen the inliers, N numbers that are not 0 for them: least squares over these, from the
model. Empty: the last step of an estimation, Params::polishing, from the model, with the inliers
that it finds.
@param cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 as of #fitModel
@return the model; empty where the points determine none. */
CV_EXPORTS_W Mat refineModel(ProblemType problem, InputArray model, InputArray points1,
                             InputArray points2, const Params& params, OutputArray mask,
                             CV_OUT Report& report, InputArray chosen = noArray(),
                             InputArray cameraMatrix1 = noArray(),
                             InputArray cameraMatrix2 = noArray(),
                             InputArray distCoeffs1 = noArray(),
                             InputArray distCoeffs2 = noArray());

/** @brief The error of each point under a model, as the mask of an estimation sees it.

@param problem what the model is
@param model as #estimateHomography and its kin return it, any depth
@param points1, points2 as of #fitModel
@param params `residual` counts
@param cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 as of #fitModel
@return N x 1, CV_64F, not squared, in the unit of Params::threshold (pixels; motions of space: the
unit of `points2`): the mask of an estimation is 1 exactly where this is at most Report::threshold.
Not finite or NaN where there is no error: points that are not finite, behind a camera, or where its
lens shows nothing. */
CV_EXPORTS_W Mat modelErrors(ProblemType problem, InputArray model, InputArray points1,
                             InputArray points2, const Params& params = Params(),
                             InputArray cameraMatrix1 = noArray(),
                             InputArray cameraMatrix2 = noArray(),
                             InputArray distCoeffs1 = noArray(),
                             InputArray distCoeffs2 = noArray());

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
