// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DOMINANT_PLANE_HPP
#define OPENCV_USACV20_DOMINANT_PLANE_HPP

#include "problems/two_view/side_by_side.hpp"

namespace cv {
namespace usacv20 {

//! The homography of the plane of three correspondences under F: A - e2 (M^-1 b)^T with A = [e2]x
//! F. False if they determine none.
bool planeOfThree(const Correspondences& p, const int* triple, const Matx33d& A, const Vec3d& e,
                  Matx33d& H);

//! A = [e]x F with the unit epipole e of image 2; false if F has none.
bool epipolar(const Model& F, Vec3d& e, Matx33d& A);

//! Squared errors above this are off a plane that was found from three points: three thresholds.
//! 1.5: time of F -3 %, errors +2 %; 6: time +8 % (F) and +4 % (E), errors -3 and -2 %.
constexpr int PLANE_LIMIT = 9;
inline double planeLimit(const Context& context)
{
    return PLANE_LIMIT * context.inlierThreshold() * context.inlierThreshold();
}

//! Looks for a plane with many of the inliers of F, or of E, which is the F of normalized points.
class DominantPlane
{
public:
    DominantPlane() : count(0) {}

    /** @brief The homography of three random inliers that maps most of (a part of) the inliers.
    @param context the points
    @param rng draws the triples
    @param F model whose inliers are looked at
    @param least part of the inliers that must be on the plane, below 1
    @param H output
    @return false if there is no such plane */
    bool find(const Context& context, Rng& rng, const Model& F, double least, Matx33d& H);

    //! Those that have been looked at.
    const int* inliers() const { return members; }
    int inlierCount() const { return count; }

private:
    //! Triples that are drawn: a plane of half of the inliers is missed once in 14. Most inliers
    //! that are looked at; fewer than LEAST_INLIERS are no plane. Half, double: errors within 2 %,
    //! time within 3 %.
    enum { MAX_TRIPLES = 20, MAX_INLIERS = 128, LEAST_INLIERS = 8 };

    int members[MAX_INLIERS];
    int count;
    SideBySide<MAX_INLIERS> someInliers;
};

//! Are so many inliers of F or E on a plane, or seen by a camera that has only turned, that its
//! epipole is free?
bool epipoleIsFree(const Context& context, const Model& F);

}  // namespace usacv20
}  // namespace cv

#endif
