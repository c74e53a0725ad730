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
cv::findFundamentalMat, cv::findEssentialMat, cv::estimateAffine2D and cv::estimateAffinePartial2D.

The values differ from all of OpenCV's own flags. The enumeration is scoped, so a flag is not
silently converted to an `int` and passed to calib3d, which treats any number it does not know as
LMedS (cv::findFundamentalMat, cv::findEssentialMat). A program that keeps its flag in an `int`,
reads it from a file, or chooses between a flag of this module and one of OpenCV calls
usacv20::findHomography, usacv20::findFundamentalMat and usacv20::findEssentialMat, which accept the
`int` values of both:
@code{.cpp}
    int method = (int)cv::USACV20;  // without the cast this does not compile
    // from a cv::FileStorage, with 16385: USACV20_FAST; with 8: cv::RANSAC
    cv::read(fs["method"], method, method);
    cv::Mat F = cv::usacv20::findFundamentalMat(points1, points2, method, 1.0, 0.99, mask);
@endcode
usacv20::methodFromInt converts a number to a flag; usacv20::isUsacV20Method tells whether it is
one.
*/
enum class UsacV20Method : int {
    //! the configuration recommended in @cite ivashechkin2021usacv20, with robust polishing;
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
    USACV20_PARALLEL = 0x4005   //!< USACV20 with cv::getNumThreads() threads and the same result;
                                //!< usacv20::Params::parallel()
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

#endif

namespace usacv20 {

//! The model that is estimated.
enum ProblemType {
    HOMOGRAPHY = 0,   //!< 3x3 homography from 4 or more correspondences
    FUNDAMENTAL = 1,  //!< 3x3 fundamental matrix from 7 or more correspondences
    ESSENTIAL = 2,    //!< 3x3 essential matrix from 5 or more correspondences of calibrated cameras
    AFFINITY = 3,     //!< 2x3 affine map from 3 or more correspondences
    SIMILARITY = 4,  //!< 2x3 rotation, uniform scale and translation from 2 or more correspondences
    ABSOLUTE_POSE = 5,  //!< 3x4 pose of a calibrated camera from 3 or more 3-D to 2-D
                        //!< correspondences
    RIGID_3D = 6,       //!< 3x4 rotation and translation from 3 or more pairs of 3-D points
    SIMILARITY_3D = 7   //!< the same with a uniform scale
};

//! How minimal samples are drawn (paper, section "Sampling"). With all of them, only one in
//! Params::orderedEvery samples is drawn this way; the others are uniform.
enum SamplerType {
    SAMPLER_UNIFORM = 0,  //!< all points are equally likely @cite fischler1981random
    SAMPLER_PROSAC = 1,   //!< from a growing set of the best points @cite chum2005matching
    //! A point and its neighbors, best points first, in growing neighborhoods
    //! @cite barath2019progressive. Of the samples that are not uniform (Params::orderedEvery), one
    //! in four is drawn from a neighborhood, or one in two if the order is the density of the
    //! points; in the paper all are, until the neighborhood contains all points. A neighborhood
    //! doubles when its point is chosen again; in the paper it grows like PROSAC's set.
    SAMPLER_P_NAPSAC = 2,
    SAMPLER_NAPSAC = 3,     //!< any point and its neighbors @cite nasuto2002napsac
    SAMPLER_IMPORTANCE = 4  //!< each point with probability proportional to Params::scores, for
                            //!< example inlier probabilities
};

//! Which points are neighbors in the joint space (x1, y1, x2, y2).
enum NeighborhoodType {
    //! points in the same cell of a grid with layers of finer and coarser cells
    //! @cite barath2019progressive
    NEIGHBORHOOD_GRID = 0,
    NEIGHBORHOOD_KNN = 1,    //!< the Params::neighbors nearest points, through cv::flann
    NEIGHBORHOOD_RADIUS = 2  //!< the points within Params::neighborRadius pixels, through cv::flann
};

//! Error of a point that is minimized and compared with the threshold.
enum ResidualType {
    //! H, affine maps: transfer error in image 2. F, E: Sampson distance. Absolute pose:
    //! reprojection error. 3-D motions: distance between a mapped point and its counterpart
    RESIDUAL_STANDARD = 0,
    //! H, affine maps: root of the summed squared transfer errors in both images. F, E: of the
    //! squared distances to both epipolar lines. Absolute pose, 3-D motions: raises cv::Exception
    RESIDUAL_SYMMETRIC = 1
};

//! Where the order of the points ("best first") comes from (paper, section "Other features").
enum OrderingType {
    ORDERING_AUTO = 0,     //!< Params::scores if given, else the local density
    ORDERING_DENSITY = 1,  //!< local density of the points in the 4-D joint space, densest first
    //! the caller has sorted the points, best first; if Params::scores are given, they determine
    //! the order instead
    ORDERING_INPUT_ORDER = 2,
    ORDERING_NONE = 3  //!< a fixed pseudo-random order
};

//! Whether low or high Params::scores are good.
enum ScoreOrder {
    SCORES_LOWER_IS_BETTER = 0,  //!< descriptor distances, distance ratios
    SCORES_HIGHER_IS_BETTER = 1  //!< similarities, probabilities
};

//! How a model is scored (paper, section "Quality").
enum QualityType {
    QUALITY_INLIERS = 0,  //!< number of inliers @cite fischler1981random
    QUALITY_MSAC = 1,     //!< sum of truncated squared errors @cite torr2000mlesac
    QUALITY_MLESAC = 2,   //!< likelihood under a mixture of Gaussian inliers and uniform outliers
                          //!< @cite torr2000mlesac
    QUALITY_LMEDS = 3,    //!< median of the squared errors; estimates the threshold
                          //!< @cite rousseeuw1984least
    QUALITY_MAGSAC = 4,   //!< likelihood marginalized over the noise scale @cite barath2019magsac
    QUALITY_MAGSAC_PLUS_PLUS = 5  //!< the robust loss whose weights are marginalized over the noise
                                  //!< scale @cite barath2020magsac
};

//! How bad models are rejected early (paper, section "Pre-emptive verification").
enum VerificationType {
    VERIFICATION_NONE = 0,  //!< no test; every model sees as many points as the score needs
    VERIFICATION_SPRT = 1,  //!< Wald's sequential probability ratio test @cite chum2008optimal
    VERIFICATION_TDD = 2    //!< Params::tddPoints random points must be inliers
                            //!< @cite matas2004randomized
};

//! How each so-far-the-best model is improved (paper, section "Local optimization").
enum LocalOptimizationType {
    LOCAL_OPTIMIZATION_NONE = 0,        //!< nothing
    LOCAL_OPTIMIZATION_GRAPH_CUT = 1,   //!< the first steps of LO-RANSAC, followed by graph cut and
                                        //!< inner RANSAC if they improve the model
                                        //!< @cite barath2018graph
    LOCAL_OPTIMIZATION_LO_RANSAC = 2,   //!< inner RANSAC and least squares with a shrinking
                                        //!< threshold @cite chum2003locally
    LOCAL_OPTIMIZATION_FLO_RANSAC = 3,  //!< the same with fits of bounded size
                                        //!< @cite lebeda2012fixing
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = 4,            //!< fits marginalized over the noise scale
                                                       //!< @cite barath2019magsac
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = 5,  //!< re-weighted fits with marginalized
                                                       //!< weights @cite barath2020magsac
    LOCAL_OPTIMIZATION_GC_RANSAC = 6  //!< graph cut and inner RANSAC alternately, as long as the
                                      //!< model improves @cite barath2018graph
};

//! Termination criteria, a set of bits; the first that fires ends the search (paper, section
//! "Termination criterion").
enum TerminationFlags {
    TERMINATION_STANDARD = 1,  //!< with probability `confidence` there is no better model
                               //!< @cite fischler1981random
    TERMINATION_SPRT = 2,      //!< the same, accounting for good models that SPRT rejects
                               //!< @cite chum2008optimal
    TERMINATION_P_NAPSAC = 4,  //!< the same for a significantly better model
                               //!< @cite barath2019progressive
    TERMINATION_PROSAC = 8,    //!< maximality and non-randomness on the best subset of the points
                               //!< @cite chum2005matching
    TERMINATION_MAGSAC = 16,   //!< the standard criterion marginalized over the noise scale
                               //!< @cite barath2019magsac
    TERMINATION_EXACT = 32,  //!< modifies the others: samples without replacement, all-inlier with
                             //!< probability C(I, m) / C(N, m), not (I / N)^m
    //! if the best model confirms a known order: PROSAC's criterion, provided that samples of the
    //! points not explained by the best model yield nothing better; no effect without `runnersUp`
    TERMINATION_ORDER = 64
};

//! Checks for degenerate configurations, a set of bits (paper, section "Degeneracy"). All bits: all
//! checks that the problem has. Affinities, similarities, absolute poses and 3-D motions raise
//! cv::Exception for #DEGENERACY_DEGENSAC unless all bits are set, and therefore for usac2013().
enum DegeneracyFlags {
    DEGENERACY_ORIENTATION = 1,  //!< H: orientation of the sample; F, E: oriented epipolar
                                 //!< constraint @cite chum2004epipolar
    //! F: samples dominated by a plane, plane and parallax @cite chum2005two. E: twice as many
    //! samples if most inliers are on a plane
    DEGENERACY_DEGENSAC = 2,
    //! samples of matches that share a point (up to noise, if there are many such matches), and
    //! models supported by such matches
    DEGENERACY_REPEATED = 4
};

//! How the best model is refined at the end (Algorithm 1, last line).
enum PolishingType {
    POLISHING_NONE = 0,           //!< nothing
    POLISHING_LEAST_SQUARES = 1,  //!< least squares of the geometric error over all inliers, until
                                  //!< the inliers no longer change
    POLISHING_REWEIGHTED = 2,     //!< iteratively re-weighted least squares with the weights of
                                  //!< MAGSAC++ @cite barath2020magsac
    POLISHING_ROBUST = 3  //!< least squares with a robust loss adapted to the noise of the inliers
                          //!< @cite beaton1974fitting
};

/** @brief All options of the estimator.

A default-constructed object is Params::usacV20. Invalid values raise a cv::Exception that names the
field when the estimator is created.
*/
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params();

    //! Inlier threshold in pixels, not squared; > 0. H, affine maps: distance in image 2. F, E:
    //! Sampson distance. Absolute pose: reprojection error in the original (distorted) image. 3-D
    //! motions: distance between a mapped point and its counterpart, in the unit of the points.
    //! Default 1.5.
    CV_PROP_RW double threshold;
    /** Probability that the search does not miss a better model (#TERMINATION_P_NAPSAC: a
    significantly better one, see `relaxation`), unless `maxIterations` ends it first; in (0, 1).
    Default 0.99. */
    CV_PROP_RW double confidence;
    /** Upper bound of the number of minimal samples; >= 1. Default 5000. With any criterion of
    `termination`, a run also ends when all possible samples have been drawn, or when none of the
    first million yielded a model. */
    CV_PROP_RW int maxIterations;
    /** Milliseconds after which a run ends with the best model so far; 0..1e9, 0: no limit.
    Exceeded by 5 ms for 10 000 points and by 0.1 s for a million (reading these takes 0.08 s, the
    mask 0.007 s; Report says which values are less exact then). The only option that makes the
    result depend on the machine, see Report::stop and ProgressScope. Default 0. */
    CV_PROP_RW double maxTime;
    //! Seed of the pseudo-random sequence; the same seed and input give bit-identical results.
    //! Default 0.
    CV_PROP_RW int seed;
    //! Threads that test hypotheses, 0: cv::getNumThreads(); 0..1024. The result does not depend on
    //! it. Default 1.
    CV_PROP_RW int threads;

    //! @ref SamplerType. Default #SAMPLER_P_NAPSAC.
    CV_PROP_RW int sampler;
    //! @ref OrderingType. Default #ORDERING_AUTO.
    CV_PROP_RW int ordering;
    //! Score of each correspondence, N values or none; #SAMPLER_IMPORTANCE uses them as weights.
    //! Default none.
    CV_PROP_RW std::vector<float> scores;
    /** Initial model, for example from the previous frame: numbers row by row, as the estimator
    returns them, or no model; see setInitialModel(). It is scored and optimized before the first
    sample, like a model of a sample; a better one replaces it. A wrong number of entries raises a
    cv::Exception. It saves time if `maxIterations` is small: poses of a smooth sequence with 20 %
    inliers took 0.20 of the time of the defaults when `maxIterations` was 8, including a second run
    without an initial model whenever there were fewer than half as many inliers as in the previous
    frame. Default none. */
    CV_PROP_RW std::vector<double> initialModel;
    //! @ref ScoreOrder of `scores`. Default #SCORES_LOWER_IS_BETTER.
    CV_PROP_RW int scoreOrder;
    //! @ref NeighborhoodType. Default #NEIGHBORHOOD_GRID.
    CV_PROP_RW int neighborhood;
    //! Number of neighbors of a point for #NEIGHBORHOOD_KNN in the finest of four layers; each
    //! further layer has twice as many; 1..1000. Default 10.
    CV_PROP_RW int neighbors;
    //! Radius for #NEIGHBORHOOD_RADIUS in the finest of four layers, doubled for each further one,
    //! pixels; >
    //! 0. Default 40.
    CV_PROP_RW double neighborRadius;
    //! @ref ResidualType. Default #RESIDUAL_STANDARD.
    CV_PROP_RW int residual;
    //! @ref QualityType. Default #QUALITY_MSAC.
    CV_PROP_RW int quality;
    /** Search, local optimization and polishing use this multiple of `threshold`, the mask uses
    `threshold` itself; 1..10. For scores and fits that are marginalized over the noise scale.
    Default 1. */
    CV_PROP_RW double reach;
    /** If the errors of the best model show that the noise is larger than `threshold`, `reach`
    grows with it, up to this multiple of `threshold`; 1..1e6; values up to `reach` have no effect.
    The mask still uses `threshold` and may then be empty for a correct model. The noise scale is
    estimated as in @cite moisan2004probabilistic. Default 1; presets of MAGSAC 1000. */
    CV_PROP_RW double widestReach;
    //! @ref VerificationType. Default #VERIFICATION_SPRT.
    CV_PROP_RW int verification;
    //! Number of points that must be inliers for #VERIFICATION_TDD; 1..100. Default 1.
    CV_PROP_RW int tddPoints;
    //! @ref LocalOptimizationType. Default #LOCAL_OPTIMIZATION_GRAPH_CUT.
    CV_PROP_RW int localOptimization;
    //! Iterations of one local optimization: alternations of labeling and fitting, steps of the
    //! shrinking threshold, or re-weightings; 1..1000. Default 5.
    CV_PROP_RW int localIterations;
    //! Size of the inner samples of a local optimization as a multiple of the minimal one; 2..100.
    //! Default 3.
    CV_PROP_RW int localSampleMultiple;
    //! Number of inner samples of a local optimization (graph cut: of each alternation); 0..1000.
    //! Default 4.
    CV_PROP_RW int localSamples;
    //! Weight of the spatial coherence in the graph cut; 0 (none) .. 10. Default 0.14.
    CV_PROP_RW double spatialWeight;
    //! Maximum number of models that are optimized before the search ends, in addition to those
    //! that were better than all models before them: those with the most inliers that the best
    //! model does not have. If above 0, the points that the best model does not explain are also
    //! sampled. 0..100. Default 16.
    CV_PROP_RW int runnersUp;
    /** Samplers that prefer some points (all except #SAMPLER_UNIFORM) draw one in this many samples
    in their own way; the others are uniform among all points. Only the uniform samples count for
    the termination criteria except #TERMINATION_PROSAC, because samples from a subset may never
    consist of inliers of the best model, and `confidence` would not hold; if one model has more
    than half of the points as inliers beside its sample, all samples count. With
    #TERMINATION_ORDER, every second one of the first samples follows a known order, and all samples
    do once the order has been confirmed. 1: all samples are drawn in the sampler's way, and all
    count, as in the papers (prosac(), usac2013()); 1..1000. Default 8. */
    CV_PROP_RW int orderedEvery;
    //! Set of @ref TerminationFlags; 0: all `maxIterations` samples are drawn. Default
    //! #TERMINATION_SPRT | #TERMINATION_P_NAPSAC | #TERMINATION_EXACT | #TERMINATION_ORDER.
    CV_PROP_RW int termination;
    //! How many more inliers a "significantly" better model has for #TERMINATION_P_NAPSAC, as a
    //! fraction of the k inliers of the best model that are not in its sample; multiplied by k / (k
    //! + 30), so that it is smaller for few inliers; 0..1. Default 0.05.
    CV_PROP_RW double relaxation;
    //! Factor on the number of samples that the termination criteria ask for, as if 1 - confidence
    //! were raised to this power; 1..100. Default 1.
    CV_PROP_RW int persistence;
    //! Set of @ref DegeneracyFlags. Default all.
    CV_PROP_RW int degeneracy;
    //! @ref PolishingType. Default #POLISHING_ROBUST; the paper's is #POLISHING_LEAST_SQUARES.
    CV_PROP_RW int polishing;
    //! Maximum number of fits of the polishing, each with the inliers or weights of the previous
    //! one; fewer if these no longer change; 1..100. Default 6.
    CV_PROP_RW int polishingSteps;
    /** Largest Report::chance with which a model is returned, a probability; 0..1, after
    @cite moisan2004probabilistic. 1: a model is always returned. Default 0: 0.01 if there are
    enough independent points that a quarter of them, as inliers, would be that significant, else 1.
  */
    CV_PROP_RW double significance;

    /** @brief The configuration recommended in the paper, with robust polishing; same as Params().
     */
    CV_WRAP static Params usacV20();
    /** @brief What UsacV20Method::USACV20_FAST uses: usacV20() that stops when a model with 50 %
    more inliers (less if there are few, see `relaxation`) would have been found; its local
    optimization has no graph cut, no inner samples and a single iteration; four runners-up and
    three polishing steps. */
    CV_WRAP static Params fast();
    /** @brief What UsacV20Method::USACV20_ACCURATE uses: usacV20() with three times the samples
    that the standard criterion asks for, up to ten alternations with ten inner samples each in the
    local optimization, 24 runners-up and 20 polishing steps. */
    CV_WRAP static Params accurate();
    /** @brief Like usacV20(), with PROSAC sampling of points that the caller has sorted, best first
    (if `scores` are given, they determine the order, as in all presets for sorted points). One
    sample in eight follows the order (`orderedEvery`), the others are uniform, so that `confidence`
    holds even for a wrong order. What UsacV20Method::USACV20_PROSAC uses. */
    CV_WRAP static Params sorted();
    /** @brief Like usacV20(), for an order that the caller trusts (`scores`, or
    #ORDERING_INPUT_ORDER): all samples are PROSAC's, and its criterion may end the search
    @cite chum2005matching. If the order is wrong, the search may miss the model. */
    CV_WRAP static Params trustedScores();
    /** @brief Like usacV20(), with all threads of OpenCV and the same result. What
    UsacV20Method::USACV20_PARALLEL uses. */
    CV_WRAP static Params parallel();
    /** @brief RANSAC of 1981: uniform samples, number of inliers, least squares
    @cite fischler1981random. The number of samples, which that paper derives from a known inlier
    ratio, follows from the inlier ratio of the best model so far, as has become customary. */
    CV_WRAP static Params ransac();
    /** @brief MSAC: like ransac(), with truncated squared errors @cite torr2000mlesac. */
    CV_WRAP static Params msac();
    /** @brief LMedS: like ransac(), with the median of the squared errors; `threshold` is not used
    @cite rousseeuw1984least. The number of samples assumes an inlier ratio of one half. */
    CV_WRAP static Params lmeds();
    /** @brief MLESAC: like ransac(), with the likelihood of a mixture of inliers and outliers
    @cite torr2000mlesac. As in ransac(), the last fit is least squares over the inliers; the paper
    minimizes the negative log-likelihood of all points.
    */
    CV_WRAP static Params mlesac();
    /** @brief PROSAC: like ransac(), with PROSAC's samples (`orderedEvery` 1: all of them) and
    termination; the caller has sorted the points, best first @cite chum2005matching. Differences of
    the termination from the paper are described at the class ProsacTermination. */
    CV_WRAP static Params prosac();
    /** @brief LO-RANSAC: like ransac(), but each new best model is refined by ten inner samples
    @cite chum2003locally, each with four steps of a shrinking threshold. As in all presets, fits
    minimize the geometric error, not the algebraic one. */
    CV_WRAP static Params loRansac();
    /** @brief FLO-RANSAC: like msac(), but each new best model is refined by inner samples and fits
    of bounded size @cite lebeda2012fixing. Four inner samples, which is faster than the paper's
    number; fits minimize the geometric error.
    */
    CV_WRAP static Params floRansac();
    /** @brief GC-RANSAC: like msac(), but each new best model is refined alternately by graph cuts
    and by inner samples of seven times the minimal size, as long as it improves, at most ten times
    @cite barath2018graph; neighbors are the points within 20 pixels. Every new best model is
    refined; the paper waits until enough samples have been drawn for the refinement to pay off. */
    CV_WRAP static Params gcRansac();
    /** @brief USAC of 2013: PROSAC samples of sorted points (`orderedEvery` 1: all of them), SPRT,
    LO-RANSAC, DEGENSAC, the terminations of SPRT and PROSAC @cite raguram2013usac. DEGENSAC
    replaces the paper's general test for degeneracy; H has only an orientation test, and E also a
    test for planes. */
    CV_WRAP static Params usac2013();
    /** @brief MAGSAC: uniform samples, marginalized score, termination and fits (sigma-consensus)
    @cite barath2019magsac. The largest standard deviation of the noise is `reach` times `threshold`
    divided by the 0.99 quantile of the chi distribution. Errors have one degree of freedom for F
    and E and two for H, the number of constraints on a match; the paper uses four, the number of
    coordinates, of which a model constrains only these. The fit divides the range of the noise into
    five parts. If the data show more noise, the range grows (`widestReach`); the paper requires a
    bound that is far too large instead. */
    CV_WRAP static Params magsac();
    /** @brief MAGSAC++: P-NAPSAC samples, SPRT, the robust loss of MAGSAC++ and re-weighted fits
    (sigma-consensus++) @cite barath2020magsac. What UsacV20Method::USACV20_MAGSAC uses. The noise
    is marginalized up to `reach` times `threshold`, and further if the data show more noise
    (`widestReach`); degrees of freedom as in magsac(). Termination, runners-up and tests for
    degeneracy are those of usacV20(). */
    CV_WRAP static Params magsacPlusPlus();
    //! The preset of a flag; an invalid value (from a cast) raises cv::Exception.
    static Params fromMethod(UsacV20Method method);
    /** @brief The preset for the value of a flag.
    @param method value of one of #UsacV20Method; anything else raises cv::Exception. */
    CV_WRAP static Params fromMethod(int method);

    //! The configuration closest to one of OpenCV's own USAC; `threshold`, `confidence` and
    //! `maxIterations` are copied.
    static Params fromUsacParams(const cv::UsacParams& params);

    /** @brief Sets `initialModel`, which saves time if `maxIterations` is small; see there.
    @param model 3x3 for H, F and E, 2x3 for affinities and similarities, 3x4 for an absolute pose
    and 3-D motions, any depth; empty: none
    */
    CV_WRAP void setInitialModel(InputArray model);

    /** @brief Raises a cv::Exception that names the first field with an invalid value.
    @param count number of correspondences, -1 if unknown. */
    CV_WRAP void check(int count = -1) const;

    //! Writes all fields to an open map of a cv::FileStorage.
    void write(FileStorage& fs) const;
    //! Reads the fields that the node contains; the others keep their values.
    void read(const FileNode& node);
};

//! The same class. With `using namespace cv`, prefer usacv20::Params: the unqualified name
//! UsacParams is, or may be, calib3d's class.
typedef Params UsacParams;

//! For `fs << "usac" << params`.
CV_EXPORTS void write(FileStorage& fs, const String& name, const Params& params);
//! For `fs["usac"] >> params`.
CV_EXPORTS void read(const FileNode& node, Params& params, const Params& defaults = Params());

/** @brief Converts an integer to a flag of the module.
@param method value of one of #UsacV20Method; anything else raises cv::Exception.
*/
CV_EXPORTS UsacV20Method methodFromInt(int method);

/** @brief True for the values of #UsacV20Method.
@param method any integer */
CV_EXPORTS_W bool isUsacV20Method(int method);

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
