// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_COMMAND_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_COMMAND_HPP

#include <string>
#include "image_pair.hpp"
#include "scenes.hpp"
#include "view_scene.hpp"

namespace benchmark {

/** The command line of usac_synthetic. */
struct SceneCommand
{
    std::string folder, name;
    std::string letters;               //!< of the problems that the scenes are for
    ProblemType problem;               //!< of the generator, but for views
    int pairs;                         //!< number of scenes
    opencv_test::SceneOptions images;  //!< of the first one; the seeds count up
    ViewOptions view;                  //!< the same for views

    //! Are the scenes views of object points? Else they are pairs of images.
    bool isView() const { return letters == "P"; }

    //! @return false if only help was asked for, which has been printed then. A mistake raises std::runtime_error.
    bool parse(int argc, char** argv);
};

}  // namespace benchmark

#endif
