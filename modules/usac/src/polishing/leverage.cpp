// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "opencv2/usac/problem.hpp"
#include "components/sample_group.hpp"
#include "components/streams.hpp"
#include "residual/normal_equations.hpp"
#include "polishing/leverage.hpp"

#include <Eigen/Cholesky>

namespace cv {
namespace usacv20 {

namespace {

//! Fraction of the inliers that the first fit uses: the inliers with the lowest leverage.
constexpr double BULK = 0.85;
//! If no inlier has at least this leverage, the model is not changed. The leverage of a point is at
//! most 1; a point with a high leverage can determine a parameter by itself.
constexpr double HIGH = 0.4;
//! A point is included again if its error is at most DEVIATIONS times the standard deviation that
//! the fit predicts for this error. In the first of two rounds, its error must also be within the
//! threshold, and its leverage at most PREDICTED. In the second round, an error above the threshold
//! must be at most DEVIATIONS standard deviations of the noise alone.
constexpr double DEVIATIONS = 3, PREDICTED = 0.3;
/** Minimum decrease (gain) of the sum of squared errors, in noise variances. If the first fit gains
less than HOPE, the attempt ends; the result must gain at least GAIN. Changing two parameters gains
6 or more by chance in one of 20 cases. This does no harm: the new model is then as good as the old
one. */
constexpr double HOPE = 3, GAIN = 6;
/** Stricter conditions if nearly all inliers leave parameters undetermined (Problem::leavesFree),
as points on a plane leave the epipole undetermined. The gain must be at least FREE_GAIN. It must
also be at least TURNED sqrt(n) for n points: another epipole changes the direction in which all
errors are measured, and the difference of two sums of n squares has a standard deviation of at most
2 sqrt(n) noise variances. The evidence of the lost inliers against the fit (surpriseOf()) must be
at most gain / FREE_AGAINST, because only inliers off the plane determine the epipole. With GAIN as
the only condition, F can lose the right matches off the plane if there are few of them.
If parameters are undetermined, an ambiguous model (E, see Problem::ambiguous) is not changed,
because fits can end between the two models that are compatible with the plane. */
constexpr double FREE_GAIN = 20, TURNED = 1.5, FREE_AGAINST = 8;
//! Lower bound of the standard deviation of the noise, in thresholds: the accuracy of errors in
//! single precision.
constexpr double LEAST_NOISE = 1e-3;
//! Maximum number of steps of a fit. The fit does not have to converge, because the result is
//! polished.
constexpr int LEVERAGE_STEPS = 5;

//! The sum of |L d|^2 over the derivatives d of the error of each point, see LeverageKernel.
void squaredNorms(const Residual& residual, const PointChunks& points, const Model& model,
                  const double* L, double* result)
{
    if (residual.kernels())
    {
        points.leverages(residual.kernels()->leverages, model.val, L, result);
        return;
    }
    const int numbers = model.size();
    double datum[MAX_COLUMNS], weight, error[Residual::MAX_COMPONENTS], derivative[MAX_DERIVATIVE];
    for (int i = 0; points.get(i, datum, weight); ++i)
    {
        const int components = residual.linearize(model, datum, error, derivative);
        result[i] = 0;
        for (int k = 0; k < components * numbers; ++k)
        {
            const int first = k - k % numbers;
            double sum = 0;
            for (int col = 0; col <= k % numbers; ++col)
                sum += L[k % numbers * numbers + col] * derivative[first + col];
            result[i] += sum * sum;
        }
    }
}

}  // namespace

Leverage::Leverage(const Context& context_, Polisher& polisher_)
    : context(context_), parts(context_.components), polisher(polisher_),
      limit(context_.inlierThreshold() * context_.inlierThreshold()), errors(0), looked(0),
      inliers(), bulk(), all(0)
{}

void Leverage::improve(Model& model)
{
    const int size = context.points.size;
    if (context.points.problem->errorDimension() > 1 || context.stop())
        return;
    Arena::Scope scope(context.arena);
    errors = scope.take<float>(size);
    inliers.indices = scope.take<int>(MOST);
    bulk.indices = scope.take<int>(MOST);
    if (!look(model) || !findBulk(model))
        return;
    Model fitted = model;
    if (!fit(bulk, 0, fitted))
        return;
    const double sum = sumOf(bulk, fitted);
    if (sumOf(bulk, model) - sum < HOPE * variance(sum, bulk.count))
        return;
    looked = std::min(4 * looked, size);
    Points near = {scope.take<int>(size), 0}, rest = {scope.take<int>(size), 0};
    if (!agreeing(fitted, bulk, PREDICTED, near) || !fit(near, STARTS, fitted) ||
        !agreeing(fitted, near, DBL_MAX, rest) ||
        !parts.nonMinimalSolver->fit(context.points, rest.indices, rest.count, 0, fitted,
                                     LEVERAGE_STEPS) ||
        !convinces(fitted, model, rest))
        return;
    polisher.polish(context, fitted);
    fitted = context.points.problem->closest(fitted);
    if (convinces(fitted, model, rest))
        model = fitted;
}

bool Leverage::convinces(const Model& fitted, const Model& model, const Points& points) const
{
    Arena::Scope scope(context.arena);
    Points common = {scope.take<int>(points.count), 0};
    sumOf(points, model);
    double before = 0;
    for (int k = 0; k < points.count; ++k)
    {
        const int i = points.indices[k];
        if (!(errors[i] <= (float)limit))
            continue;
        before += errors[i];
        common.indices[common.count++] = i;
    }
    const double sum = sumOf(common, fitted), gain = (before - sum) / variance(sum, common.count);
    if (!(gain >= GAIN))
        return false;
    const double against = surpriseOf(all - inliersOf(fitted));
    if (against > gain / 2 ||  // gain / 2 is the increase of the log-likelihood
        against > byChance())
        return false;
    const Problem& problem = *context.points.problem;
    const bool certain = !problem.ambiguous() && against <= gain / FREE_AGAINST &&
                         gain >= std::max(FREE_GAIN, TURNED * std::sqrt((double)common.count));
    return certain || !problem.leavesFree(context, fitted);
}

bool Leverage::look(const Model& model)
{
    const Correspondences& p = context.points;
    all = inliersOf(model);
    inliers.count = 0;
    for (int i = 0; i < p.size && inliers.count < MOST; ++i)
        if (errors[i] <= (float)limit)  // NaN is not an inlier
        {
            inliers.indices[inliers.count++] = i;
            looked = i + 1;
        }
    if (BULK * inliers.count < 2 * p.problem->dimension() || all == p.size)
        return false;
    return surpriseOf(1) <= byChance();
}

double Leverage::surpriseOf(int lost) const
{
    const Correspondences& p = context.points;
    const double chance = p.problem->randomInlierRatio(p) * std::sqrt(limit) / p.threshold;
    if (lost <= 0 || chance >= 1)
        return 0;
    const double size = p.size - all + lost, part = lost / size;
    if (part <= chance)
        return 0;
    return size * (part * std::log(part / chance) +
                   (part < 1 ? (1 - part) * std::log((1 - part) / (1 - chance)) : 0));
}

double Leverage::byChance() const { return 2 * std::log((double)context.points.size - all); }

bool Leverage::findBulk(const Model& model)
{
    double own[MOST];
    int order[MOST];
    const int count = inliers.count;
    if (!leverages(model, inliers, inliers, own) || !(*std::max_element(own, own + count) >= HIGH))
        return false;
    for (int k = 0; k < count; ++k)
        order[k] = k;
    bulk.count = (int)(BULK * count);
    std::nth_element(order, order + bulk.count, order + count, [&own](int a, int b) {
        return own[a] < own[b] || (own[a] == own[b] && a < b);
    });
    std::sort(order, order + bulk.count);  // because the order after nth_element is unspecified
    for (int k = 0; k < bulk.count; ++k)
        bulk.indices[k] = inliers.indices[order[k]];
    return true;
}

bool Leverage::fit(const Points& points, int first, Model& model) const
{
    const NonMinimalSolver& solver = *parts.nonMinimalSolver;
    Model other = model;
    const bool fits = solver.fit(context.points, points.indices, points.count, 0, model,
                                 LEVERAGE_STEPS);
    if (sampled(points, first, other) &&
        solver.fit(context.points, points.indices, points.count, 0, other, LEVERAGE_STEPS) &&
        (!fits || sumOf(points, other) < sumOf(points, model)))
    {
        model = other;
        return true;
    }
    return fits;
}

bool Leverage::sampled(const Points& points, int first, Model& model) const
{
    const int m = parts.minimalSolver->sampleSize();
    double least = DBL_MAX;
    SampleGroup group;
    CV_StaticAssert((int)STARTS <= (int)SampleGroup::SIZE, "the samples are solved together");
    for (int i = 0; i < STARTS; ++i)
    {
        Rng rng(context.params.seed, streamOf(STREAM_LEVERAGE, 1 + first + i));
        int* const sample = group.samples[i];
        rng.distinct(points.count, m, sample);
        for (int k = 0; k < m; ++k)
            sample[k] = points.indices[sample[k]];
    }
    group.solve(*parts.minimalSolver, context.points, STARTS);
    for (int i = 0; i < STARTS; ++i)
        for (int k = 0; k < group.found[i]; ++k)
        {
            const double sum = sumOf(points, group.models[i][k]);
            if (!(sum < least))
                continue;
            least = sum;
            model = group.models[i][k];
        }
    return least < DBL_MAX;
}

bool Leverage::agreeing(const Model& model, const Points& fitted, double most, Points& result) const
{
    CV_DbgAssert(fitted.count > context.points.problem->dimension());
    const double noise = DEVIATIONS * DEVIATIONS * variance(sumOf(fitted, model), fitted.count);
    Arena::Scope scope(context.arena);
    Points near = {scope.take<int>(looked), 0};
    double* const own = scope.take<double>(looked);
    const double widest = std::min(limit, noise * (1 + most));
    result.count = 0;
    for (int i = 0; i < looked; ++i)  // sumOf() has computed `errors`
    {
        if (most == DBL_MAX && errors[i] <= noise)
        {
            result.indices[result.count++] = i;
            continue;
        }
        near.indices[near.count] = i;
        near.count += errors[i] <= widest;
    }
    if (!leverages(model, fitted, near, own))
        return false;
    for (int k = 0; k < near.count; ++k)
        if (own[k] <= most && errors[near.indices[k]] <= noise * (1 + own[k]))
            result.indices[result.count++] = near.indices[k];
    return result.count > context.points.problem->dimension() &&
           result.count > parts.minimalSolver->sampleSize();
}

//! Uses derivatives with respect to all entries of the model, although the model has fewer degrees
//! of freedom. This increases the leverages of all points similarly.
template <int ENTRIES>
bool Leverage::leveragesOf(const Model& model, const Points& fitted, const Points& points,
                           double* result) const
{
    typedef Eigen::Matrix<double, ENTRIES, ENTRIES> Square;
    typedef Eigen::Matrix<double, ENTRIES, ENTRIES, Eigen::RowMajor> RowMajor;
    typedef Eigen::Matrix<double, ENTRIES, 1> Row;
    const Correspondences& p = context.points;
    const PointChunks chunks(p, fitted.indices, fitted.count, 0, &context.arena);
    NormalEquationsOf<ENTRIES> sums;
    sums.accumulate(*parts.residual, chunks, model);
    // Errors do not depend on the scale of the model, so JtJ is singular in the direction of a
    // change of scale; the first added term removes this singularity. If the derivative of a custom
    // residual is NaN, so is the trace of A, and false is returned.
    const Row scale = Eigen::Map<const Row>(model.val);
    Square A = sums.JtJ;
    A += scale * scale.transpose() * (A.trace() / scale.squaredNorm());
    A.diagonal().array() += 1e-14 * A.trace();
    const Eigen::LLT<Square> llt(A);
    if (!(A.trace() <= DBL_MAX) || llt.info() != Eigen::Success)
        return false;
    const RowMajor inverse = llt.matrixL().solve(Square::Identity());
    if (points.indices == fitted.indices)
        squaredNorms(*parts.residual, chunks, model, inverse.data(), result);
    else if (points.count > 0)
        squaredNorms(*parts.residual,
                     PointChunks(p, points.indices, points.count, 0, &context.arena), model,
                     inverse.data(), result);
    return true;
}

bool Leverage::leverages(const Model& model, const Points& fitted, const Points& points,
                         double* result) const
{
    return model.size() == 9    ? leveragesOf<9>(model, fitted, points, result)
           : model.size() == 12 ? leveragesOf<12>(model, fitted, points, result)
                                : false;
}

double Leverage::sumOf(const Points& points, const Model& model) const
{
    parts.residual->squaredErrors(context.points, model, 0, looked, errors);
    double sum = 0;
    for (int k = 0; k < points.count; ++k)
    {
        const double error = errors[points.indices[k]];
        sum += error < limit ? error : limit;  // NaN counts as `limit`
    }
    return sum;
}

double Leverage::variance(double sum, int count) const
{
    const int freedom = std::max(count - context.points.problem->dimension(), 1);
    return std::max(sum / freedom, LEAST_NOISE * LEAST_NOISE * limit);
}

int Leverage::inliersOf(const Model& model) const
{
    const Correspondences& p = context.points;
    parts.residual->squaredErrors(p, model, 0, p.size, errors);
    int result = 0;
    for (int i = 0; i < p.size; ++i)
        result += errors[i] <= (float)limit;
    return result;
}

}  // namespace usacv20
}  // namespace cv
