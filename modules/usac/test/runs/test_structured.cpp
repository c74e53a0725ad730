// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

namespace opencv_test {
namespace {

//! Scenes with typical camera motions of vehicles and other machines, or with a plane. The rates of
//! failures are in doc/structured.md; measuring them takes more runs than a test can make.
struct Structure
{
    const char* name;
    Motion motion;
    double angle, plane, nearest, farthest;
};

const Structure STRUCTURES[] = {
    {"forward", MOTION_FORWARD, 2, 0, 4, 9},     {"sideways", MOTION_SIDEWAYS, 2, 0, 4, 9},
    {"rectified", MOTION_RECTIFIED, 0, 0, 4, 9}, {"aerial", MOTION_RECTIFIED, 0, 0, 5.4, 6.6},
    {"planar", MOTION_PLANAR, 10, 0, 4, 9},      {"car", MOTION_CAR, 10, 0, 4, 9},
    {"plane", MOTION_GENERAL, 12, 0.9, 4, 9}};

std::ostream& operator<<(std::ostream& out, const Structure& s) { return out << s.name; }

typedef testing::TestWithParam<Structure> Usac_Structured;

TEST_P(Usac_Structured, no_flag_is_wrong)
{
    const UsacV20Method flags[] = {USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_MAGSAC};
    for (int problem : TWO_VIEW_PROBLEMS)
        for (size_t k = 0; k < sizeof(flags) / sizeof(flags[0]); ++k)
        {
            int wrong = 0;
            for (uint64 seed = 1; seed <= 8; ++seed)
            {
                SceneOptions options;
                options.setSize(200, 0.8);
                options.seed = seed;
                options.motion = GetParam().motion;
                options.angle = GetParam().angle;
                options.planeFraction = GetParam().plane;
                options.nearest = GetParam().nearest;
                options.farthest = GetParam().farthest;
                const Scene scene = makeScene((ProblemType)problem, options);
                Params params = Params::fromMethod(flags[k]);
                params.threshold = 1.5;
                wrong += !(modelError(scene, estimate(scene, params)) < 1.5);
            }
            EXPECT_EQ(0, wrong) << problem << ", flag " << k;
        }
}

INSTANTIATE_TEST_CASE_P(Motions, Usac_Structured, testing::ValuesIn(STRUCTURES));

//! Few points with scores that are informative, random or reversed. Scores can change the length of
//! the search, but in at least 19 of 20 scenes, the cost of the result (summed over the points)
//! must exceed that of the true model by less than 1.
TEST(Usac_Structured, any_order_of_scores)
{
    const double information[] = {0.9, 0.5, 0.05};
    for (int problem : TWO_VIEW_PROBLEMS)
        for (int order = 0; order < 3; ++order)
        {
            int missed = 0;
            for (uint64 seed = 1; seed <= 20; ++seed)
            {
                SceneOptions options;
                options.setSize(30, 0.6);
                options.seed = seed;
                options.scoreInformation = information[order];
                const Scene scene = makeScene((ProblemType)problem, options);
                const Ptr<Usac> usac = createUsac(scene, Params());
                const Params params;
                Arena arena;
                const Context context(usac->points(), usac->components(), params, arena);
                usac->components().start(context);
                const double truth = context.rate(toInternal(usac->points(), scene.model)).cost;
                Params sorted = Params::sorted();
                sorted.ordering = ORDERING_AUTO;
                sorted.scores = scene.scores;
                Report report;
                estimate(scene, sorted, noArray(), &report);
                missed += !(report.cost * scene.size() < truth + 1);
            }
            EXPECT_LE(missed, 1) << problem << ", order " << order;
        }
}

}
}  // namespace
