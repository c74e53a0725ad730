// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PLANE_PARALLAX_HPP
#define OPENCV_USACV20_PLANE_PARALLAX_HPP

#include "problems/two_view/epipole.hpp"
#include "problems/two_view/side_by_side.hpp"

namespace cv {
namespace usacv20 {

/** @brief The best F = [e]x H for the homography H of a plane: which epipole e of image 2 suits the
points off the plane?

The line through x2 and H x1 of a right match off the plane goes through e, so two of them determine
it. DEGENSAC @cite chum2005two draws pairs and counts the support of each; if a part w of the points
is right, that takes w^-2 pairs. Here one match is drawn. What is left of e is its place on that
line, and all other matches vote for it at once: the places that keep one within the threshold are
an arc of the line (projective, so closed), in closed form. Where most arcs overlap is the best e of
all pairs that the match is in, and of all noise of the second one. So w^-1 lines are enough.

The lines are a RANSAC of their own, without repetition: they are looked at in the order of the
points until one that leads to a better e would have been among them. That many are needed for a
support that a model of interest has, see search(), and there are as many as points, so the work is
bounded where nothing is off the plane. */
class PlaneParallax
{
public:
    //! Most points off the plane that vote and whose lines are looked at; of more, the first. Half,
    //! double: time and errors within 1 %.
    enum { MAX_POINTS = 1024 };

    PlaneParallax();

    //! Another plane. @param context the points, and memory @param offPlane, count those off it, in
    //! random order
    void setPlane(const Context& context, const int* offPlane, int count,
                  const Matx33d& homography);

    /** @brief Replaces a model by a better [e]x H.
    @param context rates models over all points
    @param failure probability that there is one and it is missed, in (0, 1)
    @param wanted models with fewer inliers off the plane are of no interest; if only a part votes,
    inliers among that part
    @param model, quality input: what is known; output: unit Frobenius norm
    @return true if the model was replaced */
    bool search(const Context& context, double failure, double wanted, Model& model,
                Quality& quality);

    //! Points that vote.
    int size() const { return voters.size(); }
    //! Lines looked at since setPlane().
    int lines() const { return next; }
    //! Epipoles that were worth a fit since setPlane().
    int fits() const { return fitted; }

private:
    //! Points of the first two steps of a fit, which tell whether it is worth while. Half, double:
    //! time within 2 %.
    enum { FIRST_FIT = 128 };
    //! Numbers of each voter: its line n and the matrix G, symmetric; see setPlane().
    enum { N0, N1, N2, G00, G01, G02, G11, G12, G22 };

    const float* number(int which) const { return &numbers[(size_t)which * stride]; }
    Quality support(const Model& model) const
    {
        return voters.msac(Residual::SAMPSON, model, limit);
    }
    int linesNeeded(double failure, double wanted) const;
    int vote(int line, Vec3d& epipole) const;
    void refine(const Context& context, Vec3d epipole, Model& model, Quality& quality);
    bool fit(const Model& F, double width, int most, Vec3d& epipole) const;

    Matx33d H;     //!< unit Frobenius norm
    double limit;  //!< squared threshold
    SideBySide<MAX_POINTS> voters;
    float* numbers;  //!< ARCS_ROWS rows of `stride`; memory for the most, once there was a plane
    int stride;      //!< size(), rounded up to whole blocks
    Quality best;    //!< lowest cost of the voters
    Vec3d lastFit;   //!< the last epipole that was fitted
    int next, fitted;
};

}  // namespace usacv20
}  // namespace cv

#endif
