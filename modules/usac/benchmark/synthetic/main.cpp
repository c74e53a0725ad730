// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Writes synthetic scenes with exact ground truth as data for usac_benchmark. Image pairs come from
// the scene generator of the module's tests.
//
//     usac_synthetic --out=<folder> --scene=plane --planeFraction=0.9 --pairs=20 --size=2000
//     --inliers=0.3
//     usac_benchmark --data=<folder>

#include "program.hpp"
#include "scene_command.hpp"
#include "scene_writer.hpp"

using namespace benchmark;

namespace {

//! Writes `count` scenes. @param options options of the first scene; the seed of each further scene
//! is greater by 1
template <class Options, class Make>
void writeAll(SceneWriter& writer, int count, Options options, const Make& make)
{
    for (int i = 0; i < count; ++i, ++options.seed)
        writer.write(make(options));
}

int run(int argc, char** argv)
{
    SceneCommand command;
    if (!command.parse(argc, argv))
        return 0;
    SceneWriter writer(command.folder, command.name, command.letters);
    if (command.isView())
        writeAll(writer, command.pairs, command.view, makeViewScene);
    else if (command.isSpace())
        writeAll(writer, command.pairs, command.space, makeSpaceScene);
    else
        writeAll(writer, command.pairs, command.images,
                 [&](const opencv_test::SceneOptions& options) {
                     return opencv_test::makeScene(command.problem, options);
                 });
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(run, argc, argv); }
