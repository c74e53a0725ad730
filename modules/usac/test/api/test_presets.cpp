// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/params_fields.hpp"

// A preset that is named after a method must have the options that the paper of this method
// describes. Each flag must select its documented preset. Params::fromUsacParams must convert the
// parameters of calib3d to the corresponding options.

namespace opencv_test {
namespace {

//! A preset, and the fields in which it differs from the parameters `from`.
struct Expected
{
    const char* name;
    Params preset, from;
    const char* changed;  //!< names of these fields in the order of visitFields
};

TEST(Usac_Presets, change_what_they_say)
{
    const Params v20, ransac = Params::ransac(), lo = Params::loRansac();
    Params trusted = Params::trustedScores();
    EXPECT_THROW(trusted.check(), cv::Exception);  // PROSAC needs scores or sorted points
    trusted.scores.assign(10, 1.f);
    const Expected all[] = {
        {"usacV20", Params::usacV20(), v20, ""},
        {"fast", Params::fast(), v20,
         "localIterations localSamples spatialWeight runnersUp relaxation polishingSteps "},
        {"accurate", Params::accurate(), v20,
         "localIterations localSamples runnersUp termination persistence polishingSteps "},
        {"sorted", Params::sorted(), v20, "sampler ordering "},
        {"trustedScores", trusted, v20, "sampler scores orderedEvery termination "},
        {"parallel", Params::parallel(), v20, "threads "},
        {"ransac", ransac, v20,
         "sampler quality verification localOptimization runnersUp termination degeneracy "
         "polishing "},
        {"msac", Params::msac(), ransac, "quality "},
        {"lmeds", Params::lmeds(), ransac, "quality "},
        {"mlesac", Params::mlesac(), ransac, "quality "},
        {"prosac", Params::prosac(), ransac, "sampler ordering orderedEvery termination "},
        {"loRansac", lo, ransac,
         "localOptimization localIterations localSampleMultiple localSamples "},
        {"floRansac", Params::floRansac(), lo, "quality localOptimization localSamples "},
        {"gcRansac", Params::gcRansac(), Params::msac(),
         "neighborhood neighborRadius localOptimization localIterations localSampleMultiple "
         "localSamples "},
        {"usac2013", Params::usac2013(), lo,
         "sampler ordering verification orderedEvery termination degeneracy "},
        {"paper", Params::paper(), v20,
         "localOptimization localIterations localSampleMultiple localSamples runnersUp "
         "orderedEvery termination degeneracy polishing polishingSteps significance "},
        {"magsac", Params::magsac(), ransac,
         "quality reach widestReach localOptimization termination polishing polishingSteps "},
        {"magsacPlusPlus", Params::magsacPlusPlus(), v20,
         "quality reach widestReach localOptimization polishing polishingSteps "}};
    const int count = sizeof(all) / sizeof(all[0]);
    for (int i = 0; i < count; ++i)
    {
        SCOPED_TRACE(all[i].name);
        EXPECT_NO_THROW(all[i].preset.check());
        EXPECT_EQ(all[i].changed, Fields::difference(all[i].from, all[i].preset));
        for (int k = 0; k < i; ++k)
            EXPECT_NE("", Fields::difference(all[i].preset, all[k].preset))
                << all[k].name << " is the same";
    }
}

TEST(Usac_Presets, ransac)
{
    const Params p = Params::ransac();
    EXPECT_EQ((int)SAMPLER_UNIFORM, p.sampler);
    EXPECT_EQ((int)QUALITY_INLIERS, p.quality);
    EXPECT_EQ((int)VERIFICATION_NONE, p.verification);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_NONE, p.localOptimization);
    EXPECT_EQ((int)TERMINATION_STANDARD, p.termination);
    EXPECT_EQ((int)POLISHING_LEAST_SQUARES, p.polishing);
    EXPECT_EQ(0, p.degeneracy);
    EXPECT_EQ((int)QUALITY_MSAC, Params::msac().quality);
    EXPECT_EQ((int)QUALITY_LMEDS, Params::lmeds().quality);
    EXPECT_EQ((int)QUALITY_MLESAC, Params::mlesac().quality);
}

TEST(Usac_Presets, prosac)
{
    EXPECT_EQ((int)SAMPLER_PROSAC, Params::prosac().sampler);
    EXPECT_EQ((int)ORDERING_INPUT_ORDER, Params::prosac().ordering);
    EXPECT_EQ((int)TERMINATION_PROSAC, Params::prosac().termination);
    EXPECT_EQ((int)SAMPLER_PROSAC, Params::sorted().sampler);
    EXPECT_EQ((int)ORDERING_INPUT_ORDER, Params::sorted().ordering);
    EXPECT_EQ(0, Params::parallel().threads);
}

TEST(Usac_Presets, locally_optimized)
{
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_LO_RANSAC, Params::loRansac().localOptimization);
    EXPECT_EQ(10, Params::loRansac().localSamples);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_FLO_RANSAC, Params::floRansac().localOptimization);
    EXPECT_LT(Params::floRansac().localSamples, Params::loRansac().localSamples)
        << "FLO-RANSAC must draw fewer inner samples";
    EXPECT_EQ((int)QUALITY_MSAC, Params::floRansac().quality);
    const Params gc = Params::gcRansac();
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_GC_RANSAC, gc.localOptimization);
    EXPECT_EQ((int)SAMPLER_UNIFORM, gc.sampler);
    EXPECT_EQ((int)QUALITY_MSAC, gc.quality);
    EXPECT_EQ((int)TERMINATION_STANDARD, gc.termination);
    EXPECT_GT(gc.spatialWeight, 0);
    const Params usac = Params::usac2013();
    EXPECT_EQ((int)SAMPLER_PROSAC, usac.sampler);
    EXPECT_EQ((int)VERIFICATION_SPRT, usac.verification);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_LO_RANSAC, usac.localOptimization);
    EXPECT_TRUE((usac.degeneracy & DEGENERACY_DEGENSAC) != 0);
    EXPECT_EQ(TERMINATION_SPRT | TERMINATION_PROSAC, usac.termination);
}

//! Records the samples of a sampler.
class RecordedSampler : public Sampler
{
public:
    explicit RecordedSampler(const Ptr<Sampler>& given_) : given(given_) {}
    void start(const Context& context) CV_OVERRIDE { given->start(context); }
    void sample(const Context& context, State& state, int* sample) CV_OVERRIDE
    {
        const int m = context.components.minimalSolver->sampleSize();
        given->sample(context, state, sample);
        samples.push_back(std::vector<int>(sample, sample + m));
        EXPECT_TRUE(state.counts);
        EXPECT_TRUE(inOneNeighborhood(context, samples.back()));
    }
    double growingShare(const Context& context) const CV_OVERRIDE
    {
        return given->growingShare(context);
    }

    std::vector<std::vector<int>> samples;

private:
    static bool inOneNeighborhood(const Context& context, const std::vector<int>& sample)
    {
        Neighborhood& neighborhood = context.neighborhood();
        for (int layer = 0; layer < neighborhood.layers(); ++layer)
        {
            const int* members;
            const int count = neighborhood.members(context, layer, sample[0], members);
            size_t found = 0;
            for (int i = 0; i < count; ++i)
                found += std::find(sample.begin(), sample.end(), members[i]) != sample.end();
            if (found == sample.size())
                return true;
        }
        return false;
    }

    const Ptr<Sampler> given;
};

//! Lines 18 and 19 of Algorithm 1: each optimized model is better than the best one.
class RecordedOptimizer : public LocalOptimizer
{
public:
    explicit RecordedOptimizer(const Ptr<LocalOptimizer>& given_) : given(given_) {}
    void start(const Context& context) CV_OVERRIDE { given->start(context); }
    bool optimize(const Context& context, State& state, Model& model, Quality& quality) CV_OVERRIDE
    {
        EXPECT_TRUE(quality.betterThan(state.bestQuality));
        return given->optimize(context, state, model, quality);
    }

private:
    const Ptr<LocalOptimizer> given;
};

//! No addition to the paper acts: all samples are P-NAPSAC's, all count, and there are no others
//! (of outliers, or of few inliers after the search); only models better than the best one are
//! optimized; only one fit follows the search; no check of repeated matches, no success
//! probability, no test of significance.
TEST(Usac_Presets, paper_has_no_additions)
{
    for (ProblemType problem : {HOMOGRAPHY, FUNDAMENTAL, ESSENTIAL})
        for (int seed = 1; seed <= 5; ++seed)
        {
            SCOPED_TRACE(cv::format("problem %d, seed %d", (int)problem, seed));
            const Scene scene = makeScene(problem, 300, 200, seed);
            const Ptr<Usac> usac = createUsac(scene, Params::paper());
            Components& parts = usac->components();
            EXPECT_EQ(problem == HOMOGRAPHY ? 1u : 2u, parts.degeneracies.size());
            EXPECT_EQ(2u, parts.terminations.size());
            const Ptr<RecordedSampler> sampler = makePtr<RecordedSampler>(parts.sampler);
            parts.sampler = sampler;
            parts.localOptimizer = makePtr<RecordedOptimizer>(parts.localOptimizer);
            Report report;
            EXPECT_FALSE(usac->run(noArray(), &report).empty());
            EXPECT_LE(report.iterations, (int)sampler->samples.size());
            EXPECT_TRUE(report.stop == STOP_SPRT || report.stop == STOP_P_NAPSAC) << report.stop;
        }
    const Scene wrong = makeScene(HOMOGRAPHY, 0, 40);
    Report report;
    EXPECT_FALSE(createUsac(wrong, Params::paper())->run(noArray(), &report).empty());
    EXPECT_GT(report.chance, 0.01);
}

TEST(Usac_Presets, marginalized)
{
    EXPECT_EQ((int)QUALITY_MAGSAC, Params::magsac().quality);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_SIGMA_CONSENSUS, Params::magsac().localOptimization);
    EXPECT_EQ((int)TERMINATION_MAGSAC, Params::magsac().termination);
    EXPECT_EQ((int)POLISHING_REWEIGHTED, Params::magsac().polishing);
    EXPECT_EQ((int)QUALITY_MAGSAC_PLUS_PLUS, Params::magsacPlusPlus().quality);
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS,
              Params::magsacPlusPlus().localOptimization);
    EXPECT_EQ((int)POLISHING_REWEIGHTED, Params::magsacPlusPlus().polishing);
}

TEST(Usac_Presets, from_method)
{
    EXPECT_EQ("", Fields::difference(Params::usacV20(), Params::fromMethod(USACV20)));
    EXPECT_EQ("", Fields::difference(Params::fast(), Params::fromMethod(USACV20_FAST)));
    EXPECT_EQ("", Fields::difference(Params::accurate(), Params::fromMethod(USACV20_ACCURATE)));
    EXPECT_EQ("", Fields::difference(Params::sorted(), Params::fromMethod(USACV20_PROSAC)));
    EXPECT_EQ("", Fields::difference(Params::magsacPlusPlus(), Params::fromMethod(USACV20_MAGSAC)));
    EXPECT_EQ("", Fields::difference(Params::parallel(), Params::fromMethod(USACV20_PARALLEL)));
    EXPECT_EQ("", Fields::difference(Params::automatic(), Params::fromMethod(USACV20_AUTO)));
    for (int method = (int)USACV20; method <= (int)USACV20_AUTO; ++method)
        EXPECT_EQ("", Fields::difference(Params::fromMethod((UsacV20Method)method),
                                         Params::fromMethod(method)));
}

TEST(Usac_Presets, from_the_parameters_of_calib3d)
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
    EXPECT_EQ((int)LOCAL_OPTIMIZATION_LO_RANSAC, params.localOptimization);
    EXPECT_EQ((int)NEIGHBORHOOD_GRID, params.neighborhood);
    other.isParallel = true;
    other.sampler = SAMPLING_PROSAC;
    params = Params::fromUsacParams(other);
    EXPECT_EQ(0, params.threads);
    EXPECT_EQ((int)SAMPLER_PROSAC, params.sampler);
    EXPECT_EQ((int)ORDERING_INPUT_ORDER, params.ordering) << "calib3d's PROSAC needs sorted points";
}

//! Sets `final_polisher`. @return false if this version of OpenCV has no such field
template <class T>
auto setPolisher(T& options, int value) -> decltype(options.final_polisher, true)
{
    options.final_polisher = (decltype(options.final_polisher))value;
    return true;
}

template <class T>
bool setPolisher(const T&, long)
{
    return false;
}

TEST(Usac_Presets, from_the_polisher_of_calib3d)
{
    const int expected[] = {POLISHING_NONE, POLISHING_LEAST_SQUARES, POLISHING_REWEIGHTED,
                            POLISHING_ROBUST};
    EXPECT_EQ((int)POLISHING_ROBUST, Params::fromUsacParams(cv::UsacParams()).polishing);
    for (int value = 0; value < 4; ++value)
    {
        cv::UsacParams other;
        if (!setPolisher(other, value))
            USAC_SKIP("this version of OpenCV has no final_polisher");
        const Params params = Params::fromUsacParams(other);
        EXPECT_EQ(expected[value], params.polishing) << value;
        EXPECT_NO_THROW(params.check());
    }
}

TEST(Usac_Presets, from_each_value_of_the_parameters_of_calib3d)
{
    const int samplers[] = {SAMPLER_UNIFORM, SAMPLER_P_NAPSAC, SAMPLER_NAPSAC, SAMPLER_PROSAC};
    const int optimizations[] = {LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_LO_RANSAC,
                                 LOCAL_OPTIMIZATION_LO_RANSAC, LOCAL_OPTIMIZATION_GRAPH_CUT,
                                 LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS};
    const int qualities[] = {QUALITY_INLIERS, QUALITY_MSAC, QUALITY_MAGSAC_PLUS_PLUS,
                             QUALITY_LMEDS};
    const int neighborhoods[] = {NEIGHBORHOOD_KNN, NEIGHBORHOOD_GRID, NEIGHBORHOOD_RADIUS};
    for (int s = 0; s < 4; ++s)
        for (int l = 0; l < 5; ++l)
            for (int q = 0; q < 4; ++q)
                for (int n = 0; n < 3; ++n)
                {
                    cv::UsacParams other;
                    other.sampler = (SamplingMethod)s;
                    other.loMethod = (LocalOptimMethod)l;
                    other.score = (ScoreMethod)q;
                    other.neighborsSearch = (NeighborSearchMethod)n;
                    const Params params = Params::fromUsacParams(other);
                    EXPECT_NO_THROW(params.check());
                    EXPECT_EQ(samplers[s], params.sampler);
                    EXPECT_EQ(q == SCORE_METHOD_LMEDS ? (int)LOCAL_OPTIMIZATION_NONE
                                                      : optimizations[l],
                              params.localOptimization);
                    EXPECT_EQ(qualities[q], params.quality);
                    EXPECT_EQ(neighborhoods[n], params.neighborhood);
                }
}

}  // namespace
}  // namespace opencv_test
