// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/results.hpp"

#include <functional>
#include <thread>

// Repeated runs must give the same bits of the model, of the mask, and of those values of the
// report that Result::exact() hashes.

namespace opencv_test {
namespace {

class UsacDeterminism : public UsacProblem
{
protected:
    //! A scene that needs so many samples that several threads share the batches of samples.
    Scene hardScene(uint64 seed = 1) const
    {
        SceneOptions options;
        options.outliers = 250;
        options.seed = seed;
        return makeScene(problem(), options);
    }

    //! All presets, each with a limit of 400 samples.
    std::vector<NamedPreset> presets() const
    {
        std::vector<NamedPreset> all = allPresets(problem());
        for (size_t i = 0; i < all.size(); ++i)
            all[i].params.maxIterations = 400;
        return all;
    }
};
INSTANTIATE_TEST_CASE_P(/**/, UsacDeterminism, testing::ValuesIn(TWO_VIEW_PROBLEMS));

TEST_P(UsacDeterminism, hundred_repeats_after_use_of_theRNG)
{
    const Scene scene = makeScene(problem());
    const Result first = resultOf(scene, Params());
    ASSERT_FALSE(first.model.empty());
    for (int i = 0; i < 100; ++i)
    {
        theRNG().state = 12345 + 77 * i;
        theRNG().next();
        EXPECT_EQ(first.exact(), resultOf(scene, Params()).exact()) << "repeat " << i;
    }
    setRNGSeed(99);
    EXPECT_EQ(first.exact(), resultOf(scene, Params()).exact());
}

TEST_P(UsacDeterminism, theRNG_is_not_used)
{
    const Scene scene = makeScene(problem());
    const std::vector<NamedPreset> all = presets();
    for (size_t p = 0; p < all.size(); ++p)
    {
        const uint64 before = theRNG().state;
        resultOf(scene, all[p].params);
        EXPECT_EQ(before, theRNG().state) << all[p].name;
    }
}

//! Runs all presets on one scene, beginning with preset number `first`.
struct Job
{
    void operator()()
    {
        for (size_t i = 0; i < presets->size(); ++i)
        {
            const size_t p = (first + i) % presets->size();
            hashes[p] = resultOf(*scene, (*presets)[p].params).exact();
        }
    }

    const Scene* scene;
    const std::vector<NamedPreset>* presets;
    size_t first;
    std::vector<uint64> hashes;
};

TEST_P(UsacDeterminism, eight_threads_at_once)
{
    const Scene scenes[2] = {makeScene(problem()), hardScene(2)};
    const std::vector<NamedPreset> all = presets();
    std::vector<Job> jobs(10);  // the first two are run alone
    for (size_t i = 0; i < jobs.size(); ++i)
    {
        jobs[i].scene = &scenes[i % 2];
        jobs[i].presets = &all;
        jobs[i].first = i * 5;
        jobs[i].hashes.resize(all.size());
    }
    jobs[0]();
    jobs[1]();
    std::vector<std::thread> threads;
    for (size_t i = 2; i < jobs.size(); ++i)
        threads.push_back(std::thread(std::ref(jobs[i])));
    for (size_t i = 0; i < threads.size(); ++i)
        threads[i].join();
    for (size_t i = 2; i < jobs.size(); ++i)
        for (size_t p = 0; p < all.size(); ++p)
            EXPECT_EQ(jobs[i % 2].hashes[p], jobs[i].hashes[p])
                << "thread " << i - 2 << ", " << all[p].name;
}

class Threads  //!< restores OpenCV's number of threads at the end
{
public:
    Threads() : before(getNumThreads()) {}
    ~Threads() { setNumThreads(before); }

private:
    const int before;
};

const int THREADS[] = {0, 1, 2, 8};

TEST_P(UsacDeterminism, any_number_of_threads_for_every_preset)
{
    const Threads threads;
    const Scene scene = hardScene();
    const std::vector<NamedPreset> all = presets();
    for (size_t p = 0; p < all.size(); ++p)
    {
        Params params = all[p].params;
        params.threads = 1;
        const uint64 expected = resultOf(scene, params).exact();
        for (int i = 0; i < 4; ++i)
        {
            setNumThreads(THREADS[i]);
            params.threads = THREADS[3 - i];
            EXPECT_EQ(expected, resultOf(scene, params).exact())
                << all[p].name << ", Params::threads " << params.threads << ", setNumThreads "
                << THREADS[i];
        }
    }
}

}
}  // namespace
