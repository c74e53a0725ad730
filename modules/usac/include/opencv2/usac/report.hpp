// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_REPORT_HPP
#define OPENCV_USACV20_REPORT_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

//! Why an estimation ended.
enum StopReason {
    STOP_NOT_RUN = 0,         //!< no estimation has been run
    STOP_TOO_FEW_POINTS = 1,  //!< fewer different, finite correspondences than a minimal sample:
                              //!< no model
    STOP_NO_MODEL = 2,        //!< no sample yielded a model with enough inliers (degenerate data)
    STOP_MAX_ITERATIONS = 3,  //!< Params::maxIterations was reached
    STOP_STANDARD = 4,        //!< #TERMINATION_STANDARD fired, or practically all possible samples
                              //!< have been drawn
    STOP_SPRT = 5,            //!< #TERMINATION_SPRT fired
    STOP_P_NAPSAC = 6,        //!< #TERMINATION_P_NAPSAC fired
    STOP_CUSTOM = 7,          //!< a Termination component of the caller fired
    STOP_PROSAC = 8,          //!< #TERMINATION_PROSAC fired
    STOP_MAGSAC = 9,          //!< #TERMINATION_MAGSAC fired
    //! no model is returned: the best one has no more inliers than random matches can yield, see
    //! Params::significance
    STOP_NOT_SIGNIFICANT = 10,
    STOP_ORDER = 11,      //!< #TERMINATION_ORDER fired
    STOP_TIME = 12,       //!< Params::maxTime was reached: the model, if any, is the best so far
    STOP_CANCELLED = 13,  //!< the function of a ProgressScope returned false: the model, if any, is
                          //!< the best so far
    STOP_NO_SEARCH = 14   //!< result of Usac::fit or Usac::refine, which do not search
};

/** @brief Statistics of one estimation. Times are elapsed times and do not influence the result.
 */
struct CV_EXPORTS_W_SIMPLE Report
{
    CV_WRAP Report();

    //! @ref StopReason.
    CV_PROP_RW int stop;
    //! Number of minimal samples drawn.
    CV_PROP_RW int iterations;
    //! Number of samples rejected by a check before a model is computed (orientation, matches that
    //! share a point).
    CV_PROP_RW int rejectedSamples;
    //! Number of samples that determine no model (repeated or collinear points, no real solution).
    CV_PROP_RW int degenerateSamples;
    //! Number of models computed from the samples.
    CV_PROP_RW int models;
    //! Number of models rejected by a check before they are scored (orientation, singular matrix).
    CV_PROP_RW int rejectedModels;
    //! Number of models rejected by the pre-emptive verification.
    CV_PROP_RW int refusedModels;
    //! Number of models that were not better than the best model that any sample had given so far,
    //! before local optimization; some of these are optimized nevertheless, see Params::runnersUp.
    CV_PROP_RW int droppedModels;
    //! Number of local optimizations.
    CV_PROP_RW int localOptimizations;
    //! Number of local optimizations whose result was better than the best model so far.
    CV_PROP_RW int localImprovements;
    //! True if #DEGENERACY_DEGENSAC found a dominant plane in the sample or among the inliers of a
    //! model that it examined (F only).
    CV_PROP_RW bool degenerate;
    //! Number of inliers: rows of the mask that are 1.
    CV_PROP_RW int inliers;
    //! The minimal sample of the search that led to the model, as row indices of the caller's
    //! points. Empty if there is no model, or if the model did not come from a minimal sample, for
    //! example from Params::initialModel.
    CV_PROP_RW std::vector<int> sample;
    //! `inliers` as a fraction of all rows of the mask, 0..1.
    CV_PROP_RW double inlierRatio;
    //! Number of inliers without repetitions: in each array, inliers in the same cell of a grid
    //! count as one; the smaller of the two arrays' numbers is stored. The side of the cells is the
    //! threshold; in an array with another unit (object points), or if all inliers are near one
    //! point (custom problems with one array), only equal points count as one. 0 (not computed) if
    //! there are more than 50 000 inliers and no time is left (Params::maxTime, ProgressScope).
    CV_PROP_RW int independentInliers;
    /** Upper bound of the probability that the same search finds a model with as many independent
    inliers (at the threshold, or at 4 or 16 times the threshold) in random matches of the same
    points, 0..1, after @cite moisan2004probabilistic. A value below 1e-6 and below a hundredth of
    its limit (Params::significance) may have been computed from a subset of the points; if the run
    was stopped early, any value may have been computed from only 50 000 points. Also set if the
    model was rejected because of it; 1 if no model was found, or without a search (Usac::fit,
    Usac::refine). With #THRESHOLD_ESTIMATED, it is computed as if the estimated threshold had been
    given. */
    CV_PROP_RW double chance;
    //! Threshold of the mask, in the unit of Params::threshold: Params::threshold itself or, with
    //! #THRESHOLD_ESTIMATED or #QUALITY_LMEDS, a threshold estimated from the data.
    CV_PROP_RW double threshold;
    //! Standard deviation of each component of the inliers' errors, in the unit of
    //! Params::threshold. For F and E it is about the standard deviation of the points'
    //! coordinates; for maps it combines the noise of both arrays. It is computed from the errors
    //! under a polished model and corrected for the number of fitted parameters and for the cut-off
    //! at the threshold. With #THRESHOLD_ESTIMATED, the threshold is derived from the same
    //! estimate. 0 if it was not estimated: there is no model, there are too few inliers, the
    //! threshold was given and Params::covariance is 0, or the model comes from a fit without a
    //! search (Usac::fit, Usac::refine with a mask).
    CV_PROP_RW double sigma;
    /** Covariance of the parameters of the returned model, d x d, CV_64F; empty if there is no
    model, if Params::covariance is 0, or if the model comes from Usac::fit or Usac::refine with a
    mask. It describes the errors of the parameters that noise in the coordinates of the inliers
    causes; this noise is estimated from the inliers' errors. With few inliers the covariance is
    enlarged, because the estimate of the noise is uncertain: the mean squared Mahalanobis distance
    of the errors is then still d.

    The parameters (translations in the unit of the caller's `objectPoints` or `points2`, angles in
    radians):

    | problem | d | parameters |
    |---|---|---|
    | absolute pose | 6 | rotation vector w, translation: [exp(w) R, t + dt] |
    | rigid motion | 6 | the same |
    | 3-D similarity | 7 | the same, and relative change of the scale |
    | affinity | 6 | the entries, row by row |
    | similarity | 4 | a, b and the translation of [a -b tx; b a ty] |
    | translation | 2 | the translation |
    | homography, F, E | 8, 7, 5 | directions of the tangent space, see #tangentOfModel |

    #tangentOfModel returns the derivatives of the entries of any of these models with respect to
    its parameters, #covarianceOfModel the covariance of the entries. #covarianceOfPose and
    #pointCovariance compute the covariance of a motion and of points.

    All entries are NaN if the covariance is not determined: if the inliers leave some of the
    parameters free (for F: points on a plane; for F and E: no translation; for most models: points
    on a line), if at most two degrees of freedom are left, or if it is unknown what the model
    minimizes, because there is no polishing (#POLISHING_NONE) or a Polisher of your own without
    Polisher::support. The covariance does not cover a wrong model, wrong matches that agree with
    each other, errors of the calibration, or matches that are not independent (each repetition
    counts as a measurement). For F and E it is too small if wrong matches near the epipolar lines
    are among the inliers (for example if a third of all matches are wrong, mainly with forward
    motion or planar scenes). For all models it is too small if there are few matches with noise as
    wide as the threshold. See doc/measurements/covariance.md. */
    CV_PROP_RW Mat covariance;
    //! Probability, 0..1, of a difference at least as large as that between the initial model and
    //! the model of the points, if Params::initialCovariance and `covariance` describe the errors
    //! of these models. If it is below 0.001, the prior was not used. Also 0 if there is no prior
    //! or no covariance of the model of the points. With up to 20 matches and noise as wide as the
    //! threshold, `covariance` is too small: a fifth to a half of correct priors are then not used.
    CV_PROP_RW double priorChance;
    /** True if `threshold` is at least half of the longest side of the box that contains nearly all
    points of the last array. A model that maps all points to a single point can then have most
    points as inliers, and the number of inliers means nothing. The threshold is probably in the
    wrong unit, for example in pixels with points of the normalized image plane. */
    CV_PROP_RW bool wideThreshold;
    /** What makes the result doubtful although the call is valid, as a text for the user; empty if
    nothing does. There are three causes: `wideThreshold`; most points are more than 80 degrees off
    the optical axis (E, absolute pose), as with a camera matrix that is inverted or has no focal
    length; the principal point is at the same corner of the box of all points in both images (E),
    as with the camera matrix of larger images or without principal point. */
    CV_PROP_RW String warning;
    //! Cost of the returned model per correspondence; 0 (best) .. 1. MSAC: mean of min(error^2 /
    //! threshold^2, 1), where the threshold is that of the search (Params::reach).
    CV_PROP_RW double cost;
    //! Milliseconds before the search: reading, shuffling and normalizing the points, and the
    //! samples of #THRESHOLD_ESTIMATED.
    CV_PROP_RW double setupMs;
    //! Milliseconds in the hypothesize-and-verify loop without the local optimization.
    CV_PROP_RW double searchMs;
    //! Milliseconds in all local optimizations.
    CV_PROP_RW double localMs;
    //! Milliseconds after the search: final polishing, mask, `chance` and `covariance`.
    CV_PROP_RW double polishMs;

    /** @brief One sentence for a log. It ends with "no better than chance" if `chance` is above
    0.01 and a search returns a model nevertheless, because there are few points or
    Params::significance allows it. */
    CV_WRAP String describe() const;
};

//! Report::warning of the last estimation in the calling thread, for functions that return no
//! Report, such as cv::findHomography with a flag of this module.
CV_EXPORTS_W String lastWarning();

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
