// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_contracts.hpp"
#include "real_set.hpp"

#include <set>

// Each pair of options, and on demand all combinations, on real matches.

namespace opencv_test {
namespace {

//! One field of Params and the values that it can have.
struct Option
{
    const char* name;
    int Params::*field;
    int values;  //!< 0 .. values - 1
    bool bits;   //!< the values are 1 << k
};

const Option OPTIONS[] = {{"sampler", &Params::sampler, 5, false},
                          {"ordering", &Params::ordering, 4, false},
                          {"neighborhood", &Params::neighborhood, 3, false},
                          {"residual", &Params::residual, 2, false},
                          {"quality", &Params::quality, 6, false},
                          {"verification", &Params::verification, 3, false},
                          {"localOptimization", &Params::localOptimization, 6, false},
                          {"termination", &Params::termination, 5, true},
                          {"degeneracy", &Params::degeneracy, 8, false},
                          {"polishing", &Params::polishing, 4, false}};
const int OPTION_COUNT = sizeof(OPTIONS) / sizeof(OPTIONS[0]);

typedef std::vector<int> Choice;  //!< number of the value of each option

int valueOf(int option, int k) { return OPTIONS[option].bits ? 1 << k : k; }

bool isPossible(const Params& params)
{
    try
    {
        params.check();
        return true;
    }
    catch (const cv::Exception&)
    {
        return false;
    }
}

std::string describe(const Choice& choice)
{
    std::string text;
    for (int i = 0; i < OPTION_COUNT; ++i)
        text += cv::format("%s=%d ", OPTIONS[i].name, valueOf(i, choice[i]));
    return text;
}

//! A real scene and what counts as a right model of it.
struct Arena
{
    Arena(const char* name, double threshold_, double error_)
        : set(RealSet(name).sorted(0.35)), threshold(threshold_), error(error_)
    {
        for (size_t i = 0; i < set.scores.size(); ++i)
            probabilities.push_back(1 - set.scores[i]);
    }

    Params paramsOf(const Choice& choice) const
    {
        Params params;
        params.threshold = threshold;
        params.maxIterations = set.problem == HOMOGRAPHY ? 5000 : 2000;
        params.confidence = 0.9999;
        params.scores = probabilities;
        params.scoreOrder = SCORES_HIGHER_IS_BETTER;
        for (int i = 0; i < OPTION_COUNT; ++i)
            params.*OPTIONS[i].field = valueOf(i, choice[i]);
        return params;
    }

    void expectRight(const Choice& choice) const
    {
        const Params params = paramsOf(choice);
        Mat mask;
        Report report;
        const Mat model = set.estimateWith(params, mask, report);
        // the points of one place, which NAPSAC draws, determine a model badly, and so does a sample that nothing
        // follows
        const double slack = (params.sampler == SAMPLER_NAPSAC ? 12 : 1) * (params.polishing == POLISHING_NONE ? 3 : 1);
        EXPECT_LT(set.error(model), slack * error) << describe(choice) << report.describe();
        EXPECT_EQ(countNonZero(mask), report.inliers);
    }

    RealSet set;
    double threshold, error;
    std::vector<float> probabilities;
};

Arena arenaOf(int problem)
{
    return problem == HOMOGRAPHY    ? Arena("graf", 2, 3)
           : problem == FUNDAMENTAL ? Arena("office01_F", 1, 4)
                                    : Arena("office01_E", 1, 3);
}

typedef std::pair<std::pair<int, int>, std::pair<int, int>> Pair;  //!< option and value, twice

Pair pairOf(int i, int a, int j, int b) { return std::make_pair(std::make_pair(i, a), std::make_pair(j, b)); }

std::set<Pair> allPairs()
{
    std::set<Pair> pairs;
    for (int i = 0; i < OPTION_COUNT; ++i)
        for (int j = i + 1; j < OPTION_COUNT; ++j)
            for (int a = 0; a < OPTIONS[i].values; ++a)
                for (int b = 0; b < OPTIONS[j].values; ++b)
                    pairs.insert(pairOf(i, a, j, b));
    return pairs;
}

int uncovered(const Choice& choice, const std::set<Pair>& open)
{
    int count = 0;
    for (int i = 0; i < OPTION_COUNT; ++i)
        for (int j = i + 1; j < OPTION_COUNT; ++j)
            count += (int)open.count(pairOf(i, choice[i], j, choice[j]));
    return count;
}

//! The possible choice with a pair that has the most uncovered pairs, of many random ones; empty if there is none.
Choice bestChoice(const Arena& arena, const Pair& pair, const std::set<Pair>& open, RNG& rng)
{
    Choice best;
    int most = 0;
    for (int attempt = 0, found = 0; attempt < 3000 && found < 60; ++attempt)
    {
        Choice choice(OPTION_COUNT);
        for (int i = 0; i < OPTION_COUNT; ++i)
            choice[i] = rng.uniform(0, OPTIONS[i].values);
        choice[pair.first.first] = pair.first.second;
        choice[pair.second.first] = pair.second.second;
        const int count = uncovered(choice, open);
        if (!isPossible(arena.paramsOf(choice)))
            continue;
        ++found;
        if (count > most)
        {
            most = count;
            best = choice;
        }
    }
    return best;
}

//! Choices that cover all possible pairs; the impossible ones are returned.
std::set<Pair> coverPairs(const Arena& arena, std::vector<Choice>& choices)
{
    std::set<Pair> open = allPairs(), impossible;
    RNG rng(1);
    while (!open.empty())
    {
        const Pair pair = *open.begin();
        const Choice choice = bestChoice(arena, pair, open, rng);
        if (choice.empty())
        {
            impossible.insert(pair);
            open.erase(pair);
            continue;
        }
        choices.push_back(choice);
        for (int i = 0; i < OPTION_COUNT; ++i)
            for (int j = i + 1; j < OPTION_COUNT; ++j)
                open.erase(pairOf(i, choice[i], j, choice[j]));
    }
    return impossible;
}

int ignoreErrors(int, const char*, const char*, const char*, int, void*) { return 0; }

class UsacCombinations : public testing::TestWithParam<int>
{
protected:
    void SetUp() CV_OVERRIDE { redirectError(ignoreErrors); }  // Params::check is asked often
    void TearDown() CV_OVERRIDE { redirectError(0); }
};

TEST_P(UsacCombinations, each_pair_of_options)
{
    const Arena arena = arenaOf(GetParam());
    std::vector<Choice> choices;
    const std::set<Pair> impossible = coverPairs(arena, choices);
    EXPECT_GT(choices.size(), (size_t)30);  // six by six values make as many
    for (size_t i = 0; i < choices.size(); ++i)
        arena.expectRight(choices[i]);

    enum { SAMPLER, ORDERING, QUALITY = 4, VERIFICATION, LOCAL_OPTIMIZATION, TERMINATION, DEGENERACY };
    std::set<Pair> expected;
    for (int v = VERIFICATION_SPRT; v <= VERIFICATION_TDD; ++v)
        expected.insert(pairOf(QUALITY, QUALITY_LMEDS, VERIFICATION, v));
    for (int l = LOCAL_OPTIMIZATION_GRAPH_CUT; l < OPTIONS[LOCAL_OPTIMIZATION].values; ++l)
        expected.insert(pairOf(QUALITY, QUALITY_LMEDS, LOCAL_OPTIMIZATION, l));
    const int sprt = 1, prosac = 3, magsac = 4;  // numbers of the bits
    expected.insert(pairOf(QUALITY, QUALITY_LMEDS, TERMINATION, sprt));
    expected.insert(pairOf(QUALITY, QUALITY_LMEDS, TERMINATION, prosac));
    expected.insert(pairOf(QUALITY, QUALITY_LMEDS, TERMINATION, magsac));
    for (int d = 0; d < OPTIONS[DEGENERACY].values; ++d)
        if (d & DEGENERACY_DEGENSAC)
            expected.insert(pairOf(QUALITY, QUALITY_LMEDS, DEGENERACY, d));
    expected.insert(pairOf(VERIFICATION, VERIFICATION_NONE, TERMINATION, sprt));
    expected.insert(pairOf(VERIFICATION, VERIFICATION_TDD, TERMINATION, sprt));
    expected.insert(pairOf(SAMPLER, SAMPLER_UNIFORM, TERMINATION, prosac));
    expected.insert(pairOf(SAMPLER, SAMPLER_NAPSAC, TERMINATION, prosac));
    expected.insert(pairOf(SAMPLER, SAMPLER_IMPORTANCE, TERMINATION, prosac));
    expected.insert(pairOf(ORDERING, ORDERING_DENSITY, TERMINATION, prosac));
    expected.insert(pairOf(ORDERING, ORDERING_NONE, TERMINATION, prosac));
    EXPECT_TRUE(expected == impossible) << impossible.size() << " pairs are impossible, " << expected.size()
                                        << " documented";
}

//! All combinations; hours. Run with --gtest_filter=*all_combinations* --test_tag_enable=verylong.
TEST_P(UsacCombinations, all_combinations)
{
    applyTestTag(CV_TEST_TAG_VERYLONG);
    const Arena arena = arenaOf(GetParam());
    Choice choice(OPTION_COUNT, 0);
    for (int option = 0; option < OPTION_COUNT;)
    {
        if (isPossible(arena.paramsOf(choice)))
            arena.expectRight(choice);
        for (option = 0; option < OPTION_COUNT && ++choice[option] == OPTIONS[option].values; ++option)
            choice[option] = 0;
    }
}

INSTANTIATE_TEST_CASE_P(/**/, UsacCombinations, testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

}
}  // namespace
