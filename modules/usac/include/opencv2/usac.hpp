// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_USAC_HPP
#define OPENCV_USACV20_USAC_HPP

/**
@defgroup usacv20 USACv20: robust estimation of homographies, fundamental and essential matrices

The RANSAC framework of @cite ivashechkin2021usacv20 behind the functions of the module calib3d. Three levels of use:

1. A flag of cv::UsacV20Method in the place of `cv::RANSAC`:
   `cv::findHomography(points1, points2, cv::USACV20, 3.0, mask)`.
2. A usacv20::Params with all options, match scores among them, and a usacv20::Report:
   usacv20::estimateHomography, usacv20::estimateFundamental, usacv20::estimateEssential.
3. A component of one's own: usacv20::Usac::create builds the default set, each can be replaced before usacv20::Usac::run.
*/

#include "opencv2/calib3d.hpp"
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"
#include "opencv2/usac/estimate.hpp"
#include "opencv2/usac/components.hpp"

namespace cv {

//! @addtogroup usacv20
//! @{

/** @name The functions of calib3d with a flag of this module
Every signature of cv::findHomography, cv::findFundamentalMat and cv::findEssentialMat, with the same meaning, order and
defaults of the arguments. Overload resolution picks these for a #UsacV20Method, and the old ones for an `int`.
Results are those of usacv20::estimateHomography, usacv20::estimateFundamental and usacv20::estimateEssential.
A flag does not tell whether `maxIters` ended the search: usacv20::Params::fromMethod with one of these functions does, by
usacv20::Report::stop == usacv20::STOP_MAX_ITERATIONS.
@{ */
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, UsacV20Method method,
                              double ransacReprojThreshold = 3, OutputArray mask = noArray(),
                              const int maxIters = 2000, const double confidence = 0.995);
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              UsacV20Method method, double ransacReprojThreshold = 3);
CV_EXPORTS Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                              const usacv20::Params& params);

CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                                  double ransacReprojThreshold, double confidence, int maxIters,
                                  OutputArray mask = noArray());
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, UsacV20Method method,
                                  double ransacReprojThreshold = 3., double confidence = 0.99,
                                  OutputArray mask = noArray());
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask, UsacV20Method method,
                                  double ransacReprojThreshold = 3., double confidence = 0.99);
CV_EXPORTS Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                  const usacv20::Params& params);

CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, UsacV20Method method,
                                double prob = 0.999, double threshold = 1.0, int maxIters = 1000,
                                OutputArray mask = noArray());
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, InputArray cameraMatrix, UsacV20Method method,
                                double prob, double threshold, OutputArray mask);
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, UsacV20Method method,
                                double prob = 0.999, double threshold = 1.0, int maxIters = 1000,
                                OutputArray mask = noArray());
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp, UsacV20Method method,
                                double prob, double threshold, OutputArray mask);
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2,
                                InputArray cameraMatrix1, InputArray distCoeffs1,
                                InputArray cameraMatrix2, InputArray distCoeffs2,
                                UsacV20Method method, double prob = 0.999, double threshold = 1.0,
                                OutputArray mask = noArray());
CV_EXPORTS Mat findEssentialMat(InputArray points1, InputArray points2,
                                InputArray cameraMatrix1, InputArray cameraMatrix2,
                                InputArray distCoeffs1, InputArray distCoeffs2,
                                OutputArray mask, const usacv20::Params& params);
//! @}

//! @}

} // namespace cv

#endif
