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
    std::string letters;  //!< letters of the problems that the scenes can be used for
    ProblemType problem;  //!< argument of makeScene(); unused for views and motions of space
    int pairs;            //!< number of scenes
    opencv_test::SceneOptions images;  //!< image pairs: options of the first scene; the seed of
                                       //!< each further scene is greater by 1
    ViewOptions view;                  //!< the same for views
    SpaceOptions space;                //!< the same for motions of space

    //! isView: the scenes are views of object points; isSpace: they are motions of space; if both
    //! are false, the scenes are image pairs.
    bool isView() const { return letters == "P"; }
    bool isSpace() const { return letters == "R" || letters == "M"; }

    //! Reads the command line. @return false if the command line is empty or asks for help; the
    //! help text has then been printed. Wrong options raise std::runtime_error.
    bool parse(int argc, char** argv);
};

}  // namespace benchmark

#endif
