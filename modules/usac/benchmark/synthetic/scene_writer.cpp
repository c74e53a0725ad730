// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scene_writer.hpp"

#include <stdexcept>
#include "opencv2/core/utils/filesystem.hpp"
#include "support/scene_geometry.hpp"

namespace benchmark {

using opencv_test::Scene;

namespace {

//! Largest number of true points that are written. More points would make the measurement of errors
//! slower, but hardly more accurate.
const int MAX_TRUE_POINTS = 500;

void makeFolder(const std::string& folder)
{
    if (!cv::utils::fs::createDirectories(folder))
        throw std::runtime_error(folder + ": cannot be made");
}

//! Writes a file of `count` lines. @param line returns the text of a line with its end
void writeLines(const std::string& file, int count, const std::function<std::string(int)>& line)
{
    std::ofstream out(file.c_str());
    for (int i = 0; i < count; ++i)
        out << line(i);
    out.close();
    if (!out)
        throw std::runtime_error(file + ": cannot be written");
}

void writeScores(const std::string& file, const std::vector<float>& scores)
{
    writeLines(file, (int)scores.size(), [&](int i) { return cv::format("%.6g\n", scores[i]); });
}

//! Writes the first `rows` rows of a matrix.
void writeMatrix(cv::FileStorage& out, const std::string& name, const cv::Matx33d& matrix,
                 int rows = 3)
{
    out << name << "[";
    for (int i = 0; i < rows; ++i)
        out << "[:" << matrix(i, 0) << matrix(i, 1) << matrix(i, 2) << "]";
    out << "]";
}

void writeMotion(cv::FileStorage& out, const cv::Matx33d& R, const cv::Vec3d& t)
{
    writeMatrix(out, "R", R);
    out << "t"
        << "[:" << t[0] << t[1] << t[2] << "]";
}

void writeSize(cv::FileStorage& out, const std::string& name)
{
    out << name << "[:" << (int)opencv_test::SCENE_WIDTH << (int)opencv_test::SCENE_HEIGHT << "]";
}

//! Writes the true model: for A, S and T the affine map between the images, otherwise the camera
//! matrices and the relative pose, and for H also the homography.
void writeModel(cv::FileStorage& out, const Scene& scene)
{
    if (opencv_test::isAffine(scene.problem))
    {
        writeMatrix(out, "A", scene.model, 2);
        return;
    }
    if (scene.problem == cv::usacv20::HOMOGRAPHY)
        writeMatrix(out, "H", scene.model);
    writeMatrix(out, "K1", scene.K);
    writeMatrix(out, "K2", scene.K);
    writeMotion(out, scene.R, scene.t);
}

void writeTruePoints(cv::FileStorage& out, const Scene& scene)
{
    out << "gt_points"
        << "[";
    for (int i = 0, written = 0; i < scene.size() && written < MAX_TRUE_POINTS; ++i)
        if (scene.truth[i])
        {
            out << "[:" << scene.clean1[i].x << scene.clean1[i].y << scene.clean2[i].x
                << scene.clean2[i].y << "]";
            ++written;
        }
    out << "]";
}

}  // namespace

SceneWriter::SceneWriter(const std::string& folder_, const std::string& name_,
                         const std::string& letters_)
    : folder(folder_), name(name_), letters(letters_), count(0)
{
    makeFolder(folder + "/lists");
    makeFolder(folder + "/pairs/" + name);
    for (char letter : letters)
    {
        const std::string file = folder + "/lists/" + name + "." + letter + ".list";
        lists.push_back(cv::makePtr<std::ofstream>(file.c_str()));
        if (!*lists.back())
            throw std::runtime_error(file + ": cannot be written");
    }
}

std::string SceneWriter::next()
{
    const std::string pair = "pairs/" + name + "/" + cv::format("%04d", count++);
    for (size_t i = 0; i < lists.size(); ++i)
        if (!(*lists[i] << pair << std::endl))
            throw std::runtime_error("the list of " + name + " cannot be written");
    return folder + "/" + pair;
}

void SceneWriter::writeTruth(const std::string& pair, const std::vector<uchar>& truth,
                             const std::function<void(cv::FileStorage&)>& writeMembers) const
{
    cv::FileStorage out(pair + ".json", cv::FileStorage::WRITE | cv::FileStorage::FORMAT_JSON);
    if (!out.isOpened())
        throw std::runtime_error(pair + ".json: cannot be written");
    out << "problem"
        << "[:";
    for (char letter : letters)
        out << std::string(1, letter);
    out << "]"
        << "gt_kind"
        << "exact";
    writeMembers(out);
    out << "gt_mask"
        << "[:";
    for (size_t i = 0; i < truth.size(); ++i)
        if (truth[i])
            out << (int)i;
    out << "]";
}

void SceneWriter::write(const Scene& scene)
{
    const std::string pair = next();
    writeLines(pair + ".corr", scene.size(), [&](int i) {
        return cv::format("%.4f %.4f %.4f %.4f %.6g\n", scene.points1[i].x, scene.points1[i].y,
                          scene.points2[i].x, scene.points2[i].y, scene.scores[i]);
    });
    writeTruth(pair, scene.truth, [&](cv::FileStorage& out) {
        writeSize(out, "size1");
        writeSize(out, "size2");
        writeModel(out, scene);
        writeTruePoints(out, scene);
    });
}

void SceneWriter::write(const ViewScene& scene)
{
    const std::string view = next();
    writeLines(view + ".txt", scene.size(), [&](int i) {
        const cv::Point3d& X = scene.objectPoints[i];
        return cv::format("%.6f %.6f %.6f %.4f %.4f\n", X.x, X.y, X.z, scene.points[i].x,
                          scene.points[i].y);
    });
    writeScores(view + ".score", scene.scores);
    writeTruth(view, scene.truth, [&](cv::FileStorage& out) {
        writeSize(out, "size");
        writeMatrix(out, "K", scene.K);
        if (scene.distortion != 0)
            out << "distCoeffs"
                << "[:" << scene.distortion << 0. << 0. << 0. << "]";
        writeMotion(out, scene.R, scene.t);
    });
}

void SceneWriter::write(const SpaceScene& scene)
{
    const std::string pair = next();
    writeLines(pair + ".txt", scene.size(), [&](int i) {
        const cv::Point3d &X1 = scene.points1[i], &X2 = scene.points2[i];
        return cv::format("%.5f %.5f %.5f %.5f %.5f %.5f\n", X1.x, X1.y, X1.z, X2.x, X2.y, X2.z);
    });
    writeScores(pair + ".score", scene.scores);
    writeTruth(pair, scene.truth, [&](cv::FileStorage& out) {
        out << "s" << scene.scale;
        writeMotion(out, scene.R, scene.t);
    });
}

}  // namespace benchmark
