// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "versions.hpp"
#include <algorithm>
#include <cctype>
#include <vector>
#include "opencv2/core.hpp"

//! The first two or three numbers of a version, which are separated by dots. A suffix (`-dev`) is
//! ignored. Fewer than two numbers raise cv::Exception.
static std::vector<int> numbersOf(const std::string& version)
{
    std::vector<int> numbers;
    size_t i = 0;
    while (i < version.size() && numbers.size() < 3 && std::isdigit((unsigned char)version[i]))
    {
        int number = 0;
        for (; i < version.size() && std::isdigit((unsigned char)version[i]) && number < 10000; ++i)
            number = 10 * number + (version[i] - '0');
        numbers.push_back(number);
        if (i < version.size() && version[i] == '.')
            ++i;
    }
    if (numbers.size() < 2)
        CV_Error_(cv::Error::StsParseError,
                  ("list of differences: %s is no version", version.c_str()));
    return numbers;
}

bool isForVersion(const std::string& condition, const std::string& version)
{
    if (condition.empty())
        return true;
    const bool before = condition[0] == '<';
    if (!before && condition.compare(0, 2, ">=") != 0)
        CV_Error_(
            cv::Error::StsParseError,
            ("list of differences: >=VERSION or <VERSION is expected, not %s", condition.c_str()));
    const std::string limit = condition.substr(before ? 1 : 2);
    if (limit.find_first_not_of("0123456789.") != std::string::npos)
        CV_Error_(cv::Error::StsParseError,
                  ("list of differences: %s is no version", limit.c_str()));
    const std::vector<int> numbers = numbersOf(version), first = numbersOf(limit);
    return before ==
           std::lexicographical_compare(numbers.begin(), numbers.end(), first.begin(), first.end());
}
