// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_METHOD_HPP

#include <string>
#include <vector>
#include "image_pair.hpp"

namespace benchmark {

//! Settings that all methods get. Defaults: confidence 0.99, seed 1; threshold and maxIterations of
//! the ProblemKind, which for H, F and E are those of the USACv20 paper.
struct Settings
{
    explicit Settings(ProblemType problem = cv::usacv20::HOMOGRAPHY);

    ProblemType problem;
    double threshold;  //!< pixels; R, M: in the unit of space 2
    double confidence;
    int maxIterations;
    int seed;  //!< for randomized methods; each repeat has its own seed
};

//! The result of a method.
struct Estimate
{
    Estimate() : iterations(-1) {}

    cv::Mat model;  //!< empty: no model
    cv::Mat mask;
    int iterations;  //!< -1: not reported
};

/** An estimation method; one row of the tables. */
class Method
{
public:
    explicit Method(const std::string& name_) : label(name_) {}
    virtual ~Method() {}

    //! The method's name as given on the command line.
    const std::string& name() const { return label; }
    //! @return false if the method cannot solve the problem.
    virtual bool solves(ProblemType problem) const = 0;
    //! Sets up the next run; not included in the measured time.
    virtual void prepare(const ImagePair& pair, const Settings& settings) = 0;
    //! The call whose time is measured.
    virtual void run(const ImagePair& pair, Estimate& estimate) = 0;
    //! Adds to the estimate of the last run what the method reports about this run, such as the
    //! number of iterations; not included in the measured time.
    virtual void tell(const ImagePair&, Estimate&) {}

private:
    std::string label;
};

/** Makes a method from its name:

    USACV20, USACV20_FAST, ...                a flag of this module
    preset:usacV20, preset:ransac, ...        a preset of cv::usacv20::Params
    cv:RANSAC, cv:USAC_MAGSAC, ...            a flag of calib3d
    custom:...                                a method that the program registered, see registry.hpp

`+scores` after a name passes the scores of the correspondences to the method; among the flags of
calib3d only cv:USAC_PROSAC allows this. `{field=value,...}` after a name of the first two kinds
sets numeric fields of cv::usacv20::Params; after a custom name, options of that method.
An unknown name raises std::runtime_error. */
cv::Ptr<Method> createMethod(const std::string& name);

//! All names that createMethod accepts, separated by commas.
std::string knownMethods();

}  // namespace benchmark

#endif
