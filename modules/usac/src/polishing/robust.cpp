// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "polishing/leverage.hpp"
#include "polishing/polishing.hpp"
#include "polishing/restarts.hpp"
#include "numeric/chi_square.hpp"
#include "numeric/instruction_set.hpp"
#include "optimization/noise_scale.hpp"

namespace cv {
namespace usacv20 {

namespace {

/** Support of the biweight in standard deviations of the noise: larger errors have a weight of 0.
With 5.3, the standard errors of fits are 1.6 % (F, E) or 2.3 % (H) larger than those of least
squares if the noise is Gaussian. */
constexpr double SUPPORT = 5.3;
/** Until the loss has settled (see SETTLED), all steps except the last two use only the first
points: so many that FEW points, or 1 / PART of all points if this is more, are within REACH
thresholds. */
constexpr int REACH = 3, FEW = 500, PART = 8;
/** If there are more than MANY points, the search has used only a part of them
(ProblemData::SEARCHED). The distance of its model from the minimum is then larger, relative to the
standard error of a fit to all points. Therefore MORE steps are added, nearly all of which use only
the first points. */
constexpr int MANY = 1 << 15, MORE = 6;
//! Errors are computed for BLOCK points at a time. The last fit has at most LAST steps, which are
//! enough to converge.
constexpr int BLOCK = 256, LAST = 10;
//! There is another step if further steps are expected to decrease the loss by at least SETTLED
//! times the mean loss of a point within the support (see Convergence), or if the scale changes by
//! at least the fraction SAME_SCALE. A decrease by SETTLED means that the model is about a tenth of
//! its standard error away from the minimum.
constexpr double SETTLED = 0.03, SAME_SCALE = 0.1;
//! The noise is estimated before the first step, before the middle step, after each step with which
//! the loss has settled (see SETTLED), and after each step that has decreased the loss by more than
//! MARKED times the loss of the points within the support.
constexpr double MARKED = 0.1;

/** Predicts by how much further steps will decrease the loss. Near the minimum, the decrease of
each step is a constant fraction (the rate) of the one before. */
class Convergence
{
public:
    Convergence() : rate(-1), before(0) {}

    //! To be called if the next decrease cannot be compared with those before, because other points
    //! or another scale of the noise are used.
    void restart() { before = 0; }
    //! @param decrease decrease of the loss by the last step
    //! @return the sum of all further decreases, but at most `decrease`, the sum for a rate of 1 /
    //! 2
    double left(double decrease)
    {
        if (before > 0 && decrease > 0)
            rate = std::max(rate, std::min(std::max(decrease / before, 0.), 0.5));
        before = decrease;
        return decrease * (rate < 0 ? 1 : rate / (1 - rate));
    }

private:
    double rate;    //!< largest rate so far; -1: not known
    double before;  //!< the decrease before; 0: not known
};

/** Gauss-Newton minimization of the geometric error under Tukey's biweight @cite beaton1974fitting,
by re-weighting with w = (1 - (error / support)^2)^2 in each step. The support is #SUPPORT standard
deviations of the noise (NoiseScale); with this support, the biweight is nearly as accurate as least
squares under Gaussian noise. Points beyond the support have no influence: a wrong match far from
the other points in the images (for example near the epipole) would distort F even with a weight of
1/100.

Each step is lengthened (lengthen()) until a longer step has raised the loss; then the shorter step
is taken instead.

The iteration ends when further steps would lower the loss by less than #SETTLED times the mean loss
of a point within the support (a limit that does not depend on the threshold) and the scale of the
noise hardly changes, but at the latest after Params::polishingSteps steps, or #MORE steps later if
there are more than #MANY points. The last of these possible steps is a fit that runs to
convergence. */
class BiweightPolisher : public Polisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        const int steps = context.params.polishingSteps + (p.size > MANY ? MORE : 0);
        const int degrees = p.problem->errorDimension();
        double sigma = 0, lossBefore = DBL_MAX;
        bool longer = true;
        Model fitted = model;
        Convergence convergence;
        int wanted = std::max(FEW, p.size / PART), lookedBefore = 0;
        Arena::Scope scope(context.arena);
        errors = scope.take<float>(p.size);
        near = scope.take<int>(p.size);
        weights = scope.take<double>(p.size + LANES);
        for (int i = 0; i < steps && !(i > 0 && context.stop()); ++i)
        {
            const int most = i + 2 < steps ? wanted : p.size;
            int looked = look(context, model, most);
            double loss = i > 0 ? weigh(p, sigma, looked) : 0;
            if (longer && looked == lookedBefore && loss > lossBefore + least())
            {
                longer = false;
                model = fitted;
                looked = look(context, model, most);
                loss = weigh(p, sigma, looked);
            }
            const double decrease = lossBefore - loss;
            const bool settled = looked == lookedBefore && convergence.left(decrease) < least();
            if (settled && looked < p.size)
                looked = look(context, model, wanted = p.size);
            if (i == 0 || i == steps / 2 || settled || decrease > MARKED * lossNear)
            {
                const double before = sigma;
                sigma = NoiseScale::estimate(errors, looked, p.threshold, degrees);
                if (settled && lookedBefore == p.size &&
                    std::abs(sigma - before) < SAME_SCALE * sigma)
                    return;
                if (std::abs(sigma - before) >= SAME_SCALE * sigma)
                    convergence.restart();
                loss = weigh(p, sigma, looked);
            }
            if (looked != lookedBefore)
                convergence.restart();
            lossBefore = loss;
            lookedBefore = looked;
            fitted = model;
            if (!context.nonMinimalSolver().fit(p, near, count, weights, fitted,
                                                i + 1 < steps ? 1 : LAST))
                return;
            if (longer && i + 1 < steps)
                lengthen(degrees, context.components.residual->homogeneous(), fitted, model);
            else
                model = fitted;
        }
        model = fitted;
    }

    double support(const Context& context, const float* squaredErrors) const CV_OVERRIDE
    {
        const Correspondences& p = context.points;
        return SUPPORT * p.threshold *
               NoiseScale::estimate(squaredErrors, p.size, p.threshold,
                                    p.problem->errorDimension());
    }

    double weight(double square, int) const CV_OVERRIDE { return (1 - square) * (1 - square); }

private:
    //! Computes errors of the first points, in blocks, until `wanted` points are within #REACH
    //! thresholds. @return number of points whose errors were computed
    int look(const Context& context, const Model& model, int wanted)
    {
        const Correspondences& p = context.points;
        const float limit = (float)(REACH * REACH * p.threshold * p.threshold);
        int looked = 0, found = 0;
        while (looked < p.size && found < wanted)
        {
            const int size = std::min<int>(BLOCK, p.size - looked);
            float* const block = &errors[looked];
            context.components.residual->squaredErrors(p, model, looked, looked + size, block);
            for (int i = 0; i < size; ++i)
                found += block[i] <= limit;
            looked += size;
        }
        return looked;
    }

    /** Finds the points within the support among the first `looked` points, and their weights.
    @return sum of the losses of the first `looked` points, each at most 1 */
    double weigh(const Correspondences& p, double sigma, int looked)
    {
        const double support = SUPPORT * sigma * p.threshold, scale = 1 / (support * support);
        const float limit = (float)(support * support);
        const float* const e = errors;
        int* const members = near;
        double* const w = weights;
        int size = 0;
        for (int i = 0; i < looked; ++i)  // without branches, because these would often be
                                          // mispredicted
        {
            members[size] = i;
            w[size] = e[i];
            size += e[i] < limit;  // NaN is not within the support
        }
        std::fill(w + size, w + alignSize(size, LANES), support * support);  // of weight 0, nearly
        double rests[LANES] = {0}, squares[LANES] = {0}, cubes[LANES] = {0};
        for (int k = 0; k < size; k += LANES)
        {
            USAC_SIMD
            for (int lane = 0; lane < LANES; ++lane)
            {
                const double rest = 1 - w[k + lane] * scale, square = rest * rest;
                w[k + lane] = square;
                rests[lane] += rest;
                squares[lane] += square;
                cubes[lane] += square * rest;
            }
        }
        sumOfWeights = sumOf(squares);
        lostCurvature = 4 * (sumOf(rests) - sumOfWeights);
        count = size;
        lossNear = size - sumOf(cubes);
        return looked - sumOf(cubes);
    }

    enum { LANES = 4 };  //!< number of partial sums, see weigh()

    static double sumOf(const double* lanes)
    {
        return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
    }

    //! Smallest change of the loss that counts, see SETTLED.
    double least() const { return SETTLED * lossNear / std::max(count, 1); }

    /** Re-weighting takes the weight w of a point for the curvature of its loss. In the direction
    of the error, the curvature is lower: with w = (1 - x)^2 it is (1 - x)(1 - 5x) = w - 4 (1 - x)
    x. The step from `model` to `fitted` is lengthened by the ratio of the sums of w and of the
    curvature over all directions of the errors, at most to twice its length, up to which the loss
    does not increase if the errors are linear in the model. The result fulfills the constraints of
    the model only to first order. */
    void lengthen(int degrees, bool homogeneous, const Model& fitted, Model& model) const
    {
        const double curvature = std::max(sumOfWeights - lostCurvature / degrees, sumOfWeights / 2),
                     further = sumOfWeights / curvature - 1;
        const double scale = homogeneous ? scaleOf(fitted, model) : 1;
        for (int k = 0; k < fitted.size(); ++k)
            model.val[k] = fitted.val[k] + further * (fitted.val[k] - scale * model.val[k]);
    }

    //! The factor by which a fit has scaled a homogeneous model `before`, whose sign can also have
    //! changed. A change of less than a tenth counts as a change of the model.
    static double scaleOf(const Model& fitted, const Model& before)
    {
        double product = 0, square = 0;
        for (int k = 0; k < fitted.size(); ++k)
        {
            product += fitted.val[k] * before.val[k];
            square += before.val[k] * before.val[k];
        }
        return std::abs(product - square) <= 0.1 * square ? 1 : product / square;
    }

    // The following members are valid only during polish().
    float* errors;                       //!< squared errors of the points
    int* near;                           //!< points within the support: the first `count` elements
    double* weights;                     //!< weights of the points in `near`
    int count;                           //!< number of points within the support
    double lossNear;                     //!< sum of the losses of the points within the support
    double sumOfWeights, lostCurvature;  //!< of the points within the support, see lengthen()
};

//! BiweightPolisher; if there are few inliers, also from other initial models (Restarts). A model
//! that is distorted by wrong matches of high leverage is corrected (Leverage).
class RobustPolisher : public BiweightPolisher
{
public:
    void polish(const Context& context, Model& model) CV_OVERRIDE
    {
        BiweightPolisher::polish(context, model);
        Restarts(context, biweight).improve(model);
        Leverage(context, biweight).improve(model);
    }

private:
    BiweightPolisher biweight;
};

}  // namespace

Ptr<Polisher> createBiweightPolisher() { return makePtr<BiweightPolisher>(); }
Ptr<Polisher> createRobustPolisher() { return makePtr<RobustPolisher>(); }

}  // namespace usacv20
}  // namespace cv
