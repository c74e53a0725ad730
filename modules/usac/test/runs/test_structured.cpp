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

}
}  // namespace
