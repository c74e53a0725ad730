// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "solvers/manifold.hpp"
#include "solvers/normal_equations.hpp"
#include "solvers/solvers.hpp"

#include <Eigen/Cholesky>

namespace cv {
namespace usacv20 {

namespace {

/** @brief Least squares of the geometric error by Levenberg and Marquardt's method @cite more1978levenberg.

Minimises the sum of (weighted) squared errors of one of the kinds of Residual over the manifold of the model,
from the given one. Starting from a model, not from nothing, it needs no linear estimate and is not confused by planar
scenes, on which the eight-point method fails. About 40 (H) or 100 (F, E) operations a point and iteration, twice that for the
symmetric errors. */
class LeastSquaresSolver : public NonMinimalSolver
{
public:
    LeastSquaresSolver(ProblemType problem_, Residual::Kind kind_) : problem(problem_), kind(kind_) {}

    bool fit(const Correspondences& points, const int* indices, int count, const double* weights,
             Model& model, int iterations) const CV_OVERRIDE
    {
        Manifold here(problem, model);
        if (residuals(count) < here.dimension())
            return false;
        const PointChunks chunks(points, indices, count, weights);
        NormalEquations sums, trialSums;
        sums.accumulate(kind, chunks, here.model());
        if (!(sums.cost <= DBL_MAX))
            return false;
        double damping = 1e-4;
        for (int iteration = 0; iteration < iterations && sums.cost > 0; ++iteration)
        {
            Manifold::Step step;
            if (!solve(here, sums, damping, step))
                return false;
            const Manifold trial = here.moved(step);
            if (iteration + 1 < iterations)
                trialSums.accumulate(kind, chunks, trial.model());
            else
                trialSums.cost = NormalEquations::costOf(kind, chunks, trial.model());
            const bool better = trialSums.cost < sums.cost;  // false for NaN
            const double gain = sums.cost - trialSums.cost;
            if (better)
            {
                here = trial;
                sums = trialSums;
                damping = std::max(damping * 0.1, 1e-12);
            }
            else
                damping *= 10;
            if ((better && gain < 1e-4 * sums.cost) || damping > 1e6)
                break;
        }
        if (!here.hasFullRank())
            return false;
        model = here.model();
        return true;
    }

private:
    int residuals(int count) const { return problem == HOMOGRAPHY ? 2 * count : count; }

    //! Step of the damped normal equations on the tangent space; false if they are singular or not finite.
    static bool solve(const Manifold& here, const NormalEquations& sums, double damping, Manifold::Step& step)
    {
        switch (here.dimension())
        {
        case 8: return solveFixed<8>(here, sums, damping, step);
        case 7: return solveFixed<7>(here, sums, damping, step);
        default: return solveFixed<5>(here, sums, damping, step);
        }
    }

    template <int DIMENSION>
    static bool solveFixed(const Manifold& here, const NormalEquations& sums, double damping, Manifold::Step& step)
    {
        Eigen::Matrix<double, DIMENSION, DIMENSION> A;
        Eigen::Matrix<double, DIMENSION, 1> b;
        here.project(sums.JtJ, sums.Jtr, A, b);
        const double mean = A.trace() / DIMENSION;
        for (int i = 0; i < DIMENSION; ++i)
            A(i, i) += damping * A(i, i) + 1e-12 * mean;
        const Eigen::LLT<Eigen::Matrix<double, DIMENSION, DIMENSION> > llt(A);
        if (llt.info() != Eigen::Success)
            return false;
        step = -llt.solve(b);
        return step.allFinite();
    }

    const ProblemType problem;
    const Residual::Kind kind;
};

} // namespace

Ptr<NonMinimalSolver> createLeastSquaresSolver(ProblemType problem, Residual::Kind kind)
{
    return makePtr<LeastSquaresSolver>(problem, kind);
}

} // namespace usacv20
} // namespace cv
