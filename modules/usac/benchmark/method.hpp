// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_METHOD_HPP

#include <string>
#include <vector>
#include "image_pair.hpp"

namespace benchmark {

//! What all methods are given alike. Defaults: confidence 0.99, the others as the ProblemKind has
//! them; for H, F and E those of the paper.
struct Settings
{
    explicit Settings(ProblemType problem = cv::usacv20::HOMOGRAPHY);

    ProblemType problem;
    double threshold;  //!< pixels; R, M: in the unit of space 2
    double confidence;
    int maxIterations;
    int seed;  //!< of this repeat, for the methods that have one
};

//! What a method found.
struct Estimate
{
    Estimate() : iterations(-1) {}

    cv::Mat model;  //!< empty: none
    cv::Mat mask;
    int iterations;  //!< -1: the method does not tell
};

/** One row of the tables. */
class Method
{
public:
    explicit Method(const std::string& name_) : label(name_) {}
    virtual ~Method() {}

    //! As given on the command line.
    const std::string& name() const { return label; }
    //! False if the method does not know the problem.
    virtual bool solves(ProblemType problem) const = 0;
    //! Sets up the next run; outside of the time measured.
    virtual void prepare(const ImagePair& pair, const Settings& settings) = 0;
    //! The call that is measured.
    virtual void run(const ImagePair& pair, Estimate& estimate) = 0;
    //! Adds what the method tells of its last run; outside of the time measured.
    virtual void tell(const ImagePair&, Estimate&) {}

private:
    std::string label;
};

/** Makes a method from its name:

    USACV20, USACV20_FAST, ...                a flag of this module
    preset:usacV20, preset:ransac, ...        a preset of cv::usacv20::Params
    cv:RANSAC, cv:USAC_MAGSAC, ...            a flag of calib3d
    custom:...                                what the program has registered, see registry.hpp

`+scores` behind a name hands over the scores of the correspondences; `{field=value,...}` behind one
of the first two kinds sets numeric fields of cv::usacv20::Params, behind one of the last what that
method has. An unknown name raises std::runtime_error. */
cv::Ptr<Method> createMethod(const std::string& name);

//! All names that createMethod knows.
std::string knownMethods();

}  // namespace benchmark

#endif
