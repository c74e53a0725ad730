// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "list_writer.hpp"

#include <stdexcept>
#include "opencv2/core/utils/filesystem.hpp"

namespace benchmark {

namespace {

void makeFolder(const std::string& folder)
{
    if (!cv::utils::fs::createDirectories(folder))
        throw std::runtime_error(folder + ": cannot be made");
}

}  // namespace

ListWriter::ListWriter(const std::string& folder_, const std::string& name_,
                       const std::string& letters)
    : folder(folder_), name(name_), count(0)
{
    makeFolder(folder + "/lists");
    makeFolder(folder + "/pairs/" + name);
    for (size_t i = 0; i < letters.size(); ++i)
    {
        const std::string file = folder + "/lists/" + name + "." + letters[i] + ".list";
        lists.push_back(cv::makePtr<std::ofstream>(file.c_str()));
        if (!*lists[i])
            throw std::runtime_error(file + ": cannot be written");
    }
}

std::string ListWriter::next()
{
    const std::string pair = "pairs/" + name + "/" + cv::format("%04d", count++);
    for (size_t i = 0; i < lists.size(); ++i)
        if (!(*lists[i] << pair << std::endl))
            throw std::runtime_error("the list of " + name + " cannot be written");
    return folder + "/" + pair;
}

void closeFile(std::ofstream& out, const std::string& file)
{
    out.close();
    if (!out)
        throw std::runtime_error(file + ": cannot be written");
}

void writeScores(const std::string& file, const std::vector<float>& scores)
{
    std::ofstream out(file.c_str());
    for (float score : scores)
        out << cv::format("%.6g\n", score);
    closeFile(out, file);
}

void openJson(cv::FileStorage& out, const std::string& file)
{
    out.open(file, cv::FileStorage::WRITE | cv::FileStorage::FORMAT_JSON);
    if (!out.isOpened())
        throw std::runtime_error(file + ": cannot be written");
}

void writeMatrix(cv::FileStorage& out, const std::string& name, const cv::Matx33d& matrix, int rows)
{
    out << name << "[";
    for (int i = 0; i < rows; ++i)
        out << "[:" << matrix(i, 0) << matrix(i, 1) << matrix(i, 2) << "]";
    out << "]";
}

void writeVector(cv::FileStorage& out, const std::string& name, const cv::Vec3d& vector)
{
    out << name << "[:" << vector[0] << vector[1] << vector[2] << "]";
}

void writeProblems(cv::FileStorage& out, const std::string& letters)
{
    out << "problem"
        << "[:";
    for (char letter : letters)
        out << std::string(1, letter);
    out << "]";
}

void writeRightMatches(cv::FileStorage& out, const std::vector<uchar>& truth)
{
    out << "gt_mask"
        << "[:";
    for (size_t i = 0; i < truth.size(); ++i)
        if (truth[i])
            out << (int)i;
    out << "]";
}

}  // namespace benchmark
