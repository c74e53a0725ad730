// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_DOMINANT_PLANE_HPP
#define OPENCV_USACV20_DOMINANT_PLANE_HPP

#include "problems/two_view/gathered_points.hpp"

namespace cv {
namespace usacv20 {

//! Computes the homography of the plane through three correspondences that agree with F:
//! H = A - e (M^-1 b)^T, where e is the epipole of image 2 and A = [e]x F; the rows of M are the
//! points x1, and b is chosen so that H maps each x1 to its x2. False if the correspondences do not
//! determine a homography.
bool planeOfThree(const Correspondences& p, const int* triple, const Matx33d& A, const Vec3d& e,
                  Matx33d& H);

//! Computes the unit epipole `e` of image 2 and A = [e]x F. False if F determines no epipole.
bool epipolar(const Model& F, Vec3d& e, Matx33d& A);

//! Matches count as lying on a plane that was found from three matches if their transfer error is
//! at most three inlier thresholds; PLANE_LIMIT is the square of 3. See doc/constants.md.
constexpr int PLANE_LIMIT = 9;
inline double planeLimit(const Context& context)
{
    return PLANE_LIMIT * context.inlierThreshold() * context.inlierThreshold();
}

//! Finds a plane that contains many inliers of F or E. E is treated as the F of points on the
//! normalized image planes.
class DominantPlane
{
public:
    DominantPlane() : count(0) {}

    /** @brief Computes homographies from random triples of inliers and finds the one with the
    most inliers on its plane, see planeLimit(). An inlier of F is a match whose Sampson distance is
    at most the inlier threshold. Only the first MAX_INLIERS inliers are used.
    @param context the points
    @param rng draws the triples
    @param F model whose inliers are tested
    @param least a fraction below 1: more than this fraction of the tested inliers must be on the
    plane
    @param H output, the homography of the plane
    @return false if no such plane is found, if F has fewer than LEAST_INLIERS inliers, or if F
    determines no epipole */
    bool find(const Context& context, Rng& rng, const Model& F, double least, Matx33d& H);

    //! The inliers that the last find() tested.
    const int* inliers() const { return members; }
    int inlierCount() const { return count; }

private:
    //! Number of triples drawn (with 20, a plane of half of the inliers is missed in one of 14
    //! cases), maximum number of tested inliers, and minimum number of inliers for a search. See
    //! doc/constants.md.
    enum { MAX_TRIPLES = 20, MAX_INLIERS = 128, LEAST_INLIERS = 8 };

    int members[MAX_INLIERS];
    int count;
    GatheredPoints<MAX_INLIERS> someInliers;
};

//! True if the inliers of F or E hardly determine the epipole, because nearly all of them are on a
//! plane or because the camera has only rotated.
bool epipoleIsFree(const Context& context, const Model& F);

}  // namespace usacv20
}  // namespace cv

#endif
