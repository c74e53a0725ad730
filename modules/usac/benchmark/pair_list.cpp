// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pair_list.hpp"

#include <fstream>
#include <stdexcept>
#include "problems/problem_kind.hpp"

namespace benchmark {

namespace {

//! The folder of a path: "a/b/c.d" gives "a/b", "c.d" gives ".".
std::string folderOf(const std::string& path)
{
    const size_t slash = path.find_last_of("/\\");
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

std::string lastPart(const std::string& path) { return path.substr(path.find_last_of("/\\") + 1); }

//! Splits "homogr.H.list" into "homogr" and 'H'. `letter` is set to '\0' if the name has no letter
//! of a problem.
std::string splitName(const std::string& file, char& letter)
{
    std::string name = lastPart(file);
    const std::string ending = ".list";
    letter = '\0';
    if (name.size() > ending.size() &&
        name.compare(name.size() - ending.size(), ending.size(), ending) == 0)
        name.resize(name.size() - ending.size());
    ProblemType problem;
    if (name.size() > 2 && name[name.size() - 2] == '.' &&
        problemOf(name[name.size() - 1], problem))
    {
        letter = name[name.size() - 1];
        name.resize(name.size() - 2);
    }
    return name;
}

}  // namespace

PairList readPairList(const std::string& file, char letter)
{
    PairList list;
    char letterOfName;
    list.file = file;
    list.name = splitName(file, letterOfName);
    if (!problemOf(letter ? letter : letterOfName, list.problem))
        throw std::runtime_error(file + ": neither the name (.H.list, .F.list and so on) nor "
                                        "--problem says which problem it is");

    std::ifstream in(file.c_str());
    if (!in)
        throw std::runtime_error(file + ": cannot be opened");
    std::string base = folderOf(file);
    if (lastPart(base) == "lists")
        base = folderOf(base);

    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
    {
        const size_t begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos || line[begin] == '#')
            continue;
        PairList::Entry entry;
        entry.path = line.substr(begin, line.find_last_not_of(" \t\r") - begin + 1);
        entry.line = number;
        if (entry.path[0] != '/' && entry.path.find(':') == std::string::npos)
            entry.path = base + "/" + entry.path;
        list.entries.push_back(entry);
    }
    return list;
}

std::vector<std::string> findLists(const std::string& folder, char letter)
{
    std::vector<std::string> result;
    const std::string letters = letter ? std::string(1, letter) : problemLetters();
    for (size_t i = 0; i < letters.size(); ++i)
    {
        std::vector<cv::String> files;
        cv::glob(folder + "/lists/*." + letters[i] + ".list", files, false);
        result.insert(result.end(), files.begin(), files.end());
    }
    return result;
}

}  // namespace benchmark
