// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_PROBLEM_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_PROBLEM_KIND_HPP

#include "method.hpp"
#include "opencv2/usac.hpp"
#include "truth_reader.hpp"

namespace benchmark {

/** All that the programs know of one problem: the truth that a pair must come with, how an estimate
is measured, and the calls of this module and of calib3d. There is one object of each, see kindOf().
*/
class ProblemKind
{
public:
    //! @param letter of lists and tables. @param modelSize of a model as the functions return it.
    //! @param threshold, maxIterations defaults of the command line
    ProblemKind(ProblemType type, char letter, const cv::Size& modelSize, double threshold,
                int maxIterations);
    virtual ~ProblemKind() {}

    const ProblemType type;
    const char letter;
    const cv::Size modelSize;
    const double threshold;
    const int maxIterations;

    //! Is the error of a model in pixels? Else it is in degrees.
    virtual bool inPixels() const { return true; }
    //! Does the problem take the camera matrices of image 1 and 2?
    virtual bool hasCamera1() const { return false; }
    virtual bool hasCamera2() const { return false; }
    //! Reads the matches and the truth of a pair, see readImagePair(). Default: the files of two
    //! views.
    virtual void read(const std::string& path, ImagePair& pair) const;

    //! See measures.hpp for these. In the coordinates of the input; what the pair has not is
    //! negative.
    virtual double modelError(const ImagePair& pair, const cv::Mat& model) const = 0;
    virtual double failureLimit(const ImagePair& pair) const = 0;
    virtual double modelCost(const ImagePair& pair, const cv::Mat& model,
                             double threshold) const = 0;
    virtual double poseError(const ImagePair& pair, const Estimate& estimate) const;
    //! Of the camera, percent of the depth of the scene, or what the problem has in its place;
    //! infinite without a model.
    virtual double centerError(const ImagePair& pair, const cv::Mat& model) const;
    //! @param error, centerError those of the model. Default: the error is above failureLimit().
    virtual bool failed(const ImagePair& pair, double error, double centerError) const;

    //! An estimator of this module for the matches of a pair; it can be run once.
    virtual cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair,
                                                 const cv::usacv20::Params& params) const;
    //! The function of this module that a user calls. @param estimate output, model and mask
    virtual void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                            Estimate& estimate) const = 0;
    //! The function of calib3d that a user calls with a flag. @param estimate output, as that
    //! function returns it
    virtual void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                            Estimate& estimate) const = 0;

protected:
    //! Tells of what the problem needs and the pair lacks. Default: nothing.
    virtual void checkTruth(const TruthReader& in, const ImagePair& pair) const;
};

//! The object of a problem.
const ProblemKind& kindOf(ProblemType problem);

//! The letters of all problems, in the order of cv::usacv20::ProblemType.
const std::string& problemLetters();

}  // namespace benchmark

#endif
