// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_WRITER_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_WRITER_HPP

#include <fstream>
#include <functional>
#include <string>
#include <vector>
#include "opencv2/core.hpp"
#include "support/scenes.hpp"
#include "space_scene.hpp"
#include "view_scene.hpp"

namespace benchmark {

/** Writes scenes as data for usac_benchmark.

For each letter, `<folder>/lists/<name>.<letter>.list` names the pairs, whose files are
`<folder>/pairs/<name>/<number>` with an extension. Existing files of these names are replaced. A
file or folder that cannot be written raises std::runtime_error. */
class SceneWriter
{
public:
    //! Makes the folders and lists. @param letters letters of the problems that the scenes can be
    //! used for
    SceneWriter(const std::string& folder, const std::string& name, const std::string& letters);

    void write(const opencv_test::Scene& scene);
    void write(const ViewScene& scene);
    void write(const SpaceScene& scene);

private:
    //! Adds the next pair to all lists. @return its path without extension
    std::string next();
    //! Writes the description of a pair; `writeMembers` writes those about the true model.
    void writeTruth(const std::string& pair, const std::vector<uchar>& truth,
                    const std::function<void(cv::FileStorage&)>& writeMembers) const;

    const std::string folder, name, letters;
    std::vector<cv::Ptr<std::ofstream>> lists;  //!< one for each letter
    int count;                                  //!< number of pairs so far
};

}  // namespace benchmark

#endif
