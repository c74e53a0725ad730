// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_REGISTRY_HPP
#define OPENCV_USACV20_BENCHMARK_REGISTRY_HPP

#include <functional>
#include <string>
#include "method.hpp"
#include "method_name.hpp"

namespace benchmark {

/** Makes a method from its name as given on the command line: `name.base` is the registered one,
`name.scores` and `name.fields` are up to the factory, which raises std::runtime_error for what the
method cannot do. The method is to be called `name.full`.

There are two ready ones: withComponents (components_method.hpp) for an estimator of this module
with components of one's own, and wholeEstimator (estimator_method.hpp) for any function that makes
a model from points. One's own is for a class derived from Method, which can prepare its runs
outside of the time measured. */
typedef std::function<cv::Ptr<Method>(const MethodName& name)> MethodFactory;

/** Makes a method known to createMethod, and so to `--methods` and `--help` of the program. To be
called before runBenchmark, from one thread.

@param name "custom:" and letters, digits, '_', '-' or '.'
@param factory makes the method each time that it is named

Another name, one that is registered already, or an empty factory raises std::runtime_error. */
void registerMethod(const std::string& name, const MethodFactory& factory);

//! True for the names that only registerMethod can make known, those that begin with "custom:".
bool isCustom(const std::string& name);

//! Makes the method registered as `name.base`. There being none raises std::runtime_error.
cv::Ptr<Method> createCustom(const MethodName& name);

//! All names registered, in alphabetical order, with commas; empty: none.
std::string customMethods();

}  // namespace benchmark

#endif
