// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CHECK_COMPONENTS_HPP
#define OPENCV_USACV20_CHECK_COMPONENTS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief Raises cv::Exception that names a problem of the caller's whose numbers do not fit each
other: errors of one or two dimensions, samples that determine a model, costs above 0. @param
residual ResidualType */
void checkProblem(const Problem& problem, int residual);

//! Raises cv::Exception that names the component where a required one or an entry of a list is
//! empty, or samples have a size that cannot be.
void checkComponents(const Components& parts);

/** @brief Raises cv::Exception where a score of the caller's, which has been started, is none:
points without error must be inliers, and costs lie between 0 and 1. */
void checkScore(const Score& score);

//! Raises cv::Exception if a sample of a caller's sampler does not have m distinct indices of 0 ..
//! size-1.
void checkSample(const int* sample, int m, int size);

//! That a minimal solver has written models; else a cv::Exception.
void checkModels(const Model* models, int count);

}  // namespace usacv20
}  // namespace cv

#endif
