// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "outcomes.hpp"
#include <fstream>
#include <iostream>
#include <sstream>
#include "exchange.hpp"
#include "versions.hpp"

static const struct
{
    const char* name;
    cv::UsacV20Method method;
} FLAGS[] = {{"USACV20", cv::USACV20},
             {"USACV20_FAST", cv::USACV20_FAST},
             {"USACV20_ACCURATE", cv::USACV20_ACCURATE},
             {"USACV20_PROSAC", cv::USACV20_PROSAC},
             {"USACV20_MAGSAC", cv::USACV20_MAGSAC},
             {"USACV20_PARALLEL", cv::USACV20_PARALLEL},
             {"USACV20_AUTO", cv::USACV20_AUTO}};

static std::string nameOf(const testing::TestInfo& test)
{
    return std::string(test.test_case_name()) + "." + test.name();
}

//! Splits a list of flags separated by commas; `*` means all flags. An unknown flag raises
//! cv::Exception.
static std::vector<std::string> flagsOf(const std::string& list)
{
    std::set<std::string> all;
    for (int i = 0; i < Outcomes::flags(); ++i)
        all.insert(FLAGS[i].name);
    if (list == "*")
        return std::vector<std::string>(all.begin(), all.end());
    std::vector<std::string> result;
    std::istringstream names(list);
    for (std::string name; std::getline(names, name, ','); result.push_back(name))
        if (!all.count(name))
            CV_Error_(cv::Error::StsParseError,
                      ("list of differences: %s is no flag", name.c_str()));
    return result;
}

int Outcomes::flags() { return sizeof(FLAGS) / sizeof(FLAGS[0]); }

Outcomes::Outcomes(const std::string& listOfDifferences) : passed(0), failed(0)
{
    std::ifstream file(listOfDifferences.c_str());
    CV_Assert(file.is_open());
    for (std::string line, more; std::getline(file, line);)
    {
        for (; file.peek() == ' '; line += ' ' + more)
            std::getline(file >> std::ws, more);
        std::istringstream words(line);
        std::string kind, where, test, reason;
        if (!(words >> kind) || kind[0] == '#')
            continue;
        words >> where >> test >> std::ws;
        std::getline(words, reason);
        const size_t end = std::min(kind.find_first_of("<>="), kind.size());
        const std::string version = kind.substr(end);
        kind.resize(end);
        if ((kind != "fails" && kind != "data") || reason.empty())
            CV_Error_(cv::Error::StsParseError,
                      ("%s: cannot read the line: %s", listOfDifferences.c_str(), line.c_str()));
        const std::vector<std::string> names = kind == "fails" ? flagsOf(where)
                                                               : std::vector<std::string>();
        if (!isForVersion(version, CV_VERSION))
            continue;
        if (kind == "data")
            data[Pair(where, test)] = reason;
        for (const std::string& name : names)
            fails[Pair(name, test)] = reason;
    }
}

std::string Outcomes::reason(const std::string& name, const std::string& test) const
{
    const std::map<Pair, std::string>::const_iterator listed = fails.find(Pair(name, test));
    return listed == fails.end() ? std::string() : listed->second;
}

std::vector<std::string> Outcomes::missingTests() const
{
    std::set<std::string> names;
    for (const std::map<Pair, std::string>* list : {&fails, &data})
        for (const std::pair<const Pair, std::string>& line : *list)
            names.insert(line.first.second);
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_case_count(); ++i)
        for (int j = 0; j < all.GetTestCase(i)->total_test_count(); ++j)
            names.erase(nameOf(*all.GetTestCase(i)->GetTestInfo(j)));
    return std::vector<std::string>(names.begin(), names.end());
}

std::string Outcomes::withoutData()
{
    std::string pattern;
    for (std::map<Pair, std::string>::const_iterator i = data.begin(); i != data.end(); ++i)
        if (!std::ifstream((cvtest::TS::ptr()->get_data_path() + i->first.first).c_str()).is_open())
        {
            pattern += (pattern.empty() ? "" : ":") + i->first.second;
            expected += "skipped: " + i->first.second + ": " + i->second + "\n";
        }
    return pattern;
}

void Outcomes::OnTestProgramStart(const testing::UnitTest&)
{
    for (const std::string& name : missingTests())
    {
        ++failed;
        unexpected += "on the list, but not among the tests of OpenCV " CV_VERSION ": " + name +
                      "\n";
    }
}

void Outcomes::OnTestIterationStart(const testing::UnitTest&, int iteration)
{
    flag = FLAGS[iteration].name;
    cv::Exchange::flag = FLAGS[iteration].method;
    std::cout << "== " << flag << std::endl;
}

void Outcomes::OnTestStart(const testing::TestInfo&) { cv::Exchange::calls = 0; }

void Outcomes::OnTestEnd(const testing::TestInfo& test)
{
    const std::string name = nameOf(test);
    const std::string why = reason(flag, name);
    const bool fine = test.result()->Passed(), onList = !why.empty();
    if (cv::Exchange::calls == 0 && name.compare(0, 17, "Usac_Differences.") != 0)
        notOurs.insert(name);
    else if (fine && !onList)
        ++passed;
    else if (!fine && onList)
        expected += "expected: " + name + " fails with " + flag + ": " + why + "\n";
    else
    {
        ++failed;
        unexpected += (fine ? "on the list, but passes: " : "FAILED: ") + name + " with " + flag +
                      "\n";
    }
}

void Outcomes::OnTestProgramEnd(const testing::UnitTest&)
{
    for (std::set<std::string>::const_iterator i = notOurs.begin(); i != notOurs.end(); ++i)
        std::cout << "not counted, calls no function of this module: " << *i << "\n";
    std::cout << expected << unexpected << passed << " passed, " << failed << " failed"
              << std::endl;
}
