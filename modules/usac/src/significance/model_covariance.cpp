// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "numeric/decompositions.hpp"
#include "optimization/any_parameterization.hpp"
#include "optimization/error_mixture.hpp"
#include "residual/kernels.hpp"
#include "significance/inlier_noise.hpp"
#include "significance/model_covariance.hpp"

#include <Eigen/Cholesky>

namespace cv {
namespace usacv20 {

namespace {

//! The noise is estimated from the errors up to NOISE_WINDOW times Polisher::support(), the error
//! up to which points influence a polished model. The EM algorithm takes at most NOISE_STEPS steps;
//! it ends earlier if the variance of the noise changes by less than the fraction SETTLED.
constexpr double NOISE_WINDOW = 2, SETTLED = 1e-3;
constexpr int NOISE_STEPS = 30;
//! Number of rounds. Each round computes the leverages of the points and from these the
//! probabilities that the points are inliers.
constexpr int ROUNDS = 3;
//! The probability that a point is an inlier depends on the numbers of inliers and of outliers that
//! have at least 1 / SIMILAR times its leverage. ALONE is added to the number of other inliers with
//! such a leverage, because a point may be the only inlier with a high leverage. If ALONE is 0.05,
//! only 79 % (instead of 87 %) of the essential matrices in tests of forward motion with 30 % wrong
//! matches are within their 95 % confidence region.
constexpr double SIMILAR = 10, ALONE = 0.01;
//! NOISE_SHARE: maximum fraction of the information on a linear combination of the parameters that
//! may come from the noise (N, see ModelCovariance); above it, the covariance is not determined.
//! NOISE_POINTS: maximum number of points from which the information of the noise is computed.
constexpr double NOISE_SHARE = 0.25;
constexpr int NOISE_POINTS = 128;
//! Number of cells of the numerical integrals over the distribution of the errors.
constexpr int CELLS = 64;
//! Step of the finite differences for the derivative of the caller's parameters with respect to
//! those of the search. The truncation error of this derivative is about 1e-10. Its rounding error,
//! 1e-16 divided by the step, must also be small compared with the smallest entries of an F for
//! points in pixels, which are about the inverse square of the focal length.
constexpr double STEP = 1e-5;
//! STEPS_TO_PRIOR: maximum number of Gauss-Newton steps that compute the parameters of a prior
//! (Params::initialModel with a covariance).
//! REACHED: these steps end when the norm of the difference from the prior is at most this fraction
//! of the norm of the prior. Convergence is quadratic.
constexpr int STEPS_TO_PRIOR = 20;
constexpr double REACHED = 1e-9;
//! Largest accepted difference between the entries (i, k) and (k, i) of a prior's covariance,
//! relative to the largest entry; more than the rounding of single precision.
constexpr double ASYMMETRY = 1e-5;

//! The covariance of A x if C is that of x.
Eigen::MatrixXd carried(const Eigen::MatrixXd& A, const Eigen::MatrixXd& C)
{
    const Eigen::MatrixXd half = A * C;
    return half * A.transpose();
}

//! Computes two expected values over the errors of inliers. `slope` is the expected derivative of
//! weight times error; for Gaussian noise, it equals the expected value of weight times squared
//! error, divided by the variance. `square` is the expected square of weight times error. Both are
//! for one component of the error, and points outside of the support contribute 0.
void expectations(const Polisher& polisher, double support, double sigma, int degrees,
                  double& slope, double& square)
{
    const double width = std::min(support, 8 * sigma) / CELLS, variance = sigma * sigma;
    const double factor = inlierPeak(variance, degrees) * width;
    slope = square = 0;
    for (int i = 0; i < CELLS; ++i)
    {
        const double e = (i + 0.5) * width, ee = e * e;
        const double density = factor * std::exp(-ee / (2 * variance)) *
                               (degrees > 1 ? power(e, degrees - 1) : 1);
        const double weight = polisher.weight(ee / (support * support), degrees);
        slope += density * weight * ee / variance;
        square += density * weight * weight * ee;
    }
}

}  // namespace

ModelCovariance::ModelCovariance(const Context& context_)
    : context(context_), points(context_.points), residual(*context_.components.residual),
      rule(points.problem->createParameterization()), degrees(points.problem->errorDimension()),
      dimension(rule ? rule->dimension() : points.problem->dimension()), support(0), noise(0),
      right(0), known(false), squared(0), members(0), shares(0), rowMemory(0), count(0), looked(0),
      components(1)
{}

void ModelCovariance::estimate(const Model& model)
{
    const Polisher* const polisher = context.components.polisher.get();
    if (!rule || !polisher)
        return;
    Arena::Scope scope(context.arena);
    squared = scope.take<float>(points.size);
    members = scope.take<int>(MOST);
    shares = scope.take<double>(MOST);
    if (!findMembers(*polisher, model))
        return;
    estimateNoise();
    const double measured = degrees * right * points.size / looked;
    if (!(measured - dimension > 2))
    {
        noise = 0;
        return;
    }
    rowMemory = scope.take<double>((size_t)count * Residual::MAX_COMPONENTS * dimension);
    known = takeRows() && judge(scope) && combine(*polisher);
    noise *= std::sqrt(measured / (measured - dimension));
}

bool ModelCovariance::findMembers(const Polisher& polisher, const Model& model)
{
    residual.squaredErrors(points, model, 0, points.size, squared);
    support = polisher.support(context, squared);
    const float limit = (float)(support * support);
    for (; looked < points.size && count < MOST; ++looked)
        if (squared[looked] < limit)
            members[count++] = looked;
    here = rule->plus(model, Vector::Zero(dimension).eval().data());
    tangent.resize(here.size(), dimension);
    return degrees * count > dimension && rule->tangent(here, tangent.data());
}

void ModelCovariance::estimateNoise()
{
    const double limit = NOISE_WINDOW * NOISE_WINDOW * support * support,
                 outlier = 1 / power(NOISE_WINDOW * support, degrees);
    double variance = support * support / 16, part = 0.9;
    for (int step = 0; step < NOISE_STEPS; ++step)
    {
        const double inside = chiSquareDistribution(limit / variance, degrees),
                     shrunk = chiSquareDistribution(limit / variance, degrees + 2);
        const double peak = part * inlierPeak(variance, degrees) / inside;
        double sum = 0, squares = 0;
        int size = 0;
        for (int i = 0; i < looked; ++i)
        {
            if (!(squared[i] < limit))  // skips NaN, too
                continue;
            const double inlier = peak * std::exp(-squared[i] / (2 * variance));
            const double weight = inlier / (inlier + (1 - part) * outlier);
            sum += weight;
            squares += weight * squared[i];
            ++size;
        }
        right = sum;
        part = std::min(std::max(sum / std::max(size, 1), 0.01), 0.999);
        const double before = variance;
        variance = squares / (degrees * std::max(sum, 1e-9)) * inside / shrunk;
        variance = std::min(std::max(variance, 1e-12 * limit), support * support);
        if (std::abs(variance - before) < SETTLED * variance)
            break;
    }
    noise = std::sqrt(variance);
}

//! Number of wrong matches per unit of error^`degrees` near the model. It is computed from the
//! wrong matches with errors up to #NOISE_WINDOW times the support. The number expected for
//! uniformly distributed wrong matches is a prior with the weight of one observed wrong match.
double ModelCovariance::chanceDensity() const
{
    const double window = NOISE_WINDOW * support, limit = window * window;
    int within = 0;
    for (int i = 0; i < looked; ++i)
        within += squared[i] < limit;
    const double chance = points.problem->randomInlierRatio(points) *
                          power(window / points.threshold, degrees);
    const double expected = std::max((looked - right) * std::min(chance, 1.), 1e-3);
    return (1 + std::max(within - right, 0.)) / (1 / expected + 1) / power(window, degrees);
}

//! Computes the derivatives of a point's error with respect to the parameters: `components` rows.
void ModelCovariance::linearize(int point, double* rows)
{
    double datum[MAX_COLUMNS], error[Residual::MAX_COMPONENTS], derivative[MAX_DERIVATIVE];
    for (int c = 0; c < points.numbers(); ++c)
        datum[c] = points.exact[c][point];
    components = residual.linearize(here, datum, error, derivative);
    Eigen::Map<Rows>(rows, components, dimension) = Eigen::Map<const Rows>(derivative, components,
                                                                           here.size())
                                                        .lazyProduct(tangent);
}

bool ModelCovariance::takeRows()
{
    for (int i = 0, at = 0; i < count; ++i, at += components * dimension)
        linearize(members[i], rowMemory + at);
    Eigen::Map<Rows> rows(rowMemory, count * components, dimension);
    scale = rows.colwise().squaredNorm().cwiseSqrt().cwiseInverse();
    rows = (rows * scale.asDiagonal()).eval();
    return rows.allFinite();
}

//! Computes the probabilities `shares` and the matrix sum p J^T J (`information`). False if this
//! matrix is singular.
bool ModelCovariance::judge(Arena::Scope& scope)
{
    double* const levers = scope.take<double>(count);
    double* const others = scope.take<double>(OTHERS);
    double* const half = scope.take<double>((size_t)count * components * dimension);
    const Eigen::Map<const Rows> rows(rowMemory, count * components, dimension);
    Eigen::Map<Rows> solved(half, count * components, dimension);
    std::fill(shares, shares + count, 1.);
    for (int round = 0;; ++round)
    {
        for (int i = 0; i < count; ++i)
            solved.middleRows(i * components, components) = std::sqrt(shares[i]) *
                                                            rows.middleRows(i * components,
                                                                            components);
        information = solved.transpose() * solved;
        const Eigen::LLT<Square> llt(information);
        if (llt.info() != Eigen::Success)
            return false;
        if (round == ROUNDS)
            return true;
        solved = llt.matrixL().solve(rows.transpose()).transpose();
        for (int i = 0; i < count; ++i)
        {
            const double g = solved.middleRows(i * components, components).squaredNorm() / degrees;
            levers[i] = g / std::max(1 - shares[i] * g, 1e-3);
        }
        likelihoods(levers, others, leversOfOthers(llt, others));
    }
}

//! Computes the leverages of some points outside of the support: the variance of the error that the
//! uncertainty of the model causes, divided by the variance of the noise. @return number of these
//! points, at most OTHERS
int ModelCovariance::leversOfOthers(const Eigen::LLT<Square>& llt, double* levers)
{
    const float limit = (float)(support * support);
    double row[MAX_DERIVATIVE];
    int found = 0;
    for (int i = 0; i < looked && found < OTHERS; ++i)
    {
        if (!(squared[i] >= limit))
            continue;
        linearize(i, row);
        const FewRows scaled = Eigen::Map<const Rows>(row, components, dimension) *
                               scale.asDiagonal();
        levers[found] = llt.matrixL().solve(scaled.transpose()).squaredNorm() / degrees;
        found += levers[found] <= DBL_MAX;  // NaN is left out
    }
    return found;
}

void ModelCovariance::likelihoods(const double* levers, double* others, int otherCount)
{
    Arena::Scope scope(context.arena);
    double* const sorted = scope.take<double>(count);
    std::copy(levers, levers + count, sorted);
    std::sort(sorted, sorted + count);
    std::sort(others, others + otherCount);
    const double variance = noise * noise, peak = inlierPeak(variance, degrees),
                 density = chanceDensity() / (otherCount + 0.5);
    for (int i = 0; i < count; ++i)
    {
        const double least = levers[i] / SIMILAR, grown = 1 + levers[i];
        const double similar = double(sorted + count -
                                      std::lower_bound(sorted, sorted + count,
                                                       least)) -
                               1;  // without the point itself
        const double wrong = double(others + otherCount -
                                    std::lower_bound(others, others + otherCount, least));
        const double inlier = (similar + ALONE) * peak * std::pow(grown, -0.5 * degrees) *
                              std::exp(-squared[members[i]] * grown / (2 * variance));
        shares[i] = inlier / (inlier + (wrong + 0.5) * density);
    }
}

//! Computes the information N that comes from noise, see ModelCovariance. False if N is more than
//! NOISE_SHARE of the total information on some linear combination of the parameters.
bool ModelCovariance::noiseInformation(Square& N)
{
    N.setZero(dimension, dimension);
    const int most = std::min(count, NOISE_POINTS);
    const double step = 0.01 * noise;
    double datum[MAX_COLUMNS], direction[MAX_COLUMNS], error[Residual::MAX_COMPONENTS],
        sides[2][MAX_DERIVATIVE];
    for (int i = 0; i < most; ++i)
        for (int c = 0; c < points.columns(); ++c)
        {
            for (int k = 0; k < points.numbers(); ++k)
                datum[k] = points.exact[k][members[i]];
            noiseDirection(points, datum, c, direction);
            for (int k = 0; k < points.columns(); ++k)
                datum[k] -= step * direction[k];
            residual.linearize(here, datum, error, sides[0]);
            for (int k = 0; k < points.columns(); ++k)
                datum[k] += 2 * step * direction[k];
            residual.linearize(here, datum, error, sides[1]);
            const Eigen::Map<const FewRows> before(sides[0], components, here.size()),
                after(sides[1], components, here.size());
            const FewRows change = (after - before) / (2 * step) * tangent * scale.asDiagonal();
            N += shares[i] * change.transpose() * change;
        }
    N *= noise * noise * count / most;
    return Eigen::LLT<Square>(NOISE_SHARE * information - N).info() == Eigen::Success;
}

bool ModelCovariance::combine(const Polisher& polisher)
{
    double slope, square, inliers = 0;
    expectations(polisher, support, noise, degrees, slope, square);
    for (int i = 0; i < count; ++i)
        inliers += shares[i];
    const double each = (double)points.size / looked;  // ratio of all points to those that were
                                                       // examined
    const double freedom = degrees * inliers * each - dimension;
    if (!(freedom > 2))
        return false;
    square *= degrees * inliers * each / (freedom - 2);
    const Eigen::Map<const Rows> rows(rowMemory, count * components, dimension);
    Square B = Square::Zero(dimension, dimension), A = information, N;
    for (int i = 0; i < count; ++i)
    {
        const double error = squared[members[i]],
                     weight = polisher.weight(error / (support * support), degrees);
        const double scatter = shares[i] * square +
                               (1 - shares[i]) * weight * weight * error / degrees;
        const Eigen::Block<const Eigen::Map<const Rows>> J = rows.block(i * components, 0,
                                                                        components, dimension);
        B += scatter * J.transpose().lazyProduct(J);
    }
    if (degrees == 1)
    {
        if (!noiseInformation(N))
            return false;
        A -= N;
    }
    const Eigen::LLT<Square> llt(A);
    const Square half = llt.solve(B);
    const Square full = llt.solve(half.transpose().eval()) / (each * slope * slope);
    own = scale.asDiagonal() * full * scale.asDiagonal();
    return llt.info() == Eigen::Success && own.allFinite();
}

//! Returns the derivatives of the caller's parameters with respect to those of the search, at a
//! model; an empty matrix if a model cannot be converted.
Eigen::MatrixXd ModelCovariance::change(const Model& from) const
{
    const Problem& problem = *points.problem;
    Model center;
    Basis basis;
    if (!problem.toInput(from, points, center))
        return Eigen::MatrixXd();
    center = rule->plus(center, Vector::Zero(dimension).eval().data());
    if (!callerBasis(*rule, center, basis))
        return Eigen::MatrixXd();
    const int n = center.size();
    const Eigen::Map<const Vector> middle(center.val, n);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, MAX_MODEL_SIZE, MAX_MODEL_SIZE>
        derivative(n, dimension);
    Vector x = Vector::Zero(dimension);
    for (int k = 0; k < dimension; ++k)
    {
        Vector sides[2];
        for (int side = 0; side < 2; ++side)
        {
            x[k] = side ? STEP : -STEP;
            Model moved;
            if (!problem.toInput(rule->plus(from, x.data()), points, moved))
                return Eigen::MatrixXd();
            moved = rule->plus(moved, Vector::Zero(dimension).eval().data());
            sides[side] = Eigen::Map<const Vector>(moved.val, n);
            if (sides[side].dot(middle) < 0)  // a homogeneous model has an arbitrary sign
                sides[side] = -sides[side];
        }
        x[k] = 0;
        derivative.col(k) = (sides[1] - sides[0]) / (2 * STEP);
    }
    return solveLeastSquares(basis, derivative);
}

//! Computes the parameters of another model, in the parameterization around `here`, by Gauss-Newton
//! steps. False if the steps do not converge.
bool ModelCovariance::stepTo(const Model& model, Vector& step) const
{
    step = Vector::Zero(dimension);
    Eigen::VectorXd wanted = Eigen::Map<const Eigen::VectorXd>(model.val, model.size());
    for (int i = 0; i < STEPS_TO_PRIOR; ++i)
    {
        const Model there = rule->plus(here, step.data());
        const Eigen::VectorXd reached = Eigen::Map<const Eigen::VectorXd>(there.val, there.size());
        if (reached.dot(wanted) < 0)  // a homogeneous model has an arbitrary sign
            wanted = -wanted;
        const Eigen::VectorXd rest = wanted - reached;
        if (rest.norm() <= REACHED * wanted.norm())
            return true;
        step += solveLeastSquares(tangent, rest);
    }
    return false;
}

void ModelCovariance::checkPrior(const Mat& covariance)
{
    const Eigen::Map<const Square> given(covariance.ptr<double>(), covariance.rows,
                                         covariance.cols);
    if ((given - given.transpose()).cwiseAbs().maxCoeff() >
            ASYMMETRY * given.cwiseAbs().maxCoeff() ||
        Eigen::LLT<Square>(given).info() != Eigen::Success)
        CV_Error(Error::StsBadArg,
                 "initialCovariance: a symmetric, positive definite matrix is expected");
}

double ModelCovariance::weigh(const Model& prior, const Mat& covariance)
{
    if (!known)  // `known` is also false if the problem has no parameterization
        return 0;
    CV_Assert(covariance.rows == dimension);
    const Eigen::MatrixXd given = Eigen::Map<const Square>(covariance.ptr<double>(), dimension,
                                                           dimension);
    const Model at = rule->plus(prior, Vector::Zero(dimension).eval().data());
    Basis there(at.size(), dimension);
    Vector step;
    if (!rule->tangent(at, there.data()) || !stepTo(at, step))
        return 0;
    const Eigen::MatrixXd T = change(at);
    if (T.size() == 0)
        return 0;
    // derivatives of the search's parameters, at the prior (`back`) and at `here` (`toHere`), with
    // respect to the caller's parameters at the prior
    const Eigen::MatrixXd back = solveLeastSquares(T, Square::Identity(dimension, dimension)),
                          toHere = solveLeastSquares(tangent, there) * back;
    const Eigen::LLT<Square> sum(own + carried(toHere, given));
    const double chance = 1 -
                          chiSquareDistribution(sum.matrixL().solve(step).squaredNorm(), dimension);
    const Square half = sum.matrixL().solve(own);
    const Vector shift = own * sum.solve(step);
    if (sum.info() != Eigen::Success || !half.allFinite() || !shift.allFinite())
        return 0;  // products of large entries have overflowed
    if (!(chance >= LEAST_CHANCE))
        return std::max(0., chance);  // 0 for NaN
    const Basis before = tangent;
    here = rule->plus(here, shift.data());
    known = rule->tangent(here, tangent.data());
    own = carried(solveLeastSquares(tangent, before), own - half.transpose() * half);
    return chance;
}

Mat ModelCovariance::ofCaller() const
{
    Mat result(dimension, dimension, CV_64F, Scalar::all(std::numeric_limits<double>::quiet_NaN()));
    const Eigen::MatrixXd T = known ? change(here) : Eigen::MatrixXd();
    if (T.size() == 0)
        return result;
    const Eigen::MatrixXd C = carried(T, own);
    for (int i = 0; i < dimension; ++i)
        for (int k = 0; k < dimension; ++k)
            result.at<double>(i, k) = (C(i, k) + C(k, i)) / 2;
    return result;
}

}  // namespace usacv20
}  // namespace cv
