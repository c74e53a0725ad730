// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_AGREEMENT_HPP
#define OPENCV_USACV20_AGREEMENT_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! How many matches agree with a model, and how many wrong ones.
struct Agreement
{
    int points;   //!< that are independent of each other
    int inliers;  //!< of them within the threshold
    int pairs;  //!< wrong matches: the point of one match in image 1 with that of another in image
                //!< 2
    int agreeing;  //!< of them within the threshold
};

/** @brief Compares the errors of the first `count` matches with those of the same points wrongly
paired.

If the matches are random, any other pairing of their points is as good as the given one: so the
wrong matches tell how often a random one agrees with this very model, wherever the points are and
whatever the model is like (one that maps everything to one place, or an epipole amid the points,
too), and right matches have no part in it.

Inliers in one place of an image, see #markRepeated, count once: the others are left out. Each point
is paired with 4 others, or with as many more as make `pairs` wrong matches, if there are so many.
O(count + pairs). */
Agreement countAgreement(const Residual& residual, const Model& model,
                         const Correspondences& points, int count, double threshold, int pairs,
                         Arena& arena);

/** Squared errors of matches that are wrong: the point of each of the first `count` matches in
array 1 with that of another one of these in array 2.
@param errors output, #WRONG_PARTNERS numbers for each match at most
@return how many */
int wrongErrors(const Residual& residual, const Model& model, const Correspondences& points,
                int count, float* errors, Arena& arena);
//! Wrong matches of each point.
enum { WRONG_PARTNERS = 4 };

}  // namespace usacv20
}  // namespace cv

#endif
