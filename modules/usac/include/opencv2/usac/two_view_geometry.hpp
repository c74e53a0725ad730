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

//! What two images are to each other: the names and numbers of COLMAP's table
//! `two_view_geometries`.
enum TwoViewConfiguration {
    TWO_VIEW_UNDEFINED = 0,   //!< nothing is known: the arguments are wrong, or the estimation was
                              //!< cancelled
    TWO_VIEW_DEGENERATE = 1,  //!< no model is good enough; TwoViewGeometry::reason says why
    TWO_VIEW_CALIBRATED = 2,  //!< an essential matrix, and a pose
    TWO_VIEW_UNCALIBRATED = 3,  //!< a fundamental matrix: the focal lengths are not known, or are
                                //!< wrong
    TWO_VIEW_PLANAR = 4,        //!< a plane, seen by calibrated cameras that have moved
    TWO_VIEW_PANORAMIC = 5,     //!< a calibrated camera that has only turned
    TWO_VIEW_PLANAR_OR_PANORAMIC = 6,  //!< one of these two, of cameras whose focal lengths are not
                                       //!< known
    TWO_VIEW_WATERMARK = 7  //!< matches in the border of both images that stay where they are
};

//! The rules of #estimateTwoViewGeometry beside the options of a search. The defaults are COLMAP's
//! but for `inlierRatio`.
struct CV_EXPORTS_W_SIMPLE TwoViewRules
{
    CV_WRAP TwoViewRules();

    //! Inliers of a model that counts, at least; >= 1. Default 15.
    CV_PROP_RW int minInliers;
    //! Least part of the matches that is expected to be right, 0..1: the search draws no more
    //! samples than find such a pair with Params::confidence. Pairs with a smaller part are found,
    //! too, but not all. Default 0.25.
    CV_PROP_RW double inlierRatio;
    /** Parts of the matches that are right in some pairs of the same collection, each above 0 and
    up to 1: the confidence is then that of a right pair of this collection, see #samples. Default
    none: not known. */
    CV_PROP_RW std::vector<double> ratios;
    //! A homography with more than this part of the inliers makes the pair planar or panoramic;
    //! 0..1. Default 0.8.
    CV_PROP_RW double planarRatio;
    //! An essential matrix with less than this part of the inliers of F tells that the focal
    //! lengths are wrong; 0..1. Default 0.95.
    CV_PROP_RW double calibrationRatio;

    /** @brief Samples that find a pair that is to be kept, whatever Params::maxIterations says.
    @param params `confidence` counts, and whether the local optimization is that of `USACV20`
    @param sampleSize points of a sample: 5 for E, 7 for F, 4 for H
    @param matches of the pair
    @return the samples, a whole number of at least 500.

    Samples are drawn without replacement: of I right ones among N matches the part C(I, m) / C(N,
    m) is right. I is `inlierRatio` of N, but `minInliers` or more. With `ratios` the mean over
    those and one pair more has the confidence: that one has any ratio between `inlierRatio` and the
    least of them, as a pair is worse than all of k others with a chance of 1 / (k + 1). Of E a
    sample of `USACV20` counts as up to four, as its local optimization makes a model of one with a
    wrong point, too. */
    CV_WRAP double samples(const Params& params, int sampleSize, int matches) const;
    //! The chance that one of these samples, but not more than Params::maxIterations, is right, if
    //! `inlierRatio` of the matches is; 0..1.
    CV_WRAP double reached(const Params& params, int sampleSize, int matches) const;
    //! Raises cv::Exception that names a wrong field.
    CV_WRAP void check() const;
};

//! Matches of two images, and what is known of their cameras: what #estimateTwoViewGeometry takes.
struct CV_EXPORTS_W_SIMPLE TwoViewPair
{
    CV_WRAP TwoViewPair();
    //! The matches alone, or with the cameras, empty: focal length not known.
    TwoViewPair(const Mat& points1, const Mat& points2, const Mat& cameraMatrix1 = Mat(),
                const Mat& cameraMatrix2 = Mat());

    //! N points of image 1 in pixels; any layout and depth that #estimateHomography takes.
    CV_PROP_RW Mat points1;
    //! Their N counterparts in image 2.
    CV_PROP_RW Mat points2;
    //! 3x3, any depth. Empty: the focal length of image 1 is not known.
    CV_PROP_RW Mat cameraMatrix1;
    //! The same of image 2, also if it is the same camera.
    CV_PROP_RW Mat cameraMatrix2;
    //! 4, 5, 8, 12 or 14 coefficients of the distortion of camera 1, which needs `cameraMatrix1`;
    //! empty: none.
    CV_PROP_RW Mat distCoeffs1;
    //! The same of image 2.
    CV_PROP_RW Mat distCoeffs2;
    //! Pixels of image 1. (0, 0): not known, and no watermark is looked for.
    CV_PROP_RW Size imageSize1;
    //! Pixels of image 2.
    CV_PROP_RW Size imageSize2;
    //! The points of image 1 as taken, if `points1` have no distortion any more, for watermarks;
    //! empty: `points1`.
    CV_PROP_RW Mat taken1;
    //! The same of image 2.
    CV_PROP_RW Mat taken2;
    //! Of the matches, in the place of Params::scores, so that pairs share their Params; N numbers.
    //! Empty: those.
    CV_PROP_RW std::vector<float> scores;
};

//! What has become of a pair. Matrices are CV_64F and empty where they are not known; pixels are
//! those without distortion.
struct CV_EXPORTS_W_SIMPLE TwoViewGeometry
{
    CV_WRAP TwoViewGeometry();

    //! @ref TwoViewConfiguration.
    CV_PROP_RW int configuration;
    //! N x 1, CV_8U, 1: an inlier of E, else of F, else of H.
    CV_PROP_RW Mat mask;
    //! How many these are.
    CV_PROP_RW int inliers;
    //! 3x3, x2^T F x1 = 0 in pixels, unit Frobenius norm.
    CV_PROP_RW Mat F;
    //! 3x3, of image planes, singular values (1, 1, 0)/sqrt(2), where the essential matrix tells
    //! the inliers.
    CV_PROP_RW Mat E;
    //! 3x3, pixels of image 1 to image 2, h33 = 1, of at least `minInliers` of the inliers.
    CV_PROP_RW Mat H;
    //! 3x3, X2 = R X1 + t, where the configuration is #TWO_VIEW_CALIBRATED, #TWO_VIEW_PLANAR (one
    //! of two motions that see a plane alike, unless matches off it decide) or #TWO_VIEW_PANORAMIC,
    //! or a watermark of calibrated cameras.
    CV_PROP_RW Mat R;
    //! 3x1, unit length; 0 where the camera has only turned.
    CV_PROP_RW Mat t;
    //! 3k x 3: of cameras whose focal lengths are given, the rotations that the matches allow, one
    //! below the other; one of them is right if the pair is.
    CV_PROP_RW Mat rotations;
    //! Of the search for the model that tells the inliers, or for the best one that was refused.
    CV_PROP_RW Report report;
    //! Samples drawn, but for those of H among inliers.
    CV_PROP_RW int iterations;
    //! Of the clock.
    CV_PROP_RW double milliseconds;
    //! Why there are no inliers, one line without a period; empty: there are.
    CV_PROP_RW String reason;
    //! Of #estimateTwoViewGeometries: message of the cv::Exception that this pair has raised, else
    //! empty.
    CV_PROP_RW String error;
};

/** @brief What two images are to each other, by their matches.

@param pair matches, cameras, sizes of the images
@param params options of each search. `threshold` is the Sampson distance of E and F in pixels
without distortion, from which that of H follows; `significance` 0: 10^-4; `maxTime` is that of each
model. `initialModel` has to be empty
@param rules the rest
@return the configuration with its models, inliers and pose.

An essential matrix E is estimated where both focal lengths are known, else a fundamental matrix F;
with E, F starts from it. Where E is refused F is searched for in 500 samples, and the square of the
significance is asked of it. Where F tells that the focal lengths are wrong E is tried once more,
from F. H is estimated of the inliers, else of all matches. CALIBRATED: E has `calibrationRatio` of
F's inliers, but for what F wins by chance, or most are on a plane. The rules are COLMAP's with
differences that doc/collections.md names; H's threshold is larger than that of E, as its error has
two coordinates.

Raises cv::Exception for lists of different lengths, points of a wrong shape, what is no camera, a
distortion without a camera, and wrong options. */
CV_EXPORTS_W TwoViewGeometry estimateTwoViewGeometry(const TwoViewPair& pair,
                                                     const Params& params = Params(),
                                                     const TwoViewRules& rules = TwoViewRules());

#ifndef OPENCV_BINDING_PARSER  // other languages have functions of their own for it

//! @overload
//! Of points as taken by cameras without distortion. `cameraMatrix1`, `cameraMatrix2`: empty: not
//! known, each by itself.
CV_EXPORTS TwoViewGeometry estimateTwoViewGeometry(InputArray points1, InputArray points2,
                                                   InputArray cameraMatrix1 = noArray(),
                                                   InputArray cameraMatrix2 = noArray(),
                                                   const Params& params = Params(),
                                                   const TwoViewRules& rules = TwoViewRules());

/** @brief Many pairs, side by side, by the same options.

@param pairs of any sizes, with and without cameras, mixed
@param params, rules as of #estimateTwoViewGeometry; the scores are those of the pairs
@param threads how many pairs at once, at most cv::getNumThreads(); 0: as many as that
@return one TwoViewGeometry for each pair, in this order: to the bit that of
#estimateTwoViewGeometry, whatever `threads` is, but for `milliseconds` and the times of the report.

A mistake in a pair ends that pair alone: its `error` says which. Raises cv::Exception for wrong
options, and if `threads` is below 0. */
CV_EXPORTS std::vector<TwoViewGeometry> estimateTwoViewGeometries(
    const std::vector<TwoViewPair>& pairs, const Params& params = Params(),
    const TwoViewRules& rules = TwoViewRules(), int threads = 0);

#endif

//! @}

}  // namespace usacv20
}  // namespace cv

#endif
