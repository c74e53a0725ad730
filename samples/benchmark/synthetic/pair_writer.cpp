// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pair_writer.hpp"

#include <stdexcept>
#include "opencv2/core/utils/filesystem.hpp"

namespace benchmark {

using opencv_test::Scene;

namespace {

//! More known points than this make the measurement of an error slower, not better.
const int MAX_TRUE_POINTS = 500;

void makeFolder(const std::string& folder)
{
    if (!cv::utils::fs::createDirectories(folder))
        throw std::runtime_error(folder + ": cannot be made");
}

void close(std::ofstream& out, const std::string& file)
{
    out.close();
    if (!out)
        throw std::runtime_error(file + ": cannot be written");
}

void writeMatrix(cv::FileStorage& out, const std::string& name, const cv::Matx33d& matrix)
{
    out << name << "[";
    for (int i = 0; i < 3; ++i)
        out << "[:" << matrix(i, 0) << matrix(i, 1) << matrix(i, 2) << "]";
    out << "]";
}

}  // namespace

PairWriter::PairWriter(const std::string& folder_, const std::string& name_, const std::string& letters_)
    : folder(folder_), name(name_), letters(letters_), count(0)
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

void PairWriter::write(const Scene& scene)
{
    const std::string pair = "pairs/" + name + "/" + cv::format("%04d", count++);
    writeCorrespondences(folder + "/" + pair + ".corr", scene);
    writeTruth(folder + "/" + pair + ".json", scene);
    for (size_t i = 0; i < lists.size(); ++i)
        if (!(*lists[i] << pair << std::endl))
            throw std::runtime_error("the list of " + name + " cannot be written");
}

void PairWriter::writeCorrespondences(const std::string& file, const Scene& scene) const
{
    std::ofstream out(file.c_str());
    for (int i = 0; i < scene.size(); ++i)
        out << cv::format("%.4f %.4f %.4f %.4f %.6g\n", scene.points1[i].x, scene.points1[i].y, scene.points2[i].x,
                          scene.points2[i].y, scene.scores[i]);
    close(out, file);
}

void PairWriter::writeTruth(const std::string& file, const Scene& scene) const
{
    cv::FileStorage out(file, cv::FileStorage::WRITE | cv::FileStorage::FORMAT_JSON);
    if (!out.isOpened())
        throw std::runtime_error(file + ": cannot be written");
    out << "problem"
        << "[:";
    for (size_t i = 0; i < letters.size(); ++i)
        out << std::string(1, letters[i]);
    out << "]";
    for (int image = 1; image <= 2; ++image)
        out << cv::format("size%d", image) << "[:" << (int)opencv_test::SCENE_WIDTH << (int)opencv_test::SCENE_HEIGHT
            << "]";
    if (scene.problem == cv::usacv20::HOMOGRAPHY)
        writeMatrix(out, "H", scene.model);
    writeMatrix(out, "K1", scene.K);
    writeMatrix(out, "K2", scene.K);
    writeMatrix(out, "R", scene.R);
    out << "t"
        << "[:" << scene.t[0] << scene.t[1] << scene.t[2] << "]"
        << "gt_kind"
        << "exact"
        << "gt_points"
        << "[";
    for (int i = 0, written = 0; i < scene.size() && written < MAX_TRUE_POINTS; ++i)
        if (scene.truth[i])
        {
            out << "[:" << scene.clean1[i].x << scene.clean1[i].y << scene.clean2[i].x << scene.clean2[i].y << "]";
            ++written;
        }
    out << "]"
        << "gt_mask"
        << "[:";
    for (int i = 0; i < scene.size(); ++i)
        if (scene.truth[i])
            out << i;
    out << "]";
}

}  // namespace benchmark
