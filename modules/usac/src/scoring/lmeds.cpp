// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/selection.hpp"
#include "scoring/scores.hpp"
#include "numeric/chi_square.hpp"
#include "scoring/mixture.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! From @cite rousseeuw1984least: inliers have errors of at most DEVIATIONS standard deviations of
//! the noise. The estimate of this standard deviation is multiplied by 1 + SMALL_SETS / (n - m) for
//! n points and samples of m points.
constexpr double DEVIATIONS = 2.5, SMALL_SETS = 5;

/** Least median of squares @cite rousseeuw1984least. It needs no threshold, but at least half of
the points must be inliers.

The cost of a model is s / (s + extent) per point, where s is the square root of the median
squared error and `extent` the extent of the points (Problem::outlierExtent). For small s this is
about the median error divided by this extent. Quality::inliers counts the points with errors up to
the median, because the method assumes that half of the points are inliers. The limit is not a
multiple of the median: a wrong model has a large median, so that most points would be inliers, and
the termination criterion would end the search too early.

The threshold of the final inliers is q c (1 + 5 / (n - m)) s for n points and samples of m points.
The factor c converts s to the standard deviation of Gaussian noise (1.4826 for F and E). The factor
in parentheses is Rousseeuw's correction for small sets of points. The factor q is 2.5 for one
degree of freedom (F, E), and the quantile of the chi distribution for the same probability for more
degrees of freedom (H has two). The threshold is at least as large as the rounding error of the
residuals. Computing score and threshold takes linear time. */
class LmedsScore : public Score
{
public:
    LmedsScore() : extent(1), sigmas(1) {}

    void start(const Context& context) CV_OVERRIDE
    {
        const Problem& problem = *context.points.problem;
        extent = std::max(problem.outlierExtent(context.points), (double)FLT_MIN);
        sigmas = sigmasInMedian(problem.errorDimension());
    }

    void accumulate(float* squaredErrors, int count, float, Quality& sum) const CV_OVERRIDE
    {
        if (count == 0)
            return;
        const float middle = medianOf(squaredErrors, count);
        if (!(middle <= FLT_MAX))
        {
            sum.cost += count;
            return;
        }
        const double s = std::sqrt((double)middle);
        sum.cost += count * (s / (s + extent));
        for (int i = 0; i < count; ++i)
            sum.inliers += squaredErrors[i] <= middle;
    }

    bool wholeModel() const CV_OVERRIDE { return true; }
    bool usesThreshold() const CV_OVERRIDE { return false; }

    double threshold(const Context& context, const Model& model) const CV_OVERRIDE
    {
        const int count = context.points.size;
        if (count == 0)
            return 0;
        Arena::Scope scope(context.arena);
        float* const errors = scope.take<float>(count);
        context.components.residual->squaredErrors(context.points, model, 0, count, errors);
        const int beside = count - context.components.minimalSolver->sampleSize();
        return std::sqrt(squaredLimit(medianOf(errors, count), beside));
    }

private:
    //! The factor q c of the threshold, see the comment of the class.
    static double sigmasInMedian(int degrees)
    {
        const double certainty = chiSquareDistribution(DEVIATIONS * DEVIATIONS, 1);
        return std::sqrt(chiSquareQuantile(certainty, degrees) / chiSquareQuantile(0.5, degrees));
    }

    double squaredLimit(double squaredMedian, int beside) const
    {
        const double factor = sigmas * (1 + SMALL_SETS / std::max(beside, 1));
        const double rounding = 8 * FLT_EPSILON * extent;
        return std::min(std::max(factor * factor * squaredMedian, rounding * rounding),
                        (double)FLT_MAX);
    }

    //! The median. NaN counts as infinite, because std::nth_element needs an ordering. The function
    //! reorders the values.
    static float medianOf(float* values, int count)
    {
        for (int i = 0; i < count; ++i)
            values[i] = values[i] <= FLT_MAX ? values[i] : std::numeric_limits<float>::infinity();
        return median(values, count);
    }

    double extent;
    double sigmas;  //!< the factor q c, see the comment of the class
};

}  // namespace

Ptr<Score> createLmedsScore() { return makePtr<LmedsScore>(); }

}  // namespace usacv20
}  // namespace cv
