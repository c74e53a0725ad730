// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LEAST_SQUARES_HPP
#define OPENCV_USACV20_LEAST_SQUARES_HPP

#include "control/watch.hpp"
#include "optimization/cholesky.hpp"
#include "optimization/inner_product.hpp"
#include "residual/normal_equations.hpp"

namespace cv {
namespace usacv20 {

//! Function object that creates the parameterization around a model, for parameterizations that
//! depend only on the model.
template <class Parameterization>
struct AroundModel
{
    Parameterization operator()(const Model& model) const { return Parameterization(model); }
};

/** @brief Least squares of the geometric error by the Gauss-Newton method, with Levenberg-Marquardt
damping @cite more1978levenberg after a step that does not lower the cost.

Minimizes the sum of (weighted) squared errors of a Residual, starting from a given model. The
parameterization is minimal: it has dimension() parameters for the NUMBERS entries of a model, and
the methods project(), plus(), model() and wellConditioned(). A fit fails if wellConditioned() is
false for its result. As the fit starts from a model, it needs no linear estimate; it therefore
works on planar scenes, where the eight-point method fails. A fit takes about 40 (H) or 100 (F, E)
operations per point and iteration, and twice as many for the symmetric errors.

The first step is not damped, because a polisher can request only one step in each call of fit().
With damping, weakly determined parameters (the epipole under forward motion) would hardly change in
any of these calls.

When the run must end (Params::maxTime, ProgressScope), a fit ends after its current step. */
template <class Parameterization, class Around = AroundModel<Parameterization>>
class LeastSquaresSolver : public NonMinimalSolver
{
public:
    //! @param residual_ error to minimize
    //! @param errorDimension_ Problem::errorDimension()
    //! @param around_ function object that creates the parameterization around a model
    LeastSquaresSolver(const Ptr<Residual>& residual_, int errorDimension_,
                       const Around& around_ = Around())
        : residual(residual_), errorDimension(errorDimension_), around(around_), arena(0), watch(0)
    {}

    void start(const Context& context) CV_OVERRIDE
    {
        arena = &context.arena;
        watch = context.watch;
    }

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        Parameterization here = around(model);
        if (errorDimension * count < here.dimension())
            return false;
        const PointChunks chunks(points, indices, count, weights, arena);
        Equations sums;
        sums.accumulate(*residual, chunks, here.model());
        if (!(sums.cost <= DBL_MAX))
            return false;
        double damping = 0;
        int steps = 0;
        for (int attempt = 0; attempt < iterations + RETRIES && steps < iterations; ++attempt)
        {
            Step step;
            double gain;
            const bool solved = solve(here, sums, damping, step, gain);
            if (!solved && damping > 0)
                return false;
            if (solved && !(gain > ARRIVED * sums.cost))
                break;
            const bool last = steps + 1 >= iterations || gain < SETTLED * sums.cost;
            if (solved && tryStep(chunks, step, last, here, sums))
            {
                if (last)
                    break;
                damping = damping > FIRST_DAMPING ? damping * 0.1 : 0;
                ++steps;
            }
            else
                damping = std::max(damping * 10, FIRST_DAMPING);
            if (watch && watch->stop(count))
                break;
        }
        if (!here.wellConditioned())
            return false;
        model = here.model();
        return true;
    }

private:
    typedef typename Parameterization::Step Step;
    typedef typename Parameterization::Matrix Matrix;
    typedef NormalEquationsOf<Parameterization::NUMBERS> Equations;

    //! Takes the step if it lowers the cost. Computes the new normal equations, or the cost alone
    //! if the step is the last one.
    bool tryStep(const PointChunks& chunks, const Step& step, bool last, Parameterization& here,
                 Equations& sums) const
    {
        const Parameterization trial = here.plus(step);
        Equations trialSums;
        if (last)
            trialSums.cost = Equations::costOf(*residual, chunks, trial.model());
        else
            trialSums.accumulate(*residual, chunks, trial.model());
        if (!(trialSums.cost < sums.cost))  // NaN is rejected, too
            return false;
        here = trial;
        if (!last)
            sums = trialSums;
        return true;
    }

    /** Solves the damped normal equations on the tangent space.
    @param gain output: the decrease of the cost that is expected for linear residuals
    @return false if the equations are singular or not finite */
    static bool solve(const Parameterization& here, const Equations& sums, double damping,
                      Step& step, double& gain)
    {
        Matrix A;
        Step b, added;
        here.project(sums, A, b);
        added = damping * A.diagonal();
        added.array() += SINGULAR * A.trace() / (double)A.rows();
        A.diagonal() += added;
        step = -b;
        if (!solvePositiveDefinite(A, step))
            return false;
        gain = innerProduct(added, step.cwiseAbs2()) - innerProduct(b, step);
        return step.allFinite();
    }

    //! Number of unsuccessful steps (the cost does not decrease) that are allowed in addition to
    //! the requested iterations.
    enum { RETRIES = 2 };
    //! After the first unsuccessful step, each diagonal entry of the normal equations is multiplied
    //! by 1 + FIRST_DAMPING. SINGULAR times the mean of the diagonal is always added to each
    //! diagonal entry, so that the equations can be solved even if they are singular.
    static const double FIRST_DAMPING, SINGULAR;
    //! If the expected decrease of the cost by a step is less than SETTLED times the cost, the step
    //! is the last one. If it is at most ARRIVED times the cost, the step is not taken, and the fit
    //! ends.
    static const double SETTLED, ARRIVED;

    const Ptr<Residual> residual;
    const int errorDimension;
    const Around around;
    Arena* arena;  //!< memory of the run; null before the first run
    Watch* watch;  //!< ends the fits of the run early; null: nothing can stop the run
};

template <class Parameterization, class Around>
const double LeastSquaresSolver<Parameterization, Around>::FIRST_DAMPING = 1e-4;
template <class Parameterization, class Around>
const double LeastSquaresSolver<Parameterization, Around>::SINGULAR = 1e-12;
template <class Parameterization, class Around>
const double LeastSquaresSolver<Parameterization, Around>::SETTLED = 1e-4;
template <class Parameterization, class Around>
const double LeastSquaresSolver<Parameterization, Around>::ARRIVED = 1e-10;

}  // namespace usacv20
}  // namespace cv

#endif
