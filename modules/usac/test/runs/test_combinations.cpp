// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/contracts.hpp"
#include "support/params_fields.hpp"
#include "support/real_set.hpp"

#include <set>

// Tests of each pair of option values, and on demand of all combinations, on real matches.

namespace opencv_test {
namespace {

//! A field of Params and the values that it can have.
struct Option
{
    std::string name;
    std::vector<int> values;
};

/** All fields of Params that select variants, with their values: all subsets of the degeneracy
checks, and each termination criterion alone. TERMINATION_EXACT is left out, because it only
modifies the criteria. */
std::vector<Option> allOptions()
{
    std::vector<Option> options;
    const Fields fields;
    for (size_t i = 0; i < fields.ints.size(); ++i)
    {
        const NamedField& field = fields.ints[i];
        if (field.values.kind != FIELD_OPTION && field.values.kind != FIELD_FLAGS)
            continue;
        Option option = {field.name, std::vector<int>()};
        const bool criteria = option.name == "termination";
        for (int value = (int)field.values.low; value <= (int)field.values.high; ++value)
            if (!criteria ||
                ((value & (value - 1)) == 0 && value != 0 && value != TERMINATION_EXACT))
                option.values.push_back(value);
        options.push_back(option);
    }
    return options;
}

const std::vector<Option> OPTIONS = allOptions();
const int OPTION_COUNT = (int)OPTIONS.size();

int numberOf(const char* name)
{
    int i = 0;
    while (OPTIONS[i].name != name)
        ++i;
    return i;
}

typedef std::vector<int> Choice;  //!< index of the value of each option

int valueOf(int option, int k) { return OPTIONS[option].values[k]; }
int countOf(int option) { return (int)OPTIONS[option].values.size(); }

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
        text += cv::format("%s=%d ", OPTIONS[i].name.c_str(), valueOf(i, choice[i]));
    return text;
}

//! Factor of the error limits of arenaOf() for choices without polishing. Of 1500 random choices,
//! three without polishing exceeded the limits of arenaOf(): two without local optimization (3.1
//! pixels for H, 1.4 pixels for E) and one with sigma-consensus (3.07 pixels for H).
const double UNPOLISHED = 1.5;

//! The best 35 % of the matches of a real scene, the threshold, and the largest error of a correct
//! model (both in pixels).
struct TestArena
{
    TestArena(const char* name, double threshold_, double error_)
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
        for (int i = 0; i < OPTION_COUNT; ++i)
            Assignment(params, OPTIONS[i].name, valueOf(i, choice[i]));
        // TERMINATION_ORDER is for use together with another criterion
        if (params.termination == TERMINATION_ORDER)
            params.termination |= TERMINATION_STANDARD;
        params.scores = params.scoreOrder == SCORES_HIGHER_IS_BETTER ? probabilities : set.scores;
        return params;
    }

    void expectRight(const Choice& choice) const
    {
        const Params params = paramsOf(choice);
        Mat mask;
        Report report;
        const Mat model = set.estimateWith(params, mask, report);
        EXPECT_LT(set.error(model), (params.polishing == POLISHING_NONE ? UNPOLISHED : 1) * error)
            << describe(choice) << report.describe();
        EXPECT_EQ(countNonZero(mask), report.inliers);
    }

    RealSet set;
    double threshold, error;
    std::vector<float> probabilities;
};

TestArena arenaOf(int problem)
{
    // Measured errors in pixels, over choices that contain all pairs of option values: at most 2.1
    // (H), 1.6 (F) and 0.6 (E), with medians 0.9, 0.6 and 0.15.
    return problem == HOMOGRAPHY    ? TestArena("graf", 2, 3)
           : problem == FUNDAMENTAL ? TestArena("office01_F", 1, 2.4)
                                    : TestArena("office01_E", 1, 1.2);
}

typedef std::pair<std::pair<int, int>, std::pair<int, int>> Pair;  //!< two pairs (option, value)

Pair pairOf(int i, int a, int j, int b)
{
    return std::make_pair(std::make_pair(i, a), std::make_pair(j, b));
}

std::set<Pair> allPairs()
{
    std::set<Pair> pairs;
    for (int i = 0; i < OPTION_COUNT; ++i)
        for (int j = i + 1; j < OPTION_COUNT; ++j)
            for (int a = 0; a < countOf(i); ++a)
                for (int b = 0; b < countOf(j); ++b)
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

//! Draws random choices that contain `pair`. @return among those that Params::check() accepts, the
//! one with the most pairs of `open`, or an empty choice if it accepts none
Choice bestChoice(const TestArena& arena, const Pair& pair, const std::set<Pair>& open, RNG& rng)
{
    Choice best;
    int most = 0;
    for (int attempt = 0, found = 0; attempt < 3000 && found < 60; ++attempt)
    {
        Choice choice(OPTION_COUNT);
        for (int i = 0; i < OPTION_COUNT; ++i)
            choice[i] = rng.uniform(0, countOf(i));
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

//! Finds choices that together contain every possible pair of option values. @return the impossible
//! pairs: those for which bestChoice() finds no choice
std::set<Pair> coverPairs(const TestArena& arena, std::vector<Choice>& choices)
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
    void SetUp() CV_OVERRIDE { redirectError(ignoreErrors); }  // Params::check throws often
    void TearDown() CV_OVERRIDE { redirectError(0); }
};

TEST_P(UsacCombinations, each_pair_of_options)
{
    const TestArena arena = arenaOf(GetParam());
    std::vector<Choice> choices;
    const std::set<Pair> impossible = coverPairs(arena, choices);
    // the 7 values of localOptimization and the 8 of degeneracy alone need 56 choices
    EXPECT_GE(choices.size(), (size_t)56);
    for (size_t i = 0; i < choices.size(); ++i)
        arena.expectRight(choices[i]);

    // values of enumerations and sets of checks equal their indices, because they begin with 0; the
    // values of `termination` are single bits
    const int sampler = numberOf("sampler"), ordering = numberOf("ordering"),
              scoreOrder = numberOf("scoreOrder"), quality = numberOf("quality"),
              verification = numberOf("verification"), local = numberOf("localOptimization"),
              termination = numberOf("termination"), degeneracy = numberOf("degeneracy");
    std::set<Pair> expected;
    for (int v = VERIFICATION_SPRT; v <= VERIFICATION_TDD; ++v)
        expected.insert(pairOf(quality, QUALITY_LMEDS, verification, v));
    for (int l = LOCAL_OPTIMIZATION_GRAPH_CUT; l < countOf(local); ++l)
        expected.insert(pairOf(quality, QUALITY_LMEDS, local, l));
    const int sprt = 1, prosac = 3, magsac = 4;  // indices of the bits
    expected.insert(pairOf(quality, QUALITY_LMEDS, termination, sprt));
    expected.insert(pairOf(quality, QUALITY_LMEDS, termination, prosac));
    expected.insert(pairOf(quality, QUALITY_LMEDS, termination, magsac));
    for (int d = 0; d < countOf(degeneracy); ++d)
        if (d & DEGENERACY_DEGENSAC)
            expected.insert(pairOf(quality, QUALITY_LMEDS, degeneracy, d));
    expected.insert(pairOf(verification, VERIFICATION_NONE, termination, sprt));
    expected.insert(pairOf(verification, VERIFICATION_TDD, termination, sprt));
    expected.insert(pairOf(sampler, SAMPLER_UNIFORM, termination, prosac));
    expected.insert(pairOf(sampler, SAMPLER_NAPSAC, termination, prosac));
    expected.insert(pairOf(sampler, SAMPLER_IMPORTANCE, termination, prosac));
    expected.insert(pairOf(sampler, SAMPLER_IMPORTANCE, scoreOrder, SCORES_LOWER_IS_BETTER));
    expected.insert(pairOf(ordering, ORDERING_DENSITY, termination, prosac));
    expected.insert(pairOf(ordering, ORDERING_NONE, termination, prosac));
    EXPECT_TRUE(expected == impossible)
        << impossible.size() << " pairs are impossible, " << expected.size() << " documented";
}

//! All combinations, which take hours. Run with --gtest_filter=*all_combinations*
//! --test_tag_enable=verylong.
TEST_P(UsacCombinations, all_combinations)
{
    applyTestTag(CV_TEST_TAG_VERYLONG);
    const TestArena arena = arenaOf(GetParam());
    Choice choice(OPTION_COUNT, 0);
    for (int option = 0; option < OPTION_COUNT;)
    {
        if (isPossible(arena.paramsOf(choice)))
            arena.expectRight(choice);
        for (option = 0; option < OPTION_COUNT && ++choice[option] == countOf(option); ++option)
            choice[option] = 0;
    }
}

INSTANTIATE_TEST_CASE_P(/**/, UsacCombinations,
                        testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL, (int)ESSENTIAL));

}
}  // namespace
