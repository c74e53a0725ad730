// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PARAMS_HPP
#define OPENCV_USACV20_PARAMS_HPP

#include <vector>
#include "opencv2/core.hpp"

namespace cv {

struct UsacParams;  // of calib3d

//! @addtogroup usacv20
//! @{

// Python's integers cv2.USACV20* are declared in misc/python/python_usac.hpp
#ifndef OPENCV_BINDING_PARSER

/** @brief Presets of the module, passed as the `method` flag of cv::findHomography,
cv::findFundamentalMat, cv::findEssentialMat, cv::estimateAffine2D and cv::estimateAffinePartial2D,
or as the argument `flags` of cv::solvePnPRansac.

The values differ from all of OpenCV's own flags. The enumeration is scoped, so a flag is not
silently converted to an `int` and passed to calib3d, which for F and E treats any unknown number
as LMedS. If a program keeps its flag in an `int`, reads it from a file, or chooses between
a flag of this module and a flag of OpenCV, it must call usacv20::findHomography,
usacv20::findFundamentalMat and similar functions, which accept both kinds of flags as `int`:
@code{.cpp}
    int method = (int)cv::USACV20;  // without the cast this does not compile
    cv::Mat F = cv::usacv20::findFundamentalMat(points1, points2, method, 1.0, 0.99, mask);
@endcode
*/
enum class UsacV20Method : int {
    //! the configuration of the paper @cite ivashechkin2021usacv20, with robust polishing;
    //! usacv20::Params::usacV20()
    USACV20 = 0x4000,
    USACV20_FAST = 0x4001,      //!< early termination and a short local optimization;
                                //!< usacv20::Params::fast()
    USACV20_ACCURATE = 0x4002,  //!< late termination and a long local optimization;
                                //!< usacv20::Params::accurate()
    USACV20_PROSAC = 0x4003,    //!< for points that the caller has sorted, best first;
                                //!< usacv20::Params::sorted()
    USACV20_MAGSAC = 0x4004,    //!< MAGSAC++: score and fits marginalized over the noise scale;
                                //!< usacv20::Params::magsacPlusPlus()
    USACV20_PARALLEL = 0x4005,  //!< USACV20 with cv::getNumThreads() threads and the same result;
                                //!< usacv20::Params::parallel()
    USACV20_AUTO = 0x4006       //!< the threshold is estimated from the data; the given value is
                                //!< its upper bound; usacv20::Params::automatic()
};

//! UsacV20Method::USACV20
constexpr UsacV20Method USACV20 = UsacV20Method::USACV20;
//! UsacV20Method::USACV20_FAST
constexpr UsacV20Method USACV20_FAST = UsacV20Method::USACV20_FAST;
//! UsacV20Method::USACV20_ACCURATE
constexpr UsacV20Method USACV20_ACCURATE = UsacV20Method::USACV20_ACCURATE;
//! UsacV20Method::USACV20_PROSAC
constexpr UsacV20Method USACV20_PROSAC = UsacV20Method::USACV20_PROSAC;
//! UsacV20Method::USACV20_MAGSAC
constexpr UsacV20Method USACV20_MAGSAC = UsacV20Method::USACV20_MAGSAC;
//! UsacV20Method::USACV20_PARALLEL
constexpr UsacV20Method USACV20_PARALLEL = UsacV20Method::USACV20_PARALLEL;
//! UsacV20Method::USACV20_AUTO
constexpr UsacV20Method USACV20_AUTO = UsacV20Method::USACV20_AUTO;

#endif

namespace usacv20 {

//! The model that is estimated.
enum ProblemType {
    HOMOGRAPHY = 0,   //!< 3x3 homography from 4 or more correspondences
    FUNDAMENTAL = 1,  //!< 3x3 fundamental matrix from 7 or more correspondences
    ESSENTIAL = 2,    //!< 3x3 essential matrix from 5 or more correspondences of calibrated cameras
    AFFINITY = 3,     //!< 2x3 affine map from 3 or more correspondences
    SIMILARITY = 4,  //!< 2x3 rotation, uniform scale and translation from 2 or more correspondences
    ABSOLUTE_POSE = 5,  //!< 3x4 pose of a calibrated camera from 3 or more 3-D points
    RIGID_3D = 6,       //!< 3x4 rotation and translation from 3 or more pairs of 3-D points
    SIMILARITY_3D = 7,  //!< like #RIGID_3D, with a uniform scale
    TRANSLATION_2D = 8  //!< 2x3 translation from 1 or more correspondences
};

// OpenCV's generator of bindings accepts no space before the colon of an enumeration.
// clang-format off
//! What Params::threshold means.
enum ThresholdType: int {
    THRESHOLD_GIVEN = 0,  //!< the inlier threshold
    /** `threshold` is the largest plausible inlier threshold, for example three to ten times the
    usual one. The inlier threshold (Report::threshold) is the error that 95 % of the inliers do not
    exceed, but at least 1/1024 of `threshold`; it follows from the noise of the inliers
    (Report::sigma) @cite moisan2004probabilistic @cite torr2000mlesac. Before the search, up to
    1000 uniform samples (at most Params::maxIterations) are drawn, which Report does not count. The
    built-in checks for orientation and repeated matches apply to them, even if a program has
    replaced these checks. If no model is better than chance, or if the best model has fewer than
    ten inliers outside its sample, the inlier threshold is `threshold` / 1.5. Usac::fit, and
    Usac::refine with a mask, use `threshold` itself. Params::widestReach has no effect. */
    THRESHOLD_ESTIMATED = 1
};

//! How minimal samples are drawn (paper, section "Sampling"). One in Params::orderedEvery samples
//! is drawn in the way of the sampler; the others are uniform.
enum SamplerType: int {
    SAMPLER_UNIFORM = 0,  //!< all points are equally likely @cite fischler1981random
    SAMPLER_PROSAC = 1,   //!< from a growing set of the best points @cite chum2005matching
    //! P-NAPSAC: a point of PROSAC's set and others from its growing neighborhood
    //! @cite barath2019progressive. One in four of the non-uniform samples (Params::orderedEvery)
    //! is drawn in this way (one in two without scores or sorted points), the others as in PROSAC;
    //! all, as in the paper, if `orderedEvery` is 1, unless #TERMINATION_PROSAC is set. A
    //! neighborhood doubles when its point is drawn again; in the paper it grows like PROSAC's set.
    SAMPLER_P_NAPSAC = 2,
    SAMPLER_NAPSAC = 3,     //!< a random point and some of its neighbors @cite nasuto2002napsac
    SAMPLER_IMPORTANCE = 4  //!< each point with probability proportional to Params::scores, for
                            //!< example inlier probabilities
};

//! Which points are neighbors in the joint space of both arrays, such as (x1, y1, x2, y2).
enum NeighborhoodType: int {
    //! points in the same cell of a grid with layers of finer and coarser cells
    //! @cite barath2019progressive
    NEIGHBORHOOD_GRID = 0,
    NEIGHBORHOOD_KNN = 1,    //!< the Params::neighbors nearest points, through cv::flann
    NEIGHBORHOOD_RADIUS = 2  //!< the points within Params::neighborRadius pixels, through cv::flann
};

//! The error of a point, which is minimized and compared with the threshold.
enum ResidualType: int {
    //! H, affine maps: transfer error in image 2. F, E: Sampson distance. Absolute pose:
    //! reprojection error in the original (distorted) image. 3-D motions: distance between a mapped
    //! point and its counterpart
    RESIDUAL_STANDARD = 0,
    //! H, affine maps: root of the sum of the squared transfer errors in both images. F, E: root of
    //! the sum of the squared distances to both epipolar lines. Absolute pose, 3-D motions: raises
    //! cv::Exception
    RESIDUAL_SYMMETRIC = 1
};

//! Where the order of the points ("best first") comes from (paper, section "Other features").
enum OrderingType: int {
    ORDERING_AUTO = 0,     //!< Params::scores if given, else the local density
    ORDERING_DENSITY = 1,  //!< local density of the points in the joint space, densest first
    //! the caller has sorted the points, best first; if Params::scores are given, they determine
    //! the order instead
    ORDERING_INPUT_ORDER = 2,
    ORDERING_NONE = 3  //!< a fixed pseudo-random order
};

//! Whether low or high Params::scores are good.
enum ScoreOrder: int {
    SCORES_LOWER_IS_BETTER = 0,  //!< descriptor distances, distance ratios
    SCORES_HIGHER_IS_BETTER = 1  //!< similarities, probabilities
};

//! How a model is scored (paper, section "Quality").
enum QualityType: int {
    QUALITY_INLIERS = 0,  //!< number of inliers @cite fischler1981random
    QUALITY_MSAC = 1,     //!< sum of truncated squared errors @cite torr2000mlesac
    QUALITY_MLESAC = 2,   //!< likelihood under a mixture of Gaussian inliers and uniform outliers
                          //!< @cite torr2000mlesac
    QUALITY_LMEDS = 3,    //!< median of the squared errors; the threshold of the mask is estimated
                          //!< @cite rousseeuw1984least
    QUALITY_MAGSAC = 4,   //!< likelihood marginalized over the noise scale @cite barath2019magsac
    QUALITY_MAGSAC_PLUS_PLUS = 5  //!< the robust loss whose weights are marginalized over the noise
                                  //!< scale @cite barath2020magsac
};

//! How bad models are rejected early (paper, section "Pre-emptive verification").
enum VerificationType: int {
    VERIFICATION_NONE = 0,  //!< no test; scoring ends early only when the cost becomes too high
    VERIFICATION_SPRT = 1,  //!< Wald's sequential probability ratio test @cite chum2008optimal
    VERIFICATION_TDD = 2    //!< Params::tddPoints random points must be inliers
                            //!< @cite matas2004randomized
};

//! How each model that is better than all before is improved (paper, section "Local optimization").
enum LocalOptimizationType: int {
    LOCAL_OPTIMIZATION_NONE = 0,        //!< nothing
    LOCAL_OPTIMIZATION_GRAPH_CUT = 1,   //!< least squares with a shrinking threshold; then, if the
                                        //!< model clearly beats the best model so far, graph cut
                                        //!< and inner RANSAC @cite barath2018graph
    LOCAL_OPTIMIZATION_LO_RANSAC = 2,   //!< inner RANSAC and least squares with a shrinking
                                        //!< threshold @cite chum2003locally
    LOCAL_OPTIMIZATION_FLO_RANSAC = 3,  //!< like LO-RANSAC, with fits of bounded size
                                        //!< @cite lebeda2012fixing
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = 4,            //!< fits marginalized over the noise scale
                                                       //!< @cite barath2019magsac
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = 5,  //!< re-weighted fits with marginalized
                                                       //!< weights @cite barath2020magsac
    LOCAL_OPTIMIZATION_GC_RANSAC = 6  //!< graph cut and inner RANSAC alternately, as long as the
                                      //!< model improves @cite barath2018graph; see Params::paper
};

//! Termination criteria, a set of bits; the first that fires ends the search (paper, section
//! "Termination criterion").
enum TerminationFlags {
    TERMINATION_STANDARD = 1,  //!< with probability `confidence` there is no better model
                               //!< @cite fischler1981random
    TERMINATION_SPRT = 2,      //!< the standard criterion, allowing for good models that SPRT
                               //!< rejects @cite chum2008optimal
    TERMINATION_P_NAPSAC = 4,  //!< with probability `confidence` there is no significantly better
                               //!< model, see Params::relaxation @cite barath2019progressive
    TERMINATION_PROSAC = 8,    //!< PROSAC's maximality and non-randomness on a set of best points
                               //!< @cite chum2005matching
    TERMINATION_MAGSAC = 16,   //!< the standard criterion marginalized over the noise scale
                               //!< @cite barath2019magsac
    TERMINATION_EXACT = 32,    //!< modifies the other criteria: with I inliers among N points, a
                             //!< sample of m points, drawn without replacement, is all-inlier with
                             //!< probability C(I, m) / C(N, m) instead of (I / N)^m
    //! PROSAC's criterion, if inliers of the best model come early in a known order and samples
    //! drawn from its outliers yield no better model; takes effect only with PROSAC or P-NAPSAC,
    //! local optimization, `orderedEvery` above 1 and `runnersUp` above 0
    TERMINATION_ORDER = 64
};

//! Checks for degenerate configurations, a set of bits (paper, section "Degeneracy"). All bits: all
//! checks that the problem has. For affine maps, absolute poses and 3-D motions,
//! #DEGENERACY_DEGENSAC raises cv::Exception unless all bits are set, as in usac2013() and paper().
enum DegeneracyFlags {
    DEGENERACY_ORIENTATION = 1,  //!< H: orientation of the sample; F, E: oriented epipolar
                                 //!< constraint @cite chum2004epipolar
    //! F of a sample on a plane: plane and parallax @cite chum2005two. E with #TERMINATION_EXACT:
    //! twice as many samples if most inliers are on a plane. Pose: the second pose of a plane
    DEGENERACY_DEGENSAC = 2,
    //! rejects samples in which two matches have the same point in an array (nearly the same, if
    //! there are many such matches); many matches to one point, or many copies of one match, count
    //! as a single inlier
    DEGENERACY_REPEATED = 4
};

//! How the best model is refined at the end (Algorithm 1, last line).
enum PolishingType: int {
    POLISHING_NONE = 0,           //!< nothing
    POLISHING_LEAST_SQUARES = 1,  //!< least squares of the geometric error over all inliers,
                                  //!< repeated while this improves the model
    POLISHING_REWEIGHTED = 2,     //!< iteratively re-weighted least squares with the weights of
                                  //!< MAGSAC++ @cite barath2020magsac
    POLISHING_ROBUST = 3  //!< least squares with a robust loss adapted to the noise of the inliers
                          //!< @cite beaton1974fitting; few inliers: from several initial models
};

// clang-format on

/** @brief All options of the estimator.

A default-constructed object equals Params::usacV20(). When an estimator is created, an invalid
value raises a cv::Exception that names the field. */
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params();

    //! Inlier threshold, the upper bound of the error that `residual` selects, in pixels, not
    //! squared; > 0. 3-D motions: in the unit of the points. Default 1.5.
    CV_PROP_RW double threshold;
    //! @ref ThresholdType of `threshold`. Default #THRESHOLD_GIVEN.
    CV_PROP_RW ThresholdType thresholdType;
    /** Probability that the search does not miss a better model (#TERMINATION_P_NAPSAC: a
    significantly better one, see `relaxation`), unless `maxIterations` ends it first; in (0, 1).
    Default 0.99. */
    CV_PROP_RW double confidence;
    /** Upper bound of the number of minimal samples; >= 1. Default 5000. Unless `termination` is 0,
    a run also ends when nearly all possible samples have been drawn, or when none of the first
    million samples has yielded a model. */
    CV_PROP_RW int maxIterations;
    /** Milliseconds after which a run ends with the best model so far; 0..1e9, 0: no limit. A run
    takes up to 5 ms longer with 10 000 points, 0.1 s longer with a million. Some values of Report
    are then less exact, see Report::chance. No other option makes the result depend on the machine
    (but a ProgressScope can do so). Default 0. */
    CV_PROP_RW double maxTime;
    //! Seed of the pseudo-random sequence; the same seed and input give equal results. Default 0.
    CV_PROP_RW int seed;
    //! Number of threads that compute and score models; 0..1024, 0: cv::getNumThreads(). The result
    //! does not depend on this number. Default 1.
    CV_PROP_RW int threads;
    //! @ref SamplerType. Default #SAMPLER_P_NAPSAC.
    CV_PROP_RW SamplerType sampler;
    //! @ref OrderingType. Default #ORDERING_AUTO.
    CV_PROP_RW OrderingType ordering;
    //! Score of each match, N values, not all NaN (the worst), or none; samplers use them to prefer
    //! matches, `runnersUp` to decide between models of nearly equal cost. Default none.
    CV_PROP_RW std::vector<float> scores;
    /** Noise of each correspondence: N, 3 N or 6 N numbers, or no sigmas; N: standard deviations of
    errors, 1e-6 to 1e6, in pixels or up to a common factor (such as keypoint scales); 3 N:
    covariances xx, xy, yy of points in image 2, square pixels, without noise in image 1; 6 N: for
    each match, the covariance in image 2, then that in image 1 (0, 0, 0: exact). Variances are
    1e-12 to 1e12, and 1 - xy^2 / (xx yy) is at least 1e-6. Covariances need image points (a pose
    has one image: 3 N) and #RESIDUAL_STANDARD. `threshold`, Usac::errors, Report::threshold and
    Report::sigma are then multiples of the standard deviation of each error. Default none. */
    CV_PROP_RW std::vector<float> sigmas;
    //! Entries, row by row, of an initial model as the estimator returns it, or no model; see
    //! setInitialModel(). It is scored and optimized before the first sample. Default none.
    CV_PROP_RW std::vector<double> initialModel;
    /** Entries, row by row, of the covariance of `initialModel`, or no covariance; d x d, symmetric
    and positive definite, for the parameters of Report::covariance. With it, the initial model is a
    prior: the result is the mean of the prior and the model of the points, weighted by inverse
    covariances @cite kalman1960filter, and Report::covariance is that of this mean. If the two
    models contradict each other (Report::priorChance below 0.001), the prior is not used. If the
    model is that of a previous frame, add the covariance of the motion since then. Default none. */
    CV_PROP_RW std::vector<double> initialCovariance;
    //! @ref ScoreOrder of `scores`. Default #SCORES_LOWER_IS_BETTER.
    CV_PROP_RW ScoreOrder scoreOrder;
    //! @ref NeighborhoodType. Default #NEIGHBORHOOD_GRID.
    CV_PROP_RW NeighborhoodType neighborhood;
    //! Number of neighbors of a point for #NEIGHBORHOOD_KNN in the finest of four layers; each
    //! further layer has twice as many (up to 512); 1..1000. Default 10.
    CV_PROP_RW int neighbors;
    //! Radius in pixels for #NEIGHBORHOOD_RADIUS in the finest of four layers, doubled for each
    //! further layer, with at most 512 neighbors; > 0. Default 40.
    CV_PROP_RW double neighborRadius;
    //! @ref ResidualType. Default #RESIDUAL_STANDARD.
    CV_PROP_RW ResidualType residual;
    //! @ref QualityType. Default #QUALITY_MSAC.
    CV_PROP_RW QualityType quality;
    /** Search, local optimization and polishing use this multiple of `threshold`; the mask uses
    `threshold` itself; 1..10. Meant for scores and fits that are marginalized over the noise scale.
    Default 1; magsac() 3, magsacPlusPlus() 2.4. */
    CV_PROP_RW double reach;
    /** Upper bound to which `reach` grows during the search if the errors of the best model show
    that `threshold` times `reach` is too small for the noise; 1..1e6. The mask still uses
    `threshold` and can then be empty for a correct model. The noise scale is estimated as in
    @cite moisan2004probabilistic. Default 1; magsac() and magsacPlusPlus() 1000. */
    CV_PROP_RW double widestReach;
    //! @ref VerificationType. Default #VERIFICATION_SPRT.
    CV_PROP_RW VerificationType verification;
    //! Number of points that must be inliers for #VERIFICATION_TDD; 1..100. Default 1.
    CV_PROP_RW int tddPoints;
    //! @ref LocalOptimizationType. Default #LOCAL_OPTIMIZATION_GRAPH_CUT.
    CV_PROP_RW LocalOptimizationType localOptimization;
    //! Iterations of one local optimization: alternations of labeling and fitting, steps of the
    //! shrinking threshold, or re-weightings; 1..1000. Default 5.
    CV_PROP_RW int localIterations;
    //! Size of the inner samples of local optimization, in minimal sample sizes; 2..100. Default 3.
    CV_PROP_RW int localSampleMultiple;
    //! Number of inner samples of local optimization (graph cuts: per alternation). If not 0,
    //! #LOCAL_OPTIMIZATION_GRAPH_CUT draws at least 4 if there are few inliers; 0..1000. Default 1;
    //! accurate(), loRansac() 10, floRansac() 4, gcRansac(), paper() 20.
    CV_PROP_RW int localSamples;
    //! Weight of the spatial coherence in the graph cut; 0 (none) .. 10. Default 0.14.
    CV_PROP_RW double spatialWeight;
    //! Maximum number of runners-up: models that were not the best one, but are optimized when the
    //! search is about to end, because they have the most inliers that are outliers of the best
    //! model. If above 0, samples are also drawn from these outliers. 0..100. Default 16.
    CV_PROP_RW int runnersUp;
    /** Samplers that prefer some points (all except #SAMPLER_UNIFORM) draw one in this many samples
    in their own way; the others are uniform. Only the uniform samples count for the termination
    criteria except #TERMINATION_PROSAC and #TERMINATION_ORDER, because samples from a subset might
    never be all-inlier. But all samples count if more than half of the points outside the sample of
    the best model are its inliers and no plane dominates. If the order is known, the first 8
    samples are uniform; with #TERMINATION_ORDER, every second sample then follows the order at
    first, and every sample once the order is confirmed. 1: all samples are drawn in the sampler's
    way and count, as in the papers (prosac(), usac2013(), paper()); 1..1000. Default 8. */
    CV_PROP_RW int orderedEvery;
    //! Set of @ref TerminationFlags; 0: all `maxIterations` samples are drawn. Default
    //! #TERMINATION_SPRT | #TERMINATION_P_NAPSAC | #TERMINATION_EXACT | #TERMINATION_ORDER.
    CV_PROP_RW int termination;
    //! For #TERMINATION_P_NAPSAC and #TERMINATION_ORDER: how many more inliers than the best model
    //! a "significantly" better one has, as a fraction of the k inliers of the best model outside
    //! its sample. The fraction is multiplied by k / (k + 30), so that it is smaller for few
    //! inliers; 0..1. Default 0.05.
    CV_PROP_RW double relaxation;
    //! Factor on the number of samples that the termination criteria ask for, as if 1 - confidence
    //! were raised to this power; 1..100. Default 1.
    CV_PROP_RW int persistence;
    //! Set of @ref DegeneracyFlags. Default all.
    CV_PROP_RW int degeneracy;
    //! @ref PolishingType. Default #POLISHING_ROBUST; the paper has #POLISHING_LEAST_SQUARES.
    CV_PROP_RW PolishingType polishing;
    //! Maximum number of fits of the polishing, each with the inliers or weights of the previous
    //! fit; six more for #POLISHING_ROBUST with more than 32768 points; 1..100. Default 6.
    CV_PROP_RW int polishingSteps;
    /** Largest Report::chance with which a model is returned, a probability; 0..1, after
    @cite moisan2004probabilistic. 1: a model is returned whatever its chance is. Default 0: the
    bound is 0.01, or 1 if there are so few independent points that even a model with a quarter of
    them as inliers would have a chance above 0.01. */
    CV_PROP_RW double significance;
    //! 1: Report::covariance and Report::sigma are computed (0.1 to 0.3 ms); 0..1. Default 0.
    CV_PROP_RW int covariance;

    /** @brief The configuration of the paper, with additions; equal to Params(). See paper(). */
    CV_WRAP static Params usacV20();
    /** @brief Preset of UsacV20Method::USACV20_FAST: like usacV20(), but the search ends when a
    model with 50 % more inliers (less if there are few inliers, see `relaxation`) would have been
    found; local optimization has no graph cut, no inner samples and a single iteration; there are
    four runners-up and three polishing steps. */
    CV_WRAP static Params fast();
    /** @brief Preset of UsacV20Method::USACV20_ACCURATE: like usacV20(), but with three times the
    samples that the standard criterion asks for, up to ten alternations with ten inner samples each
    in the local optimization, 24 runners-up and 20 polishing steps. */
    CV_WRAP static Params accurate();
    /** @brief Like usacV20(), with PROSAC sampling of points that the caller has sorted, best first
    (if `scores` are given, they determine the order, as in all presets for sorted points). Only
    some samples follow the order (`orderedEvery`); the others are uniform, so that `confidence`
    holds even for a wrong order. Preset of UsacV20Method::USACV20_PROSAC. */
    CV_WRAP static Params sorted();
    /** @brief Like usacV20(), for an order that the caller trusts (`scores`, or
    #ORDERING_INPUT_ORDER): all samples are drawn as in PROSAC, and PROSAC's criterion can end the
    search @cite chum2005matching. If the order is wrong, the search might miss the model. */
    CV_WRAP static Params trustedScores();
    /** @brief Like usacV20(), with all threads of OpenCV and the same result. Preset of
    UsacV20Method::USACV20_PARALLEL. */
    CV_WRAP static Params parallel();
    /** @brief Like usacV20(), with an estimated threshold (#THRESHOLD_ESTIMATED) of at most 5
    pixels. Preset of UsacV20Method::USACV20_AUTO. */
    CV_WRAP static Params automatic();
    /** @brief RANSAC of 1981: uniform samples, number of inliers, least squares
    @cite fischler1981random. The number of samples follows from the best model so far. */
    CV_WRAP static Params ransac();
    /** @brief MSAC: like ransac(), with truncated squared errors @cite torr2000mlesac. */
    CV_WRAP static Params msac();
    /** @brief LMedS: like ransac(), with the median of the squared errors; `threshold` is not used
    @cite rousseeuw1984least. The number of samples assumes an inlier ratio of one half. */
    CV_WRAP static Params lmeds();
    /** @brief MLESAC: like ransac(), with the likelihood of a mixture of inliers and outliers
    @cite torr2000mlesac. As in ransac(), the last fit is least squares over the inliers; the paper
    minimizes the negative log-likelihood of all points. */
    CV_WRAP static Params mlesac();
    /** @brief PROSAC: like ransac(), with PROSAC's samples (`orderedEvery` 1: all of them) and
    termination; the caller has sorted the points, best first @cite chum2005matching. The comment of
    the class ProsacTermination describes how the termination differs from the paper. */
    CV_WRAP static Params prosac();
    /** @brief LO-RANSAC: like ransac(), but each new best model is refined by ten inner samples
    @cite chum2003locally, each followed by four fits with a shrinking threshold. As in all
    presets, fits minimize the geometric error, not the algebraic one. */
    CV_WRAP static Params loRansac();
    /** @brief FLO-RANSAC: like msac(), but each new best model is refined by inner samples (four,
    fewer than in the paper) and fits of bounded size @cite lebeda2012fixing. */
    CV_WRAP static Params floRansac();
    /** @brief GC-RANSAC: like msac(), but each new best model is refined alternately by graph cuts
    and by inner samples of seven times the minimal size, as long as the model improves, at most ten
    times @cite barath2018graph; neighbors are the points within 20 pixels. The paper postpones the
    refinement until enough samples have been drawn for it to pay off. */
    CV_WRAP static Params gcRansac();
    /** @brief USAC of 2013: PROSAC samples of sorted points (`orderedEvery` 1: all of them), SPRT,
    LO-RANSAC, DEGENSAC, the terminations of SPRT and PROSAC @cite raguram2013usac. DEGENSAC (only
    for F) replaces the paper's general test for degeneracy; all have the orientation test. */
    CV_WRAP static Params usac2013();
    /** @brief USACv20 to the letter, for comparisons (H, F, E): Algorithm 1 and section 2 of
    @cite ivashechkin2021usacv20, without the additions of usacV20(). P-NAPSAC draws all samples,
    and as in gcRansac(), each model better than the optimized best one is optimized at once (in the
    other presets: than all models of samples; of the first samples, only the best). The paper's
    experiments have 10000 iterations for H, 1000 for F and E. What remains: batches of samples,
    only a random part of more than 32768 points is searched; all of it is in doc/paper_map.md. */
    CV_WRAP static Params paper();
    /** @brief MAGSAC: uniform samples, marginalized score, termination and fits (sigma-consensus)
    @cite barath2019magsac. The largest standard deviation of the noise is `reach` times `threshold`
    divided by the 0.99 quantile of the chi distribution. Errors have as many degrees of freedom as
    a match has constraints, one for F and E and two for H; the paper uses four, the number of
    coordinates of a match. The fit divides the range of the noise scale into five parts. If the
    data show more noise, the range grows (`widestReach`); the paper uses a large fixed range. */
    CV_WRAP static Params magsac();
    /** @brief MAGSAC++: P-NAPSAC samples, SPRT, the robust loss of MAGSAC++ and re-weighted fits
    (sigma-consensus++) @cite barath2020magsac. Preset of UsacV20Method::USACV20_MAGSAC. Noise scale
    and degrees of freedom as in magsac(); termination, runners-up, degeneracy as in usacV20(). */
    CV_WRAP static Params magsacPlusPlus();
    //! The preset of a flag; an invalid value (from a cast) raises cv::Exception.
    static Params fromMethod(UsacV20Method method);
    //! The preset for the value of a #UsacV20Method; anything else raises cv::Exception.
    CV_WRAP static Params fromMethod(int method);

    //! The options closest to those of OpenCV's own USAC; threshold, confidence, maximum number of
    //! iterations and seed are copied.
    static Params fromUsacParams(const cv::UsacParams& params);

    /** @brief Sets `initialModel` and `initialCovariance`. A wrong shape raises cv::Exception.
    @param model 3x3 for H, F and E, 2x3 for affine maps, 3x4 for poses and 3-D motions, or these
    numbers as a row or a column; any depth; empty: none
    @param covariance d x d, any depth, such as Report::covariance; empty: none */
    CV_WRAP void setInitialModel(InputArray model, InputArray covariance = noArray());

    /** @brief Raises a cv::Exception that names the first field with an invalid value.
    @param count number of correspondences, -1 if unknown. */
    CV_WRAP void check(int count = -1) const;

    //! Writes all fields to an open map of a cv::FileStorage.
    void write(FileStorage& fs) const;
    //! Reads the fields that the node contains; the others keep their values.
    void read(const FileNode& node);
};

//! Another name for Params. After `using namespace cv`, prefer usacv20::Params, because the
//! unqualified name UsacParams can also mean the class of calib3d.
typedef Params UsacParams;

//! For `fs << "usac" << params`.
CV_EXPORTS void write(FileStorage& fs, const String& name, const Params& params);
//! For `fs["usac"] >> params`.
CV_EXPORTS void read(const FileNode& node, Params& params, const Params& defaults = Params());

//! Converts a number to a flag; one that is not a #UsacV20Method raises cv::Exception.
CV_EXPORTS UsacV20Method methodFromInt(int method);

//! True for the values of #UsacV20Method.
CV_EXPORTS_W bool isUsacV20Method(int method);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
