// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_COMMAND_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_COMMAND_HPP

#include <string>
#include "image_pair.hpp"
#include "support/scenes.hpp"
#include "space_scene.hpp"
#include "view_scene.hpp"

namespace benchmark {

/** The command line of usac_synthetic. */
struct SceneCommand
{
    std::string folder, name;
    std::string letters;               //!< of the problems that the scenes are for
    ProblemType problem;               //!< of the generator, but for views and motions of space
    int pairs;                         //!< number of scenes
    opencv_test::SceneOptions images;  //!< of the first one; the seeds count up
    ViewOptions view;                  //!< the same for views
    SpaceOptions space;                //!< and for motions of space

    //! Are the scenes views of object points, or motions of space? Else they are pairs of images.
    bool isView() const { return letters == "P"; }
    bool isSpace() const { return letters == "R" || letters == "M"; }

    //! @return false if only help was asked for, which has been printed then. A mistake raises
    //! std::runtime_error.
    bool parse(int argc, char** argv);
};

}  // namespace benchmark

#endif
