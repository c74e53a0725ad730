// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "problems/two_view/dominant_plane.hpp"
#include "problems/share_a_point.hpp"
#include "problems/fundamental/plane_parallax.hpp"
#include "problems/two_view/gathered_points.hpp"
#include "problems/kernels.hpp"
#include "problems/fundamental/fundamental.hpp"
#include "problems/homography/homography.hpp"

namespace cv {
namespace usacv20 {

namespace {

// In this file, a homography maps a match, and the match is on its plane, if the transfer error is
// at most three inlier thresholds, see planeLimit(), unless another limit is given.

//! Least-squares fits of the homography of a plane: maximum numbers of points in a fit (MAX_FIT),
//! of fits (MAX_FITS) and of steps per fit (FIT_STEPS). A plane with fewer than LEAST_POINTS points
//! is not fitted.
constexpr int MAX_FIT = 256, MAX_FITS = 5, FIT_STEPS = 2, LEAST_POINTS = 8;
//! The plane to which planeAndParallax() was applied last is called the known plane. The function
//! is applied to this plane again only if a new homography of the plane maps more than CLEARLY
//! times as many points as the old one.
constexpr double CLEARLY = 1.05;
//! A plane counts as the known plane if more than this fraction of the tested inliers on it are on
//! the known plane, too. (If there is a sample, the condition is that at least five of its points
//! are on the known plane.)
constexpr double SAME_PLANE = 0.9;
//! DOMINANT: minimum number of points on a dominant plane, as a fraction of the model's number of
//! inliers. ROUGHLY: fraction of the minimum number of points (see also SEEN) that is required
//! before the plane is fitted.
constexpr double DOMINANT = 0.5, ROUGHLY = 0.6;
//! A dominant plane also has at least this fraction w of all points. With w = 0.1, one sample in
//! 5000 (21 w^5) has five of its seven points on the plane. For smaller planes, this is so rare
//! that a plane found in a sample is more likely to fit five points of the sample by chance.
constexpr double SEEN = 0.1;
//! The search for an epipole ignores models that have fewer inliers than this fraction of the best
//! model's inliers. The fraction is below 1 because local optimization can add inliers.
constexpr double OF_INTEREST = 0.9;
//! A match is off the plane and votes for the epipole if its squared transfer error exceeds this
//! many squared thresholds; a match closer to the plane is an inlier for most epipoles.
constexpr double OFF_PLANE = 4;

/** @brief DEGENSAC @cite chum2005two: fundamental matrices from samples dominated by a plane.

If five or more of the seven points lie on a plane, F fits everything on the plane and little else.
At least one of five fixed triples of the sample then lies on the plane. F and a triple determine a
homography; the sample is degenerate if one of the five homographies maps at least five of the seven
points. A locally optimized or initial model has no sample; a plane with more than half of the
inliers of such a model is searched for. The remedy is plane and parallax: the homography H of the
plane, refined on the points of the plane, and two correspondences off the plane determine
F = [e]x H. The paper samples such pairs; PlaneParallax describes the method used here. The best
F = [e]x H replaces the original model only if its score is better, so that other scenes are not
affected. A plane with fewer points than half of the model's inliers is ignored, because ordinary
samples then find F. */
class Degensac : public Degeneracy
{
public:
    Degensac()
        : fitter(createHomographyFit(createResidualOf<TransferError>())), known(Matx33d::zeros()),
          knownPoints(0), onPlane(0), offPlane(0), errors(0), onCount(0), offCount(0), parallax(0)
    {}

    void start(const Context& context) CV_OVERRIDE
    {
        fitter->start(context);
        knownPoints = 0;
        errors = 0;
        parallax = 0;
    }

    void thresholdChanged(const Context&) CV_OVERRIDE { knownPoints = 0; }

    bool recover(const Context& context, State& state, const int* sample, Model& model,
                 Quality& quality) CV_OVERRIDE
    {
        Matx33d H;
        if (sample ? !planeOfSample(context, sample, model, H)
                   : !plane.find(context, state.rng, model, DOMINANT, H))
            return true;
        state.degenerate = true;
        const Quality before = quality;
        if (knownPoints > 0 && isKnown(context, H, sample))
        {
            if (knownQuality.betterThan(quality))
            {
                model = knownModel;
                quality = knownQuality;
            }
            if (pointsOn(context, H) <= CLEARLY * knownPoints)
                return true;
        }
        if (!fitPlane(context, std::max(DOMINANT * before.inliers, SEEN * context.points.size), H))
            return true;
        known = H;
        knownPoints = pointsOn(context, H);
        planeAndParallax(context, state, H, model, quality);
        knownModel = model;
        knownQuality = quality.betterThan(before) ? quality : Quality();
        return true;
    }

private:
    //! True if H belongs to the known plane, so that the result would be the same.
    bool isKnown(const Context& context, const Matx33d& H, const int* sample) const
    {
        if (sample)
            return mapped(context, known, sample, 7) >= 5;
        const Correspondences& p = context.points;
        int both = 0, here = 0;
        const int* const inliers = plane.inliers();
        for (int k = 0; k < plane.inlierCount(); ++k)
        {
            const bool on = error(p, H, inliers[k]) <= planeLimit(context);
            here += on;
            both += on && error(p, known, inliers[k]) <= planeLimit(context);
        }
        return both > SAME_PLANE * here;
    }

    static int mapped(const Context& context, const Matx33d& H, const int* indices, int count)
    {
        int result = 0;
        for (int k = 0; k < count; ++k)
            result += error(context.points, H, indices[k]) <= planeLimit(context);
        return result;
    }

    //! True if the homography of one of the five triples maps five or more of the seven points; `H`
    //! is then this homography.
    static bool planeOfSample(const Context& context, const int* sample, const Model& F, Matx33d& H)
    {
        static const int triples[5][3] = {{0, 1, 2}, {3, 4, 5}, {0, 1, 6}, {3, 4, 6}, {2, 5, 6}};
        Vec3d e;
        Matx33d A;
        if (!epipolar(F, e, A))
            return false;
        for (int t = 0; t < 5; ++t)
        {
            const int triple[3] = {sample[triples[t][0]], sample[triples[t][1]],
                                   sample[triples[t][2]]};
            if (planeOfThree(context.points, triple, A, e, H) && mapped(context, H, sample, 7) >= 5)
                return true;
        }
        return false;
    }

    static double error(const Correspondences& p, const Matx33d& H, int i)
    {
        return TransferError::At<double>(H.val, p.exact[X1][i], p.exact[Y1][i], p.exact[X2][i],
                                         p.exact[Y2][i])
            .squared();
    }

    static int pointsOn(const Context& context, const Matx33d& H)
    {
        float m[9];
        toFloat(H, m);
        Quality sum(0, 0);
        kernelsOf<TransferError>().inliers(context.points, m, (float)planeLimit(context), 0,
                                           context.points.size, sum);
        return sum.inliers;
    }

    //! Splits all points: points with a squared error of at most `most` are on the plane.
    void split(const Correspondences& p, const Matx33d& H, double most)
    {
        float m[9];
        toFloat(H, m);
        kernelsOf<TransferError>().errors(p, m, 0, p.size, errors);
        onCount = offCount = 0;
        for (int i = 0; i < p.size; ++i)  // without branches, which would often be mispredicted
        {
            const bool on = errors[i] <= (float)most;
            onPlane[onCount] = offPlane[offCount] = i;
            onCount += on;
            offCount += !on;
        }
    }

    /** Repeats least squares over the points on the plane until their number stops growing, at most
    MAX_FITS times: the homography of three noisy points often maps only a part of the plane.
    @param least minimum number of points on a dominant plane
    @param H replaced by the homography of the last fit
    @return false if fewer than LEAST_POINTS or ROUGHLY times `least` points are on the plane before
    the first fit, or fewer than `least` after the last fit, or if a fit fails; otherwise onPlane
    and offPlane are set for planeAndParallax() */
    bool fitPlane(const Context& context, double least, Matx33d& H)
    {
        const Correspondences& p = context.points;
        if (!errors)
        {
            errors = context.arena.take<float>(p.size);
            onPlane = context.arena.take<int>(p.size);
            offPlane = context.arena.take<int>(p.size);
        }
        split(p, H, planeLimit(context));
        if (onCount < LEAST_POINTS || onCount < ROUGHLY * least)
            return false;
        Correspondences plain = p;  // without covariances, which `fitter` does not use
        plain.noise = p.noise > 1 ? 0 : p.noise;
        Model fitted = H;
        int before = 0;
        for (int k = 0; k < MAX_FITS && onCount > before; ++k)
        {
            before = onCount;
            if (!fitter->fit(plain, onPlane, std::min(before, MAX_FIT), 0, fitted, FIT_STEPS))
                return false;
            H = fitted;
            split(p, H, planeLimit(context));
        }
        if (onCount < least)
            return false;
        split(p, H, OFF_PLANE * context.inlierThreshold() * context.inlierThreshold());
        return true;
    }

    //! Replaces the model with the best F = [e]x H if this F is better.
    void planeAndParallax(const Context& context, const State& state, const Matx33d& H,
                          Model& model, Quality& quality)
    {
        const double off = offCount, wanted = OF_INTEREST * state.bestQuality.inliers - onCount;
        if (off < 2 || wanted > off)
            return;
        if (!parallax)
            parallax = new (context.arena.take<PlaneParallax>(1)) PlaneParallax();
        parallax->setPlane(context, offPlane, offCount, H);
        parallax->search(context, 1 - context.params.confidence, wanted * parallax->size() / off,
                         model, quality);
    }

    Ptr<NonMinimalSolver> fitter;
    Matx33d known;         //!< homography of the known plane
    int knownPoints;       //!< number of points that `known` maps; 0: there is no known plane
    Model knownModel;      //!< the F found with the known plane
    Quality knownQuality;  //!< score of knownModel; infinite cost: no better F was found
    DominantPlane plane;
    int *onPlane, *offPlane;
    float* errors;  //!< squared errors of all points under the homography; null before the first
                    //!< plane
    int onCount, offCount;    //!< numbers of points on and off the plane
    PlaneParallax* parallax;  //!< null before the first plane
};

}  // namespace

Ptr<Degeneracy> createDegensac() { return makePtr<Degensac>(); }

}  // namespace usacv20
}  // namespace cv
