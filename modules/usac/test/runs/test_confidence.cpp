// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "termination/termination.hpp"

namespace opencv_test {
namespace {

const int SEEDS = 1000;

/** Two homographies without noise, among wrong matches. The true one has a few more matches than
the other, the decoy. If a criterion ends the search too early, the result is often the decoy. The
rows are sorted, best first: matches of the true model, of the decoy and wrong ones alternate
evenly, with the true matches slightly earlier. */
struct Rivals
{
    Rivals(int right, int decoys, int outliers)
    {
        SceneOptions options;
        options.noise = 0;
        options.inliers = right;
        options.outliers = outliers;
        const Scene all = makeScene(HOMOGRAPHY, options);
        options.inliers = decoys;
        options.outliers = 0;
        options.seed = 7;
        const Scene other = makeScene(HOMOGRAPHY, options);
        scene = all;
        std::vector<std::pair<double, std::pair<int, int>>> order;  // position, (scene, row)
        int seen[2] = {0, 0};
        for (int i = 0; i < all.size(); ++i)
        {
            const int part = all.truth[i] ? 0 : 1;
            order.push_back(std::make_pair((seen[part]++ + 0.3 * part) / (part ? outliers : right),
                                           std::make_pair(0, i)));
        }
        for (int i = 0; i < decoys; ++i)
            order.push_back(std::make_pair((i + 0.2) / decoys, std::make_pair(1, i)));
        std::sort(order.begin(), order.end());
        scene.points1.clear();
        scene.points2.clear();
        scene.truth.clear();
        for (size_t i = 0; i < order.size(); ++i)
        {
            const int from = order[i].second.first, row = order[i].second.second;
            scene.points1.push_back((from ? other : all).points1[row]);
            scene.points2.push_back((from ? other : all).points2[row]);
            scene.truth.push_back(from == 0 && all.truth[row]);
        }
        scene.clean1 = scene.points1;
        scene.clean2 = scene.points2;
        scene.onPlane = scene.truth;
        decoyModel = other.model;
    }

    int size() const { return scene.size(); }

    //! The rows that are inliers of the true model, or of the decoy if `right` is false.
    std::vector<uchar> inliers(bool right, double threshold) const
    {
        std::vector<uchar> mask;
        for (int i = 0; i < size(); ++i)
            mask.push_back(pixelError(scene, right ? scene.model : decoyModel, scene.points1[i],
                                      scene.points2[i]) <= threshold);
        return mask;
    }

    Scene scene;
    Matx33d decoyModel;
};

//! Parameters to test a criterion alone, without local optimization, polishing and degeneracy
//! checks.
Params plainParams(int termination, VerificationType verification = VERIFICATION_NONE)
{
    Params params;
    params.confidence = 0.9;  // low, so that there are enough failures to count
    params.maxIterations = 1000000;
    params.sampler = SAMPLER_UNIFORM;
    params.quality = QUALITY_INLIERS;
    params.verification = verification;
    params.localOptimization = LOCAL_OPTIMIZATION_NONE;
    params.termination = termination;
    params.degeneracy = 0;
    params.polishing = POLISHING_NONE;
    return params;
}

//! The results of SEEDS runs with different seeds.
struct Runs
{
    Runs(const Rivals& rivals, Params params)
        : wrong(0), inliers(SEEDS), iterations(SEEDS), stop(STOP_NOT_RUN)
    {
        for (params.seed = 0; params.seed < SEEDS; ++params.seed)
        {
            Report report;
            const Mat model = estimate(rivals.scene, params, noArray(), &report);
            wrong += !(modelError(rivals.scene, model) < 0.1);
            inliers[params.seed] = report.inliers;
            iterations[params.seed] = report.iterations;
            stop = params.seed == 0 || stop == report.stop ? report.stop : (int)STOP_NOT_RUN;
        }
    }

    //! There must be no more failures than the confidence allows, and about as many as expected in
    //! this scene.
    void check(double expected, int reason) const
    {
        const double deviation = std::sqrt(0.1 * 0.9 * SEEDS);
        EXPECT_LE(wrong, 0.1 * SEEDS + 3.5 * deviation);
        EXPECT_NEAR(expected * SEEDS, wrong, 4.5 * deviation);
        EXPECT_EQ(reason, stop) << "the same reason must end all runs";
    }

    int wrong;
    std::vector<int> inliers, iterations;
    int stop;
};

//! Probability that m different points of n are all inliers.
double subsets(double inliers, int n, int m)
{
    double p = 1;
    for (int i = 0; i < m; ++i)
        p *= (inliers - i) / (n - i);
    return p;
}

//! Number of samples that a criterion requires for a confidence of 0.9 if a sample is good with
//! probability `p`.
double closedForm(double p) { return std::ceil(std::log(0.1) / std::log1p(-p)); }

/** Probability that the decoy ends the search: the decoy, but not the true model, is found in the
first `samples` samples, after which the criterion ends the search.
@param more number of points that must be inliers in addition to the sample */
double failureRate(const Rivals& rivals, double threshold, double samples, int more = 0)
{
    double p[2];
    for (int right = 0; right < 2; ++right)
    {
        const std::vector<uchar> mask = rivals.inliers(right != 0, threshold);
        const int count = (int)std::count(mask.begin(), mask.end(), 1);
        p[right] = subsets(count, rivals.size(), 4) * subsets(count, rivals.size(), more);
    }
    EXPECT_GT(p[1], p[0]) << "the right model must have more inliers";
    return std::pow(1 - p[1], samples) - std::pow(1 - p[0] - p[1], samples);
}

int count(const std::vector<uchar>& mask) { return (int)std::count(mask.begin(), mask.end(), 1); }

//! The standard criterion with the formula for samples with replacement (kind 0) and with the exact
//! formula (TERMINATION_EXACT; kinds 1 to 3). With kinds 2 and 3, a T(d,d) test with d = 1 or 2
//! rejects some good models.
TEST(Usac_Confidence, standard)
{
    for (int kind = 0; kind < 4; ++kind)
    {
        const bool exact = kind > 0;
        const int d = kind > 1 ? kind - 1 : 0;
        const Rivals rivals = kind == 1 ? Rivals(19, 18, 9) : Rivals(101, 100, 99);
        Params params = plainParams(exact ? TERMINATION_STANDARD | TERMINATION_EXACT
                                          : TERMINATION_STANDARD,
                                    d ? VERIFICATION_TDD : VERIFICATION_NONE);
        params.tddPoints = std::max(d, 1);
        const int n = rivals.size();
        const Runs runs(rivals, params);
        int asComputed = 0;
        for (int i = 0; i < SEEDS; ++i)
        {
            const int I = runs.inliers[i];
            const double k = closedForm(exact ? subsets(I, n, 4) * subsets(I, n, d)
                                              : std::pow(I / (double)n, 4));
            EXPECT_GE(runs.iterations[i], k) << kind;
            // if not equal, the model was found after more than k samples
            asComputed += runs.iterations[i] == k;
        }
        EXPECT_GT(asComputed, SEEDS * 0.85) << kind;
        const int decoys = count(rivals.inliers(false, params.threshold));
        const double last = closedForm(exact ? subsets(decoys, n, 4) * subsets(decoys, n, d)
                                             : std::pow(decoys / (double)n, 4));
        runs.check(failureRate(rivals, params.threshold, last, d), STOP_STANDARD);
    }
}

//! Number of inliers that a homography needs, by P-NAPSAC's criterion, to be significantly better
//! than one with `inliers`.
double significant(double inliers, double relaxation)
{
    const double beside = inliers - 4;
    return 4 + beside * (1 + relaxation * beside / (beside + 30));
}

//! P-NAPSAC's criterion: a significantly better model must not be missed more often than the
//! confidence allows.
TEST(Usac_Confidence, pNapsac)
{
    const Rivals rivals(110, 99, 91);
    Params params = plainParams(TERMINATION_P_NAPSAC | TERMINATION_EXACT);
    params.relaxation = 0.1;
    const int n = rivals.size();
    const Runs runs(rivals, params);
    int asComputed = 0;
    for (int i = 0; i < SEEDS; ++i)
    {
        const double k = closedForm(subsets(significant(runs.inliers[i], params.relaxation), n, 4));
        EXPECT_GE(runs.iterations[i], k);
        asComputed += runs.iterations[i] == k;
    }
    EXPECT_GT(asComputed, SEEDS * 0.7);
    const int decoys = count(rivals.inliers(false, params.threshold));
    runs.check(failureRate(rivals, params.threshold,
                           closedForm(subsets(significant(decoys, params.relaxation), n, 4))),
               STOP_P_NAPSAC);
}

//! SPRT rejects some good models, so that its criterion requires more samples than the standard
//! criterion. The difference is small, because SPRT rarely rejects a good model if the solver is as
//! expensive as here.
TEST(Usac_Confidence, sprt)
{
    const Rivals rivals(202, 200, 198);
    const Params params = plainParams(TERMINATION_SPRT | TERMINATION_EXACT, VERIFICATION_SPRT);
    const int n = rivals.size();
    const Runs runs(rivals, params);
    int asComputed = 0;
    for (int i = 0; i < SEEDS; ++i)
    {
        const double k = closedForm(subsets(runs.inliers[i], n, 4));
        EXPECT_GE(runs.iterations[i], k);
        asComputed += runs.iterations[i] <= 1.1 * k + 1;
    }
    EXPECT_GT(asComputed, SEEDS * 0.8);
    const int decoys = count(rivals.inliers(false, params.threshold));
    runs.check(failureRate(rivals, params.threshold, closedForm(subsets(decoys, n, 4))), STOP_SPRT);
}

//! PROSAC's criterion chooses a number n* of best points. Among these points, the criterion must
//! not miss the true model more often than the confidence allows, and it must end the search after
//! the number of samples that prosacSamples() computes.
TEST(Usac_Confidence, prosac)
{
    const Rivals rivals(102, 100, 98);
    for (SamplerType sampler : {SAMPLER_PROSAC, SAMPLER_P_NAPSAC})
    {
        Params params = plainParams(TERMINATION_PROSAC | TERMINATION_EXACT);
        params.sampler = sampler;
        params.ordering = ORDERING_INPUT_ORDER;
        params.orderedEvery = 1;
        const Ptr<Usac> usac = createUsac(rivals.scene, params);
        const double ratio = usac->points().problem->randomInlierRatio(usac->points());
        int samples[2], length[2];
        for (int right = 0; right < 2; ++right)
        {
            const std::vector<uchar> inliers = rivals.inliers(right != 0, params.threshold);
            samples[right] = prosacSamples(inliers.data(), 0, (int)inliers.size(), 4,
                                           sampler == SAMPLER_PROSAC ? 1 : 0.75, ratio,
                                           std::log(0.1), true, length[right]);
        }
        const Runs runs(rivals, params);
        int asComputed = 0;
        for (int i = 0; i < SEEDS; ++i)
            asComputed += runs.iterations[i] == samples[0] || runs.iterations[i] == samples[1];
        EXPECT_LE(runs.wrong, 0.1 * SEEDS + 3.5 * std::sqrt(0.1 * 0.9 * SEEDS));
        // the local samples of P-NAPSAC find both models earlier than computed
        if (sampler == SAMPLER_PROSAC)
        {
            EXPECT_GE(runs.wrong, 0.03 * SEEDS);
        }
        EXPECT_EQ((int)STOP_PROSAC, runs.stop);
        EXPECT_GT(asComputed, SEEDS * 0.8);
    }
}

}
}  // namespace
