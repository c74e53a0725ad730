// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_COMPONENTS_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_COMPONENTS_METHOD_HPP

#include <functional>
#include "module_method.hpp"
#include "problem_set.hpp"
#include "registry.hpp"

namespace benchmark {

/** A function that replaces components of an estimator that cv::usacv20::Usac::create has just
made:

    usac.components().sampler = cv::makePtr<MySampler>();

The function is called for each run, within the measured time. It must make new components each
time, since components keep data about the points. The components must be deterministic: after the
timed run, a second run with the same seed makes the report, and must give the same model. */
typedef std::function<void(cv::usacv20::Usac& usac)> ComponentChange;

/** An estimator of this module with user-defined components. `+scores` and `{field=value}` in the
 method's name act as they do for a preset. */
class ComponentsMethod : public ModuleMethod
{
public:
    ComponentsMethod(const MethodName& name, const cv::usacv20::Params& params,
                     const ComponentChange& change, const ProblemSet& problems);

    bool solves(ProblemType which) const CV_OVERRIDE { return problems.has(which); }
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;
    cv::Ptr<cv::usacv20::Usac> estimator(const ImagePair& pair) const CV_OVERRIDE;

private:
    ComponentChange change;
    ProblemSet problems;
};

/** Makes a factory for registerMethod:

    registerMethod("custom:mine", withComponents(Params::usacV20(), [](Usac& usac) { ... }));

@param params selects the other components and their options. Its threshold, confidence, limit of
iterations and seed are replaced by those of the command line. Its scores are replaced by those of
the pair if the method's name has `+scores`; otherwise they are removed.
@param change the function that replaces components; std::runtime_error is raised if it is empty
@param problems the problems that the components can be used for */
MethodFactory withComponents(const cv::usacv20::Params& params, const ComponentChange& change,
                             const ProblemSet& problems = ProblemSet());

}  // namespace benchmark

#endif
