// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/allocation_counter.hpp"
#include "problems/absolute_pose/pose_scenes.hpp"
#include "problems/rigid_motion/rigid_scenes.hpp"
#include "support/contracts.hpp"
#include "support/params_fields.hpp"

// A run must allocate only the model that it returns, and nothing in the main loop.

namespace opencv_test {
namespace {

//! Number of allocations of one run. The memory of `mask` is allocated before the run.
long allocationsOf(Usac& usac, Mat& mask, Report& report, bool& found)
{
    report.sample.reserve(MAX_SAMPLE_SIZE);  // so that the run does not allocate this memory
    const long before = allocationsSoFar();
    const Mat model = usac.run(mask, &report);
    const long after = allocationsSoFar();
    found = !model.empty();
    return after - before;
}

//! Runs the object three times. Each run must allocate only the model that it returns, see
//! allocationsOfModel(). @return number of runs that have returned a model
int expectOnlyModels(Usac& usac, long model)
{
    Mat mask(usac.points().inputSize, 1, CV_8U);
    Report report;
    int found = 0;
    for (int run = 0; run < 3; ++run)
    {
        bool any = false;
        const long count = allocationsOf(usac, mask, report, any);
        EXPECT_EQ(any ? model : 0, count) << "run " << run;
        found += any;
    }
    return found;
}

//! Number of allocations for the matrix that is returned.
long allocationsOfModel()
{
    const Mat first(Matx33d::eye(), true);  // before counting, so that OpenCV allocates its tables
    const long before = allocationsSoFar();
    const Mat model(Matx33d::eye(), true);
    return allocationsSoFar() - before;
}

//! Parameters with a name for messages.
struct Variant
{
    std::string name;
    Params params;
};

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

void addVariants(std::vector<Variant>& variants, const Params& base, const char* name, int values,
                 bool bits = false)
{
    for (int k = 0; k < values; ++k)
    {
        Variant variant = {cv::format("%s %d", name, k), base};
        Assignment(variant.params, name, bits ? 1 << k : k);
        if (isPossible(variant.params))
            variants.push_back(variant);
    }
}

//! All presets, and the default parameters with one component changed, each of them without and
//! with scores.
std::vector<Variant> allVariants(ProblemType problem, const std::vector<float>& scores)
{
    const bool hasSymmetric = problem < ABSOLUTE_POSE;
    std::vector<Variant> variants;
    Params scored;
    for (size_t i = 0; i < scores.size(); ++i)
        scored.scores.push_back(1 - scores[i]);
    scored.scoreOrder = SCORES_HIGHER_IS_BETTER;
    for (int given = 0; given < 2; ++given)
    {
        const std::vector<NamedPreset> presets = allPresets(problem);
        for (size_t p = 0; p < presets.size(); ++p)
        {
            Variant variant = {presets[p].name, presets[p].params};
            if (given)
            {
                variant.params.scores = scored.scores;
                variant.params.scoreOrder = scored.scoreOrder;
            }
            variants.push_back(variant);
        }
        const Params base = given ? scored : Params();
        addVariants(variants, base, "sampler", given ? 5 : 4);
        addVariants(variants, base, "quality", 6);
        addVariants(variants, base, "localOptimization", 7);
        addVariants(variants, base, "polishing", 4);
        addVariants(variants, base, "verification", 3);
        addVariants(variants, base, "termination", 5, true);
        addVariants(variants, base, "residual", hasSymmetric ? 2 : 1);
        addVariants(variants, base, "ordering", 4);
    }
    for (size_t i = 0; i < variants.size(); ++i)
    {
        variants[i].params.threads = 1;
        variants[i].params.spatialWeight = 0;  // OpenCV's graph cut allocates memory
        variants[i].params.neighborhood = NEIGHBORHOOD_GRID;
        variants[i].params.maxIterations = std::min(variants[i].params.maxIterations, 300);
    }
    return variants;
}

Scene planarScene(ProblemType problem, int size, uint64 seed = 1)
{
    SceneOptions options;
    options.setSize(size, 0.6);
    options.planeFraction = 0.6;  // so that the checks for planes run
    options.copies = 1;
    options.duplicates = size / 20;
    options.seed = seed;
    return makeScene(problem, options);
}

typedef testing::TestWithParam<int> Usac_Memory;

//! Each of the first three runs of an object must allocate only the returned model.
TEST_P(Usac_Memory, nothingButTheModel)
{
    if (!allocationsAreCounted())
        return;
    const long model = allocationsOfModel();
    EXPECT_GT(model, 0);
    const ProblemType problem = (ProblemType)GetParam();
    const Scene scene = planarScene(problem, 400);
    const std::vector<Variant> variants = allVariants(problem, scene.scores);
    EXPECT_GE(variants.size(), 85u);
    estimate(scene, Params());  // the first run of a process chooses the SIMD kernels
    int found = 0;
    for (size_t v = 0; v < variants.size(); ++v)
    {
        SCOPED_TRACE(variants[v].name);
        const Params& params = variants[v].params;
        const Ptr<Usac> usac = createUsac(scene, params);
        found += expectOnlyModels(*usac, model);
    }
    EXPECT_GT(found, 2 * (int)variants.size());
}

//! setPoints() with as many or fewer points must not allocate memory, not even for points of type
//! float, which are converted. A run with these points must allocate only the returned model.
TEST_P(Usac_Memory, otherPoints)
{
    if (!allocationsAreCounted())
        return;
    const long model = allocationsOfModel();
    const ProblemType problem = (ProblemType)GetParam();
    Params params;
    params.spatialWeight = 0;
    params.threads = 1;
    const Ptr<Usac> usac = createUsac(planarScene(problem, 1000), params);
    Mat mask(1000, 1, CV_8U);
    usac->run(mask);
    for (int size = 1000; size >= 10; size /= 2)
        for (int kind = 0; kind < 2; ++kind)
        {
            const Scene scene = planarScene(problem, size, size);
            const std::vector<Point2f> points1(scene.points1.begin(), scene.points1.end()),
                points2(scene.points2.begin(), scene.points2.end());
            mask.create(size, 1, CV_8U);
            Report report;
            bool found = false;
            const long before = allocationsSoFar();
            if (kind)
                usac->setPoints(points1, points2);
            else
                usac->setPoints(scene.points1, scene.points2);
            const long read = allocationsSoFar() - before;
            EXPECT_EQ(0, read) << size << " " << kind;
            const long count = allocationsOf(*usac, mask, report, found);
            EXPECT_EQ(found ? model : 0, count) << size << " " << kind;
        }
}

//! OpenCV itself allocates memory: a growing list for each graph cut (maximum flow), and results
//! for each point whose neighbors the kd-tree finds. The number of allocations must not grow from
//! run to run. Its bounds are 12 for each cut and 3 for each point.
TEST_P(Usac_Memory, ofOpenCV)
{
    if (!allocationsAreCounted())
        return;
    const long model = allocationsOfModel();
    const Scene scene = planarScene((ProblemType)GetParam(), 400);
    for (int neighborhood = 0; neighborhood < 3; ++neighborhood)
        for (int spatial = 0; spatial < 2; ++spatial)
        {
            Params params;
            params.neighborhood = (NeighborhoodType)neighborhood;
            params.threads = 1;
            if (!spatial)
                params.spatialWeight = 0;
            const Ptr<Usac> usac = createUsac(scene, params);
            Mat mask(scene.size(), 1, CV_8U);
            Report report;
            bool found = false;
            long counts[4];
            for (int run = 0; run < 4; ++run)
                counts[run] = allocationsOf(*usac, mask, report, found) - model;
            ASSERT_TRUE(found);
            EXPECT_EQ(counts[2], counts[1]) << "the number of allocations changes from run to run";
            EXPECT_EQ(counts[3], counts[1]) << "the number of allocations changes from run to run";
            const long ofCuts = spatial ? 12L * report.localOptimizations * params.localIterations
                                        : 0;
            const long ofTree = neighborhood ? 3L * scene.size() : 0;
            EXPECT_LE(counts[1], ofCuts + ofTree) << neighborhood << " " << spatial;
        }
}

//! The same test as Usac_Memory.nothingButTheModel for absolute poses. The final polishing and the
//! mask use the original (distorted) image points, and must not allocate memory, either.
TEST(Usac_Memory_Pose, nothingButTheModel)
{
    if (!allocationsAreCounted())
        return;
    const long model = allocationsOfModel();
    for (int coefficients = 0; coefficients <= 5; coefficients += 5)
    {
        PoseSceneOptions options;
        options.size = 400;
        options.coefficients = coefficients;
        const PoseScene scene = makePoseScene(options);
        estimateAbsolutePose(scene.object, scene.image, scene.K,
                             scene.distortion);  // chooses the SIMD kernels
        const std::vector<Variant> variants = allVariants(ABSOLUTE_POSE, scene.scores);
        EXPECT_GE(variants.size(), 83u);
        int found = 0;
        for (size_t v = 0; v < variants.size(); ++v)
        {
            SCOPED_TRACE(cv::format("%s, %d coefficients", variants[v].name.c_str(), coefficients));
            const Ptr<Usac> usac = Usac::create(ABSOLUTE_POSE, scene.object, scene.image,
                                                variants[v].params, scene.K, noArray(),
                                                scene.distortion);
            found += expectOnlyModels(*usac, model);
        }
        EXPECT_GT(found, 2 * (int)variants.size());
    }
}

//! The same test for 3-D motions. Replacing the points by fewer points must not allocate memory,
//! either.
TEST(Usac_Memory_Space, nothingButTheModel)
{
    if (!allocationsAreCounted())
        return;
    const long model = allocationsOfModel();
    for (ProblemType problem : {RIGID_3D, SIMILARITY_3D})
    {
        RigidSceneOptions options;
        options.size = 400;
        const RigidScene scene = makeRigidScene(options);
        options.size = 100;
        const RigidScene fewer = makeRigidScene(options);
        estimateRigid3D(scene.points1, scene.points2);  // chooses the SIMD kernels
        int found = 0, runs = 0;
        for (const Variant& variant : allVariants(problem, scene.scores))
        {
            SCOPED_TRACE(variant.name);
            Params params = variant.params;
            params.threshold = scene.threshold;
            const Ptr<Usac> usac = Usac::create(problem, scene.points1, scene.points2, params);
            found += expectOnlyModels(*usac, model);
            runs += 3;
            if (!params.scores.empty())
                continue;
            const long before = allocationsSoFar();
            usac->setPoints(fewer.points1, fewer.points2);
            EXPECT_EQ(0, allocationsSoFar() - before);
        }
        EXPECT_GT(runs, 200);
        EXPECT_EQ(runs, found);
    }
}

INSTANTIATE_TEST_CASE_P(All, Usac_Memory, testing::ValuesIn(TWO_VIEW_PROBLEMS));

}  // namespace
}  // namespace opencv_test
