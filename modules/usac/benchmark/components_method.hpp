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

/** Puts components of one's own into an estimator that cv::usacv20::Usac::create has just made:

    usac.components().sampler = cv::makePtr<MySampler>();

Called for each run, within the time measured. It makes new components each time, as they keep what
they learned of the points, and the same ones, as the run that is timed and the one that makes the
report must give the same model. */
typedef std::function<void(cv::usacv20::Usac& usac)> ComponentChange;

/** An estimator of this module with components of one's own. `+scores` and `{field=value}` do what
 they do for a * preset. */
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

/** For registerMethod:

    registerMethod("custom:mine", withComponents(Params::usacV20(), [](Usac& usac) { ... }));

@param params names the other components and their options. Threshold, confidence, limit of
iterations and seed are those of the command line; `scores` those of the pair with `+scores`, else
none.
@param change is not empty, or std::runtime_error is raised
@param problems for which the components can be used */
MethodFactory withComponents(const cv::usacv20::Params& params, const ComponentChange& change,
                             const ProblemSet& problems = ProblemSet());

}  // namespace benchmark

#endif
