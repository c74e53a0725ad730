// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PLANE_PARALLAX_HPP
#define OPENCV_USACV20_PLANE_PARALLAX_HPP

#include "problems/two_view/epipole.hpp"
#include "problems/two_view/gathered_points.hpp"

namespace cv {
namespace usacv20 {

/** @brief Plane and parallax: the best F = [e]x H for the homography H of a plane, that is, the
epipole e of image 2 that agrees with most points off the plane.

For a correct match off the plane, the line through x2 and H x1 contains e, so two matches determine
it. DEGENSAC @cite chum2005two draws pairs and counts the support of each; if a share w of the
points is right, that takes w^-2 pairs. Here a single match is drawn. Only the position of e on its
line is then unknown, and all other matches vote for it at once: the positions that keep a match
within the threshold form an arc of the projective (thus closed) line, in closed form. The position
where most arcs overlap is the best e over all pairs with this match, whatever the noise of the
second one. So w^-1 lines suffice.

The lines are drawn as in RANSAC, but without replacement: in the order of the points, until with
the given confidence one of them leads to a better e. Their number follows from the support that a
model of interest has, see search(). It is at most the number of points, which bounds the time if
nothing is off the plane. */
class PlaneParallax
{
public:
    //! Maximum number of points off the plane that vote and whose lines are tried; of more points,
    //! the first ones are taken.
    enum { MAX_POINTS = 1024 };

    PlaneParallax();

    //! Sets another plane. @param context points and memory @param offPlane, count indices of the
    //! points off the plane, in random order
    void setPlane(const Context& context, const int* offPlane, int count,
                  const Matx33d& homography);

    /** @brief Replaces a model by a better [e]x H.
    @param context scores models over all points
    @param failure probability of missing a better one if there is one, in (0, 1)
    @param wanted models with fewer inliers off the plane are of no interest; if only some of the
    points vote, the number of inliers among these
    @param model, quality input: the known model; output: unit Frobenius norm
    @return true if the model was replaced */
    bool search(const Context& context, double failure, double wanted, Model& model,
                Quality& quality);

    //! Number of points that vote.
    int size() const { return voters.size(); }
    //! Number of lines tried since setPlane().
    int lines() const { return next; }
    //! Number of epipoles that were worth a fit since setPlane().
    int fits() const { return fitted; }

private:
    //! Number of points of the first two steps of a fit, which decide whether it continues.
    enum { FIRST_FIT = 128 };
    //! Rows of `numbers`: for each voter its line n and the symmetric matrix G, see setPlane().
    enum { N0, N1, N2, G00, G01, G02, G11, G12, G22 };

    const float* number(int which) const { return &numbers[(size_t)which * stride]; }
    Quality support(const Model& model) const { return voters.msac<SampsonError>(model, limit); }
    int linesNeeded(double failure, double wanted) const;
    int vote(int line, Vec3d& epipole) const;
    void refine(const Context& context, Vec3d epipole, Model& model, Quality& quality);
    bool fit(const Model& F, double width, int most, Vec3d& epipole) const;

    Matx33d H;     //!< unit Frobenius norm
    double limit;  //!< squared threshold
    GatheredPoints<MAX_POINTS> voters;
    float* numbers;  //!< ARCS_ROWS rows of `stride`; room for MAX_POINTS from the first plane on
    int stride;      //!< size(), rounded up to whole blocks
    Quality best;    //!< lowest cost over the voters
    Vec3d lastFit;   //!< the last epipole that was fitted
    int next, fitted;
};

}  // namespace usacv20
}  // namespace cv

#endif
