// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"

// Params: ranges, presets, conversion, storage. What each field does is in test_params_effects.cpp.

namespace opencv_test { namespace {

//! The fields but for the scores, by name.
struct Fields
{
    static std::vector<std::pair<std::string, int Params::*> > ints()
    {
        std::vector<std::pair<std::string, int Params::*> > f;
        f.push_back(std::make_pair("maxIterations", &Params::maxIterations));
        f.push_back(std::make_pair("seed", &Params::seed));
        f.push_back(std::make_pair("threads", &Params::threads));
        f.push_back(std::make_pair("sampler", &Params::sampler));
        f.push_back(std::make_pair("prior", &Params::prior));
        f.push_back(std::make_pair("scoreOrder", &Params::scoreOrder));
        f.push_back(std::make_pair("quality", &Params::quality));
        f.push_back(std::make_pair("verification", &Params::verification));
        f.push_back(std::make_pair("localOptimization", &Params::localOptimization));
        f.push_back(std::make_pair("localIterations", &Params::localIterations));
        f.push_back(std::make_pair("localSampleMultiple", &Params::localSampleMultiple));
        f.push_back(std::make_pair("localSamples", &Params::localSamples));
        f.push_back(std::make_pair("termination", &Params::termination));
        f.push_back(std::make_pair("degeneracy", &Params::degeneracy));
        f.push_back(std::make_pair("polishing", &Params::polishing));
        return f;
    }

    static std::vector<std::pair<std::string, double Params::*> > doubles()
    {
        std::vector<std::pair<std::string, double Params::*> > f;
        f.push_back(std::make_pair("threshold", &Params::threshold));
        f.push_back(std::make_pair("confidence", &Params::confidence));
        f.push_back(std::make_pair("spatialWeight", &Params::spatialWeight));
        f.push_back(std::make_pair("relaxation", &Params::relaxation));
        return f;
    }

    //! Names of the fields that differ, in the order above.
    static std::string difference(const Params& a, const Params& b)
    {
        std::string names;
        for (size_t i = 0; i < ints().size(); ++i)
            if (a.*ints()[i].second != b.*ints()[i].second)
                names += ints()[i].first + " ";
        for (size_t i = 0; i < doubles().size(); ++i)
            if (a.*doubles()[i].second != b.*doubles()[i].second)
                names += doubles()[i].first + " ";
        return names + (a.scores != b.scores ? "scores " : "");
    }
};

struct Check
{
    void operator()() const { params.check(); }
    Params params;
};

TEST(Usac_Params, ranges_of_integers)
{
    const struct { const char* name; int low, high; } ranges[] = {
        {"maxIterations", 1, INT_MAX}, {"seed", INT_MIN, INT_MAX}, {"threads", 0, 1024},
        {"sampler", SAMPLER_UNIFORM, SAMPLER_NAPSAC}, {"prior", PRIOR_AUTO, PRIOR_NONE},
        {"scoreOrder", SCORES_LOWER_IS_BETTER, SCORES_HIGHER_IS_BETTER}, {"quality", QUALITY_INLIERS, QUALITY_MAGSAC_PLUS_PLUS},
        {"verification", VERIFICATION_NONE, VERIFICATION_SPRT},
        {"localOptimization", LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_GRAPH_CUT}, {"localIterations", 1, 1000},
        {"localSampleMultiple", 2, 100}, {"localSamples", 0, 1000}, {"termination", 0, 7}, {"degeneracy", 0, 3},
        {"polishing", POLISHING_NONE, POLISHING_ROBUST}};
    ASSERT_EQ(Fields::ints().size(), sizeof(ranges) / sizeof(ranges[0]));
    for (size_t i = 0; i < Fields::ints().size(); ++i)
    {
        SCOPED_TRACE(ranges[i].name);
        ASSERT_EQ(Fields::ints()[i].first, ranges[i].name);
        Check check;
        int& field = check.params.*Fields::ints()[i].second;
        if (std::string("verification") == ranges[i].name)
            check.params.termination = TERMINATION_STANDARD;
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
    const struct { const char* name; double right[2], wrong[3]; } ranges[] = {
        {"threshold", {1e-300, 1e300}, {0, -1, inf}}, {"confidence", {1e-300, 1 - 1e-15}, {0, 1, 2}},
        {"spatialWeight", {0, 10}, {-1e-9, 10.001, inf}}, {"relaxation", {0, 1}, {-1e-9, 1.001, -inf}}};
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

TEST(Usac_Params, sprt_termination_needs_sprt)
{
    Check check;
    check.params.verification = VERIFICATION_NONE;
    expectException(check, "termination");
    check.params.termination = TERMINATION_STANDARD | TERMINATION_P_NAPSAC;
    EXPECT_NO_THROW(check());
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
    EXPECT_EQ((int)PRIOR_AUTO, p.prior);
    EXPECT_TRUE(p.scores.empty());
    EXPECT_EQ((int)SCORES_LOWER_IS_BETTER, p.scoreOrder);
    EXPECT_EQ((int)QUALITY_MSAC, p.quality);
    EXPECT_EQ((int)VERIFICATION_SPRT, p.verification);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_GRAPH_CUT, p.localOptimization);
    EXPECT_EQ(5, p.localIterations);
    EXPECT_EQ(3, p.localSampleMultiple);
    EXPECT_EQ(4, p.localSamples);
    EXPECT_EQ(0.14, p.spatialWeight);
    EXPECT_EQ(TERMINATION_SPRT | TERMINATION_P_NAPSAC, p.termination);
    EXPECT_EQ(0.03, p.relaxation);
    EXPECT_EQ(DEGENERACY_ORIENTATION | DEGENERACY_DEGENSAC, p.degeneracy);
    EXPECT_EQ((int)POLISHING_LEAST_SQUARES, p.polishing);
}

TEST(Usac_Params, presets)
{
    const Params presets[] = {Params::usacV20(), Params::fast(), Params::accurate(), Params::prosac(), Params::ransac(),
                              Params::parallel()};
    for (int i = 0; i < 6; ++i)
    {
        EXPECT_NO_THROW(presets[i].check()) << i;
        for (int k = 0; k < i; ++k)
            EXPECT_NE("", Fields::difference(presets[i], presets[k])) << i << " and " << k << " are the same";
    }
    EXPECT_EQ("", Fields::difference(Params(), presets[0]));
    EXPECT_EQ("sampler prior ", Fields::difference(Params(), presets[3]));
    EXPECT_EQ("threads ", Fields::difference(Params(), presets[5]));
    EXPECT_EQ(0, presets[5].threads);
    EXPECT_EQ((int)SAMPLER_PROSAC, presets[3].sampler);
    EXPECT_EQ((int)PRIOR_INPUT_ORDER, presets[3].prior);
    const Params& ransac = presets[4];
    EXPECT_EQ((int)SAMPLER_UNIFORM, ransac.sampler);
    EXPECT_EQ((int)QUALITY_INLIERS, ransac.quality);
    EXPECT_EQ((int)VERIFICATION_NONE, ransac.verification);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_NONE, ransac.localOptimization);
    EXPECT_EQ((int)TERMINATION_STANDARD, ransac.termination);
    EXPECT_EQ((int)POLISHING_LEAST_SQUARES, ransac.polishing);
    EXPECT_EQ(0, ransac.degeneracy);
}

TEST(Usac_Params, from_method)
{
    EXPECT_EQ("", Fields::difference(Params::usacV20(), Params::fromMethod(USACV20)));
    EXPECT_EQ("", Fields::difference(Params::fast(), Params::fromMethod(USACV20_FAST)));
    EXPECT_EQ("", Fields::difference(Params::accurate(), Params::fromMethod(USACV20_ACCURATE)));
    EXPECT_EQ("", Fields::difference(Params::prosac(), Params::fromMethod(USACV20_PROSAC)));
    EXPECT_EQ("", Fields::difference(Params::parallel(), Params::fromMethod(USACV20_PARALLEL)));
}

TEST(Usac_Params, from_the_parameters_of_calib3d)
{
    cv::UsacParams other;
    other.threshold = 2.25;
    other.confidence = 0.75;
    other.maxIterations = 321;
    other.randomGeneratorState = 17;
    Params params = Params::fromUsacParams(other);
    EXPECT_NO_THROW(params.check());
    EXPECT_EQ(2.25, params.threshold);
    EXPECT_EQ(0.75, params.confidence);
    EXPECT_EQ(321, params.maxIterations);
    EXPECT_EQ(17, params.seed);
    EXPECT_EQ(1, params.threads);
    EXPECT_EQ((int)SAMPLER_UNIFORM, params.sampler);
    EXPECT_EQ((int)QUALITY_MSAC, params.quality);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_GRAPH_CUT, params.localOptimization);
    other.isParallel = true;
    other.score = SCORE_METHOD_RANSAC;
    other.loMethod = LOCAL_OPTIM_NULL;
    other.sampler = SAMPLING_PROSAC;
    params = Params::fromUsacParams(other);
    EXPECT_EQ(0, params.threads);
    EXPECT_EQ((int)QUALITY_INLIERS, params.quality);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_NONE, params.localOptimization);
    EXPECT_EQ((int)SAMPLER_PROSAC, params.sampler);
    EXPECT_EQ((int)PRIOR_INPUT_ORDER, params.prior) << "calib3d's PROSAC wants sorted points";
    other.sampler = SAMPLING_PROGRESSIVE_NAPSAC;
    EXPECT_EQ((int)SAMPLER_P_NAPSAC, Params::fromUsacParams(other).sampler);
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
    p.prior = PRIOR_DENSITY;
    p.scores.push_back(0.1f);
    p.scores.push_back(-1e-20f);
    p.scores.push_back(3e20f);
    p.scoreOrder = SCORES_HIGHER_IS_BETTER;
    p.quality = QUALITY_INLIERS;
    p.verification = VERIFICATION_NONE;
    p.localOptimization = LOCAL_OPTIMIZATION_NONE;
    p.localIterations = 9;
    p.localSampleMultiple = 11;
    p.localSamples = 13;
    p.spatialWeight = 0.7;
    p.termination = TERMINATION_STANDARD;
    p.relaxation = 0.3;
    p.degeneracy = DEGENERACY_DEGENSAC;
    p.polishing = POLISHING_NONE;
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

}} // namespace
