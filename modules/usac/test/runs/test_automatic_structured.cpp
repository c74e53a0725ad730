// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

// In scenes with a plane or a second motion, a search with an estimated threshold must miss the
// true model at most once more in 20 runs than a search with a given threshold. The rates are in
// doc/structured.md.

namespace opencv_test {
namespace {

struct AutomaticScene
{
    const char* name;
    ProblemType problem;
    int size;
    double ratio, plane;
    OutlierModel wrong;
    int second;  //!< number of matches of the second motion or structure
};

const AutomaticScene AUTOMATIC_SCENES[] = {
    {"plane of few matches", FUNDAMENTAL, 30, 0.7, 0.8, OUTLIERS_UNIFORM, 0},
    {"plane", FUNDAMENTAL, 400, 0.45, 0.95, OUTLIERS_UNIFORM, 0},
    {"H, second motion", HOMOGRAPHY, 190, 100 / 190., 0, OUTLIERS_SECOND_MODEL, 90},
    {"F, second motion", FUNDAMENTAL, 190, 100 / 190., 0, OUTLIERS_SECOND_MODEL, 90},
    {"E, second motion", ESSENTIAL, 190, 100 / 190., 0, OUTLIERS_SECOND_MODEL, 90},
    {"F, shift", FUNDAMENTAL, 100, 0.45, 0, OUTLIERS_SHIFT, 35},
    {"E, shift", ESSENTIAL, 30, 0.45, 0, OUTLIERS_SHIFT, 10},
    {"F, moving plane", FUNDAMENTAL, 100, 0.45, 0, OUTLIERS_PLANE, 35}};

std::ostream& operator<<(std::ostream& out, const AutomaticScene& scene)
{
    return out << scene.name;
}

//! A model is a miss if it costs at least MISSED outliers more than the true model.
const double MISSED = 2;

typedef testing::TestWithParam<AutomaticScene> UsacAutomaticStructured;

TEST_P(UsacAutomaticStructured, missesHardlyMoreThanAGivenThreshold)
{
    const int SCENES = 100;
    int missed[2] = {0, 0};
    for (int seed = 1; seed <= SCENES; ++seed)
    {
        SceneOptions options;
        options.setSize(GetParam().size, GetParam().ratio);
        options.seed = seed;
        options.planeFraction = GetParam().plane;
        options.outlierModel = GetParam().wrong;
        if (GetParam().second > 0)
            options.structured = GetParam().second;
        const Scene scene = makeScene(GetParam().problem, options);
        Params params[2] = {Params(), Params::automatic()};
        params[0].threshold = 1.5;  // three times the noise
        params[1].threshold = 4.5;
        const Ptr<Usac> usac = createUsac(scene, params[0]);
        Arena arena;
        const Context context(usac->points(), usac->components(), params[0], arena);
        usac->components().start(context);
        const double truth = context.rate(toInternal(usac->points(), scene.model)).cost;
        for (int k = 0; k < 2; ++k)
        {
            params[k].seed = seed;
            params[k].maxIterations = 100000;
            const Mat model = estimate(scene, params[k]);
            missed[k] += model.empty() ||
                         !(context.rate(toInternal(usac->points(), Matx33d(model))).cost <
                           truth + MISSED);
        }
    }
    // more may be missed, but not many: an estimated threshold can fit the second motion instead,
    // in 3 % of the scenes (H)
    EXPECT_LE(missed[1], missed[0] + 8) << "of " << SCENES;
}

INSTANTIATE_TEST_CASE_P(Scenes, UsacAutomaticStructured, testing::ValuesIn(AUTOMATIC_SCENES));

}
}  // namespace
