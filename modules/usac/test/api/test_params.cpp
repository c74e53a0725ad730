// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/params_fields.hpp"

// Tests of the ranges, combinations and storage of the fields of Params. The effects of most fields
// are tested in test_params_effects.cpp and test_params_components.cpp.

namespace opencv_test {
namespace {

struct Check
{
    void operator()() const { params.check(); }
    Params params;
};

//! Sets other fields so that no value of `field` in its range contradicts them.
void permitAll(const std::string& field, Params& params)
{
    if (field == "verification")
        params.termination = TERMINATION_STANDARD;
    if (field == "termination")
        params.ordering = ORDERING_INPUT_ORDER;
    if (field == "sampler")
    {
        params.scores.assign(1, 1.f);
        params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    }
}

TEST(Usac_Params, ranges_of_integers)
{
    for (const NamedField& tested : Fields().ints)
    {
        SCOPED_TRACE(tested.name);
        const int low = (int)tested.values.low, high = (int)tested.values.high;
        Check check;
        permitAll(tested.name, check.params);
        for (int right : {low, high})
        {
            Assignment(check.params, tested.name, right);
            EXPECT_NO_THROW(check());
        }
        if (low == INT_MIN)
            continue;
        for (int wrong : {low - 1, INT_MIN, high < INT_MAX ? high + 1 : -2})
        {
            Assignment(check.params, tested.name, wrong);
            expectException(check, std::string(tested.name) + ": ");
        }
    }
}

TEST(Usac_Params, ranges_of_reals)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const NamedField& tested : Fields().doubles)
    {
        SCOPED_TRACE(tested.name);
        double low = tested.values.low, high = tested.values.high;
        if (tested.values.kind == FIELD_PIXELS || tested.values.kind == FIELD_PROBABILITY)
            low = std::nextafter(low, inf);
        if (tested.values.kind == FIELD_PROBABILITY)
            high = std::nextafter(high, -inf);
        Check check;
        for (double right : {low, high})
        {
            Assignment(check.params, tested.name, right);
            EXPECT_NO_THROW(check());
        }
        for (double wrong : {std::nextafter(low, -inf), std::nextafter(high, inf), -inf, inf, nan})
        {
            Assignment(check.params, tested.name, wrong);
            expectException(check, std::string(tested.name) + ": ");
        }
    }
}

TEST(Usac_Params, messages)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Check check;
    check.params.neighborRadius = -2;
    expectException(check, "neighborRadius: a positive number of pixels is expected, not -2");
    check.params.quality = (QualityType)7;
    expectException(check, "neighborRadius");  // the message names the first wrong field
    check.params.neighborRadius = 1;
    expectException(check, "quality: 0 .. 5 is expected, not 7");
    check.params.confidence = 1;
    expectException(check, "confidence: a number between 0 and 1 is expected, not 1");
    check.params.threshold = nan;
    expectException(check, "threshold: a positive number of pixels is expected, not nan");
}

//! Contradictory options must raise an exception that names the field and says why.
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
    for (OrderingType guess : {ORDERING_AUTO, ORDERING_DENSITY, ORDERING_NONE})
    {
        check.params.ordering = guess;
        expectException(check, "termination: TERMINATION_PROSAC needs points in an order");
    }
    check.params.ordering = ORDERING_INPUT_ORDER;
    EXPECT_NO_THROW(check());
    check.params.ordering = ORDERING_AUTO;
    check.params.scores.assign(3, 0.5f);
    EXPECT_NO_THROW(check());
    for (SamplerType other : {SAMPLER_UNIFORM, SAMPLER_NAPSAC})
    {
        check.params.sampler = other;
        expectException(check, "termination: TERMINATION_PROSAC needs");
    }
}

TEST(Usac_Params, impossible_combinations_with_lmeds)
{
    const Params lmeds = Params::lmeds();
    EXPECT_NO_THROW(lmeds.check());
    const struct
    {
        const char* field;
        int value;
    } wrong[] = {{"verification", VERIFICATION_SPRT},
                 {"verification", VERIFICATION_TDD},
                 {"localOptimization", LOCAL_OPTIMIZATION_GRAPH_CUT},
                 {"localOptimization", LOCAL_OPTIMIZATION_LO_RANSAC},
                 {"localOptimization", LOCAL_OPTIMIZATION_GC_RANSAC},
                 {"degeneracy", DEGENERACY_DEGENSAC},
                 {"termination", TERMINATION_MAGSAC}};
    for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); ++i)
    {
        Check check;
        check.params = lmeds;
        Assignment(check.params, wrong[i].field, wrong[i].value);
        expectException(check, wrong[i].field);
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
    const float wrong[] = {-0.1f, std::numeric_limits<float>::quiet_NaN(),
                           std::numeric_limits<float>::infinity()};
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

TEST(Usac_Params, scores_that_are_all_nan)
{
    Params params;
    params.scores.assign(10, std::numeric_limits<float>::quiet_NaN());
    expectException([&]() { params.check(10); }, "scores: ");
    params.scores[9] = 0.5f;
    EXPECT_NO_THROW(params.check(10));
}

//! Gives each field a value that is in its range and differs from its default. Some of these values
//! contradict each other; unusual() corrects them.
struct Changer
{
    Params& params;
    template <class T>
    void operator()(const char*, T Params::*member, const FieldValues& values)
    {
        params.*
            member = (T)(values.initial < values.high ? values.initial + 1 : values.initial - 1);
    }
    void operator()(const char*, double Params::*member, const FieldValues& values)
    {
        const double end = values.initial < 1    ? std::min(values.high, 1.)
                           : values.initial == 1 ? 2
                                                 : 0;
        // usually not a finite binary fraction, so that inexact storage would change the value
        params.*member = (2 * values.initial + end) / 3;
    }
    void operator()(const char*, std::vector<float> Params::*member, const FieldValues& values)
    {
        const bool positive = values.kind == FIELD_SIGMAS;
        params.*member = {0.1f, positive ? 2e-6f : -1e-20f, positive ? 3e5f : 3e20f};
    }
    void operator()(const char*, std::vector<double> Params::*member, const FieldValues&)
    {
        params.*member = {0.1, -1e-200, 3e200};
    }
};

//! Parameters with all fields valid and different from their defaults.
Params unusual()
{
    Params p;
    Changer changer = {p};
    visitFields(changer);
    p.maxIterations = 2000000001;
    p.seed = -5;
    p.scoreOrder = SCORES_HIGHER_IS_BETTER;
    p.sampler = SAMPLER_PROSAC;
    p.verification = VERIFICATION_NONE;
    p.termination = TERMINATION_STANDARD;
    return p;
}

TEST(Usac_Params, storage_keeps_every_field)
{
    const Params written = unusual();
    EXPECT_NO_THROW(written.check());
    std::string all;
    for (const std::string& name : Fields().names)
        all += name + " ";
    EXPECT_EQ(all, Fields::difference(Params(), written));
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
    in["usac"] >> params;  // >> sets missing fields to their defaults
    EXPECT_EQ("threshold sampler scores ", Fields::difference(Params(), params));
    in["missing"] >> params;
    EXPECT_EQ("", Fields::difference(Params(), params));
}

}  // namespace
}  // namespace opencv_test
