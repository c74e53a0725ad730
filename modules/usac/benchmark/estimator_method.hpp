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

//! What a whole estimator is given: all of a pair but the truth.
struct Task
{
    Settings settings;  //!< problem, threshold in pixels, confidence, limit of iterations, seed
    std::vector<cv::Point2f> points1, points2;  //!< pixels
    std::vector<cv::Point3f> objectPoints;      //!< P, R, M: in the place of points1
    std::vector<cv::Point3f> spacePoints2;      //!< R, M: in the place of points2
    std::vector<float> scores;  //!< one a correspondence, lower is better; empty without `+scores`
    cv::Matx33d K1, K2;         //!< E: camera matrices; P: K2 alone; others: identity
    std::vector<double> distortion;  //!< P: of the camera; empty: none
    std::map<std::string, double>
        fields;  //!< the estimator's own, EstimatorTraits::fields or what the name says instead
};

/** Estimates a model. Called for each run; this call is what is measured. An exception counts as a
failure.
@return the model, of CV_64F as the functions of calib3d return it (3 x 3, A and S 2 x 3, P and R [R
t], M [s R t]), or empty: none; mask, N values of CV_8U, or empty: all (for the pose); number of
iterations, or -1 */
typedef std::function<Estimate(const Task& task)> Estimator;

//! What a whole estimator can do.
struct EstimatorTraits
{
    explicit EstimatorTraits(const ProblemSet& problems_ = ProblemSet(), bool takesScores_ = false)
        : problems(problems_), takesScores(takesScores_)
    {}

    ProblemSet problems;  //!< for which problems it is run
    bool takesScores;     //!< false: `+scores` behind its name is refused
    std::map<std::string, double>
        fields;  //!< numbers of its own that `{field=value}` sets, and their defaults
};

/** A function that makes a model from points, be it of this module or not. `{field=value}` sets
`threshold`, `confidence`, `maxIterations`, `seed` and the fields of its own. */
class EstimatorMethod : public Method
{
public:
    EstimatorMethod(const MethodName& name, const Estimator& estimator,
                    const EstimatorTraits& traits);

    bool solves(ProblemType problem) const CV_OVERRIDE { return traits.problems.has(problem); }
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    //! Raises std::runtime_error if the estimate has not the form that Estimator tells of.
    void tell(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

private:
    void setFields();

    Estimator estimator;
    EstimatorTraits traits;
    std::string fields;
    bool useScores;
    Task task;
};

/** For registerMethod:

    registerMethod("custom:mine", wholeEstimator([](const Task& task) -> Estimate { ... }));

An empty function raises std::runtime_error. */
MethodFactory wholeEstimator(const Estimator& estimator,
                             const EstimatorTraits& traits = EstimatorTraits());

}  // namespace benchmark

#endif
