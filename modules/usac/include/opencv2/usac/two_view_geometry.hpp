// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TWO_VIEW_GEOMETRY_HPP
#define OPENCV_USACV20_TWO_VIEW_GEOMETRY_HPP

#include <vector>
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

//! The relation between two images, with the names and numbers of COLMAP's table
//! `two_view_geometries`.
enum TwoViewConfiguration {
    TWO_VIEW_UNDEFINED = 0,     //!< unknown: the estimation was canceled, or it raised an exception
                                //!< (batches)
    TWO_VIEW_DEGENERATE = 1,    //!< no model is good enough, see TwoViewGeometry::reason
    TWO_VIEW_CALIBRATED = 2,    //!< essential matrix and relative pose
    TWO_VIEW_UNCALIBRATED = 3,  //!< fundamental matrix: the focal lengths are unknown or wrong
    TWO_VIEW_PLANAR = 4,        //!< plane seen by calibrated cameras with a baseline
    TWO_VIEW_PANORAMIC = 5,     //!< pure rotation of a calibrated camera
    TWO_VIEW_PLANAR_OR_PANORAMIC = 6,  //!< plane or pure rotation; the focal lengths are unknown or
                                       //!< wrong
    TWO_VIEW_WATERMARK = 7  //!< most inliers are at the borders of both images, with a common shift
};

//! The rules by which #estimateTwoViewGeometry accepts models and chooses a configuration. The
//! defaults are those of COLMAP.
struct CV_EXPORTS_W_SIMPLE TwoViewRules
{
    CV_WRAP TwoViewRules();

    //! Minimum number of inliers of an accepted model; >= 1. Pairs with fewer than 8 matches are
    //! rejected in any case. Default 15.
    CV_PROP_RW int minInliers;
    //! Smallest expected inlier ratio, 0..1. The maximum number of samples is chosen so that the
    //! model of a pair with this ratio is found with probability Params::confidence (unless
    //! Params::maxIterations is smaller). Models of pairs with a smaller ratio can be found, too,
    //! but less reliably. Default 0.25.
    CV_PROP_RW double inlierRatio;
    /** Inlier ratios of some image pairs of the same collection, each above 0 and at most 1.
    Params::confidence is then the probability that the model of a pair is found, averaged over
    pairs with these ratios, see #samples. Default none: the ratios are unknown. */
    CV_PROP_RW std::vector<double> ratios;
    //! The pair is planar or panoramic if a homography explains more than this fraction of the
    //! inliers in TwoViewGeometry::mask; 0..1. Default 0.8.
    CV_PROP_RW double planarRatio;
    //! The focal lengths are considered wrong if the number of inliers of E is clearly less than
    //! this fraction of the number of inliers of F, see #estimateTwoViewGeometry. F may lose
    //! at most the fraction 1 minus `calibrationRatio` of the inliers of E; 0..1. Default 0.95.
    CV_PROP_RW double calibrationRatio;

    /** @brief Number of samples needed to find the model of an acceptable pair, regardless of
    Params::maxIterations.
    @param params options, of which only `confidence` matters, and whether sampler, quality, local
    optimization and polishing are those of `USACV20`
    @param sampleSize number of points in a sample: 5 for E, 7 for F, 4 for H
    @param matches number of matches of the pair
    @return the number of samples, an integer of at least 500.

    Samples are drawn without replacement: with I inliers among N matches, a sample of m points
    consists of inliers with probability C(I, m) / C(N, m). I is `inlierRatio` times N, rounded up,
    but at least `minInliers`. With `ratios`, the confidence is met on average over these k pairs
    and one more pair, whose ratio is uniformly distributed between `inlierRatio` and the smallest
    of `ratios`. The additional pair has the weight 1 / (k + 1), which is the probability that a new
    pair has a smaller ratio than k others. For E and F with these options of `USACV20`, a sample
    counts as up to four samples, because models are also found from samples with an outlier. */
    CV_WRAP double samples(const Params& params, int sampleSize, int matches) const;
    //! Probability, 0..1, that the model of a pair with the inlier ratio `inlierRatio` is found.
    //! The number of samples is samples(), but at most Params::maxIterations.
    CV_WRAP double reached(const Params& params, int sampleSize, int matches) const;
    //! Raises a cv::Exception that names the first invalid field.
    CV_WRAP void check() const;
    //! Like check(), but also checks `params`, which must have no `initialModel`, because E, F and
    //! H are estimated. `quality` must not be #QUALITY_LMEDS, which estimates a separate threshold
    //! for each model: E, F and H are compared at one threshold.
    CV_WRAP void check(const Params& params) const;
};

//! The input of #estimateTwoViewGeometry: the matches of two images and, if known, their cameras.
struct CV_EXPORTS_W_SIMPLE TwoViewPair
{
    CV_WRAP TwoViewPair();
    //! Matches and cameras; an empty camera matrix means that the focal length is unknown.
    TwoViewPair(const Mat& points1, const Mat& points2, const Mat& cameraMatrix1 = Mat(),
                const Mat& cameraMatrix2 = Mat());

    //! N points of image 1 in pixels; any layout and depth that #estimateHomography accepts.
    CV_PROP_RW Mat points1;
    //! Their N counterparts in image 2.
    CV_PROP_RW Mat points2;
    //! 3x3, any depth. Empty: the focal length of image 1 is unknown.
    CV_PROP_RW Mat cameraMatrix1;
    //! The same for image 2. It is not copied from image 1, even if the camera is the same.
    CV_PROP_RW Mat cameraMatrix2;
    //! 4, 5, 8, 12 or 14 distortion coefficients of camera 1, which require `cameraMatrix1`; empty:
    //! no distortion.
    CV_PROP_RW Mat distCoeffs1;
    //! The same for image 2.
    CV_PROP_RW Mat distCoeffs2;
    //! Size of image 1 in pixels. (0, 0): the size is unknown, and watermarks are not detected.
    CV_PROP_RW Size imageSize1;
    //! The same for image 2.
    CV_PROP_RW Size imageSize2;
    //! Original (distorted) points of image 1, if `points1` have been undistorted. They are used
    //! for the detection of watermarks; empty: `points1` are used.
    CV_PROP_RW Mat taken1;
    //! The same for image 2.
    CV_PROP_RW Mat taken2;
    //! N scores of the matches, used instead of Params::scores, so that pairs can share their
    //! Params. Empty: Params::scores.
    CV_PROP_RW std::vector<float> scores;
    //! N standard deviations of the errors of the matches, used instead of Params::sigmas. Empty:
    //! Params::sigmas, which must not be covariances.
    CV_PROP_RW std::vector<float> sigmas;
};

//! The result for a pair. All matrices except the mask are CV_64F, and empty if they were not
//! determined. F and H refer to undistorted pixels.
struct CV_EXPORTS_W_SIMPLE TwoViewGeometry
{
    CV_WRAP TwoViewGeometry();

    //! @ref TwoViewConfiguration.
    CV_PROP_RW int configuration;
    //! N x 1, CV_8U, 1 for the inliers of one accepted model: of E; of F if E was not accepted or
    //! if the focal lengths are wrong; of H if only H was accepted. All 0 if none was accepted;
    //! empty if `error` is set, or if a batch was canceled before this pair was begun.
    CV_PROP_RW Mat mask;
    //! Number of inliers in the mask.
    CV_PROP_RW int inliers;
    //! 3x3, x2^T F x1 = 0 in pixels, unit Frobenius norm.
    CV_PROP_RW Mat F;
    //! 3x3, for normalized image planes, singular values (1, 1, 0)/sqrt(2); set if `mask` marks the
    //! inliers of E.
    CV_PROP_RW Mat E;
    //! 3x3, maps pixels of image 1 to image 2, h33 = 1; set if H has at least `minInliers` inliers
    //! (among the inliers of E or F if one of them was accepted).
    CV_PROP_RW Mat H;
    //! 3x3, X2 = R X1 + t; set if `E` is set (planar pair: of the two motions compatible with the
    //! plane the one that #estimateRelativePose prefers), or if the camera only rotates
    //! (#TWO_VIEW_PANORAMIC).
    CV_PROP_RW Mat R;
    //! 3x1, unit length; 0 for a pure rotation.
    CV_PROP_RW Mat t;
    //! 3k x 3: for cameras with known focal lengths, the k rotations compatible with the matches,
    //! stacked; if the matches are correct, one of the rotations is the true one. Empty for
    //! #TWO_VIEW_WATERMARK and #TWO_VIEW_PLANAR_OR_PANORAMIC.
    CV_PROP_RW Mat rotations;
    //! Report on the search for the model of the mask or, if no model was accepted, for the
    //! rejected model with the lowest Report::chance. If the estimation was canceled, only
    //! Report::stop is set, to #STOP_CANCELLED.
    CV_PROP_RW Report report;
    //! Number of samples drawn, not counting the samples from which H was estimated among the
    //! inliers of E or F.
    CV_PROP_RW int iterations;
    //! Elapsed time in milliseconds.
    CV_PROP_RW double milliseconds;
    //! The reason why there are no inliers, one line without a period; empty if there are inliers,
    //! or if `error` is set.
    CV_PROP_RW String reason;
    //! Only from #estimateTwoViewGeometries: message of the cv::Exception that this pair raised,
    //! else empty.
    CV_PROP_RW String error;
};

/** @brief Determines the relation between two images from their matches.

@param pair matches, cameras, image sizes
@param params options of each search. `threshold` is the maximum Sampson distance for E and F in
undistorted pixels; the threshold of H is derived from it. `significance` 0 means 10^-4 here;
`maxTime` applies to each search separately. `initialModel` must be empty, and `quality` must not be
#QUALITY_LMEDS (see TwoViewRules::check). With sigmas, thresholds and errors are multiples of the
sigma of each match (see Params::sigmas). With #THRESHOLD_ESTIMATED, each search estimates its
threshold until a model is accepted; from then on, the threshold of the pair is Report::threshold of
this model (divided by 1.77, the ratio of the thresholds of H and E, if the model is H)
@param rules rules by which models are accepted and the configuration is chosen
@return the configuration with its models, inliers and pose.

If both focal lengths are known, an essential matrix E is estimated, and then a fundamental matrix F
starting from E; otherwise only F. If E is rejected, F is searched for with at most 500 samples and
accepted only if its Report::chance is at most the square of `significance`. If F is then accepted,
or has clearly more inliers than E, E is estimated once more, starting from F. A homography H is
estimated from the inliers of E (of F if E was rejected) or, if both were rejected, from all
matches. The threshold of H is larger than that of E, because the error of H has two coordinates.

If E and F are accepted, F is used instead of E, and the focal lengths are considered wrong, if all
of the following conditions hold:
- the number of inliers of E is clearly less than `calibrationRatio` times that of F;
- F loses hardly any inlier of E, and its errors for the matches that are inliers of both are hardly
  larger than those of E;
- if most inliers of E are on a plane: it is improbable that F has gained its additional inliers by
  chance.

These are the rules of COLMAP, with differences listed in doc/collections.md.

Raises cv::Exception for lists of different lengths, points of the wrong shape, invalid cameras,
distortion without a camera, and invalid options. */
CV_EXPORTS_W TwoViewGeometry estimateTwoViewGeometry(const TwoViewPair& pair,
                                                     const Params& params = Params(),
                                                     const TwoViewRules& rules = TwoViewRules());

#ifndef OPENCV_BINDING_PARSER  // not for the bindings, which have functions of their own

//! @overload
//! For points of cameras without distortion. An empty camera matrix means that the focal length of
//! this image is unknown.
CV_EXPORTS TwoViewGeometry estimateTwoViewGeometry(InputArray points1, InputArray points2,
                                                   InputArray cameraMatrix1 = noArray(),
                                                   InputArray cameraMatrix2 = noArray(),
                                                   const Params& params = Params(),
                                                   const TwoViewRules& rules = TwoViewRules());

/** @brief Processes many pairs in parallel, with the same options.

@param pairs the pairs; sizes can differ, and pairs with and without cameras can be mixed
@param params, rules as in #estimateTwoViewGeometry
@param threads how many pairs run at once, at most cv::getNumThreads(); 0: cv::getNumThreads()
@return one TwoViewGeometry for each pair, in the same order, bit-identical to that of
#estimateTwoViewGeometry, whatever `threads` is, except for `milliseconds` and the times in the
report.

An error in a pair ends only that pair and is described in its `error`. Raises cv::Exception for
invalid options, and if `threads` is negative. */
CV_EXPORTS std::vector<TwoViewGeometry> estimateTwoViewGeometries(
    const std::vector<TwoViewPair>& pairs, const Params& params = Params(),
    const TwoViewRules& rules = TwoViewRules(), int threads = 0);

#endif

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
