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
Verifier::keptProbability(). For example, the T(d,d) test needs epsilon^-d times as many samples for
the inlier ratio epsilon @cite matas2004randomized. (SPRT has its own criterion.) */
double keptProbability(const Context& context, double inliers);
/** Estimated number of copies of each match, which is assumed to be the same for all matches; 1: no
copies. It follows from the number of samples that were rejected because they contain two copies of
a match: each of the m (m - 1) / 2 pairs of a sample is such a pair with a probability of
(copies - 1) / (n - 1). */
double copiesOf(const State& state, int n, int m);
/** Probability that a sample gives a good model, with this number of inliers, and that the verifier
does not reject this model. Samples that were rejected because they contain a match twice are left
out; from their number, copiesOf() estimates how many distinct matches there are. */
double goodModelProbability(const Context& context, const State& state, double inliers);
/** Probability that a sample leads to a good model with this number of inliers: the probability of
an all-inlier sample times State::successProbability. Points are assumed to be drawn with repetition
or, with #TERMINATION_EXACT, without repetition from the distinct matches. */
double goodSampleProbability(const Context& context, const State& state, double inliers);

/** Minimum number of inliers of a model that is significantly better than the best model, see
PNapsacTermination. The best model must have more inliers than the sample size. */
double significantInliers(const Context& context, const State& state);

/** Number of samples after which practically all different samples have been drawn. This limit is
needed because the criteria may ask for more samples, or may never be fulfilled, if no model has
inliers outside its own sample. INT_MAX: there are no criteria. */
int exhaustiveSamples(const Context& context);

/** @brief PROSAC's criterion for a model, see ProsacTermination. @return the smallest T'_n, see
Growth, of a length n* such that

- maximality: with a probability of at most exp(`logFailure`), none of T_n* samples of the n* best
points is an all-inlier sample of the model, which has I_n* inliers among these points;
- non-randomness: the probability that one of T'_n* wrong models has as many independent inliers
among the n* points is less than 5 %.

Sampling continues after the set has reached all N points: for n* = N, the samples that are missing
for maximality are added to T'_N.
@param inliers which of the `size` points are inliers, best point first
@param repeated which inliers are no evidence because they repeat an earlier inlier; null: none
@param size number of points
@param m size of a sample
@param kept probability that a sample comes from the growing set and a good model is kept
@param randomRatio probability that a point is an inlier of a wrong model
@param logFailure logarithm of 1 - confidence
@param exact points are drawn without repetition, see goodSampleProbability
@param length output: n*; 0 if no length fulfills the conditions, and the result is then INT_MAX
@param context context of the run; the result is INT_MAX if the run must end meanwhile. Null: there
is no time limit */
int prosacSamples(const uchar* inliers, const uchar* repeated, int size, int m, double kept,
                  double randomRatio, double logFailure, bool exact, int& length,
                  const Context* context = 0);

}  // namespace usacv20
}  // namespace cv

#endif
