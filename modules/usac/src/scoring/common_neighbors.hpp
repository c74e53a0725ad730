// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COMMON_NEIGHBORS_HPP
#define OPENCV_USACV20_COMMON_NEIGHBORS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Number of nearest neighbors of a point in each image, see commonNeighbors().
constexpr int NEIGHBORS_COMPARED = 8;
//! Maximum number of matches for which commonNeighbors() should be called, in order to take little
//! time.
constexpr int MATCHES_COMPARED = 256;

//! True for F, and for other problems with matches of two images, errors of one dimension and at
//! least 7 degrees of freedom. Wrong matches
//! along epipolar lines, as between repeated elements of a facade, can fit an F; they seldom fit E,
//! which has only 5 degrees of freedom, and models with errors of two dimensions.
bool hasCommonNeighbors(const Problem& problem);

/** @brief Measures how well each match fits its surroundings, before any model is known
@cite ma2019locality.

The surfaces of a scene are mostly smooth, so that points that are neighbors in one image are
neighbors in the other image. The result is the number of the #NEIGHBORS_COMPARED nearest neighbors
of a point in image 1 that are also among the nearest neighbors of its counterpart in image 2. It
does not depend on scale, rotation or density. Matches that coincide in one of the images are not
neighbors.
@param points the matches
@param count the first `count` matches are looked at
@param threshold distance up to which points coincide, in the unit of Correspondences::threshold
@param common output, a number from 0 to #NEIGHBORS_COMPARED for each of these matches */
void commonNeighbors(const Correspondences& points, int count, double threshold, uchar* common,
                     Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
