// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "registry.hpp"

#include <map>
#include <stdexcept>

namespace benchmark {

namespace {

const std::string& prefix()
{
    static const std::string text = "custom:";
    return text;
}

//! Sorted by name, so that the order does not depend on the order of registration.
std::map<std::string, MethodFactory>& registry()
{
    static std::map<std::string, MethodFactory> methods;
    return methods;
}

//! Commas, braces and '+' are excluded because they have a meaning on the command line.
bool isValid(const std::string& name)
{
    const char* const allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
    return isCustom(name) && name.size() > prefix().size() &&
           name.find_first_not_of(allowed, prefix().size()) == std::string::npos;
}

}  // namespace

void registerMethod(const std::string& name, const MethodFactory& factory)
{
    if (!isValid(name))
        throw std::runtime_error("registerMethod: '" + name +
                                 "': expected custom: and letters, digits, '_', '-' or '.'");
    if (!factory)
        throw std::runtime_error("registerMethod: " + name + ": the factory is empty");
    if (!registry().insert(std::make_pair(name, factory)).second)
        throw std::runtime_error("registerMethod: " + name + " is registered already");
}

bool isCustom(const std::string& name) { return name.compare(0, prefix().size(), prefix()) == 0; }

cv::Ptr<Method> createCustom(const MethodName& name)
{
    const std::map<std::string, MethodFactory>::const_iterator found = registry().find(name.base);
    if (found == registry().end())
        throw std::runtime_error(name.full + ": no such method is registered; " +
                                 (registry().empty() ? "this program registers none"
                                                     : "registered methods: " + customMethods()));
    const cv::Ptr<Method> method = found->second(name);
    if (!method)
        throw std::runtime_error(name.full + ": its factory returned null");
    return method;
}

std::string customMethods()
{
    std::string result;
    for (const std::pair<const std::string, MethodFactory>& method : registry())
        result += (result.empty() ? "" : ", ") + method.first;
    return result;
}

}  // namespace benchmark
