// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "method_name.hpp"

#include <stdexcept>

namespace benchmark {

namespace {

//! Removes `+scores` from the end of a name or from before `{`. @return whether it was there.
bool cutScores(std::string& name)
{
    const std::string suffix = "+scores";
    const size_t found = name.find(suffix), next = found + suffix.size();
    if (found == std::string::npos || (next < name.size() && name[next] != '{'))
        return false;
    name.erase(found, suffix.size());
    return true;
}

//! Removes `{...}` from the end of a name. @return the text between the braces, empty if there are
//! none.
std::string cutFields(std::string& name)
{
    const size_t open = name.find('{');
    if (open == std::string::npos)
        return std::string();
    if (name[name.size() - 1] != '}')
        throw std::runtime_error(name + ": expected '}' at the end");
    const std::string fields = name.substr(open + 1, name.size() - open - 2);
    name.resize(open);
    return fields;
}

}  // namespace

MethodName::MethodName(const std::string& name) : full(name), base(name)
{
    scores = cutScores(base);
    fields = cutFields(base);
}

}  // namespace benchmark
