// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TERMINATION_HPP
#define OPENCV_USACV20_TERMINATION_HPP

#include "components/sample_statistics.hpp"
#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Creates the standard criterion of RANSAC, see StandardTermination.
Ptr<Termination> createStandardTermination();
//! Creates the criterion for models that are verified by SPRT, see SprtTermination.
Ptr<Termination> createSprtTermination();
//! Creates the criterion of P-NAPSAC, see PNapsacTermination.
Ptr<Termination> createPNapsacTermination();
//! Creates the criterion of MAGSAC, see MagsacTermination.
Ptr<Termination> createMagsacTermination();
//! Creates the criterion of PROSAC, see ProsacTermination.
Ptr<Termination> createProsacTermination();
//! Creates the criterion for an order that the data confirm, see ConfirmedOrderTermination.
Ptr<Termination> createConfirmedOrderTermination();

/** Probability that the verifier does not reject a good model with this number of inliers, see
Verifier::keptProbability(). For example, the T(d,d) test keeps a good model with probability
epsilon^d, where epsilon is the inlier ratio @cite matas2004randomized, so that more samples are
needed. 1 for SPRT, which has its own criterion, and without a verifier. */
double keptProbability(const Context& context, double inliers);
/** Estimated number of copies of each match, including the match itself; 1: no repetitions. This
number is assumed to be the same for all n matches. The estimate follows from the number of samples
that were rejected because they contain two copies of a match: each of the m (m - 1) / 2 pairs of
matches in a sample is a pair of copies with a probability of (copies - 1) / (n - 1). */
double copiesOf(const State& state, int n, int m);
//! Probability that a sample leads to a good model with this number of inliers and that the
//! verifier does not reject the model: goodSampleProbability() times keptProbability().
double goodModelProbability(const Context& context, const State& state, double inliers);
/** Probability that a sample leads to a good model with this number of inliers: the probability of
an all-inlier sample times State::successProbability. With #TERMINATION_EXACT, points are assumed to
be drawn without repetition from the distinct matches, the number of which follows from copiesOf();
samples with two copies of a match are not counted. Otherwise, points are assumed to be drawn with
repetition. */
double goodSampleProbability(const Context& context, const State& state, double inliers);

/** Minimum number of inliers of a model that is significantly better than the best model, see
PNapsacTermination. The best model must have more inliers than a sample has points. */
double significantInliers(const Context& context, const State& state);

/** Number of samples after which practically all different samples have been drawn. This limit is
needed because the criteria might ask for more samples, or might never be fulfilled, if no model has
inliers outside its own sample. INT_MAX: there are no criteria. */
int exhaustiveSamples(const Context& context);

/** @brief PROSAC's criterion for a model, see ProsacTermination. @return T'_n* (see Growth) for the
smallest number n* of best points such that

- maximality: with a probability of at most exp(`logFailure`), none of T_n* uniform samples of the
n* best points consists of inliers of the model and leads to a model that is kept;
- non-randomness: the probability that one of T'_n* wrong models has at least as many independent
inliers among the n* points is less than 5 %.

Sampling continues after the set has reached all N points: for n* = N, the samples that are missing
for maximality are added to T'_N.
@param inliers marks the inliers of the model among the `size` points, best point first
@param repeated marks inliers that do not count for non-randomness, because they repeat an earlier
inlier; null: all inliers count
@param size number of points
@param m size of a sample
@param kept probability that a sample comes from the growing set and that the verifier keeps its
model if the model is good
@param randomRatio probability that a point is an inlier of a wrong model
@param logFailure logarithm of 1 - confidence
@param exact true: points are assumed to be drawn without repetition, see goodSampleProbability()
@param length output: n*; 0 if no n* fulfills the conditions, and the result is then INT_MAX
@param context context of the run; the result is INT_MAX if the run must end during the call. Null:
there is no time limit */
int prosacSamples(const uchar* inliers, const uchar* repeated, int size, int m, double kept,
                  double randomRatio, double logFailure, bool exact, int& length,
                  const Context* context = 0);

}  // namespace usacv20
}  // namespace cv

#endif
