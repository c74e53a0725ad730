// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_ESTIMATOR_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_ESTIMATOR_METHOD_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>
#include "problem_set.hpp"
#include "registry.hpp"

namespace benchmark {

//! The input of an Estimator: settings and a pair without its ground truth. Letters stand for
//! problems, see letterOf(): P absolute pose; R, M rigid motion and similarity of 3D space.
struct Task
{
    Settings settings;
    std::vector<cv::Point2f> points1, points2;  //!< pixels
    std::vector<cv::Point3f> objectPoints;      //!< P, R, M: used instead of points1
    std::vector<cv::Point3f> spacePoints2;      //!< R, M: used instead of points2
    std::vector<float> scores;  //!< one for each match, lower is better; empty without `+scores`
    cv::Matx33d K1, K2;  //!< E: both camera matrices; P: K2 is that of the image; else the identity
    std::vector<double> distortion;  //!< P: lens distortion coefficients; empty: none
    std::map<std::string, double>
        fields;  //!< EstimatorTraits::fields, with the values that the method's name sets
};

/** A function that estimates a model by itself. It is called once in each run, and its time is
measured. An exception counts as a failure.
@return the model, of type CV_64F and in the form in which the functions of this module return it
(H, F and E 3 x 3; A, S and T 2 x 3; P and R [R | t]; M [s R | t]), or an empty matrix if there is
none; the mask, N values of CV_8U, or an empty matrix (the pose error of F and E then uses all
matches, and the number of inliers is reported as 0); the number of iterations, or -1 if it is
unknown */
typedef std::function<Estimate(const Task& task)> Estimator;

//! The abilities of an Estimator.
struct EstimatorTraits
{
    explicit EstimatorTraits(const ProblemSet& problems_ = ProblemSet(), bool takesScores_ = false)
        : problems(problems_), takesScores(takesScores_)
    {}

    ProblemSet problems;  //!< the problems that the estimator is run for
    bool takesScores;     //!< false: `+scores` after the method's name is an error
    std::map<std::string, double>
        fields;  //!< further options that `{field=value}` can set, with their default values
};

/** A method that calls an Estimator. `{field=value}` in its name sets `threshold`, `confidence`,
`maxIterations`, `seed`, or one of EstimatorTraits::fields. */
class EstimatorMethod : public Method
{
public:
    EstimatorMethod(const MethodName& name, const Estimator& estimator,
                    const EstimatorTraits& traits);

    bool solves(ProblemType problem) const CV_OVERRIDE { return traits.problems.has(problem); }
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    //! Raises std::runtime_error if the estimate does not have the form that Estimator requires.
    void tell(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

private:
    void setFields();

    Estimator estimator;
    EstimatorTraits traits;
    std::string fields;
    bool useScores;
    Task task;
};

/** Makes a factory for registerMethod:

    registerMethod("custom:mine", wholeEstimator([](const Task& task) -> Estimate { ... }));

An empty function raises std::runtime_error. */
MethodFactory wholeEstimator(const Estimator& estimator,
                             const EstimatorTraits& traits = EstimatorTraits());

}  // namespace benchmark

#endif
