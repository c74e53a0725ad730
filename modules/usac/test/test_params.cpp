// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"
#include "params_fields.hpp"

// Params: ranges, presets, conversion, storage. What each field does is in test_params_effects.cpp.

namespace opencv_test {
namespace {

struct Check
{
    void operator()() const { params.check(); }
    Params params;
};

TEST(Usac_Params, ranges_of_integers)
{
    const struct
    {
        const char* name;
        int low, high;
    } ranges[] = {{"maxIterations", 1, INT_MAX},
                  {"seed", INT_MIN, INT_MAX},
                  {"threads", 0, 1024},
                  {"sampler", SAMPLER_UNIFORM, SAMPLER_IMPORTANCE},
                  {"ordering", ORDERING_AUTO, ORDERING_NONE},
                  {"scoreOrder", SCORES_LOWER_IS_BETTER, SCORES_HIGHER_IS_BETTER},
                  {"neighborhood", NEIGHBORHOOD_GRID, NEIGHBORHOOD_RADIUS},
                  {"neighbors", 1, 1000},
                  {"residual", RESIDUAL_STANDARD, RESIDUAL_SYMMETRIC},
                  {"quality", QUALITY_INLIERS, QUALITY_MAGSAC_PLUS_PLUS},
                  {"verification", VERIFICATION_NONE, VERIFICATION_TDD},
                  {"tddPoints", 1, 100},
                  {"localOptimization", LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_GC_RANSAC},
                  {"localIterations", 1, 1000},
                  {"localSampleMultiple", 2, 100},
                  {"localSamples", 0, 1000},
                  {"termination", 0, 63},
                  {"runnersUp", 0, 100},
                  {"orderedEvery", 1, 1000},
                  {"persistence", 1, 100},
                  {"degeneracy", 0, 7},
                  {"polishing", POLISHING_NONE, POLISHING_ROBUST},
                  {"polishingSteps", 1, 100}};
    ASSERT_EQ(Fields::ints().size(), sizeof(ranges) / sizeof(ranges[0]));
    for (size_t i = 0; i < Fields::ints().size(); ++i)
    {
        SCOPED_TRACE(ranges[i].name);
        ASSERT_EQ(Fields::ints()[i].first, ranges[i].name);
        Check check;
        int& field = check.params.*Fields::ints()[i].second;
        if (std::string("verification") == ranges[i].name)
            check.params.termination = TERMINATION_STANDARD;
        if (std::string("termination") == ranges[i].name)
            check.params.ordering = ORDERING_INPUT_ORDER;
        if (std::string("sampler") == ranges[i].name)
        {
            check.params.scores.assign(1, 1.f);
            check.params.scoreOrder = SCORES_HIGHER_IS_BETTER;
        }
        const int right[] = {ranges[i].low, ranges[i].high};
        for (int k = 0; k < 2; ++k)
        {
            field = right[k];
            EXPECT_NO_THROW(check());
        }
        if (ranges[i].low == INT_MIN)
            continue;
        const int wrong[] = {ranges[i].low - 1, INT_MIN, ranges[i].high < INT_MAX ? ranges[i].high + 1 : -2};
        for (int k = 0; k < 3; ++k)
        {
            field = wrong[k];
            expectException(check, ranges[i].name);
        }
    }
}

TEST(Usac_Params, ranges_of_reals)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const struct
    {
        const char* name;
        double right[2], wrong[3];
    } ranges[] = {{"threshold", {1e-300, 1e300}, {0, -1, inf}},      {"confidence", {1e-300, 1 - 1e-15}, {0, 1, 2}},
                  {"neighborRadius", {1e-300, 1e300}, {0, -1, inf}}, {"reach", {1, 10}, {0.99, 10.1, -inf}},
                  {"widestReach", {1, 1e6}, {0.99, 1.001e6, inf}},   {"spatialWeight", {0, 10}, {-1e-9, 10.001, inf}},
                  {"relaxation", {0, 1}, {-1e-9, 1.001, -inf}},      {"significance", {0, 1}, {-1e-9, 1.001, -inf}}};
    ASSERT_EQ(Fields::doubles().size(), sizeof(ranges) / sizeof(ranges[0]));
    for (size_t i = 0; i < Fields::doubles().size(); ++i)
    {
        SCOPED_TRACE(ranges[i].name);
        ASSERT_EQ(Fields::doubles()[i].first, ranges[i].name);
        Check check;
        double& field = check.params.*Fields::doubles()[i].second;
        for (int k = 0; k < 2; ++k)
        {
            field = ranges[i].right[k];
            EXPECT_NO_THROW(check());
        }
        for (int k = 0; k < 3; ++k)
        {
            field = ranges[i].wrong[k];
            expectException(check, ranges[i].name);
        }
        field = nan;
        expectException(check, ranges[i].name);
    }
}

TEST(Usac_Params, message_has_the_value)
{
    Check check;
    check.params.localIterations = 4711;
    expectException(check, "4711");
}

//! Options that contradict each other raise an exception that names the field and says why.
TEST(Usac_Params, impossible_combinations)
{
    Check check;
    check.params.verification = VERIFICATION_NONE;
    expectException(check, "termination: TERMINATION_SPRT needs");
    check.params.termination = TERMINATION_STANDARD | TERMINATION_P_NAPSAC;
    EXPECT_NO_THROW(check());
    check.params.termination = TERMINATION_EXACT;
    expectException(check, "termination: TERMINATION_EXACT modifies");
    check.params.termination = TERMINATION_PROSAC;
    const int guesses[] = {ORDERING_AUTO, ORDERING_DENSITY, ORDERING_NONE};
    for (int i = 0; i < 3; ++i)
    {
        check.params.ordering = guesses[i];
        expectException(check, "termination: TERMINATION_PROSAC needs points in an order");
    }
    check.params.ordering = ORDERING_INPUT_ORDER;
    EXPECT_NO_THROW(check());
    check.params.ordering = ORDERING_AUTO;
    check.params.scores.assign(3, 0.5f);
    EXPECT_NO_THROW(check());
    const int others[] = {SAMPLER_UNIFORM, SAMPLER_NAPSAC};
    for (int i = 0; i < 2; ++i)
    {
        check.params.sampler = others[i];
        expectException(check, "termination: TERMINATION_PROSAC needs");
    }
}

TEST(Usac_Params, impossible_combinations_with_lmeds)
{
    const Params lmeds = Params::lmeds();
    EXPECT_NO_THROW(lmeds.check());
    const struct
    {
        int Params::*field;
        int value;
        const char* name;
    } wrong[] = {{&Params::verification, VERIFICATION_SPRT, "verification"},
                 {&Params::verification, VERIFICATION_TDD, "verification"},
                 {&Params::localOptimization, LOCAL_OPTIMIZATION_GRAPH_CUT, "localOptimization"},
                 {&Params::localOptimization, LOCAL_OPTIMIZATION_LO_RANSAC, "localOptimization"},
                 {&Params::localOptimization, LOCAL_OPTIMIZATION_GC_RANSAC, "localOptimization"},
                 {&Params::degeneracy, DEGENERACY_DEGENSAC, "degeneracy"},
                 {&Params::termination, TERMINATION_MAGSAC, "termination"}};
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); ++i)
    {
        Check check;
        check.params = lmeds;
        check.params.*wrong[i].field = wrong[i].value;
        expectException(check, wrong[i].name);
    }
}

TEST(Usac_Params, importance_sampling_needs_probabilities)
{
    Check check;
    check.params.sampler = SAMPLER_IMPORTANCE;
    check.params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    expectException(check, "sampler");
    check.params.scores.assign(3, 0.5f);
    EXPECT_NO_THROW(check());
    check.params.scoreOrder = SCORES_LOWER_IS_BETTER;
    expectException(check, "sampler");
    check.params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    const float wrong[] = {-0.1f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
    for (int i = 0; i < 3; ++i)
    {
        check.params.scores[1] = wrong[i];
        expectException(check, "scores");
    }
}

TEST(Usac_Params, number_of_scores)
{
    Params params;
    params.scores.assign(10, 0.5f);
    EXPECT_NO_THROW(params.check());
    EXPECT_NO_THROW(params.check(10));
    expectException([&]() { params.check(9); }, "scores");
    expectException([&]() { params.check(0); }, "scores");
    params.scores.clear();
    EXPECT_NO_THROW(params.check(9));
}

TEST(Usac_Params, defaults_as_documented)
{
    const Params p;
    EXPECT_EQ(1.5, p.threshold);
    EXPECT_EQ(0.99, p.confidence);
    EXPECT_EQ(5000, p.maxIterations);
    EXPECT_EQ(0, p.seed);
    EXPECT_EQ(1, p.threads);
    EXPECT_EQ((int)SAMPLER_P_NAPSAC, p.sampler);
    EXPECT_EQ((int)ORDERING_AUTO, p.ordering);
    EXPECT_TRUE(p.scores.empty());
    EXPECT_EQ((int)SCORES_LOWER_IS_BETTER, p.scoreOrder);
    EXPECT_EQ((int)NEIGHBORHOOD_GRID, p.neighborhood);
    EXPECT_EQ(10, p.neighbors);
    EXPECT_EQ(40, p.neighborRadius);
    EXPECT_EQ((int)RESIDUAL_STANDARD, p.residual);
    EXPECT_EQ((int)QUALITY_MSAC, p.quality);
    EXPECT_EQ(1, p.reach);
    EXPECT_EQ(1, p.widestReach);
    EXPECT_EQ((int)VERIFICATION_SPRT, p.verification);
    EXPECT_EQ(1, p.tddPoints);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_GRAPH_CUT, p.localOptimization);
    EXPECT_EQ(5, p.localIterations);
    EXPECT_EQ(3, p.localSampleMultiple);
    EXPECT_EQ(4, p.localSamples);
    EXPECT_EQ(0.14, p.spatialWeight);
    EXPECT_EQ(TERMINATION_SPRT | TERMINATION_P_NAPSAC | TERMINATION_EXACT, p.termination);
    EXPECT_EQ(0.05, p.relaxation);
    EXPECT_EQ(16, p.runnersUp);
    EXPECT_EQ(8, p.orderedEvery);
    EXPECT_EQ(1, p.persistence);
    EXPECT_EQ(DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC | DEGENERACY_REPEATED, p.degeneracy);
    EXPECT_EQ((int)POLISHING_ROBUST, p.polishing);
    EXPECT_EQ(6, p.polishingSteps);
    EXPECT_EQ(0, p.significance);
}

//! All fields different from their defaults and right.
Params unusual()
{
    Params p;
    p.threshold = 1. / 3;
    p.confidence = 0.123456789012345678;
    p.maxIterations = 2000000001;
    p.seed = -5;
    p.threads = 3;
    p.sampler = SAMPLER_PROSAC;
    p.ordering = ORDERING_DENSITY;
    p.scores.push_back(0.1f);
    p.scores.push_back(-1e-20f);
    p.scores.push_back(3e20f);
    p.scoreOrder = SCORES_HIGHER_IS_BETTER;
    p.neighborhood = NEIGHBORHOOD_KNN;
    p.neighbors = 17;
    p.neighborRadius = 3.3;
    p.residual = RESIDUAL_SYMMETRIC;
    p.quality = QUALITY_INLIERS;
    p.reach = 1.7;
    p.widestReach = 33.3;
    p.verification = VERIFICATION_NONE;
    p.tddPoints = 2;
    p.localOptimization = LOCAL_OPTIMIZATION_NONE;
    p.localIterations = 9;
    p.localSampleMultiple = 11;
    p.localSamples = 13;
    p.spatialWeight = 0.7;
    p.termination = TERMINATION_STANDARD;
    p.relaxation = 0.3;
    p.runnersUp = 5;
    p.orderedEvery = 3;
    p.persistence = 7;
    p.degeneracy = DEGENERACY_DEGENSAC;
    p.polishing = POLISHING_NONE;
    p.polishingSteps = 9;
    p.significance = 0.001;
    return p;
}

TEST(Usac_Params, storage_keeps_every_field)
{
    const Params written = unusual();
    EXPECT_NO_THROW(written.check());
    for (size_t i = 0; i < Fields::ints().size(); ++i)
        EXPECT_NE(Params().*Fields::ints()[i].second, written.*Fields::ints()[i].second) << Fields::ints()[i].first;
    const char* names[] = {"p.yml", "p.xml", "p.json"};
    for (int i = 0; i < 3; ++i)
    {
        SCOPED_TRACE(names[i]);
        FileStorage out(names[i], FileStorage::WRITE | FileStorage::MEMORY);
        out << "before" << 1 << "usac" << written << "plain" << Params() << "after" << 2;
        const String text = out.releaseAndGetString();
        FileStorage in(text, FileStorage::READ | FileStorage::MEMORY);
        Params read = Params::fast(), plain = written;
        in["usac"] >> read;
        in["plain"] >> plain;
        EXPECT_EQ("", Fields::difference(written, read));
        EXPECT_EQ("", Fields::difference(Params(), plain));
        EXPECT_EQ(2, (int)in["after"]);
    }
}

TEST(Usac_Params, storage_of_some_fields)
{
    FileStorage in("%YAML:1.0\nusac:\n   threshold: 4.5\n   sampler: 1\n   scores: [ 1., 2. ]\n",
                   FileStorage::READ | FileStorage::MEMORY);
    Params params = unusual();
    params.read(in["usac"]);
    EXPECT_EQ(4.5, params.threshold);
    EXPECT_EQ((size_t)2, params.scores.size());
    EXPECT_EQ("threshold scores ", Fields::difference(unusual(), params));
    in["usac"] >> params;  // the others get their defaults
    EXPECT_EQ("sampler threshold scores ", Fields::difference(Params(), params));
    in["missing"] >> params;
    EXPECT_EQ("", Fields::difference(Params(), params));
}

}
}  // namespace
