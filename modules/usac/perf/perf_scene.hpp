// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PERF_SCENE_HPP
#define OPENCV_USACV20_PERF_SCENE_HPP

#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/scenes.hpp"

namespace opencv_test {

//! A problem as a parameter of a performance test. It is printed as its name.
struct PerfProblem
{
    ProblemType type;
    const char* name;
};

inline void PrintTo(const PerfProblem& problem, std::ostream* out) { *out << problem.name; }

const PerfProblem PERF_PROBLEMS[] = {
#define USACV20_PROBLEM(TYPE, NAME, PLURAL, ARGUMENTS) {TYPE, #TYPE},
#include "problems/registry.inl.hpp"
};

/** A synthetic scene with 50 % outliers, and an estimator whose components have been started. */
struct PerfScene
{
    PerfScene(ProblemType problem, int size, const Params& params_ = Params())
        : params(params_), usac(problem == ABSOLUTE_POSE ? createPose(size)
                                : isSpace(problem)       ? createSpace(problem, size)
                                                         : createTwoView(problem, size)),
          context(usac->points(), usac->components(), params, arena)
    {
        usac->components().start(context);
    }

    //! True if the i-th point is a true match.
    bool isRight(int i) const { return truth[usac->points().inputIndex[i]] != 0; }

    const Params params;
    std::vector<uchar> truth;  //!< for each row of the input, 1 if it is a true match
    Model model;               //!< the true model, in the coordinates of Usac::points()
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;

private:
    static bool isSpace(ProblemType problem)
    {
        return problem == RIGID_3D || problem == SIMILARITY_3D;
    }

    Ptr<Usac> createTwoView(ProblemType problem, int size)
    {
        SceneOptions options;
        options.setSize(size, 0.5);
        const Scene scene = makeScene(problem, options);
        const Ptr<Usac> created = createUsac(scene, params);
        truth = scene.truth;
        model = problem == ESSENTIAL ? scene.model : toInternal(created->points(), scene.model);
        return created;
    }

    Ptr<Usac> createPose(int size)
    {
        PoseSceneOptions options;
        options.size = size;
        options.inlierRatio = 0.5;
        const PoseScene scene = makePoseScene(options);
        const Ptr<Usac> created = Usac::create(ABSOLUTE_POSE, scene.object, scene.image, params,
                                               scene.K);
        setTruth(*created, scene.truth, scene.pose);
        return created;
    }

    Ptr<Usac> createSpace(ProblemType problem, int size)
    {
        RigidSceneOptions options;
        options.size = size;
        options.inlierRatio = 0.5;
        options.unit = params.threshold / (3.5 * options.noise);
        const RigidScene scene = makeRigidScene(options);
        const Ptr<Usac> created = Usac::create(problem, scene.points1, scene.points2, params);
        setTruth(*created, scene.truth, scene.motion);
        return created;
    }

    void setTruth(const Usac& created, const std::vector<uchar>& mask, const Matx34d& motion)
    {
        const std::vector<double> numbers(motion.val, motion.val + 12);
        truth = mask;
        CV_Assert(created.points().problem->fromOutput(numbers, created.points(), model));
    }

    PerfScene(const PerfScene&);
    PerfScene& operator=(const PerfScene&);
};

}  // namespace opencv_test

#endif
