// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "pair_writer.hpp"

#include "support/scene_geometry.hpp"

namespace benchmark {

using opencv_test::Scene;

namespace {

//! Largest number of true points that are written. More points would make the measurement of errors
//! slower, but hardly more accurate.
const int MAX_TRUE_POINTS = 500;

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
    writeMatrix(out, "R", scene.R);
    writeVector(out, "t", scene.t);
}

}  // namespace

PairWriter::PairWriter(const std::string& folder, const std::string& name,
                       const std::string& letters_)
    : letters(letters_), list(folder, name, letters_)
{}

void PairWriter::write(const Scene& scene)
{
    const std::string pair = list.next();
    writeCorrespondences(pair + ".corr", scene);
    writeTruth(pair + ".json", scene);
}

void PairWriter::writeCorrespondences(const std::string& file, const Scene& scene) const
{
    std::ofstream out(file.c_str());
    for (int i = 0; i < scene.size(); ++i)
        out << cv::format("%.4f %.4f %.4f %.4f %.6g\n", scene.points1[i].x, scene.points1[i].y,
                          scene.points2[i].x, scene.points2[i].y, scene.scores[i]);
    closeFile(out, file);
}

void PairWriter::writeTruth(const std::string& file, const Scene& scene) const
{
    cv::FileStorage out;
    openJson(out, file);
    writeProblems(out, letters);
    for (int image = 1; image <= 2; ++image)
        out << cv::format("size%d", image) << "[:" << (int)opencv_test::SCENE_WIDTH
            << (int)opencv_test::SCENE_HEIGHT << "]";
    writeModel(out, scene);
    out << "gt_kind"
        << "exact"
        << "gt_points"
        << "[";
    for (int i = 0, written = 0; i < scene.size() && written < MAX_TRUE_POINTS; ++i)
        if (scene.truth[i])
        {
            out << "[:" << scene.clean1[i].x << scene.clean1[i].y << scene.clean2[i].x
                << scene.clean2[i].y << "]";
            ++written;
        }
    out << "]";
    writeRightMatches(out, scene.truth);
}

}  // namespace benchmark
