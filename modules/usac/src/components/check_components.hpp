// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_CHECK_COMPONENTS_HPP
#define OPENCV_USACV20_CHECK_COMPONENTS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief Finds numbers of a problem that cannot be, or do not agree with each other: it must
create a residual and a minimal solver, points must have one to three coordinates (in the second
array: zero to three), errors must have one to three dimensions, but not more than a point has, a
sample must determine a model, a parameterization must have the degrees of freedom of the problem,
and Problem::sampleCost must be positive.
@param residual @ref ResidualType of the run
@return empty if all numbers are right, otherwise a description of the first wrong one */
String findWrongNumber(const Problem& problem, int residual);

//! Raises a cv::Exception that names the component if a required component or an entry of a list of
//! components is empty, or if the sample size is out of range.
void checkComponents(const Components& parts);

/** @brief Raises a cv::Exception for an invalid score of the caller: points without error must be
inliers, accumulate() must add the cost of a point, which must be 0 to 1, and Score::inlierPart()
must be above 0 and at most 1.
To be called after Score::start(). Calls the score for points without error, and for points with the
largest possible error.
@param size number of points of the run, see Score::wholeModel */
void checkScore(const Score& score, int size);

//! Raises a cv::Exception if a sample of a caller's sampler does not have m distinct indices from 0
//! to size - 1.
void checkSample(const int* sample, int m, int size);

//! Raises a cv::Exception if an edge of a caller's neighborhood does not join two different ones of
//! the points 0 to size - 1.
void checkEdges(const Vec2i* edges, int count, int size);

//! Raises a cv::Exception if a minimal solver has returned more than #MAX_MODELS models or an empty
//! model.
void checkModels(const Model* models, int count);

}  // namespace usacv20
}  // namespace cv

#endif
