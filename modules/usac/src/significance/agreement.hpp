// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AGREEMENT_HPP
#define OPENCV_USACV20_AGREEMENT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Numbers of matches and of wrong matches, and of those within the threshold of a model.
struct Agreement
{
    int points;    //!< matches that are independent of each other
    int inliers;   //!< number of these matches within the threshold
    int pairs;     //!< wrong matches: the points of two different matches in images 1 and 2
    int agreeing;  //!< number of the wrong matches within the threshold
};

/** @brief Compares the errors of the first `count` matches with those of wrong matches of the same
points.

If the matches are random, any other pairing of their points is as likely as the given one. The
wrong matches thus tell how often a random match agrees with this very model, for any positions of
the points and any model (even if it maps everything to one place, or has an epipole amid the
points), and right matches do not affect the result.

Of inliers in one place of an image (see #markRepeated), all but one are left out. Each point is
paired with 4 others, or with more to get `pairs` wrong matches, but at most with all others.
O(count + pairs). */
Agreement countAgreement(const Residual& residual, const Model& model,
                         const Correspondences& points, int count, double threshold, int pairs,
                         Arena& arena);

/** Squared errors of wrong matches, each of them the points of two of the first `count` matches: of
one match in array 1, of another one in array 2.
@param errors output, at most #WRONG_PARTNERS numbers per match
@return number of errors */
int wrongErrors(const Residual& residual, const Model& model, const Correspondences& points,
                int count, float* errors, Arena& arena);
//! Number of wrong matches per point.
enum { WRONG_PARTNERS = 4 };

}  // namespace usacv20
}  // namespace cv

#endif
