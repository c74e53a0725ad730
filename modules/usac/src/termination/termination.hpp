// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TERMINATION_HPP
#define OPENCV_USACV20_TERMINATION_HPP

#include "core/sample_counts.hpp"
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! See StandardTermination.
Ptr<Termination> createStandardTermination();
//! See SprtTermination.
Ptr<Termination> createSprtTermination();
//! See PNapsacTermination.
Ptr<Termination> createPNapsacTermination();
//! See MagsacTermination.
Ptr<Termination> createMagsacTermination();
//! See ProsacTermination.
Ptr<Termination> createProsacTermination();
//! See ConfirmedOrderTermination.
Ptr<Termination> createConfirmedOrderTermination();

/** Probability that the model of a good sample is not dropped before it is rated, if it has
`inliers` of all points: what the verifier says, see Verifier::keptProbability(). So T(d,d) needs
epsilon^-d times as many samples @cite matas2004randomized. (SPRT has a criterion of its own.) */
double keptProbability(const Context& context, double inliers);
/** Matches for each different one, if each is there equally often: of the m (m - 1) / 2 pairs of a
sample each is of the same match with a probability of (copies - 1) / (n - 1), and a sample is not
refused if none is. */
double copiesOf(const State& state, int n, int m);
/** Probability that a sample that counts gives a good model that is kept, if that has `inliers` of
all points. Samples that were refused as a match was in them twice do not count; how many they are
tells how many different matches there are. */
double goodModelProbability(const Context& context, const State& state, double inliers);
/** As goodSampleProbability() with or without repetition as Params::termination says, among the
 different ones of the * matches. */
double goodSampleProbability(const Context& context, const State& state, double inliers);

/** Inliers of a model that has significantly more than the best one, which has more than a sample,
see PNapsacTermination. */
double significantInliers(const Context& context, const State& state);

/** Samples after which there is nothing left to be drawn. The criteria may ask for more, or never
be fulfilled, where no model has more inliers than its own sample. */
int exhaustiveSamples(const Context& context);

/** @brief PROSAC's criterion for a model, see ProsacTermination. @return the smallest T'_n, see
Growth, of a length n* such that

- maximality: T_n* samples of the n* best points all miss its I_n* inliers with a probability of at
most exp(`logFailure`);
- non-randomness: that one of T'_n* wrong models has as many independent inliers among the n* points
is less likely than 5 %.

As all points are drawn from once the set has grown to them, the samples that T_N lacks are added to
T'_N.
@param inliers which of the `size` points are inliers, best point first
@param repeated which of the inliers repeat an earlier one and are no evidence; null: none
@param size number of points
@param m size of a sample
@param kept probability that a sample comes from the growing set and a good model is kept
@param randomRatio probability that a point is an inlier of a wrong model
@param logFailure logarithm of 1 - confidence
@param exact points are drawn without repetition, see goodSampleProbability
@param length output: n*, 0 if there is none; the result is then INT_MAX
@param context of the run, which may have to end meanwhile: the result is then INT_MAX, too; null:
it has not */
int prosacSamples(const uchar* inliers, const uchar* repeated, int size, int m, double kept,
                  double randomRatio, double logFailure, bool exact, int& length,
                  const Context* context = 0);

}  // namespace usacv20
}  // namespace cv

#endif
