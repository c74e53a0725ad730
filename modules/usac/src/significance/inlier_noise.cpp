// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/chi_square.hpp"
#include "components/repetitions.hpp"
#include "optimization/error_mixture.hpp"
#include "optimization/significant_scale.hpp"
#include "significance/agreement.hpp"
#include "significance/inlier_noise.hpp"

#include <Eigen/Core>

namespace cv {
namespace usacv20 {

namespace {

//! The smallest threshold that can be estimated is the upper bound `widest` divided by FINEST; data
//! without noise give this threshold.
constexpr int FINEST = 1024;
//! Number of inliers, in addition to the points of a sample, that are needed to estimate the noise.
//! With fewer inliers, the estimate might come from wrong matches of the sample, which the model of
//! the sample fits exactly.
constexpr int BEYOND = 10;
//! Threshold of the rough estimate, in standard deviations of the noise.
constexpr double IN_SIGMAS = 2.2;
//! If there are at least LEAST inliers, the mixture is fitted to the errors up to WINDOW times the
//! sigma of SignificantScale, by STEPS steps of the EM algorithm. Initial values: FIRST_PART, the
//! fraction of inliers among the points with such errors; FIRST_TAIL, the fraction of badly located
//! points among the inliers.
constexpr int LEAST = 50, STEPS = 20, WINDOW = 8;
constexpr double FIRST_PART = 0.7, FIRST_TAIL = 0.1;
//! Fraction of the inliers whose errors do not exceed the threshold @cite hartley2003multiple
//! (table 4.2).
constexpr double WITHIN = 0.95;
//! Maximum number of inliers for which errorsGoOn() computes how the model maps the noise of the
//! points to the error, see degreesAt().
constexpr int CHANGES = 20;

//! The errors of the first `most` points, which are a random subset, and the noise scale that
//! SignificantScale finds by comparing them with the errors of wrong matches.
class Errors
{
public:
    Errors(const Context& context, const Model& model, double widest, int most, bool once)
        : scope(context.arena), size(std::min<int>(context.points.size, most)),
          squared(scope.take<float>(size)), degrees(context.points.problem->errorDimension()),
          sampleSize(context.components.minimalSolver->sampleSize())
    {
        const Correspondences& p = context.points;
        const Residual& residual = *context.components.residual;
        residual.squaredErrors(p, model, 0, size, squared);
        float* const memory = scope.take<float>((size_t)WRONG_PARTNERS * size);
        wrong = memory;
        wrongCount = wrongErrors(residual, model, p, size, memory, context.arena);
        // the smallest radius of SignificantScale, 0.31 units, is then 1.2 widest / FINEST
        unit = 4 * widest / FINEST;
        Correspondences narrow = p;
        narrow.threshold = unit;
        chance = p.problem->randomInlierRatio(narrow);
        find();
        if (once && found.sigma > 0 && dropRepeated(p, IN_SIGMAS * found.sigma, context.arena))
            find();
    }

    //! Ratio of the noise to the errors of the inliers, which are smaller because the model was
    //! fitted to them.
    double correction() const
    {
        return std::sqrt((double)found.inliers / std::max(found.inliers - sampleSize, 1));
    }

    InlierNoise noise(double sigma, double threshold, double widest) const
    {
        if (!(sigma > 0 && sigma <= DBL_MAX) || found.inliers < sampleSize + BEYOND)
            return InlierNoise();
        const InlierNoise result = {
            sigma * correction(),
            std::max(widest / FINEST, std::min(threshold * correction(), widest)),
            (double)found.inliers / std::max(size, 1), found.inliers - sampleSize};
        return result;
    }

    Arena::Scope scope;
    int size;
    float* const squared;
    const int degrees, sampleSize;
    SignificantScale::Found found;

private:
    void find()
    {
        found = SignificantScale::estimate(squared, size, wrong, wrongCount, unit, chance, degrees,
                                           sampleSize, FINEST / 4);
    }

    //! Of the inliers in the same cell of a grid over one of the arrays, removes all but one,
    //! because copies of a match have the same error, which may look like small noise. @return
    //! false if nothing was removed
    bool dropRepeated(const Correspondences& p, double threshold, Arena& arena)
    {
        Arena::Scope local(arena);
        uchar *const mask = local.take<uchar>(size), *const repeated = local.take<uchar>(size);
        for (int i = 0; i < size; ++i)
            mask[i] = squared[i] <= threshold * threshold;
        std::fill(repeated, repeated + size, (uchar)0);
        if (markRepeated(p, 0, mask, size, threshold, repeated, arena) == 0)
            return false;
        int kept = 0;
        for (int i = 0; i < size; ++i)
            if (!repeated[i])
                squared[kept++] = squared[i];
        size = kept;
        return true;
    }

    const float* wrong;  //!< squared errors of wrong matches
    int wrongCount;
    double unit;    //!< unit of the radii of SignificantScale
    double chance;  //!< probability that a point is within one unit of a wrong model
};

}  // namespace

InlierNoise roughNoise(const Context& context, const Model& model, double widest, int most,
                       bool once)
{
    const Errors errors(context, model, widest, most, once);
    return errors.noise(errors.found.sigma, IN_SIGMAS * errors.found.sigma, widest);
}

InlierNoise preciseNoise(const Context& context, const Model& model, double widest)
{
    const Errors errors(context, model, widest, SignificantScale::MOST, true);
    const double unit = errors.found.sigma;
    if (!(unit > 0) || errors.found.inliers < LEAST)
        return errors.noise(unit, std::sqrt(chiSquareQuantile(WITHIN, errors.degrees)) * unit,
                            widest);
    ErrorMixture mixture(errors.degrees, 1, FIRST_PART, FIRST_TAIL);
    mixture.fit(ErrorHistogram(errors.squared, errors.size, unit, WINDOW, errors.size), STEPS);
    return errors.noise(mixture.sigma() * unit, mixture.quantile(WITHIN) * unit, widest);
}

void noiseDirection(const Correspondences& points, const double* datum, int index,
                    double* direction)
{
    const int columns = points.columns();
    const bool last = index >= points.coordinates[0];
    std::fill(direction, direction + columns, 0.);
    if (!last && !points.problem->commonUnit())
        return;
    if (points.noise > 1)
    {
        const double* const root = datum + columns + (last ? 0 : 3);  // p, q, s
        const int first = last ? points.coordinates[0] : 0;
        if (index == first)
            direction[first] = root[0];
        direction[first + 1] = root[index == first ? 1 : 2];
        return;
    }
    direction[index] = last ? 1 : points.frame[0].scale / points.frame[1].scale;
    if (points.noise == 1)
        direction[index] /= datum[columns];
}

namespace {

/** Effective degrees of freedom of the error of a point, by Satterthwaite's formula, for noise in
both arrays. For an error in the plane: 2 if the error has the same variance in all directions, and
nearly 1 if the model enlarges the noise much more in one direction than in the other.
@param step step of the finite differences, which should be below the noise */
double degreesAt(const Context& context, const Model& model, int point, double step)
{
    const Correspondences& p = context.points;
    const Residual& residual = *context.components.residual;
    double datum[MAX_COLUMNS], moved[MAX_COLUMNS], direction[MAX_COLUMNS],
        sides[2][Residual::MAX_COMPONENTS];
    for (int c = 0; c < p.numbers(); ++c)
        datum[c] = moved[c] = p.exact[c][point];
    Eigen::Matrix<double, Residual::MAX_COMPONENTS, MAX_COLUMNS> change;
    change.setZero();
    for (int c = 0; c < p.columns(); ++c)
    {
        noiseDirection(p, datum, c, direction);
        for (int k = 0; k < p.columns(); ++k)
            moved[k] = datum[k] - step * direction[k];
        residual.error(model, moved, sides[0]);
        for (int k = 0; k < p.columns(); ++k)
            moved[k] = datum[k] + step * direction[k];
        const int components = residual.error(model, moved, sides[1]);
        for (int k = 0; k < components; ++k)
            change(k, c) = sides[1][k] - sides[0][k];
    }
    const double variance = change.squaredNorm(),
                 degrees = variance * variance / (change * change.transpose()).squaredNorm();
    return degrees >= 1 ? degrees : 1;  // NaN gives 1
}

}  // namespace

bool errorsGoOn(const Context& context, const Model& model, double threshold, double factor)
{
    const Correspondences& p = context.points;
    const int size = std::min<int>(p.size, SignificantScale::MOST),
              m = context.components.minimalSolver->sampleSize();
    Arena::Scope scope(context.arena);
    float* const squared = scope.take<float>(size);
    context.components.residual->squaredErrors(p, model, 0, size, squared);
    const double square = threshold * threshold;
    int within = 0, withinHalf = 0;
    double degrees = 0;
    for (int i = 0; i < size; ++i)
    {
        const bool inlier = squared[i] <= square;
        if (inlier && within < CHANGES)
            degrees += degreesAt(context, model, i, 0.01 * threshold);
        within += inlier;
        withinHalf += squared[i] <= square / 4;
    }
    degrees = std::min(degrees / std::max(std::min(within, CHANGES), 1),
                       (double)p.problem->errorDimension());
    const double x = chiSquareQuantile(WITHIN, degrees) / (factor * factor);
    return (within - m) * chiSquareDistribution(x / 4, degrees) >
           (withinHalf - m) * chiSquareDistribution(x, degrees);
}

}  // namespace usacv20
}  // namespace cv
