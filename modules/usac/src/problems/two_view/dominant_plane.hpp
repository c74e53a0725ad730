// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DOMINANT_PLANE_HPP
#define OPENCV_USACV20_DOMINANT_PLANE_HPP

#include "problems/two_view/gathered_points.hpp"

namespace cv {
namespace usacv20 {

//! The homography of the plane of three correspondences under F: A - e2 (M^-1 b)^T with A = [e2]x
//! F. False if they determine none.
bool planeOfThree(const Correspondences& p, const int* triple, const Matx33d& A, const Vec3d& e,
                  Matx33d& H);

//! A = [e]x F with the unit epipole e of image 2; false if F has none.
bool epipolar(const Model& F, Vec3d& e, Matx33d& A);

//! The square of 3: points are on a plane that was found from three points if their error is at
//! most three thresholds. See doc/constants.md.
constexpr int PLANE_LIMIT = 9;
inline double planeLimit(const Context& context)
{
    return PLANE_LIMIT * context.inlierThreshold() * context.inlierThreshold();
}

//! Finds a plane that contains many inliers of F, or of E, which is the F of normalized points.
class DominantPlane
{
public:
    DominantPlane() : count(0) {}

    /** @brief Finds the homography of three random inliers that maps the most inliers, among the
    first MAX_INLIERS.
    @param context the points
    @param rng draws the triples
    @param F model whose inliers are tested
    @param least share of the tested inliers that must be on the plane, below 1
    @param H output
    @return false if there is no such plane */
    bool find(const Context& context, Rng& rng, const Model& F, double least, Matx33d& H);

    //! The inliers that the last find() tested.
    const int* inliers() const { return members; }
    int inlierCount() const { return count; }

private:
    //! Number of triples drawn (a plane of half of the inliers is missed once in 14 times); maximum
    //! number of tested inliers; minimum number of inliers for a search. See doc/constants.md.
    enum { MAX_TRIPLES = 20, MAX_INLIERS = 128, LEAST_INLIERS = 8 };

    int members[MAX_INLIERS];
    int count;
    GatheredPoints<MAX_INLIERS> someInliers;
};

//! True if nearly all inliers of F or E are on a plane, or the camera has only rotated, so that the
//! inliers hardly determine the epipole.
bool epipoleIsFree(const Context& context, const Model& F);

}  // namespace usacv20
}  // namespace cv

#endif
