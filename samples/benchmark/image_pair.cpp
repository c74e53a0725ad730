// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "image_pair.hpp"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include "json.hpp"

namespace benchmark {

namespace {

const char LETTERS[] = "HFE";  // in the order of cv::usacv20::ProblemType

void fail(const std::string& file, int line, const std::string& what)
{
    std::ostringstream message;
    message << file << ":" << line << ": " << what;
    throw std::runtime_error(message.str());
}

void failToOpen(const std::string& file) { throw std::runtime_error(file + ": cannot be opened"); }

//! Reads up to `count` numbers from a line. @return how many there are, -1 if something else follows them.
int readNumbers(const std::string& line, double* values, int count)
{
    const char* at = line.c_str();
    for (int found = 0;; ++found)
    {
        char* end = 0;
        const double value = std::strtod(at, &end);
        if (end == at || found == count)
            return line.find_first_not_of(" \t\r", at - line.c_str()) == std::string::npos ? found : -1;
        values[found] = value;
        at = end;
    }
}

void readCorrespondences(const std::string& file, ImagePair& pair)
{
    std::ifstream in(file.c_str());
    if (!in)
        failToOpen(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
    {
        if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        double v[5] = {0, 0, 0, 0, 1};
        const int count = readNumbers(line, v, 5);
        if (count != 5 && count != 4)
            fail(file, number, "expected 'x1 y1 x2 y2 score'");
        for (int i = 0; i < 5; ++i)
            if (!std::isfinite(v[i]))
                fail(file, number, "expected finite numbers");
        pair.points1.push_back(cv::Point2f((float)v[0], (float)v[1]));
        pair.points2.push_back(cv::Point2f((float)v[2], (float)v[3]));
        pair.scores.push_back((float)v[4]);
    }
    if (pair.points1.empty())
        fail(file, 1, "no correspondences");
}

cv::Size2d readSize(const Json& json)
{
    const std::vector<Json>& v = json.array();
    if (v.size() != 2 || !(v[0].number() > 0) || !(v[1].number() > 0))
        throw std::runtime_error("expected [width, height] above 0");
    return cv::Size2d(v[0].number(), v[1].number());
}

//! @return false if the matrix is null.
bool readMatrix(const Json& json, cv::Matx33d& matrix)
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

bool readVector(const Json& json, cv::Vec3d& vector)
{
    if (json.isNull())
        return false;
    if (json.array().size() != 3)
        throw std::runtime_error("expected three numbers");
    for (int i = 0; i < 3; ++i)
        vector[i] = json.array()[i].number();
    return true;
}

void readTruePoints(const Json& json, ImagePair& pair)
{
    if (json.isNull())
        return;
    const std::vector<Json>& rows = json.array();
    for (size_t i = 0; i < rows.size(); ++i)
    {
        const std::vector<Json>& v = rows[i].array();
        if (v.size() != 4)
            throw std::runtime_error("expected [x1, y1, x2, y2]");
        pair.truth1.push_back(cv::Point2d(v[0].number(), v[1].number()));
        pair.truth2.push_back(cv::Point2d(v[2].number(), v[3].number()));
    }
}

//! `problem` is a letter or a list of letters.
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

/** Reads the members of a pair's description; what they complain about comes with file, line and name. */
class TruthReader
{
public:
    TruthReader(const Json& json_, const std::string& file_) : json(json_), file(file_) {}

    template <class Reader>
    void read(const std::string& name, Reader reader) const
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

    void require(bool condition, const std::string& name, const std::string& what) const
    {
        if (!condition)
            fail(file, json.type() == Json::OBJECT ? json[name].line() : json.line(), name + ": " + what);
    }

private:
    const Json& json;
    const std::string& file;
};

void readTruth(const TruthReader& in, ProblemType problem, ImagePair& pair)
{
    bool rightProblem = true, hasK1 = false, hasK2 = false, hasR = false, hasT = false;
    in.read("problem", [&](const Json& v) { rightProblem = names(v, letterOf(problem)); });
    in.read("size1", [&](const Json& v) { pair.size1 = readSize(v); });
    in.read("size2", [&](const Json& v) { pair.size2 = readSize(v); });
    in.read("H", [&](const Json& v) { pair.hasHomography = readMatrix(v, pair.H); });
    in.read("K1", [&](const Json& v) { hasK1 = readMatrix(v, pair.K1); });
    in.read("K2", [&](const Json& v) { hasK2 = readMatrix(v, pair.K2); });
    in.read("R", [&](const Json& v) { hasR = readMatrix(v, pair.R); });
    in.read("t", [&](const Json& v) { hasT = readVector(v, pair.t); });
    in.read("gt_points", [&](const Json& v) { readTruePoints(v, pair); });
    in.read("gt_kind", [&](const Json& v) { pair.truthIsHomography = !v.isNull() && v.string() == "homography"; });

    pair.hasCameras = hasK1 && hasK2;
    pair.hasPose = pair.hasCameras && hasR && hasT;
    const bool essential = problem == cv::usacv20::ESSENTIAL;
    in.require(rightProblem, "problem", std::string("the pair is not one for ") + letterOf(problem));
    in.require(hasK1 || !essential, "K1", "needed for E");
    in.require(hasK2 || !essential, "K2", "needed for E");
    in.require(!pair.truth1.empty(), "gt_points", "none, the error cannot be measured");
    in.require(pair.hasHomography || !pair.truthIsHomography, "H", "needed where gt_kind is homography");
}

}  // namespace

char letterOf(ProblemType problem) { return LETTERS[problem]; }

bool problemOf(char letter, ProblemType& problem)
{
    const size_t found = std::string(LETTERS).find(letter);
    if (letter == '\0' || found == std::string::npos)
        return false;
    problem = (ProblemType)found;
    return true;
}

ImagePair readImagePair(const std::string& path, ProblemType problem)
{
    ImagePair pair;
    pair.name = path.substr(path.find_last_of("/\\") + 1);
    readCorrespondences(path + ".corr", pair);

    const std::string file = path + ".json";
    std::ifstream in(file.c_str());
    if (!in)
        failToOpen(file);
    std::ostringstream text;
    text << in.rdbuf();
    const Json json = Json::parse(text.str(), file);
    readTruth(TruthReader(json, file), problem, pair);
    return pair;
}

}  // namespace benchmark
