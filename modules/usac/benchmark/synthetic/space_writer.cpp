// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "space_writer.hpp"

namespace benchmark {

SpaceWriter::SpaceWriter(const std::string& folder, const std::string& name,
                         const std::string& letter_)
    : letter(letter_), list(folder, name, letter_)
{}

void SpaceWriter::write(const SpaceScene& scene)
{
    const std::string pair = list.next(), file = pair + ".txt";
    std::ofstream out(file.c_str());
    for (int i = 0; i < scene.size(); ++i)
    {
        const cv::Point3d &X1 = scene.points1[i], &X2 = scene.points2[i];
        out << cv::format("%.5f %.5f %.5f %.5f %.5f %.5f\n", X1.x, X1.y, X1.z, X2.x, X2.y, X2.z);
    }
    closeFile(out, file);
    writeScores(pair + ".score", scene.scores);
    writeTruth(pair + ".json", scene);
}

void SpaceWriter::writeTruth(const std::string& file, const SpaceScene& scene) const
{
    cv::FileStorage out;
    openJson(out, file);
    writeProblems(out, letter);
    out << "s" << scene.scale;
    writeMatrix(out, "R", scene.R);
    writeVector(out, "t", scene.t);
    out << "gt_kind"
        << "exact";
    writeRightMatches(out, scene.truth);
}

}  // namespace benchmark
