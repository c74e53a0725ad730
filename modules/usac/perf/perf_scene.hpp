// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PERF_SCENE_HPP
#define OPENCV_USACV20_PERF_SCENE_HPP

#include "scenes.hpp"

namespace opencv_test {

/** A synthetic scene in which half of the matches are wrong, as the components see it. */
struct PerfScene
{
    PerfScene(ProblemType problem, int size, const Params& params_ = Params())
        : params(params_), scene(makeScene(problem, optionsOf(size))), usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena),
          model(problem == ESSENTIAL ? scene.model : toInternal(usac->points(), scene.model))
    {
        usac->components().start(context);
    }

    //! The i-th point is a right match.
    bool isRight(int i) const { return scene.truth[usac->points().inputIndex[i]] != 0; }

    const Params params;
    const Scene scene;
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;
    const Model model;  //!< the true one, in the coordinates of the components

private:
    static SceneOptions optionsOf(int size)
    {
        SceneOptions options;
        options.setSize(size, 0.5);
        return options;
    }

    PerfScene(const PerfScene&);
    PerfScene& operator=(const PerfScene&);
};

}  // namespace opencv_test

#endif
