// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "truth_reader.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace benchmark {

namespace {

std::string contentsOf(const std::string& file)
{
    std::ifstream in(file.c_str());
    if (!in)
        failToOpen(file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

//! True if `json` is null, is this letter, or is a list that contains this letter.
bool names(const Json& json, char letter)
{
    if (json.isNull())
        return true;
    if (json.type() == Json::STRING)
        return json.string() == std::string(1, letter);
    for (size_t i = 0; i < json.array().size(); ++i)
        if (json.array()[i].string() == std::string(1, letter))
            return true;
    return false;
}

}  // namespace

void failAt(const std::string& file, int line, const std::string& what)
{
    std::ostringstream message;
    message << file << ":" << line << ": " << what;
    throw std::runtime_error(message.str());
}

void failToOpen(const std::string& file) { throw std::runtime_error(file + ": cannot be opened"); }

int readNumbers(const std::string& line, double* values, int count)
{
    const char* at = line.c_str();
    for (int found = 0;; ++found)
    {
        char* end = 0;
        const double value = std::strtod(at, &end);
        if (end == at || found == count)
            return line.find_first_not_of(" \t\r", at - line.c_str()) == std::string::npos ? found
                                                                                           : -1;
        values[found] = value;
        at = end;
    }
}

void readRows(const std::string& file, int most, const std::function<void(const NumberRow&)>& take)
{
    std::ifstream in(file.c_str());
    if (!in)
        failToOpen(file);
    std::string line;
    NumberRow row;
    for (row.line = 1; std::getline(in, line); ++row.line)
    {
        if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        row.count = readNumbers(line, row.values, most);
        take(row);
        for (int i = 0; i < row.count; ++i)
            if (!std::isfinite(row.values[i]))
                failAt(file, row.line, "expected finite numbers");
    }
}

TruthReader::TruthReader(const std::string& file_)
    : file(file_), json(Json::parse(contentsOf(file_), file_))
{}

void TruthReader::read(const std::string& name,
                       const std::function<void(const Json&)>& reader) const
{
    try
    {
        reader(json[name]);
    }
    catch (const std::runtime_error& error)
    {
        require(false, name, error.what());
    }
}

void TruthReader::require(bool condition, const std::string& name, const std::string& what) const
{
    if (!condition)
        failAt(file, json.type() == Json::OBJECT ? json[name].line() : json.line(),
               name + ": " + what);
}

void TruthReader::requireProblem(char letter) const
{
    bool right = true;
    read("problem", [&](const Json& v) { right = names(v, letter); });
    require(right, "problem", std::string("the pair is not one for ") + letter);
}

cv::Size2d toSize(const Json& json)
{
    const std::vector<Json>& v = json.array();
    if (v.size() != 2 || !(v[0].number() > 0) || !(v[1].number() > 0))
        throw std::runtime_error("expected [width, height] above 0");
    return cv::Size2d(v[0].number(), v[1].number());
}

bool toMatrix(const Json& json, cv::Matx33d& matrix)
{
    if (json.isNull())
        return false;
    if (json.array().size() != 3)
        throw std::runtime_error("expected three rows");
    for (int i = 0; i < 3; ++i)
    {
        const std::vector<Json>& row = json.array()[i].array();
        if (row.size() != 3)
            throw std::runtime_error("expected three columns");
        for (int j = 0; j < 3; ++j)
            matrix(i, j) = row[j].number();
    }
    return true;
}

bool toVector(const Json& json, cv::Vec3d& vector)
{
    if (json.isNull())
        return false;
    if (json.array().size() != 3)
        throw std::runtime_error("expected three numbers");
    for (int i = 0; i < 3; ++i)
        vector[i] = json.array()[i].number();
    return true;
}

}  // namespace benchmark
