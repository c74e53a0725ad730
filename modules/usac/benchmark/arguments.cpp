// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arguments.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace benchmark {

namespace {

bool isDeclared(const cv::CommandLineParser& parser, const std::string& name)
{
    try
    {
        parser.has(name);
        return true;
    }
    catch (const cv::Exception&)
    {
        return false;
    }
}

bool isHelp(const std::string& name)
{
    return name == "help" || name == "h" || name == "usage" || name == "?";
}

template <class Number>
Number convert(const std::string& text, const std::string& name, const char* expected)
{
    std::istringstream in(text);
    Number value = 0;
    if (!(in >> value) || in.peek() != std::istringstream::traits_type::eof())
        throw std::runtime_error("--" + name + ": expected " + expected + ", not '" + text + "'");
    return value;
}

}  // namespace

std::vector<std::string> splitNames(const std::string& names)
{
    std::vector<std::string> result(1);
    int depth = 0;
    for (size_t i = 0; i < names.size(); ++i)
    {
        depth += (names[i] == '{') - (names[i] == '}');
        if (names[i] == ',' && depth == 0)
            result.push_back(std::string());
        else
            result.back() += names[i];
    }
    for (size_t i = result.size(); i-- > 0;)
        if (result[i].empty())
            result.erase(result.begin() + i);
    return result;
}

void require(bool condition, const std::string& what)
{
    if (!condition)
        throw std::runtime_error(what);
}

double toNumber(const std::string& text, const std::string& name)
{
    return convert<double>(text, name, "a number");
}

int toInteger(const std::string& text, const std::string& name)
{
    return convert<int>(text, name, "an integer");
}

double numberOf(const cv::CommandLineParser& parser, const std::string& name)
{
    return toNumber(parser.get<cv::String>(name), name);
}

int integerOf(const cv::CommandLineParser& parser, const std::string& name)
{
    return toInteger(parser.get<cv::String>(name), name);
}

Arguments::Arguments(int argc, char** argv, const cv::CommandLineParser& parser)
{
    for (int i = 1; i < argc; ++i)
    {
        const std::string argument = argv[i];
        const size_t begin = argument.find_first_not_of('-'), equals = argument.find('=');
        if (begin == 0 || begin == std::string::npos)
            throw std::runtime_error("'" + argument + "': expected --option=value (see --help)");
        const std::string name = argument.substr(begin, equals - begin);
        if (!isDeclared(parser, name))
            throw std::runtime_error("'" + argument + "': unknown option (see --help)");
        if (equals == std::string::npos && !isHelp(name))
            throw std::runtime_error("'" + argument + "': expected --" + name + "=value");
        names.push_back(name);
        values.push_back(equals == std::string::npos ? std::string() : argument.substr(equals + 1));
    }
}

std::vector<std::string> Arguments::all(const std::string& name) const
{
    std::vector<std::string> result;
    for (size_t i = 0; i < names.size(); ++i)
    {
        if (names[i] != name)
            continue;
        const std::vector<std::string> more = splitNames(values[i]);
        result.insert(result.end(), more.begin(), more.end());
    }
    return result;
}

bool Arguments::given(const std::string& name) const
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> namesOf(const cv::CommandLineParser& parser, const Arguments& arguments,
                                 const std::string& option, const std::string& fallback)
{
    std::vector<std::string> names = arguments.all(option);
    if (!arguments.given(option))
        names = splitNames(fallback.empty() ? std::string(parser.get<cv::String>(option))
                                            : fallback);
    require(!names.empty(), "--" + option + ": nothing given");
    return names;
}

}  // namespace benchmark
