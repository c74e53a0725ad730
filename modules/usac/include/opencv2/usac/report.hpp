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
    STOP_NOT_RUN = 0,         //!< nothing has been run
    STOP_TOO_FEW_POINTS = 1,  //!< fewer finite correspondences than a minimal sample: no model
    STOP_NO_MODEL = 2,  //!< no sample gave a model with more inliers than a sample (degenerate
                        //!< data): no model
    STOP_MAX_ITERATIONS = 3,  //!< Params::maxIterations reached
    STOP_STANDARD = 4,        //!< #TERMINATION_STANDARD fired
    STOP_SPRT = 5,            //!< #TERMINATION_SPRT fired
    STOP_P_NAPSAC = 6,        //!< #TERMINATION_P_NAPSAC fired
    STOP_CUSTOM = 7,          //!< a Termination of the caller's fired
    STOP_PROSAC = 8,          //!< #TERMINATION_PROSAC fired
    STOP_MAGSAC = 9,          //!< #TERMINATION_MAGSAC fired
    //! the best model has no more support than random points give, see Params::significance: no
    //! model
    STOP_NOT_SIGNIFICANT = 10,
    STOP_ORDER = 11,  //!< #TERMINATION_ORDER fired
    STOP_TIME = 12,   //!< Params::maxTime is over: the model is the best one by then, or there is
                      //!< none yet
    STOP_CANCELLED = 13,  //!< a ProgressScope said no; the same
    STOP_NO_SEARCH = 14   //!< of Usac::fit and Usac::refine: nothing was searched
};

/** @brief What one estimation learned on its way. Times are of the steady clock and decide nothing.
 */
struct CV_EXPORTS_W_SIMPLE Report
{
    CV_WRAP Report();

    //! @ref StopReason.
    CV_PROP_RW int stop;
    //! Minimal samples drawn.
    CV_PROP_RW int iterations;
    //! Samples refused by a check of the sample (orientation, matches that share a point).
    CV_PROP_RW int rejectedSamples;
    //! Samples that determine no model (repeated or collinear points, no real solution).
    CV_PROP_RW int degenerateSamples;
    //! Models computed from the samples.
    CV_PROP_RW int models;
    //! Models refused by a check of the model itself (orientation, singular).
    CV_PROP_RW int rejectedModels;
    //! Models dropped by the pre-emptive verification.
    CV_PROP_RW int refusedModels;
    //! Models that were no better than the best one; Params::runnersUp of them are optimized
    //! nevertheless.
    CV_PROP_RW int droppedModels;
    //! Local optimizations run.
    CV_PROP_RW int localOptimizations;
    //! Those that improved their model.
    CV_PROP_RW int localImprovements;
    //! True if a so-far-the-best F came from a sample dominated by a plane.
    CV_PROP_RW bool degenerate;
    //! Rows of the mask that are 1.
    CV_PROP_RW int inliers;
    //! The sample that led to the model: rows of the points, as many as a minimal solver takes.
    //! Empty: there is no model, or it came from Params::initialModel or from a fit of all points.
    CV_PROP_RW std::vector<int> sample;
    //! `inliers` as a part of all rows of the mask, 0..1.
    CV_PROP_RW double inlierRatio;
    //! Inliers that are more than a threshold apart from each other in both images: repeated
    //! matches count once. 0 if the run had to end (Params::maxTime, ProgressScope) and has more
    //! than 50 000.
    CV_PROP_RW int independentInliers;
    /** Probability that the same search finds a model with as many independent inliers (at the
    threshold, or at 4 or 16 times of it) in random matches of the same points, 0..1: an upper
    bound, after @cite moisan2004probabilistic. Values below a millionth, and below a hundredth of
    Params::significance, may come from a part of the points, as any of a run that had to end: from
    50 000. Kept if the model was refused; 1 if there was none. */
    CV_PROP_RW double chance;
    //! Threshold of the mask in pixels, that of Params; #QUALITY_LMEDS: found from the data.
    CV_PROP_RW double threshold;
    /** True if `threshold` is at least half of the longest side of the box in which nearly all
    points of the last array lie: a model that maps everything to one place then has them all as
    inliers, and the number of inliers says nothing. The threshold is probably in another unit:
    pixels, say, beside points of the normalized image plane. */
    CV_PROP_RW bool wideThreshold;
    //! Cost of the returned model per correspondence; 0 (best) .. 1. MSAC: mean of min(error^2 /
    //! threshold^2, 1).
    CV_PROP_RW double cost;
    //! Milliseconds: reading, scaling and ordering the points.
    CV_PROP_RW double setupMs;
    //! Milliseconds: the hypothesize-and-verify loop without the local optimization.
    CV_PROP_RW double searchMs;
    //! Milliseconds: all local optimizations.
    CV_PROP_RW double localMs;
    //! Milliseconds: final polishing and the mask.
    CV_PROP_RW double polishMs;

    /** @brief One sentence for a log. It ends with "no better than chance" where `chance` is above
    0.01 and there is a model nevertheless: few points, or what Params::significance says. */
    CV_WRAP String describe() const;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
