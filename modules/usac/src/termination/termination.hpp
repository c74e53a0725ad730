// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TERMINATION_HPP
#define OPENCV_USACV20_TERMINATION_HPP

#include "components/sample_statistics.hpp"
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

/** Probability that the verifier does not reject a good model with this number of inliers, see
Verifier::keptProbability(). With epsilon the inlier ratio, T(d,d) thus needs epsilon^-d times as
many samples @cite matas2004randomized. (SPRT has a criterion of its own.) */
double keptProbability(const Context& context, double inliers);
/** Estimated number of copies of each match, assumed to be the same for all: each of the m (m - 1)
/ 2 pairs of a sample consists of copies of one match with a probability of (copies - 1) / (n - 1),
and samples with such a pair are rejected. */
double copiesOf(const State& state, int n, int m);
/** Probability that a sample gives a good model, with this number of inliers, and that the verifier
does not reject it. Samples rejected because they contain a match twice are left out here; from
their number, copiesOf() estimates how many distinct matches there are. */
double goodModelProbability(const Context& context, const State& state, double inliers);
/** Probability that a sample leads to a good model with this number of inliers: that of an
all-inlier sample, times State::successProbability. Points are assumed to be drawn with repetition
or, with #TERMINATION_EXACT, without repetition from the distinct matches. */
double goodSampleProbability(const Context& context, const State& state, double inliers);

/** Minimum number of inliers of a significantly better model, see PNapsacTermination. The best
model must have more inliers than the points of a sample. */
double significantInliers(const Context& context, const State& state);

/** Number of samples after which practically all different samples have been drawn. If no model has
more inliers than its own sample, the criteria may ask for more samples, or never be fulfilled. */
int exhaustiveSamples(const Context& context);

/** @brief PROSAC's criterion for a model, see ProsacTermination. @return the smallest T'_n, see
Growth, of a length n* such that

- maximality: T_n* samples of the n* best points all miss its I_n* inliers with a probability of at
most exp(`logFailure`);
- non-randomness: the probability that one of T'_n* wrong models has as many independent inliers
among the n* points is less than 5 %.

Once the set contains all points, sampling goes on: for n* = N, as many samples as T_N lacks for
maximality are added to T'_N.
@param inliers which of the `size` points are inliers, best point first
@param repeated which of the inliers are no evidence as they repeat an earlier one; null: none
@param size number of points
@param m size of a sample
@param kept probability that a sample comes from the growing set and a good model is kept
@param randomRatio probability that a point is an inlier of a wrong model
@param logFailure logarithm of 1 - confidence
@param exact points are drawn without repetition, see goodSampleProbability
@param length output: n*, 0 if there is none; the result is then INT_MAX
@param context context of the run; the result is INT_MAX if the run has to end meanwhile. Null: it
need not end */
int prosacSamples(const uchar* inliers, const uchar* repeated, int size, int m, double kept,
                  double randomRatio, double logFailure, bool exact, int& length,
                  const Context* context = 0);

}  // namespace usacv20
}  // namespace cv

#endif
