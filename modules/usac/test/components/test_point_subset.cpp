// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "components/point_subset.hpp"

namespace opencv_test {
namespace {

//! DependentPoints must count all inliers of a subset of the points together as one inlier. The
//! expected number of inliers and cost are computed from the errors of
//! the points outside and inside the subset.
TEST(Usac_CountedOnce, asIfOthersWereNotThere)
{
    SceneOptions options;
    options.setSize(200, 0.5);
    const Scene scene = makeScene(HOMOGRAPHY, options);
    const Params params;
    const Ptr<Usac> usac = createUsac(scene, params);
    Arena arena;
    const Context context(usac->points(), usac->components(), params, arena);
    usac->components().start(context);
    const Model model = toInternal(usac->points(), scene.model);
    const Correspondences& p = usac->points();
    std::vector<float> errors(p.size);
    context.components.residual->squaredErrors(p, model, 0, p.size, errors.data());
    const float limit = (float)(p.threshold * p.threshold);
    for (int size = 0; size <= 60; size += 20)
    {
        Quality rest(0, 0), inside(0, 0);
        for (int i = 0; i < p.size; ++i)
        {
            float error = errors[i];
            context.components.score->accumulate(&error, 1, limit, i < size ? inside : rest);
        }
        Arena::Scope scope(arena);
        DependentPoints subset(p, std::max(size, 1), scope);
        for (int i = 0; i < size; ++i)
            subset.add(i);
        Quality quality = context.rate(model);
        subset.countOnce(context, model, quality);
        const bool any = inside.inliers > 0;
        const double gain = any ? (size - inside.cost) / inside.inliers : size - inside.cost;
        EXPECT_EQ(rest.inliers + any, quality.inliers) << size;
        EXPECT_NEAR(rest.cost + size - gain, quality.cost, 1e-3) << size;
    }
}

}  // namespace
}  // namespace opencv_test
