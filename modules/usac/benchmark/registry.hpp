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

/** Makes a method from its name as given on the command line. `name.base` is the registered name.
The factory interprets `name.scores` and `name.fields` and raises std::runtime_error if the method
does not support them. Method::name() of the new method must be `name.full`.

Two functions return factories: withComponents (components_method.hpp) for an estimator of this
module with user-defined components, and wholeEstimator (estimator_method.hpp) for any function that
makes a model from points. A custom factory is needed for other classes derived from Method, for
example to prepare runs outside of the measured time. */
typedef std::function<cv::Ptr<Method>(const MethodName& name)> MethodFactory;

/** Registers a method, so that createMethod can make it from its name, `--methods` of the program
accepts this name, and `--help` lists it. All methods must be registered before runBenchmark is
called, from a single thread.

@param name "custom:" and letters, digits, '_', '-' or '.'
@param factory makes a new method each time the name is used

An invalid or already registered name or an empty factory raises std::runtime_error. */
void registerMethod(const std::string& name, const MethodFactory& factory);

//! True for names that begin with "custom:", which only registerMethod can define.
bool isCustom(const std::string& name);

//! Makes the method registered as `name.base`. Raises std::runtime_error if no such method is
//! registered, or if its factory returns a null pointer.
cv::Ptr<Method> createCustom(const MethodName& name);

//! All registered names in alphabetical order, separated by commas; empty if there are none.
std::string customMethods();

}  // namespace benchmark

#endif
