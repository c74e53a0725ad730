// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_USAC_HPP
#define OPENCV_USACV20_USAC_HPP

/**
@defgroup usacv20 USACv20: robust estimation

The RANSAC framework of @cite ivashechkin2021usacv20 behind the functions of the module calib3d.
Three levels of use:

1. A flag of cv::UsacV20Method in place of `cv::RANSAC`: `cv::findHomography(points1, points2,
   cv::USACV20, 3.0, mask)`. A program that keeps its flag (of this module or of OpenCV) in an `int`
   calls `cv::usacv20::findHomography(points1, points2, method, 3.0, mask)`.
   The same holds for cv::estimateAffine2D, cv::estimateAffinePartial2D, cv::findFundamentalMat,
   cv::findEssentialMat and cv::solvePnPRansac.
2. A usacv20::Params with all options, including match scores, and a usacv20::Report:
   usacv20::estimateHomography and similar functions, one for each usacv20::ProblemType, and
   usacv20::estimateModel for any of them. usacv20::estimateBatch, usacv20::estimateHomographies
   and so on run many estimations in parallel. usacv20::estimateTwoViewGeometry estimates several
   of these models, and determines from them the relation between two images (calibrated, planar,
   pure rotation and so on).
3. Components of your own: usacv20::Usac::create builds the default set, and each component can be
   replaced before usacv20::Usac::run. See @ref usacv20_extend.

@{
    @defgroup usacv20_extend Extension interface, not yet stable

    Classes that a program can replace or extend (components, problems, residuals,
    parameterizations), and the data types that they use. A minor version can change these classes
    if the algorithms require a change; the functions, usacv20::Params and usacv20::Report stay
    compatible.
@}
*/

/** @namespace cv OpenCV's namespace. This module adds the enumeration cv::UsacV20Method, and
overloads of OpenCV's functions that accept its flags. */

/** @namespace cv::usacv20
Everything else in this module, see @ref usacv20. */

#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"
#include "opencv2/usac/progress.hpp"
#include "opencv2/usac/find.hpp"
#include "opencv2/usac/find_affine.hpp"
#include "opencv2/usac/find_pose.hpp"
#include "opencv2/usac/estimate.hpp"
#include "opencv2/usac/lens.hpp"
#include "opencv2/usac/batch.hpp"
#include "opencv2/usac/components.hpp"
#include "opencv2/usac/problem.hpp"
#include "opencv2/usac/estimator.hpp"
#include "opencv2/usac/given.hpp"
#include "opencv2/usac/covariance.hpp"
#include "opencv2/usac/relative_pose.hpp"
#include "opencv2/usac/two_view_geometry.hpp"

#endif
