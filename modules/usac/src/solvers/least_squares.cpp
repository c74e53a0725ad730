// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "solvers/parameterization.hpp"
#include "solvers/normal_equations.hpp"
#include "solvers/solvers.hpp"

#include <Eigen/Cholesky>

namespace cv {
namespace usacv20 {

namespace {

/** @brief Least squares of the geometric error by Gauss and Newton's method, damped as by Levenberg and Marquardt
@cite more1978levenberg after a step that does not lower the cost.

Minimizes the sum of (weighted) squared errors of one of the kinds of Residual over the models of one kind,
from the given one. Starting from a model, not from nothing, it needs no linear estimate and is not confused by planar
scenes, on which the eight-point method fails. About 40 (H) or 100 (F, E) operations a point and iteration, twice that for the
symmetric errors.

The first step is not damped: a polisher asks for one step at a time, and any damping that is worth its name would stop
the movement in a weakly determined direction (along the epipole under a forward motion) each time anew. */
class LeastSquaresSolver : public NonMinimalSolver
{
public:
    LeastSquaresSolver(ProblemType problem_, Residual::Kind kind_) : problem(problem_), kind(kind_) {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        Parameterization here(problem, model);
        if (residuals(count) < here.dimension())
            return false;
        const PointChunks chunks(points, indices, count, weights);
        NormalEquations sums, trialSums;
        sums.accumulate(kind, chunks, here.model());
        if (!(sums.cost <= DBL_MAX))
            return false;
        double damping = 0;
        int steps = 0;
        for (int attempt = 0; attempt < iterations + RETRIES && steps < iterations; ++attempt)
        {
            Parameterization::Step step;
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
        }
        if (!here.hasFullRank())
            return false;
        model = here.model();
        return true;
    }

private:
    int residuals(int count) const { return problem == HOMOGRAPHY ? 2 * count : count; }

    //! Takes the step if it lowers the cost; with the new normal equations, or with the cost alone if it is the last one.
    bool tryStep(const PointChunks& chunks, const Parameterization::Step& step, bool last, Parameterization& here,
                 NormalEquations& sums) const
    {
        const Parameterization trial = here.plus(step);
        NormalEquations trialSums;
        if (last)
            trialSums.cost = NormalEquations::costOf(kind, chunks, trial.model());
        else
            trialSums.accumulate(kind, chunks, trial.model());
        if (!(trialSums.cost < sums.cost))  // also for NaN
            return false;
        here = trial;
        if (!last)
            sums = trialSums;
        return true;
    }

    /** Step of the damped normal equations on the tangent space, and by how much it lowers the cost where the residuals are
    linear. False if they are singular or not finite. */
    static bool solve(const Parameterization& here, const NormalEquations& sums, double damping, Parameterization::Step& step,
                      double& gain)
    {
        switch (here.dimension())
        {
        case 8: return solveFixed<8>(here, sums, damping, step, gain);
        case 7: return solveFixed<7>(here, sums, damping, step, gain);
        default: return solveFixed<5>(here, sums, damping, step, gain);
        }
    }

    template <int DIMENSION>
    static bool solveFixed(const Parameterization& here, const NormalEquations& sums, double damping,
                           Parameterization::Step& step, double& gain)
    {
        Eigen::Matrix<double, DIMENSION, DIMENSION> A;
        Eigen::Matrix<double, DIMENSION, 1> b, x, added;
        here.project(sums.JtJ, sums.Jtr, A, b);
        added = damping * A.diagonal();
        added.array() += SINGULAR * A.trace() / DIMENSION;
        A.diagonal() += added;
        const Eigen::LLT<Eigen::Matrix<double, DIMENSION, DIMENSION> > llt(A);
        if (llt.info() != Eigen::Success)
            return false;
        x = -llt.solve(b);
        gain = added.dot(x.cwiseAbs2()) - b.dot(x);
        step = x;
        return x.allFinite();
    }

    //! So many steps that did not lower the cost are not counted.
    enum { RETRIES = 2 };
    //! What is added to the diagonal of the normal equations: a part of it after a step that failed, and of their mean always.
    static const double FIRST_DAMPING, SINGULAR;
    //! Expected decrease, a part of the cost, of a step that is the last one, and of one that is not worth its while.
    static const double SETTLED, ARRIVED;

    const ProblemType problem;
    const Residual::Kind kind;
};

const double LeastSquaresSolver::FIRST_DAMPING = 1e-4;
const double LeastSquaresSolver::SINGULAR = 1e-12;
const double LeastSquaresSolver::SETTLED = 1e-4;
const double LeastSquaresSolver::ARRIVED = 1e-10;

} // namespace

Ptr<NonMinimalSolver> createLeastSquaresSolver(ProblemType problem, Residual::Kind kind)
{
    return makePtr<LeastSquaresSolver>(problem, kind);
}

} // namespace usacv20
} // namespace cv
