// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Tests of the minimal solvers of H, F and E and of the check of H that process several samples at
// once, each in one lane of the vector registers (SIMD). Each instruction set has such functions,
// called kernels.

#include "test_precomp.hpp"
#include "support/problem_objects.hpp"
#include "lanes/lane_kernels.hpp"

#include <atomic>

namespace opencv_test {
namespace {

enum { TOGETHER = MinimalSolver::MAX_TOGETHER };

struct NamedKernels
{
    const char* name;
    lanes::Kernels kernels;
};

//! The baseline kernels, the kernels that the module chooses for one sample and for TOGETHER
//! samples, and, if this processor has AVX2, the kernels for AVX2.
std::vector<NamedKernels> availableKernels()
{
    std::vector<NamedKernels> result;
    const NamedKernels all[] = {{"baseline", lanes::baselineKernels()},
                                {"for few", lanes::kernelsFor(1)},
                                {"for many", lanes::kernelsFor(TOGETHER)}};
    result.assign(all, all + 3);
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
    {
        const NamedKernels avx2 = {"AVX2", lanes::avx2Kernels()};
        result.push_back(avx2);
    }
#endif
    return result;
}

//! Samples of true and wrong matches. Some samples are degenerate, because points are repeated.
struct Samples
{
    Samples(ProblemType problem_, double planeFraction)
        : problem(problem_), count(4000), size(problem == ESSENTIAL     ? 5
                                               : problem == FUNDAMENTAL ? 7
                                                                        : 4)
    {
        SceneOptions options;
        options.seed = 5;
        options.setSize(200, 0.5);
        options.planeFraction = planeFraction;
        usac = createUsac(makeScene(problem, options), Params());
        indices.resize(count * MAX_SAMPLE_SIZE);
        for (int i = 0; i < count; ++i)
        {
            int* const own = &indices[i * MAX_SAMPLE_SIZE];
            Rng(2, i).distinct(points().size, size, own);
            if (i % 9 == 0)
                own[1] = own[0];  // degenerate: one point is repeated
            if (i % 31 == 0)
                std::fill(own, own + size, own[0]);
            all.push_back(own);
        }
    }

    const Correspondences& points() const { return usac->points(); }
    SolverKernel solverOf(const lanes::Kernels& kernels) const
    {
        return problem == ESSENTIAL     ? kernels.fivePoints
               : problem == FUNDAMENTAL ? kernels.sevenPoints
                                        : kernels.fourPoints;
    }

    const ProblemType problem;
    const int count, size;
    Ptr<Usac> usac;
    std::vector<int> indices;
    std::vector<const int*> all;
};

typedef std::vector<std::vector<double>> Solutions;  //!< the entries of all models of each sample

//! Solves all samples with one kernel: the first `apart` samples one by one, the others in groups
//! of `together` samples.
Solutions solutions(const Samples& samples, SolverKernel solver, int together, int apart = 0)
{
    Solutions result;
    double models[TOGETHER][MAX_MODELS][9];
    int found[TOGETHER];
    for (int i = 0; i < samples.count;)
    {
        const int wanted = i < apart ? 1 : together, count = std::min(wanted, samples.count - i);
        solver(samples.points(), &samples.all[i], count, models, found);
        for (int k = 0; k < count; ++k)
            result.push_back(
                std::vector<double>(&models[k][0][0], &models[k][0][0] + 9 * found[k]));
        i += count;
    }
    return result;
}

Solutions expectedOf(const Samples& samples)
{
    return solutions(samples, samples.solverOf(lanes::baselineKernels()), 1);
}

//! Number of samples whose models differ between `a` and `b` in at least one bit.
int different(const Solutions& a, const Solutions& b)
{
    int result = a.size() != b.size();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        result += a[i].size() != b[i].size() ||
                  (!a[i].empty() &&
                   memcmp(a[i].data(), b[i].data(), a[i].size() * sizeof(double)) != 0);
    return result;
}

//! The test parameters are a problem and the fraction of true matches on a plane.
typedef testing::TestWithParam<std::tuple<int, double>> Usac_Lanes;

ProblemType problemOf(const std::tuple<int, double>& parameters)
{
    return (ProblemType)std::get<0>(parameters);
}

TEST_P(Usac_Lanes, sameBitsWithEveryInstructionSet)
{
    const Samples samples(problemOf(GetParam()), std::get<1>(GetParam()));
    const Solutions expected = expectedOf(samples);
    size_t numbers = 0;
    for (size_t i = 0; i < expected.size(); ++i)
        numbers += expected[i].size();
    EXPECT_GT(numbers, 9000u);
    const std::vector<NamedKernels> all = availableKernels();
    for (size_t k = 0; k < all.size(); ++k)
    {
        const SolverKernel solver = samples.solverOf(all[k].kernels);
        EXPECT_EQ(0, different(expected, solutions(samples, solver, TOGETHER))) << all[k].name;
    }
}

//! The models of a sample must not depend on how many samples are solved at once, or on the
//! position of the sample among them.
TEST_P(Usac_Lanes, sameBitsInEveryLane)
{
    const Samples samples(problemOf(GetParam()), std::get<1>(GetParam()));
    const Solutions expected = expectedOf(samples);
    const std::vector<NamedKernels> all = availableKernels();
    for (size_t k = 0; k < all.size(); ++k)
    {
        const SolverKernel solver = samples.solverOf(all[k].kernels);
        for (int i = 1; i < TOGETHER; ++i)
        {
            EXPECT_EQ(0, different(expected, solutions(samples, solver, i))) << all[k].name;
            EXPECT_EQ(0, different(expected, solutions(samples, solver, TOGETHER, i)))
                << all[k].name;
        }
    }
}

TEST_P(Usac_Lanes, sameModelsOneByOne)
{
    const Samples samples(problemOf(GetParam()), std::get<1>(GetParam()));
    const Ptr<MinimalSolver> solver = samples.problem == ESSENTIAL     ? createEssential5Solver()
                                      : samples.problem == FUNDAMENTAL ? createFundamental7Solver()
                                                                       : createHomography4Solver();
    EXPECT_GT(solver->together(), 1);
    const int counts[] = {1, 3, TOGETHER, TOGETHER + 1, 1000};
    std::vector<Model> models(1000 * MAX_MODELS);
    std::vector<Model*> places;
    std::vector<int> found(1000);
    for (int i = 0; i < 1000; ++i)
        places.push_back(&models[i * MAX_MODELS]);
    for (int c = 0; c < 5; ++c)
    {
        solver->solveMany(samples.points(), samples.all.data(), counts[c], places.data(),
                          found.data());
        for (int i = 0; i < counts[c]; ++i)
        {
            Model own[MAX_MODELS];
            ASSERT_EQ(solver->solve(samples.points(), samples.all[i], own), found[i]);
            EXPECT_TRUE(std::equal(own, own + found[i], places[i])) << counts[c] << " " << i;
        }
    }
}

INSTANTIATE_TEST_CASE_P(Problems, Usac_Lanes,
                        testing::Combine(testing::Values((int)HOMOGRAPHY, (int)FUNDAMENTAL,
                                                         (int)ESSENTIAL),
                                         testing::Values(0., 0.8)));

//! +1 or -1: orientation of a triangle of three points; 0: the points are collinear.
int orientationOf(const double* x, const double* y, int a, int b, int c)
{
    const double area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
    return (area > 0) - (area < 0);
}

//! True if the four triangles of a sample all keep their orientation or all reverse it.
bool consistent(const Correspondences& p, const int* s)
{
    const int triangles[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    int same = 0;
    for (const int(&t)[3] : triangles)
        same += orientationOf(p.exact[X1], p.exact[Y1], s[t[0]], s[t[1]], s[t[2]]) *
                    orientationOf(p.exact[X2], p.exact[Y2], s[t[0]], s[t[1]], s[t[2]]) >
                0;
    return same == 0 || same == 4;
}

TEST(Usac_LanesOrientation, agreesWithTheTriangles)
{
    const Samples samples(HOMOGRAPHY, 0);
    const std::vector<NamedKernels> all = availableKernels();
    for (size_t k = 0; k < all.size(); ++k)
        for (int together = 1; together <= TOGETHER; ++together)
        {
            int accepted = 0;
            for (int i = 0; i < samples.count; i += together)
            {
                bool valid[TOGETHER];
                const int count = std::min(together, samples.count - i);
                all[k].kernels.orientation(samples.points(), &samples.all[i], count, valid);
                for (int j = 0; j < count; ++j)
                {
                    ASSERT_EQ(consistent(samples.points(), samples.all[i + j]), valid[j])
                        << all[k].name << " " << together << " " << i + j;
                    accepted += valid[j];
                }
            }
            EXPECT_GT(accepted, samples.count / 10);
            EXPECT_LT(accepted, samples.count / 2);
        }
}

//! A check as a caller could write it, which does not override validSamples().
class OwnCheck : public Degeneracy
{
public:
    explicit OwnCheck(const Ptr<Degeneracy>& check_) : check(check_) {}
    bool validSample(const Context& context, const int* sample) const CV_OVERRIDE
    {
        return check->validSample(context, sample);
    }
    bool validModel(const Context& context, const int* sample, const Model& model) const CV_OVERRIDE
    {
        return check->validModel(context, sample, model);
    }

private:
    const Ptr<Degeneracy> check;
};

TEST(Usac_OwnCheck, sameRunAsWithTheBuiltInOne)
{
    SceneOptions options;
    options.outliers = 200;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    const Ptr<Usac> usac = createUsac(scene, Params()), other = createUsac(scene, Params());
    Ptr<Degeneracy>& first = other->components().degeneracies[0];
    first = makePtr<OwnCheck>(first);
    Report expected, report;
    const Mat model = usac->run(noArray(), &expected);
    ASSERT_FALSE(model.empty());
    EXPECT_EQ(0, cv::norm(model, other->run(noArray(), &report), NORM_INF));
    EXPECT_GT(expected.rejectedSamples, 0);
    EXPECT_EQ(expected.rejectedSamples, report.rejectedSamples);
    EXPECT_EQ(expected.models, report.models);
}

//! A solver as a caller could write it, which does not override solveMany().
class OwnSolver : public MinimalSolver
{
public:
    OwnSolver() : calls(0), solver(createHomography4Solver()) {}
    int sampleSize() const CV_OVERRIDE { return 4; }
    int solve(const Correspondences& points, const int* sample, Model* models) const CV_OVERRIDE
    {
        ++calls;
        return solver->solve(points, sample, models);
    }

    mutable std::atomic<int> calls;

private:
    const Ptr<MinimalSolver> solver;
};

TEST(Usac_OwnSolver, sameRunAsWithTheBuiltInOne)
{
    SceneOptions options;
    options.outliers = 200;
    const Scene scene = makeScene(HOMOGRAPHY, options);
    const Ptr<Usac> usac = createUsac(scene, Params()), other = createUsac(scene, Params());
    other->components().minimalSolver = makePtr<OwnSolver>();
    const Mat expected = usac->run(), model = other->run();
    EXPECT_EQ(0, cv::norm(expected, model, NORM_INF));
}

}  // namespace
}  // namespace opencv_test
