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

/** Replaces components of an estimator that cv::usacv20::Usac::create has just made:

    usac.components().sampler = cv::makePtr<MySampler>();

It is called for each run, within the measured time. It must make new components each time, since
components keep what they learn of the points. It must always make the same components: the timed
run and the run that makes the report must give the same model. */
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

/** Makes the factory that registerMethod takes:

    registerMethod("custom:mine", withComponents(Params::usacV20(), [](Usac& usac) { ... }));

@param params names the other components and their options. Threshold, confidence, limit of
iterations and seed come from the command line; `scores` are those of the pair if the name has
`+scores`, otherwise none.
@param change must not be empty; otherwise std::runtime_error is raised
@param problems that the components can be used for */
MethodFactory withComponents(const cv::usacv20::Params& params, const ComponentChange& change,
                             const ProblemSet& problems = ProblemSet());

}  // namespace benchmark

#endif
