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

/** The options of usac_synthetic's command line. */
struct SceneCommand
{
    std::string folder, name;
    std::string letters;               //!< letters of the problems that the scenes can be used for
    ProblemType problem;               //!< for makeScene(); unused for views and motions of space
    int pairs;                         //!< number of scenes
    opencv_test::SceneOptions images;  //!< options of the first scene; seeds increase by 1
    ViewOptions view;                  //!< as `images`, for views
    SpaceOptions space;                //!< as `images`, for motions of space

    //! isView: the scenes are views of object points; isSpace: motions of space; neither: image
    //! pairs
    bool isView() const { return letters == "P"; }
    bool isSpace() const { return letters == "R" || letters == "M"; }

    //! @return false if the command line only asks for help, which has then been printed. Wrong
    //! options raise std::runtime_error.
    bool parse(int argc, char** argv);
};

}  // namespace benchmark

#endif
