// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_DRAW_HPP
#define OPENCV_USACV20_TEST_DRAW_HPP

#include "test_precomp.hpp"

namespace opencv_test {

//! A sampler with everything that it needs. Each call of next() draws its next sample, as Ransac
//! does.
class Draw
{
public:
    Draw(ProblemType problem, int count, const Ptr<Sampler>& sampler_, uint64 seed_ = 0,
         const Params& params_ = ordered())
        : params(params_), sampler(sampler_), scene(makeScene(problem, optionsOf(count))),
          usac(createUsac(scene, params)),
          context(usac->points(), usac->components(), params, arena),
          m(usac->components().minimalSolver->sampleSize()), seed(seed_)
    {
        order.resize(count);
        for (int i = 0; i < count; ++i)  // a permutation unless 11 divides count
            order[i] = (i * 11 + 3) % count;
        state.order = order.data();
        usac->components().start(context);
        sampler->start(context);
    }

    //! Parameters with which every sample follows the rule of the sampler. By default, most would
    //! be uniform (Params::orderedEvery).
    static Params ordered()
    {
        Params result;
        result.orderedEvery = 1;
        return result;
    }

    void next()
    {
        state.rng = Rng(seed, state.iteration);
        sampler->sample(context, state, sample);
        ++state.iteration;
    }

    //! Returns false if an index of the sample is out of range or repeated.
    bool valid() const
    {
        for (int i = 0; i < m; ++i)
        {
            if (sample[i] < 0 || sample[i] >= context.points.size)
                return false;
            for (int j = 0; j < i; ++j)
                if (sample[i] == sample[j])
                    return false;
        }
        return true;
    }

    bool contains(int point) const { return std::find(sample, sample + m, point) != sample + m; }

    static SceneOptions optionsOf(int count)
    {
        SceneOptions options;
        options.inliers = count - count / 3;
        options.outliers = count / 3;
        return options;
    }

    Params params;
    Ptr<Sampler> sampler;
    const Scene scene;
    const Ptr<Usac> usac;
    Arena arena;
    const Context context;
    const int m;
    State state;
    std::vector<int> order;
    int sample[MAX_SAMPLE_SIZE];

private:
    const uint64 seed;
};

//! Distance of the chi-squared statistic of equally likely counts from its mean (the degrees of
//! freedom), in standard deviations. `total` is the sum of the counts.
inline double deviation(const std::vector<int>& counts, double total)
{
    const double expected = total / counts.size(), freedom = counts.size() - 1.;
    double sum = 0;
    for (size_t i = 0; i < counts.size(); ++i)
        sum += (counts[i] - expected) * (counts[i] - expected) / expected;
    return (sum - freedom) / std::sqrt(2 * freedom);
}

/** The values T'_n, n = 0 .. N, of PROSAC as published, from the product that defines T_n. The
values T_n are written to `uniform`. T_N is 200000 or, if smaller, the number of possible
samples. */
inline std::vector<double> publishedGrowth(int N, int m, std::vector<double>* uniform = 0)
{
    long double subsets = 1;
    for (int i = 0; i < m; ++i)
        subsets = subsets * (N - i) / (i + 1);
    std::vector<long double> T(N + 1, std::min(subsets, 200000.L));
    for (int n = 0; n <= N; ++n)
        for (int i = 0; i < m; ++i)
            T[n] *= (long double)std::max(n - i, 0) / (N - i);
    std::vector<double> limit(N + 1, 0.);
    limit[m] = 1;
    for (int n = m; n < N; ++n)
        limit[n + 1] = limit[n] + (double)std::ceil((T[n + 1] - T[n]) * (1 - 1e-12L));
    if (uniform)
        uniform->assign(T.begin(), T.end());
    return limit;
}

}  // namespace opencv_test

#endif
