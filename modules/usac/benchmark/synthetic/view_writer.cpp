// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "view_writer.hpp"

namespace benchmark {

namespace {

const char LETTER[] = "P";

void writeMatches(const std::string& file, const ViewScene& scene)
{
    std::ofstream out(file.c_str());
    for (int i = 0; i < scene.size(); ++i)
    {
        const cv::Point3d& X = scene.objectPoints[i];
        out << cv::format("%.6f %.6f %.6f %.4f %.4f\n", X.x, X.y, X.z, scene.points[i].x,
                          scene.points[i].y);
    }
    closeFile(out, file);
}

void writeTruth(const std::string& file, const ViewScene& scene)
{
    cv::FileStorage out;
    openJson(out, file);
    writeProblems(out, LETTER);
    out << "size"
        << "[:" << (int)opencv_test::SCENE_WIDTH << (int)opencv_test::SCENE_HEIGHT << "]";
    writeMatrix(out, "K", scene.K);
    if (scene.distortion != 0)
        out << "distCoeffs"
            << "[:" << scene.distortion << 0. << 0. << 0. << "]";
    writeMatrix(out, "R", scene.R);
    writeVector(out, "t", scene.t);
    out << "gt_kind"
        << "exact";
    writeRightMatches(out, scene.truth);
}

}  // namespace

ViewWriter::ViewWriter(const std::string& folder, const std::string& name)
    : list(folder, name, LETTER)
{}

void ViewWriter::write(const ViewScene& scene)
{
    const std::string view = list.next();
    writeMatches(view + ".txt", scene);
    writeScores(view + ".score", scene.scores);
    writeTruth(view + ".json", scene);
}

}  // namespace benchmark
