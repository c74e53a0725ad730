// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANCE_HPP
#define OPENCV_USACV20_SIGNIFICANCE_HPP

#include "significance/agreement.hpp"

namespace cv {
namespace usacv20 {

//! Effort of the search that has found a model.
struct SearchEffort
{
    int sampleSize;
    double samples;      //!< number of samples drawn
    double models;       //!< number of models of the samples that were compared with the points
    bool countsInliers;  //!< true if the local optimization maximizes the number of inliers
    bool ownThreshold;   //!< true if the threshold was chosen from the errors (#QUALITY_LMEDS)
};

/** @brief Tests whether the best model of a search is better than the best model that the same
search would find in random matches.

The m points of a sample are inliers of its model in any case. Each other point is an inlier of a
model of random matches with the same, unknown probability as a wrong match. This probability is
estimated by testing some wrong matches, see Agreement. The probability p that one such model has at
least as many inliers as the given model is thus a beta-binomial tail. The probability that the best
of T such models has at least as many inliers is at most 1 - (1 - p)^T.

T is the number of models that were compared with the points (scaled down if more samples were drawn
than the C(n, m) different samples), times a factor for local optimization and polishing, because an
optimized model can have more inliers than the model of any sample. An optimum is determined by m +
1 points (for example, a line by two points, but the narrowest strip around points by three). The
number of sets of m + 1 points is C(n, m + 1) / C(n, m) = (n - m) / (m + 1) times the number of
samples. The factor is this quotient if the local optimization maximizes the number of inliers,
otherwise its square root: T = models min(1, C(n, m) / samples) factor. The probability was checked
on random points (doc/contributing.md): with n = 1000, LO-RANSAC needs a factor of 30 (F) or 40 (E),
and the formula gives 124 or 166; USACV20 needs a factor of 10, and the formula gives 11 or 13. The
bound of @cite moisan2004probabilistic counts all possible samples, even those that were not drawn.

With a threshold far below the noise, a right model has few inliers. Therefore 4 and 16 times the
threshold are tried, too, each with a tenth of the allowed error probability. If the threshold was
chosen from the errors, T is n - m times as large @cite moisan2004probabilistic.

Takes O(n), or O(1) if a few points are enough to decide. These points are a random subset of all
points; their result is an upper bound of the probability. */
class Significance
{
public:
    /** @param threshold in the coordinates of `points`
    @param arena memory for the tests
    @param context context of the run; if the run must end meanwhile, only some of the points are
    tested. Null: there is no time limit */
    Significance(const Residual& residual, const Model& model, const Correspondences& points,
                 double threshold, const SearchEffort& effort, Arena& arena,
                 const Context* context = 0);

    /** Probability that the same search finds a model as good as this one in random matches.
    @param inliers approximate number of inliers of the model
    @param clear subsets of the points give upper bounds of the probability; the first such bound
    that is at most `clear` is returned without further tests */
    double chance(int inliers, double clear);

    /** True if there are so many points that chance() would be at most `limit` for a model with
    this inlier ratio. A point and its repetitions count once. To be called after chance(). */
    bool decisive(double inlierRatio, double limit) const;

private:
    Agreement look(int count, double scale, int pairs) const;
    //! True if there is no time to test `count` points. All later tests then use at most ENOUGH
    //! points (50 000, see control/watch.hpp).
    bool shorten(double count);
    //! @param share fraction of the allowed error probability that is assigned to the threshold of
    //! this test, because several thresholds are tried
    double chanceOf(const Agreement& found, double share = MAIN_SHARE) const;

    //! Fractions of the allowed error probability for the threshold itself and for each wider
    //! threshold.
    static const double MAIN_SHARE, WIDE_SHARE;

    const Residual& residual;
    const Model model;
    const Correspondences& points;
    const double threshold;
    const int sampleSize;
    const double trials;  //!< T
    Arena& arena;
    const Context* const context;
    int size;        //!< maximum number of points in a test
    Agreement last;  //!< result of the last test with the threshold itself
};

}  // namespace usacv20
}  // namespace cv

#endif
