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
epipole e of image 2 that agrees with the largest number of points off the plane.

For a correct match off the plane, the line through x2 and H x1 contains e, so two matches determine
e. DEGENSAC @cite chum2005two draws pairs of matches and counts the inliers of each F; if a fraction
w of the matches is correct, about w^-2 pairs are needed. Here a single match is drawn. Only the
position of e on the line of this match is then unknown, and all other matches vote for this
position at once: the positions for which another match is within the threshold form an arc of the
projective (thus closed) line, which is computed in closed form. The position where most arcs
overlap is the best e over all pairs with the drawn match, whatever the noise of the second match.
Therefore about w^-1 lines suffice.

The lines are drawn as in RANSAC, but without replacement: in the order of the points, until with
the given confidence one of them has led to a better e, if there is one. The number of lines follows
from the number of inliers that a model of interest has, see search(). There are at most as many
lines as points off the plane, which bounds the time if no correct match is off the plane. */
class PlaneParallax
{
public:
    //! Maximum number of points off the plane that vote and whose lines can be tried. If there are
    //! more points off the plane, only the first MAX_POINTS are used.
    enum { MAX_POINTS = 1024 };

    PlaneParallax();

    //! Sets the plane and discards the results for the previous plane.
    //! @param context points and memory
    //! @param offPlane, count indices of the points off the plane, in random order, and their
    //! number
    //! @param homography H of the plane
    void setPlane(const Context& context, const int* offPlane, int count,
                  const Matx33d& homography);

    /** @brief Replaces a model with a better [e]x H if one is found.
    @param context scores models over all points
    @param failure accepted probability, in (0, 1), of missing a better model if there is one
    @param wanted models with fewer inliers off the plane are of no interest; only inliers among
    the voters are counted
    @param model, quality input: a model and its quality; output: if the model was replaced, the
    better model, of unit Frobenius norm, and its quality
    @return true if the model was replaced */
    bool search(const Context& context, double failure, double wanted, Model& model,
                Quality& quality);

    //! Number of points that vote.
    int size() const { return voters.size(); }
    //! Number of lines tried since setPlane().
    int lines() const { return next; }
    //! Number of epipoles, since setPlane(), whose fit continued after its first two steps.
    int fits() const { return fitted; }

private:
    //! Maximum number of points in each of the first two steps of a fit. These steps decide whether
    //! the fit continues.
    enum { FIRST_FIT = 128 };
    //! Rows of `numbers`: for each voter its line n and the symmetric matrix G of setPlane().
    enum { N0, N1, N2, G00, G01, G02, G11, G12, G22 };

    const float* number(int which) const { return &numbers[(size_t)which * stride]; }
    Quality support(const Model& model) const { return voters.msac<SampsonError>(model, limit); }
    int linesNeeded(double failure, double wanted) const;
    int vote(int line, Vec3d& epipole) const;
    void refine(const Context& context, Vec3d epipole, Model& model, Quality& quality);
    bool fit(const Model& F, double width, int most, Vec3d& epipole) const;

    Matx33d H;     //!< homography of the plane, of unit Frobenius norm
    double limit;  //!< squared threshold
    GatheredPoints<MAX_POINTS> voters;
    //! Upper triangles of the symmetric matrices of the numerator and of the denominator of a
    //! voter's squared error, row by row, see setPlane().
    struct Terms
    {
        double numerator[6], denominator[6];
    };

    float* numbers;  //!< ARCS_ROWS rows of `stride` numbers; memory for MAX_POINTS columns
    Terms* terms;    //!< one element per voter; memory for MAX_POINTS elements
    int stride;      //!< size(), rounded up to a multiple of ARCS_BLOCK
    Quality best;    //!< quality, over the voters, of the model with the lowest cost so far
    Vec3d lastFit;   //!< the last epipole whose fit continued after two steps
    int next, fitted;
};

}  // namespace usacv20
}  // namespace cv

#endif
