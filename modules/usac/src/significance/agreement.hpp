// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AGREEMENT_HPP
#define OPENCV_USACV20_AGREEMENT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! How many matches are within the threshold of a model, and how many wrong matches.
struct Agreement
{
    int points;   //!< matches that are independent of each other
    int inliers;  //!< of them within the threshold
    int pairs;  //!< wrong matches: the point of one match in image 1 with that of another in image
                //!< 2
    int agreeing;  //!< of them within the threshold
};

/** @brief Compares the errors of the first `count` matches with those of wrong matches of the same
points.

If the matches are random, any other pairing of their points is as likely as the given one. The
wrong matches thus tell how often a random match agrees with this very model, for any positions of
the points and any model (even if it maps everything to one place, or has an epipole amid the
points), and right matches do not affect the result.

Inliers in one place of an image, see #markRepeated, count once: the others are left out. Each point
is paired with 4 others, or with more to get `pairs` wrong matches, as far as there are others.
O(count + pairs). */
Agreement countAgreement(const Residual& residual, const Model& model,
                         const Correspondences& points, int count, double threshold, int pairs,
                         Arena& arena);

/** Squared errors of wrong matches: the point of each of the first `count` matches in array 1,
paired with that of another of these matches in array 2.
@param errors output, at most #WRONG_PARTNERS numbers per match
@return number of errors */
int wrongErrors(const Residual& residual, const Model& model, const Correspondences& points,
                int count, float* errors, Arena& arena);
//! Number of wrong matches per point.
enum { WRONG_PARTNERS = 4 };

}  // namespace usacv20
}  // namespace cv

#endif
