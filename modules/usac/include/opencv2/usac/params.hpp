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

/** @brief Presets of the module, selected in the place of a `method` flag of cv::findHomography,
cv::findFundamentalMat, cv::findEssentialMat, cv::estimateAffine2D and cv::estimateAffinePartial2D.

The values meet none of OpenCV's own flags. The type is a scoped one, so a flag does not become an
`int` unseen: calib3d, which would get it, takes each number that it does not know for LMedS
(cv::findFundamentalMat, cv::findEssentialMat). A program that keeps its flag in an `int`, reads it
from a file, or chooses between a flag of this module and one of OpenCV's calls
usacv20::findHomography, usacv20::findFundamentalMat and usacv20::findEssentialMat, which take the
`int`s of both:
@code{.cpp}
    int method = (int)cv::USACV20;  // without the cast this does not compile
    // from a cv::FileStorage, with 16385: USACV20_FAST; with 8: cv::RANSAC
    cv::read(fs["method"], method, method);
    cv::Mat F = cv::usacv20::findFundamentalMat(points1, points2, method, 1.0, 0.99, mask);
@endcode
usacv20::methodFromInt makes a flag of a number, usacv20::isUsacV20Method tells whether it is one.
*/
enum class UsacV20Method : int {
    //! the configuration chosen in @cite ivashechkin2021usacv20, with robust polishing;
    //! usacv20::Params::usacV20()
    USACV20 = 0x4000,
    USACV20_FAST = 0x4001,  //!< early stop and a short local optimization; usacv20::Params::fast()
    USACV20_ACCURATE = 0x4002,  //!< late stop and a long local optimization;
                                //!< usacv20::Params::accurate()
    USACV20_PROSAC = 0x4003,    //!< the caller's points are sorted, best first;
                                //!< usacv20::Params::sorted()
    USACV20_MAGSAC = 0x4004,    //!< quality and fits marginalized over the noise;
                                //!< usacv20::Params::magsacPlusPlus()
    USACV20_PARALLEL = 0x4005   //!< USACV20 with cv::getNumThreads() threads, same result;
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
    SIMILARITY = 4,   //!< 2x3 map by rotation, uniform scale and translation from 2 or more
                      //!< correspondences
    ABSOLUTE_POSE = 5,  //!< 3x4 pose of a calibrated camera from 3 or more points of space and
                        //!< their images
    RIGID_3D = 6,       //!< 3x4 rotation and translation of space from 3 or more pairs of points of
                        //!< space
    SIMILARITY_3D = 7   //!< the same with a uniform scale
};

//! How minimal samples are drawn (paper, section "Sampling"); all but one of Params::orderedEvery
//! samples are uniform with any.
enum SamplerType {
    SAMPLER_UNIFORM = 0,  //!< all points are equally likely @cite fischler1981random
    SAMPLER_PROSAC = 1,   //!< the best points first, then ever more of them @cite chum2005matching
    //! The best point first and its neighbors, ever wider @cite barath2019progressive. Of the
    //! samples that are not uniform (Params::orderedEvery) one in four is local, every second one
    //! where the order is the density; in the paper all are until the neighborhood has grown to
    //! everything. It doubles when its point is chosen again; in the paper as PROSAC's set.
    SAMPLER_P_NAPSAC = 2,
    SAMPLER_NAPSAC = 3,     //!< any point and its neighbors @cite nasuto2002napsac
    SAMPLER_IMPORTANCE = 4  //!< points as often as Params::scores, their probabilities of being
                            //!< right, say
};

//! Which points are neighbors in the joint space (x1, y1, x2, y2).
enum NeighborhoodType {
    //! points in the same cell of a grid with layers of finer and wider cells
    //! @cite barath2019progressive
    NEIGHBORHOOD_GRID = 0,
    NEIGHBORHOOD_KNN = 1,    //!< the Params::neighbors nearest points, through cv::flann
    NEIGHBORHOOD_RADIUS = 2  //!< the points within Params::neighborRadius pixels, through cv::flann
};

//! Which error of a point is minimized and compared with the threshold.
enum ResidualType {
    //! H, affine maps: transfer error in image 2. F, E: Sampson distance. Absolute pose:
    //! reprojection error. Motions of space: distance in space 2
    RESIDUAL_STANDARD = 0,
    //! H, affine maps: root of the summed squared transfer errors in both images. F, E: of the
    //! squared distances to both epipolar lines. Absolute pose, motions of space: refused
    RESIDUAL_SYMMETRIC = 1
};

//! Where the order of the points ("best first") comes from (paper, section "Other features").
enum OrderingType {
    ORDERING_AUTO = 0,     //!< Params::scores where given, else the local density
    ORDERING_DENSITY = 1,  //!< local density of the points in the 4-D joint space, densest first
    //! the caller has sorted the points, best first; but Params::scores, where given, are the order
    ORDERING_INPUT_ORDER = 2,
    ORDERING_NONE = 3  //!< a fixed pseudo-random order
};

//! Which end of Params::scores is the good one.
enum ScoreOrder {
    SCORES_LOWER_IS_BETTER = 0,  //!< descriptor distances, ratios of distances
    SCORES_HIGHER_IS_BETTER = 1  //!< similarities, probabilities
};

//! How a model is rated (paper, section "Quality").
enum QualityType {
    QUALITY_INLIERS = 0,  //!< number of inliers @cite fischler1981random
    QUALITY_MSAC = 1,     //!< sum of truncated squared errors @cite torr2000mlesac
    QUALITY_MLESAC = 2,   //!< likelihood under a mixture of Gaussian inliers and uniform outliers
                          //!< @cite torr2000mlesac
    QUALITY_LMEDS = 3,    //!< median of the squared errors; finds the threshold itself
                          //!< @cite rousseeuw1984least
    QUALITY_MAGSAC = 4,   //!< likelihood marginalized over the scale of the noise
                          //!< @cite barath2019magsac
    QUALITY_MAGSAC_PLUS_PLUS = 5  //!< the robust loss of the marginalized weights
                                  //!< @cite barath2020magsac
};

//! How bad models are dropped early (paper, section "Pre-emptive verification").
enum VerificationType {
    VERIFICATION_NONE = 0,  //!< every model sees all points, or as many as the quality needs
    VERIFICATION_SPRT = 1,  //!< Wald's sequential probability ratio test @cite chum2008optimal
    VERIFICATION_TDD = 2    //!< the first Params::tddPoints points must be inliers
                            //!< @cite matas2004randomized
};

//! What improves each so-far-the-best model (paper, section "Local optimization").
enum LocalOptimizationType {
    LOCAL_OPTIMIZATION_NONE = 0,        //!< nothing
    LOCAL_OPTIMIZATION_GRAPH_CUT = 1,   //!< LO-RANSAC's first steps; where they gain, graph cut,
                                        //!< inner RANSAC @cite barath2018graph
    LOCAL_OPTIMIZATION_LO_RANSAC = 2,   //!< inner RANSAC, least squares with a shrinking threshold
                                        //!< @cite chum2003locally
    LOCAL_OPTIMIZATION_FLO_RANSAC = 3,  //!< the same on a bounded number of inliers
                                        //!< @cite lebeda2012fixing
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = 4,  //!< fits marginalized over the scale of the noise
                                             //!< @cite barath2019magsac
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = 5,  //!< re-weighted fits with marginalized
                                                       //!< weights @cite barath2020magsac
    LOCAL_OPTIMIZATION_GC_RANSAC = 6  //!< graph cut and inner RANSAC in turn, while the model
                                      //!< becomes better @cite barath2018graph
};

//! What ends the search, a set of bits; the first that fires wins (paper, section "Termination
//! criterion").
enum TerminationFlags {
    TERMINATION_STANDARD = 1,  //!< no better model with probability `confidence`
                               //!< @cite fischler1981random
    TERMINATION_SPRT = 2,      //!< the same, with the errors of SPRT accounted for
                               //!< @cite chum2008optimal
    TERMINATION_P_NAPSAC = 4,  //!< no significantly better model @cite barath2019progressive
    TERMINATION_PROSAC = 8,    //!< maximality and non-randomness in the best subset of the points
                               //!< @cite chum2005matching
    TERMINATION_MAGSAC = 16,   //!< the standard criterion marginalized over the noise
                               //!< @cite barath2019magsac
    TERMINATION_EXACT = 32,    //!< modifies the others: samples without repetition, C(I, m) / C(N,
                               //!< m), not (I / N)^m
    //! where the best model confirms a known order: PROSAC's, and nothing better beside it; idle
    //! without `runnersUp`
    TERMINATION_ORDER = 64
};

//! Degenerate configurations that are looked for, a set of bits (paper, section "Degeneracy"). All
//! bits: all checks of the problem. Maps but H, poses and motions of space refuse
//! #DEGENERACY_DEGENSAC but in that set, so usac2013(), too.
enum DegeneracyFlags {
    DEGENERACY_ORIENTATION = 1,  //!< H: orientation of the sample; F, E: oriented epipolar
                                 //!< constraint @cite chum2004epipolar
    //! F: samples of a plane, plane and parallax @cite chum2005two. E: twice the samples where most
    //! inliers are on one
    DEGENERACY_DEGENSAC = 2,
    //! samples of matches that share a point, also but for the noise where many do, and models of
    //! such matches
    DEGENERACY_REPEATED = 4
};

//! What is done to the best model at the end (Algorithm 1, last line).
enum PolishingType {
    POLISHING_NONE = 0,           //!< nothing
    POLISHING_LEAST_SQUARES = 1,  //!< least squares of the geometric error over all inliers, until
                                  //!< they settle
    POLISHING_REWEIGHTED = 2,     //!< iteratively re-weighted least squares with the weights of
                                  //!< MAGSAC++ @cite barath2020magsac
    POLISHING_ROBUST = 3  //!< least squares with a robust loss, that fits the noise of the inliers
                          //!< @cite beaton1974fitting
};

/** @brief All options of the estimator; each has an effect.

A default-constructed object is Params::usacV20. Wrong values raise a
cv::Exception that names the field when the estimator is created.
*/
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params();

    //! Inlier threshold in pixels, not squared; > 0. H, affine maps: distance in image 2. F, E:
    //! Sampson distance. Absolute pose: reprojection error in the image as it was taken. Motions of
    //! space: distance in space 2, in the unit of the points. Default 1.5.
    CV_PROP_RW double threshold;
    /** Probability that the search does not miss a better model (#TERMINATION_P_NAPSAC: one that is
    significantly better, see `relaxation`), unless `maxIterations` ends it; in (0, 1). Default
    0.99. */
    CV_PROP_RW double confidence;
    /** Upper bound of the number of minimal samples; >= 1. Default 5000. With any criterion of
    `termination` a run also ends when no sample is left to be drawn, or when none of the first
    million gave a model. */
    CV_PROP_RW int maxIterations;
    /** Milliseconds after which a run ends with what it has found; 0..1e9, 0: no limit. Late by 5
    ms for 10 000 points and 0.1 s for a million (to read these takes 0.08 s, the mask 0.007 s;
    Report tells what is less exact then). The only option by which the result depends on the
    machine, see Report::stop and ProgressScope. Default 0. */
    CV_PROP_RW double maxTime;
    //! Seed of the pseudo-random sequence; same seed, same input: same bits. Default 0.
    CV_PROP_RW int seed;
    //! Threads that test hypotheses, 0: cv::getNumThreads(); 0..1024. The result does not depend on
    //! it. Default 1.
    CV_PROP_RW int threads;

    //! @ref SamplerType. Default #SAMPLER_P_NAPSAC.
    CV_PROP_RW int sampler;
    //! @ref OrderingType. Default #ORDERING_AUTO.
    CV_PROP_RW int ordering;
    //! One for each correspondence, N values or none; #SAMPLER_IMPORTANCE takes them as
    //! probabilities. Default none.
    CV_PROP_RW std::vector<float> scores;
    /** A model to begin with, that of the frame before, say: numbers row by row, as the estimator
    returns them, or no model; see setInitialModel(). It is rated and optimized before the first
    sample, as if it came from one; what is better takes its place. Numbers of another model raise a
    cv::Exception. It saves time with a small `maxIterations`: poses of a smooth sequence with 20 %
    of right matches took 0.20 of the time of the defaults with 8, and a second run without a model
    where there were less than half of the inliers of the frame before. Default none. */
    CV_PROP_RW std::vector<double> initialModel;
    //! @ref ScoreOrder of `scores`. Default #SCORES_LOWER_IS_BETTER.
    CV_PROP_RW int scoreOrder;
    //! @ref NeighborhoodType. Default #NEIGHBORHOOD_GRID.
    CV_PROP_RW int neighborhood;
    //! Neighbors of a point for #NEIGHBORHOOD_KNN in the finest of four layers, each of twice as
    //! many; 1..1000. Default 10.
    CV_PROP_RW int neighbors;
    //! Radius for #NEIGHBORHOOD_RADIUS in the finest of four layers, each twice as wide, pixels; >
    //! 0. Default 40.
    CV_PROP_RW double neighborRadius;
    //! @ref ResidualType. Default #RESIDUAL_STANDARD.
    CV_PROP_RW int residual;
    //! @ref QualityType. Default #QUALITY_MSAC.
    CV_PROP_RW int quality;
    /** Search, local optimization and polishing work with so many times `threshold`, the mask with
    `threshold` itself; 1..10. For qualities and fits that are marginalized over the noise. Default
    1. */
    CV_PROP_RW double reach;
    /** Where the errors of the best model show that the noise is larger than `threshold`, `reach`
    grows with it, up to this, a multiple of `threshold`; 1..1e6; what is not above `reach` changes
    nothing. The mask stays that of `threshold` and may then be empty with a right model. The scale
    of the noise is found as in @cite moisan2004probabilistic. Default 1; presets of MAGSAC 1000. */
    CV_PROP_RW double widestReach;
    //! @ref VerificationType. Default #VERIFICATION_SPRT.
    CV_PROP_RW int verification;
    //! Points that must be inliers for #VERIFICATION_TDD; 1..100. Default 1.
    CV_PROP_RW int tddPoints;
    //! @ref LocalOptimizationType. Default #LOCAL_OPTIMIZATION_GRAPH_CUT.
    CV_PROP_RW int localOptimization;
    //! Rounds of one local optimization: alternations of labeling and fitting, steps of the
    //! shrinking threshold, re-weightings; 1..1000. Default 5.
    CV_PROP_RW int localIterations;
    //! Size of the inner samples of a local optimization as a multiple of the minimal one; 2..100.
    //! Default 3.
    CV_PROP_RW int localSampleMultiple;
    //! Inner samples of a local optimization (graph cut: of each of its alternations); 0..1000.
    //! Default 4.
    CV_PROP_RW int localSamples;
    //! Weight of the spatial coherence in the graph cut; 0 (none) .. 10. Default 0.14.
    CV_PROP_RW double spatialWeight;
    //! Models beside those that beat all samples before them that are optimized before the search
    //! ends, at most: those that explain most of what the best one does not, which is sampled, too
    //! (0: not). 0..100. Default 16.
    CV_PROP_RW int runnersUp;
    /** Samplers that prefer some of the points (all but #SAMPLER_UNIFORM) draw one in so many
    samples as they prefer, the others are uniform among all points. Only the uniform ones count for
    the criteria of termination but #TERMINATION_PROSAC: what is drawn from some points may never
    meet the best model, and `confidence` would not hold; but where one model has more than half of
    the points beside its sample, all count. With #TERMINATION_ORDER every second one of the first
    samples follows a known order, and all once it has proved to be good. 1: all samples are as
    preferred, and all count, as in the papers (prosac(), usac2013()); 1..1000. Default 8. */
    CV_PROP_RW int orderedEvery;
    //! Set of @ref TerminationFlags; 0 runs all `maxIterations`.
    //! Default #TERMINATION_SPRT | #TERMINATION_P_NAPSAC | #TERMINATION_EXACT | #TERMINATION_ORDER.
    CV_PROP_RW int termination;
    //! What a "significantly" better model has more for #TERMINATION_P_NAPSAC, as a fraction of the
    //! k inliers of the best one beside those of its sample if these are many; of few it is k / (k
    //! + 30) times that; 0..1. Default 0.05.
    CV_PROP_RW double relaxation;
    //! Times as many samples as the termination criteria ask for, as if 1 - confidence were this
    //! power of it; 1..100. Default 1.
    CV_PROP_RW int persistence;
    //! Set of @ref DegeneracyFlags. Default all.
    CV_PROP_RW int degeneracy;
    //! @ref PolishingType. Default #POLISHING_ROBUST; the paper's is #POLISHING_LEAST_SQUARES.
    CV_PROP_RW int polishing;
    //! Most fits of the polishing, each with the inliers or weights under the last one; fewer when
    //! they settle; 1..100. Default 6.
    CV_PROP_RW int polishingSteps;
    /** The largest Report::chance with which a model is returned, a probability; 0..1, after
    @cite moisan2004probabilistic. 1: a model is always returned. Default 0: 0.01 where there are
    enough independent points for a quarter of them to be that significant, else 1. */
    CV_PROP_RW double significance;

    /** @brief The configuration chosen in the paper, with robust polishing; the same as Params().
     */
    CV_WRAP static Params usacV20();
    /** @brief What UsacV20Method::USACV20_FAST uses: usacV20() that stops when a model with half as
    many inliers more would have been found, less of few (`relaxation`), whose local optimization
    has no graph cut, no inner samples and one round, with four runners-up and three steps of
    polishing. */
    CV_WRAP static Params fast();
    /** @brief What UsacV20Method::USACV20_ACCURATE uses: usacV20() with three times the samples
    that the standard termination asks for, up to ten alternations of ten inner samples in the local
    optimization, 24 runners-up, 20 polishing steps. */
    CV_WRAP static Params accurate();
    /** @brief As usacV20(), with PROSAC sampling of points that the caller has sorted, best first
    (`scores`, where given, are the order, as in all presets of sorted points): one sample in eight
    (`orderedEvery`), the others are uniform, so that a wrong order breaks no promise. What
    UsacV20Method::USACV20_PROSAC uses. */
    CV_WRAP static Params sorted();
    /** @brief As usacV20(), for who vouches for the order (`scores`, or #ORDERING_INPUT_ORDER): all
    samples are PROSAC's, and its criterion may end the search @cite chum2005matching. Where the
    order is wrong, it may miss the model. */
    CV_WRAP static Params trustedScores();
    /** @brief As usacV20(), with all threads of OpenCV, the same result. What
    UsacV20Method::USACV20_PARALLEL uses. */
    CV_WRAP static Params parallel();
    /** @brief RANSAC of 1981: uniform samples, number of inliers, least squares
    @cite fischler1981random. The number of samples, which the paper derives from a known part of
    inliers, follows from that of the best model so far, as has become custom. */
    CV_WRAP static Params ransac();
    /** @brief As ransac(), with truncated squared errors @cite torr2000mlesac. */
    CV_WRAP static Params msac();
    /** @brief As ransac(), with the median of the squared errors; `threshold` is not used
    @cite rousseeuw1984least. The number of samples is that for half of the points being right. */
    CV_WRAP static Params lmeds();
    /** @brief As ransac(), with the likelihood of a mixture of inliers and outliers
    @cite torr2000mlesac. The last fit is, as in ransac(), least squares over the inliers; the
    paper's minimizes the negative log-likelihood of all points.
  */
    CV_WRAP static Params mlesac();
    /** @brief As ransac(), with PROSAC's samples (`orderedEvery` 1: all of them) and termination;
    the caller has sorted the points, best first @cite chum2005matching. Where the termination
    differs from the paper is said at the class ProsacTermination. */
    CV_WRAP static Params prosac();
    /** @brief LO-RANSAC: as ransac(), each new best model is refined by ten inner samples
    @cite chum2003locally, each with four steps of a shrinking threshold. Fits are least squares of
    the geometric error, not of the algebraic one; so in all presets. */
    CV_WRAP static Params loRansac();
    /** @brief FLO-RANSAC: as msac(), each new best model is refined by inner samples and fits of
    bounded size @cite lebeda2012fixing. Four inner samples, which is faster than the paper's; their
    fits are of the geometric error.
  */
    CV_WRAP static Params floRansac();
    /** @brief GC-RANSAC: as msac(), each new best model is refined by graph cuts and inner samples
    of seven times the minimal size in turn, while it becomes better @cite barath2018graph;
    neighbors are the points within 20 pixels. The alternations end after ten. Every new best model
    is refined; the paper waits until enough samples have been drawn to expect it to be worth the
    time. */
    CV_WRAP static Params gcRansac();
    /** @brief USAC of 2013: PROSAC samples of sorted points (`orderedEvery` 1: all of them), SPRT,
    LO-RANSAC, DEGENSAC, the terminations of SPRT and PROSAC @cite raguram2013usac. DEGENSAC stands
    for the paper's general test of degeneracy; H has a test of orientation only, E one of planes
    beside it. */
    CV_WRAP static Params usac2013();
    /** @brief MAGSAC: uniform samples, marginalized quality, termination and fits (sigma-consensus)
    @cite barath2019magsac. The largest standard deviation of the noise is `reach` times `threshold`
    over the 0.99 quantile of chi. The errors have one degree of freedom for F and E and two for H,
    the constraints that a match has to fulfil; the paper has four, those of the coordinates, of
    which a model leaves the others free. The fit takes five parts of the noise's range. Where the
    data show more noise, the range grows (`widestReach`); the paper asks for a bound that is far
    too large instead. */
    CV_WRAP static Params magsac();
    /** @brief MAGSAC++: P-NAPSAC samples, SPRT, its robust loss and re-weighted fits
    (sigma-consensus++) @cite barath2020magsac. What UsacV20Method::USACV20_MAGSAC uses. The noise
    is marginalized up to `reach` times `threshold`, and further where the data show more noise
    (`widestReach`); degrees of freedom as in magsac(). Termination, runners-up and tests of
    degeneracy are those of usacV20(). */
    CV_WRAP static Params magsacPlusPlus();
    //! The preset behind a flag; a number that is none, made one by a cast, raises cv::Exception.
    static Params fromMethod(UsacV20Method method);
    /** @brief The preset behind the value of a flag.
    @param method value of one of #UsacV20Method; anything else raises cv::Exception. */
    CV_WRAP static Params fromMethod(int method);

    //! The nearest configuration to one of OpenCV's own USAC; `threshold`, `confidence`,
    //! `maxIterations` as they are.
    static Params fromUsacParams(const cv::UsacParams& params);

    /** @brief Sets `initialModel`, which saves time with a small `maxIterations`; see there.
    @param model 3x3 for H, F and E, 2x3 for affinities and similarities, 3x4 for an absolute pose
    and motions of space, any depth; empty: none
    */
    CV_WRAP void setInitialModel(InputArray model);

    /** @brief Raises a cv::Exception that names the first field with a wrong value.
    @param count number of correspondences, -1 if unknown. */
    CV_WRAP void check(int count = -1) const;

    //! Writes all fields into an open map of a cv::FileStorage.
    void write(FileStorage& fs) const;
    //! Reads the fields that the node has; the others keep their values.
    void read(const FileNode& node);
};

//! The same class. Beside `using namespace cv` prefer usacv20::Params: the name UsacParams alone
//! is, or may be, calib3d's class.
typedef Params UsacParams;

//! For `fs << "usac" << params`.
CV_EXPORTS void write(FileStorage& fs, const String& name, const Params& params);
//! For `fs["usac"] >> params`.
CV_EXPORTS void read(const FileNode& node, Params& params, const Params& defaults = Params());

/** @brief Turns an integer into a flag of the module.
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
