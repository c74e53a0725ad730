// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COMMON_NEIGHBORS_HPP
#define OPENCV_USACV20_COMMON_NEIGHBORS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

//! Number of nearest neighbors of a point that are compared in each image, see commonNeighbors().
constexpr int NEIGHBORS_COMPARED = 8;
//! Maximum number of matches that commonNeighbors() compares.
constexpr int MATCHES_COMPARED = 256;

//! True for F, and for other problems with matches of two images, errors of one dimension and
//! models of at least 7 degrees of freedom. Wrong matches along epipolar lines, as between repeated
//! elements of a facade, can fit an F. They seldom fit an E, which has only 5 degrees of freedom,
//! or a model whose errors have two dimensions (H).
bool hasCommonNeighbors(const Problem& problem);

/** @brief Measures how well each match fits its surroundings, before any model is known
@cite ma2019locality.

The surfaces of a scene are mostly smooth, so that points that are neighbors in one image are mostly
neighbors in the other image. Each match has two sets of neighbors: the #NEIGHBORS_COMPARED matches
whose points in image 1 are nearest to its own point, and the same for image 2. The result is the
number of matches that are in both sets. It does not depend on the scale and rotation of the images
or on the density of the points. Distances that differ by less than 3e-5 of their value can count
as equal; the match with the lower index is then nearer. Two matches are not neighbors if their
points coincide in one of the images.
@param points the matches
@param count only the first `count` matches are used, from 1 to #MATCHES_COMPARED
@param threshold distance up to which points coincide, in the unit of Correspondences::threshold
@param common output, a number from 0 to #NEIGHBORS_COMPARED for each of these matches */
void commonNeighbors(const Correspondences& points, int count, double threshold, uchar* common,
                     Arena& arena);

}  // namespace usacv20
}  // namespace cv

#endif
