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

//! The input of a whole estimator: a pair without its ground truth.
struct Task
{
    Settings settings;  //!< problem, threshold in pixels, confidence, limit of iterations, seed
    std::vector<cv::Point2f> points1, points2;  //!< pixels
    std::vector<cv::Point3f> objectPoints;      //!< P, R, M: used instead of points1
    std::vector<cv::Point3f> spacePoints2;      //!< R, M: used instead of points2
    std::vector<float> scores;  //!< one for each match, lower is better; empty without `+scores`
    cv::Matx33d K1, K2;         //!< E: camera matrices; P: K2 alone; others: identity
    std::vector<double> distortion;  //!< P: lens distortion coefficients; empty: none
    std::map<std::string, double>
        fields;  //!< numbers of EstimatorTraits::fields, as changed by the method's name
};

/** Estimates a model. Each run calls it once, and this call is what is timed. An exception counts
as a failure.
@return the model, of type CV_64F and of the same form as the functions of calib3d return it (3 x 3;
A and S 2 x 3; P and R [R t]; M [s R t]), or an empty matrix if there is none; the mask, N values of
CV_8U, or an empty matrix if all matches are inliers (used for the pose); the number of iterations,
or -1 if unknown */
typedef std::function<Estimate(const Task& task)> Estimator;

//! The abilities of a whole estimator.
struct EstimatorTraits
{
    explicit EstimatorTraits(const ProblemSet& problems_ = ProblemSet(), bool takesScores_ = false)
        : problems(problems_), takesScores(takesScores_)
    {}

    ProblemSet problems;  //!< the problems that it is run for
    bool takesScores;     //!< false: `+scores` after its name is an error
    std::map<std::string, double>
        fields;  //!< further numeric options that `{field=value}` sets, with defaults
};

/** A method that calls a function that makes a model from points, from this module or elsewhere.
`{field=value}` sets `threshold`, `confidence`, `maxIterations`, `seed` and the fields in
EstimatorTraits. */
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

/** Makes the factory that registerMethod takes:

    registerMethod("custom:mine", wholeEstimator([](const Task& task) -> Estimate { ... }));

An empty function raises std::runtime_error. */
MethodFactory wholeEstimator(const Estimator& estimator,
                             const EstimatorTraits& traits = EstimatorTraits());

}  // namespace benchmark

#endif
