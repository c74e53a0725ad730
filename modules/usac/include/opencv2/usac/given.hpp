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

/** @name Fits, refinement and errors without a search
These functions fit, refine or evaluate a model. Each works for all problems of #ProblemType. (For
several calls with the same points, or for a problem of your own, use Usac::fit, Usac::refine and
Usac::errors.)
@{ */

/** @brief Least-squares fit to all points, or to a subset, as with the flag 0 of calib3d.

@param problem what to fit
@param points1 N points, in the layouts that #estimateHomography and similar functions accept;
#ABSOLUTE_POSE: 3-D points
@param points2 their N counterparts; #ABSOLUTE_POSE: image points
@param params `threshold` is the threshold of the mask, `residual` the error that is minimized
@param mask output, N x 1, CV_8U: 1 exactly where the error of a point under the returned model is
at most the threshold
@param report output; `stop` is #STOP_NO_SEARCH, the reason why there is no model, or #STOP_TIME or
#STOP_CANCELLED if the fit ended early
@param weights N finite weights of the squared errors, at least 0, any depth; empty: all 1
@param chosen mask of the points to fit (for example the inliers), N numbers, 0 for points that are
left out; empty: all points
@param cameraMatrix1 3x3, for #ESSENTIAL and #ABSOLUTE_POSE
@param cameraMatrix2 3x3, for #ESSENTIAL; empty: the same as `cameraMatrix1`
@param distCoeffs1 distortion of camera 1, for #ESSENTIAL and #ABSOLUTE_POSE; empty: none
@param distCoeffs2 distortion of camera 2, for #ESSENTIAL; empty: none
@return the model as #estimateHomography and similar functions return it; empty if the points
determine none.

The fit is not robust: outliers are not detected and affect it fully. Raises cv::Exception for lists
of different lengths, negative weights and invalid parameters. */
CV_EXPORTS_W Mat fitModel(ProblemType problem, InputArray points1, InputArray points2,
                          const Params& params, OutputArray mask, CV_OUT Report& report,
                          InputArray weights = noArray(), InputArray chosen = noArray(),
                          InputArray cameraMatrix1 = noArray(),
                          InputArray cameraMatrix2 = noArray(), InputArray distCoeffs1 = noArray(),
                          InputArray distCoeffs2 = noArray());

/** @brief Refines a known model.

@param problem kind of the model
@param model as #estimateHomography and similar functions return it, any depth
@param points1, points2 as in #fitModel
@param params options. Those of the search (samples, local optimization, termination) have no
effect. If `chosen` is given, `covariance` and the options of the polishing have no effect, either
@param mask, report as in #fitModel
@param chosen mask of the inliers, N numbers, 0 for other points. With a mask, a least-squares fit
to these inliers is made, starting from the model. Empty: the model is polished as at the end of an
estimation (Params::polishing), which selects the inliers itself.
@param cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 as in #fitModel
@return the model; empty if the points determine none. */
CV_EXPORTS_W Mat refineModel(ProblemType problem, InputArray model, InputArray points1,
                             InputArray points2, const Params& params, OutputArray mask,
                             CV_OUT Report& report, InputArray chosen = noArray(),
                             InputArray cameraMatrix1 = noArray(),
                             InputArray cameraMatrix2 = noArray(),
                             InputArray distCoeffs1 = noArray(),
                             InputArray distCoeffs2 = noArray());

/** @brief The error of each point under a model, as used for the mask of an estimation.

@param problem kind of the model
@param model as #estimateHomography and similar functions return it, any depth
@param points1, points2 as in #fitModel
@param params options; `residual` and `sigmas` are used
@param cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2 as in #fitModel
@return N x 1, CV_64F, not squared, in the unit of Params::threshold (pixels; 3-D motions: the unit
of `points2`): the mask of an estimation is 1 exactly where this error is at most Report::threshold.
Infinite or NaN where the error is not defined: for points that are not finite, outside the field of
view of a lens, or (absolute pose) behind the camera. */
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
