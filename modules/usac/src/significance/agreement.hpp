// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AGREEMENT_HPP
#define OPENCV_USACV20_AGREEMENT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Numbers of matches and of artificial wrong matches: in total, and with an error under a model
//! that is within the threshold.
struct Agreement
{
    int points;    //!< number of matches, without inliers that repeat another inlier
    int inliers;   //!< number of these matches within the threshold
    int pairs;     //!< number of artificial wrong matches (or, with one array, points)
    int agreeing;  //!< number of the wrong matches within the threshold
};

/** @brief Compares the errors of the first `count` matches with the errors of wrong matches of the
same points.

If the matches are random, any other pairing of their points is as likely as the given pairing. The
wrong matches thus tell how often a random match is within the threshold of this particular model,
whatever the positions of the points and the model are (even if the model maps everything to a
single point, or has an epipole amid the points). Right matches do not distort this result, because
their points are paired anew, too.

If there is only one array, wrong points are drawn uniformly from the box that contains nearly all
points. Mixing the coordinates of different points would not make wrong points: points on a
horizontal plane, for example, would stay on this plane.

Of several inliers in the same cell of a grid over an array (see #markRepeated), only one is
counted. Each point of array 1 is paired with the points of k other matches in array 2, where k is 4
or, if this is larger, the number needed to get about `pairs` wrong matches in total; if there are
fewer than k other matches, all of them are used. Takes O(count + pairs). */
Agreement countAgreement(const Residual& residual, const Model& model,
                         const Correspondences& points, int count, double threshold, int pairs,
                         Arena& arena);

/** Computes the squared errors of wrong matches. Each wrong match is made of two of the first
`count` matches: it has the point of one match in array 1 and the point of another match in array 2.
If there is only one array, wrong points are made as for countAgreement().
@param errors output, at most #WRONG_PARTNERS squared errors per match
@return number of errors written */
int wrongErrors(const Residual& residual, const Model& model, const Correspondences& points,
                int count, float* errors, Arena& arena);
//! Maximum number of wrong matches that wrongErrors() makes per point of array 1.
enum { WRONG_PARTNERS = 4 };

}  // namespace usacv20
}  // namespace cv

#endif
