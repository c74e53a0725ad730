// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Writes synthetic scenes with exact ground truth as data for usac_benchmark. Image pairs come from
// the scene generator of the module's tests.
//
//     usac_synthetic --out=<folder> --scene=plane --planeFraction=0.9 --pairs=20 --size=2000
//     --inliers=0.3
//     usac_benchmark --data=<folder>

#include "pair_writer.hpp"
#include "program.hpp"
#include "scene_command.hpp"
#include "space_writer.hpp"
#include "view_writer.hpp"

using namespace benchmark;

namespace {

void writePairs(SceneCommand& command)
{
    PairWriter writer(command.folder, command.name, command.letters);
    for (int i = 0; i < command.pairs; ++i, ++command.images.seed)
        writer.write(opencv_test::makeScene(command.problem, command.images));
}

void writeViews(SceneCommand& command)
{
    ViewWriter writer(command.folder, command.name);
    for (int i = 0; i < command.pairs; ++i, ++command.view.seed)
        writer.write(makeViewScene(command.view));
}

void writeSpaces(SceneCommand& command)
{
    SpaceWriter writer(command.folder, command.name, command.letters);
    for (int i = 0; i < command.pairs; ++i, ++command.space.seed)
        writer.write(makeSpaceScene(command.space));
}

int run(int argc, char** argv)
{
    SceneCommand command;
    if (!command.parse(argc, argv))
        return 0;
    if (command.isView())
        writeViews(command);
    else if (command.isSpace())
        writeSpaces(command);
    else
        writePairs(command);
    return 0;
}

}  // namespace

int main(int argc, char** argv) { return runProgram(run, argc, argv); }
