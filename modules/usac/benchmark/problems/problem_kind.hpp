// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PROBLEM_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_PROBLEM_KIND_HPP

#include "method.hpp"
#include "opencv2/usac.hpp"
#include "truth_reader.hpp"

namespace benchmark {

/** The properties of one problem: the ground truth that a pair must have, the error measures of
estimates, and the calls of this module and of calib3d. There is one object for each problem, which
kindOf() returns.
*/
class ProblemKind
{
public:
    //! @param letter letter of the problem in lists and tables
    //! @param modelSize columns and rows of a model
    //! @param threshold, maxIterations defaults of the command line
    ProblemKind(ProblemType type, char letter, const cv::Size& modelSize, double threshold,
                int maxIterations);
    virtual ~ProblemKind() {}

    const ProblemType type;
    const char letter;
    const cv::Size modelSize;
    const double threshold;
    const int maxIterations;

    //! True if the error of a model is in pixels; otherwise it is in degrees.
    virtual bool inPixels() const { return true; }
    //! hasCamera1: true if the problem needs the camera matrix of image 1; hasCamera2: the same for
    //! image 2.
    virtual bool hasCamera1() const { return false; }
    virtual bool hasCamera2() const { return false; }
    //! Reads the matches and the ground truth of a pair, see readImagePair(). Default: reads the
    //! files of an image pair.
    virtual void read(const std::string& path, ImagePair& pair) const;

    /** Error of an estimate; infinite without a model. Letters stand for problems, see letterOf().

    P, R and M: the angle between the estimated and the true rotation in degrees. Other problems:
    root mean square over the true correspondences, in pixels, of one of these errors. H, A, S and
    T: transfer error, the distance in image 2 between a point mapped by the estimate and its true
    counterpart, or the point mapped by the true H if H is the ground truth. F: Sampson distance. E:
    Sampson distance of K2^-T E K1^-1. Models are in the coordinates of the input. */
    virtual double modelError(const ImagePair& pair, const cv::Mat& model) const = 0;
    /** Error above which an estimate counts as a failure. H, A, S and T: 1 % of the diagonal of
    image 2, where the error is measured. F and E: 1 % of the mean of both diagonals. P, R and M: 5
    degrees (see MotionKind for a second condition). */
    virtual double failureLimit(const ImagePair& pair) const = 0;
    /** A cost like those that estimators minimize, which does not depend on the ground truth: the
    mean of min(1, (error / threshold)^2) over all correspondences. The error of a correspondence is
    its transfer error or Sampson distance, see modelError (P: reprojection error, with cost 1 for a
    point behind the camera; R, M: distance in space 2). 1 without a model. If a bad estimate has a
    higher cost than a good one, a longer search can improve it.
    @param threshold pixels; R, M: in the unit of space 2 */
    virtual double modelCost(const ImagePair& pair, const cv::Mat& model,
                             double threshold) const = 0;
    /** F and E: the larger of two angles in degrees, between the estimated and the true rotation,
    and between the estimated and the true direction of the translation. P, R and M: only the angle
    between the rotations. 180 without a model.

    Of the four poses of E (F: of K2^T F K1), the one with the most inliers in front of both cameras
    is used, or the one with the most correspondences there if the estimate has no inliers. Opposite
    translations differ by 180 degrees. Negative if the problem has no pose (the default), or if the
    true pose is not known. */
    virtual double poseError(const ImagePair& pair, const Estimate& estimate) const;
    //! Problem P: error of the camera center in percent of the depth of the scene; R and M (motions
    //! of 3D space): another measure in percent, see RigidMotion. Infinite without a model;
    //! negative for all other problems.
    virtual double centerError(const ImagePair& pair, const cv::Mat& model) const;
    //! True if the estimate is a failure; by default, if the error is above failureLimit() or NaN.
    //! @param error, centerError results of modelError() and centerError()
    virtual bool failed(const ImagePair& pair, double error, double centerError) const;

    //! An estimator of this module for the matches of a pair.
    virtual cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                                 const cv::usacv20::Params& params) const;
    //! Calls the function of this module as a user does. @param estimate output: model and mask
    virtual void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                            Estimate& estimate) const = 0;
    //! Calls the function of calib3d as a user does, with a flag. @param estimate output: model and
    //! mask; empty if the function fails
    virtual void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                            Estimate& estimate) const = 0;

protected:
    //! Called by the default of read(): raises an exception if the pair lacks ground truth
    //! that the problem needs in addition to true points. Default: checks nothing.
    virtual void checkTruth(const TruthReader& in, const ImagePair& pair) const;
};

//! Declares kindOf<NAME>() for each problem in registry.inl.hpp. The function is defined in the
//! file of the problem and returns the problem's only object.
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) const ProblemKind& kindOf##NAME();
#include "../../src/problems/registry.inl.hpp"

//! The object that describes a problem.
const ProblemKind& kindOf(ProblemType problem);

//! The letters of all problems, in the order of cv::usacv20::ProblemType.
const std::string& problemLetters();

}  // namespace benchmark

#endif
