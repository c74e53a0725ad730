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
