// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/results.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/real_set.hpp"
#include "problems/kernels.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <Eigen/Dense>

// Hashes of the results of every preset, on the sets of test_data/ and on synthetic scenes, are
// compared with those of test_data/hashes.txt, so that no change of a result goes unnoticed. After
// an intended change, this command writes all rows again:
//
//     USAC_WRITE_HASHES=test_data/hashes.txt opencv_test_usac --gtest_filter=Usac_Hashes.stored
//
// The module's own arithmetic is that of IEEE 754 in an order that the source fixes, so that its
// results do not depend on compiler, optimization and instruction set. Functions of other libraries
// can give results that differ in the last bit between machines: exp, log, pow, acos, cbrt and
// others of libm (glibc itself has other variants for processors without FMA), cv::SVD of another
// version of OpenCV, and Eigen's decompositions of another version or with other vector
// instructions. The file also has a hash of some results of such functions (`platform`). If this
// hash is equal, all results must be equal bit by bit. Otherwise the rows are compared by their
// robust hashes (mask, number of iterations and stop reason). Up to a tenth of the rows are then
// allowed to differ, because the last bit can decide between two equally good models.

namespace opencv_test {
namespace {

struct Row
{
    bool operator==(const Row& other) const
    {
        return name == other.name && exact == other.exact && robust == other.robust;
    }

    std::string name;
    int iterations, inliers;  //!< only for readers of the file
    uint64 robust, exact;
};

void PrintTo(const Row& row, std::ostream* os)
{
    *os << row.name << ", " << row.iterations << " iterations, " << row.inliers
        << " inliers, exact hash " << row.exact;
}

struct Table
{
    std::string kernels;
    uint64 platform;
    std::vector<Row> rows;
};

//! Hash of results of other libraries' functions that this module uses.
uint64 platformHash()
{
    Hash hash;
    RNG rng(1);
    for (int i = 0; i < 1000; ++i)
    {
        const double x = rng.uniform(-1., 1.), y = rng.uniform(0., 10.), z = rng.uniform(-30., 0.),
                     p = rng.uniform(0., 1.);
        hash.number(std::exp(z))
            .number(std::log(y))
            .number(std::log1p(-p))
            .number(std::pow(y, 0.5 + p));
        hash.number(std::acos(x)).number(std::cbrt(y)).number(std::atan2(x, y));
        hash.number(std::sin(4 * x)).number(std::cos(4 * x)).number(std::sqrt(y));
    }
    for (int i = 0; i < 100; ++i)
    {
        Matx33d M, U, Vt;
        for (int k = 0; k < 9; ++k)
            M.val[k] = rng.uniform(-1., 1.);
        Vec3d w;
        SVD::compute(M, w, U, Vt);
        hash.add(Mat(w)).add(Mat(U)).add(Mat(Vt)).add(Mat(M.inv())).number(determinant(M));
        const Eigen::Map<Eigen::Matrix3d> A(M.val);
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(Eigen::Matrix3d(A),
                                                    Eigen::ComputeFullU | Eigen::ComputeFullV);
        const Eigen::Matrix3d product = A.transpose() * A + Eigen::Matrix3d::Identity(),
                              inverse = product.llt().solve(A);
        hash.add(svd.matrixU().data(), 9 * sizeof(double))
            .add(svd.matrixV().data(), 9 * sizeof(double));
        hash.add(inverse.data(), 9 * sizeof(double));
    }
    return hash.value();
}

//! Instruction set of the loops over points in this process.
std::string kernelsInUse()
{
    // avx512Kernels() and avx2Kernels() are called only if the processor has their instructions,
    // because even these functions can contain such instructions
#ifdef USACV20_HAVE_AVX512
    if (checkHardwareSupport(CV_CPU_AVX512_SKX) && kernels().arcs == avx512Kernels().arcs)
        return "avx512";
#endif
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2) && kernels().arcs == avx2Kernels().arcs)
        return "avx2";
#endif
    return "baseline";
}

//! The presets, and parameters that differ from a preset in the scores, the sigmas, the seed or a
//! component.
std::vector<NamedPreset> hashedParams(ProblemType problem, const std::vector<float>& scores)
{
    std::vector<NamedPreset> all = allPresets(problem);
    const char* names[] = {"scores",     "seed",       "knn",        "radius",
                           "napsac",     "importance", "tdd",        "symmetric",
                           "unpolished", "sigmas",     "covariances"};
    for (int i = 0; i < 11; ++i)
    {
        const NamedPreset preset = {names[i], Params()};
        all.push_back(preset);
    }
    NamedPreset* other = &all[all.size() - 11];
    other[0].params.scores = scores;
    other[1].params.seed = 1;
    other[2].params.neighborhood = NEIGHBORHOOD_KNN;
    other[3].params.neighborhood = NEIGHBORHOOD_RADIUS;
    other[4].params.sampler = SAMPLER_NAPSAC;
    other[5].params.sampler = SAMPLER_IMPORTANCE;
    other[5].params.scoreOrder = SCORES_HIGHER_IS_BETTER;
    for (size_t i = 0; i < scores.size(); ++i)
        other[5].params.scores.push_back(std::max(1 - scores[i], 0.f));
    other[6].params = Params::msac();
    other[6].params.verification = VERIFICATION_TDD;
    other[7].params.residual = RESIDUAL_SYMMETRIC;
    other[8].params.polishing = POLISHING_NONE;
    for (size_t i = 0; i < scores.size(); ++i)
        other[9].params.sigmas.push_back(1 + 0.5f * (i % 4));
    const size_t images = problem == ABSOLUTE_POSE ? 1 : 2;
    for (size_t i = 0; i < images * scores.size(); ++i)
        for (float number : {1 + 0.5f * (i % 4), 0.25f * (i % 5) - 0.5f, 1.5f})  // xx, xy, yy
            other[10].params.sigmas.push_back(number);
    return all;
}

//! Like hashedParams(), but without the symmetric residual, which does not exist for poses and 3-D
//! motions, and for 3-D motions also without covariances of points, which must be image points.
std::vector<NamedPreset> hashedSpaceParams(ProblemType problem, const std::vector<float>& scores)
{
    std::vector<NamedPreset> all = hashedParams(problem, scores);
    for (size_t i = all.size(); i-- > 0;)
        if (all[i].params.residual == RESIDUAL_SYMMETRIC ||
            (problem != ABSOLUTE_POSE && all[i].params.sigmas.size() > scores.size()))
            all.erase(all.begin() + i);
    return all;
}

//! Adds a row with the result of estimate(params, mask, report) for each element of `all`.
template <class Estimate>
void addRows(const std::string& name, const std::vector<NamedPreset>& all, double threshold,
             const Estimate& estimate, std::vector<Row>& rows)
{
    for (size_t i = 0; i < all.size(); ++i)
    {
        Params params = all[i].params;
        params.threshold = threshold;
        params.maxIterations = 1000;
        Result result;
        result.model = estimate(params, result.mask, result.report);
        const Row row = {name + ":" + all[i].name, result.report.iterations, result.report.inliers,
                         result.robust(), result.exact()};
        rows.push_back(row);
    }
}

void addRows(const std::string& name, double threshold, std::vector<Row>& rows)
{
    const RealSet set = RealSet(name).sorted();
    const auto estimate = [&](const Params& params, Mat& mask, Report& report) {
        return set.estimateWith(params, mask, report);
    };
    addRows(name, hashedParams(set.problem, set.scores), threshold, estimate, rows);
}

//! Adds the rows of a synthetic scene, whose matches are not sorted by their scores.
void addRows(ProblemType problem, std::vector<Row>& rows)
{
    SceneOptions options;
    options.outliers = 400;
    options.scoreInformation = 0.7;
    const Scene scene = makeScene(problem, options);
    const auto estimate = [&](const Params& params, Mat& mask, Report& report) {
        return estimatePoints(problem, scene.points1, scene.points2, params, mask, report);
    };
    addRows(nameOf(problem), hashedParams(problem, scene.scores), 2, estimate, rows);
}

//! Adds the rows of a synthetic scene of absolute pose. With 0 coefficients there is no lens
//! distortion.
void addPoseRows(const std::string& name, int coefficients, std::vector<Row>& rows)
{
    PoseSceneOptions options;
    options.size = 600;
    options.inlierRatio = 0.33;
    options.scoreInformation = 0.7;
    options.coefficients = coefficients;
    const PoseScene scene = makePoseScene(options);
    const auto estimate = [&](const Params& params, Mat& mask, Report& report) {
        return estimateAbsolutePose(scene.object, scene.image, scene.K, scene.distortion, params,
                                    mask, report);
    };
    addRows(name, hashedSpaceParams(ABSOLUTE_POSE, scene.scores), 2, estimate, rows);
}

//! Adds the rows of a synthetic scene of a 3-D motion, whose matches are not sorted by their
//! scores. The unit is chosen so that the default radius of neighborhoods, meant for pixels, suits
//! the coordinates.
void addRigidRows(ProblemType problem, std::vector<Row>& rows)
{
    RigidSceneOptions options;
    options.size = 600;
    options.inlierRatio = 0.33;
    options.scoreInformation = 0.7;
    options.unit = 200;
    options.modelScale = problem == SIMILARITY_3D ? 1.5 : 1;
    const RigidScene scene = makeRigidScene(options);
    const auto estimate = [&](const Params& params, Mat& mask, Report& report) {
        return problem == RIGID_3D
                   ? estimateRigid3D(scene.points1, scene.points2, params, mask, report)
                   : estimateSimilarity3D(scene.points1, scene.points2, params, mask, report);
    };
    addRows(nameOf(problem), hashedSpaceParams(problem, scene.scores), scene.threshold, estimate,
            rows);
}

Table makeTable()
{
    Table table;
    table.kernels = kernelsInUse();
    table.platform = platformHash();
    addRows("graf", 2, table.rows);
    addRows("aloe", 1, table.rows);
    addRows("office12_F", 1, table.rows);
    addRows("office01_E", 1, table.rows);
    addRows(AFFINITY, table.rows);
    addRows(SIMILARITY, table.rows);
    addRows(TRANSLATION_2D, table.rows);
    addPoseRows("absolutePose", 0, table.rows);
    addPoseRows("absolutePose_lens", 5, table.rows);
    addRigidRows(RIGID_3D, table.rows);
    addRigidRows(SIMILARITY_3D, table.rows);
    return table;
}

//! The table of this process.
const Table& ownTable()
{
    static const Table table = makeTable();
    return table;
}

void writeTable(const Table& table, const std::string& file)
{
    std::ofstream out(file.c_str());
    out << "# made by test_hashes.cpp: set:parameters, iterations, inliers, robust hash, exact "
           "hash\n";
    out << "kernels " << table.kernels << "\nplatform "
        << cv::format("%016llx", (unsigned long long)table.platform) << "\n";
    for (size_t i = 0; i < table.rows.size(); ++i)
    {
        const Row& row = table.rows[i];
        out << row.name
            << cv::format(" %d %d %016llx %016llx\n", row.iterations, row.inliers,
                          (unsigned long long)row.robust, (unsigned long long)row.exact);
    }
    out.close();
    ASSERT_TRUE(out.good()) << "cannot write " << file;
}

Table readTable(const std::string& file)
{
    std::ifstream in(file.c_str());
    EXPECT_TRUE(in.good()) << "cannot read " << file;
    Table table;
    std::string line, key;
    std::getline(in, line);
    in >> key >> table.kernels >> key >> std::hex >> table.platform;
    Row row;
    while (in >> row.name >> std::dec >> row.iterations >> row.inliers >> std::hex >> row.robust >>
           row.exact)
        table.rows.push_back(row);
    return table;
}

TEST(Usac_Hashes, stored)
{
    const Table& table = ownTable();
    const char* written = std::getenv("USAC_WRITE_HASHES");
    if (written && *written)
    {
        writeTable(table, written);
        return;
    }
    const Table stored = readTable(std::string(USAC_TEST_DATA_DIR) + "/hashes.txt");
    ASSERT_EQ(stored.rows.size(), table.rows.size());
    const bool samePlatform = stored.platform == table.platform;
    size_t differ = 0;
    for (size_t i = 0; i < table.rows.size(); ++i)
    {
        EXPECT_EQ(stored.rows[i].name, table.rows[i].name);
        if (samePlatform)
        {
            EXPECT_EQ(stored.rows[i], table.rows[i]);
        }
        differ += stored.rows[i].robust != table.rows[i].robust;
    }
    EXPECT_LE(differ, samePlatform ? 0 : table.rows.size() / 10)
        << "of " << table.rows.size() << " rows differ in their robust hash";
}

//! The best kernels of this processor except those for AVX-512.
std::string secondBestKernels()
{
#ifdef USACV20_HAVE_AVX2
    if (checkHardwareSupport(CV_CPU_AVX2))
        return "avx2";
#endif
    return "baseline";
}

TEST(Usac_Hashes, kernels)
{
    std::string best = secondBestKernels();
#ifdef USACV20_HAVE_AVX512
    if (checkHardwareSupport(CV_CPU_AVX512_SKX))
        best = "avx512";
#endif
    const char* expected = std::getenv("USAC_EXPECTED_KERNELS");
    EXPECT_EQ(expected ? expected : best, kernelsInUse());
}

// The following tests start other processes with a POSIX shell. They are left out without AVX2,
// because there is then only one set of kernels.
#if defined USACV20_HAVE_AVX2 && !defined _WIN32

//! Runs a test in another process of this program, which must not use these features of the
//! processor.
void testWithout(const std::string& features, const std::string& test, const std::string& variable)
{
    const std::string program = testing::internal::GetArgvs()[0];
    const std::string command = "env -u GTEST_OUTPUT -u GTEST_TOTAL_SHARDS -u GTEST_SHARD_INDEX "
                                "OPENCV_CPU_DISABLE='" +
                                features + "' " + variable + " '" + program +
                                "' --gtest_filter=" + test + " > /dev/null 2>&1";
    EXPECT_EQ(0, std::system(command.c_str())) << command;
}

Table tableWithout(const std::string& features)
{
    const std::string file = tempfile(".txt");
    testWithout(features, "Usac_Hashes.stored", "USAC_WRITE_HASHES='" + file + "'");
    const Table table = readTable(file);
    std::remove(file.c_str());
    return table;
}

//! OPENCV_CPU_DISABLE is read at the start of a process, so that each set of features needs a
//! process of its own. The variable also changes which code OpenCV's own functions run.
//! Nevertheless, all results must be equal bit by bit.
TEST(Usac_Hashes, every_instruction_set)
{
    const Table& table = ownTable();
    const std::string features[] = {
        "AVX512F", "AVX512F,AVX512-SKX,AVX2",
        "AVX512F,AVX512-SKX,AVX2,FMA3,AVX,FP16,SSE4.2,SSE4.1,SSSE3,POPCNT"};
    for (int i = 0; i < 3; ++i)
    {
        SCOPED_TRACE("without " + features[i]);
        const Table other = tableWithout(features[i]);
        EXPECT_EQ(i == 0 ? secondBestKernels() : "baseline", other.kernels);
        ASSERT_EQ(table.rows.size(), other.rows.size());
        EXPECT_EQ(table.platform, other.platform);
        for (size_t r = 0; r < table.rows.size(); ++r)
            EXPECT_EQ(table.rows[r], other.rows[r]);
    }
}

//! OPENCV_CPU_DISABLE can contain the name of the group AVX512-SKX or of one of its members. The
//! kernels for AVX-512 must not be used in either case.
TEST(Usac_Hashes, every_part_of_avx512)
{
    const std::string features[] = {"AVX512-SKX", "AVX512F", "AVX512BW", "AVX512DQ", "AVX512VL"};
    for (int i = 0; i < 5; ++i)
        testWithout(features[i], "Usac_Hashes.kernels",
                    "USAC_EXPECTED_KERNELS=" + secondBestKernels());
}

#endif

}
}  // namespace
