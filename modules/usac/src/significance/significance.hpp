// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_SIGNIFICANCE_HPP
#define OPENCV_USACV20_SIGNIFICANCE_HPP

#include "significance/agreement.hpp"

namespace cv {
namespace usacv20 {

//! The search that has found a model.
struct SearchEffort
{
    int sampleSize;
    double samples;      //!< drawn
    double models;       //!< of them that were compared with the points
    bool countsInliers;  //!< the local optimization maximizes their number
    bool ownThreshold;   //!< the threshold was chosen from the errors, #QUALITY_LMEDS
};

/** @brief Is the best model of a search better than the best one that the same search finds in
random matches?

The sample's own m points agree in any case. Each other one agrees with a model of random matches
with the same, unknown probability as a wrong match; of these some are counted, see Agreement. That
gives the probability p of as many inliers for one such model, a beta-binomial tail. The best of T
models has them with a probability of at most 1 - (1 - p)^T.

What T is: the models that were compared with the points; not more than of all C(n, m) samples.
Local optimization and polishing move a model to where it has more inliers than any sample gives. An
optimum is held by one more point than a sample has (as the narrowest strip around points of a plane
is held by three of them, and a line by two), and there are C(n, m + 1) / C(n, m) = (n - m) / (m +
1) times as many sets of m + 1 points as samples: so many times more models has a search whose local
optimization maximizes the number of inliers, and the root of that any other. With T = models min(1,
C(n, m) / samples) times this factor the chance was measured on random points (doc/design.md);
LO-RANSAC needs 30 and 40 at 1000 points (F, E) of 124 and 166, USACV20 10 of 11 and 13. The bound
that counts all samples, drawn or not, is that of @cite moisan2004probabilistic.

A threshold far below the noise leaves few inliers of a right model; so 4 and 16 times the threshold
are looked at, too, with a tenth of the allowed error each. With a threshold of its own choice a
model has n - m more chances @cite moisan2004probabilistic.

O(n); where a few points settle it, O(1): they are a random sample of all, so what holds for them is
a bound. */
class Significance
{
public:
    /** @param threshold in the coordinates of `points`
    @param arena memory
    @param context of the run, which may have to end meanwhile: then only some of the points are
    looked at; null: it has not */
    Significance(const Residual& residual, const Model& model, const Correspondences& points,
                 double threshold, const SearchEffort& effort, Arena& arena,
                 const Context* context = 0);

    /** Probability that the search finds such a model in random matches.
    @param inliers about as many inliers has the model
    @param clear smaller values need not be exact: the first bound that is smaller is the result. */
    double chance(int inliers, double clear);

    /** After chance(): are the points so many that a model with `inlierRatio` of them would have a
     chance of at most * `limit`? Points that repeat another one count once. */
    bool decisive(double inlierRatio, double limit) const;

private:
    Agreement look(int count, double scale, int pairs) const;
    //! Is there no time to look at so many points? Then all that follows looks at less.
    bool shorten(double count);
    //! @param share of the allowed error that a look at one of several thresholds has
    double chanceOf(const Agreement& found, double share = MAIN_SHARE) const;

    //! Of the threshold itself, and of each of the wider ones.
    static const double MAIN_SHARE, WIDE_SHARE;

    const Residual& residual;
    const Model model;
    const Correspondences& points;
    const double threshold;
    const int sampleSize;
    const double trials;
    Arena& arena;
    const Context* const context;
    int size;        //!< so many points are looked at
    Agreement last;  //!< with the threshold itself
};

}  // namespace usacv20
}  // namespace cv

#endif
