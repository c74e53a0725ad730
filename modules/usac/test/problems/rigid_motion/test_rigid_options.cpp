// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "contracts/rigid_contracts.hpp"
#include "support/run_context.hpp"
#include "support/params_fields.hpp"

// Tests of the search for 3-D motions with each component, with an initial model and with a
// residual of the caller.

namespace opencv_test {
namespace {

RigidSceneOptions optionsOf(ProblemType type, double inlierRatio)
{
    RigidSceneOptions options;
    options.modelScale = type == SIMILARITY_3D ? 2.5 : 1;
    options.inlierRatio = inlierRatio;
    options.scoreInformation = 0.8;
    return options;
}

Params paramsOf(const RigidScene& scene)
{
    Params params;
    params.threshold = scene.threshold;
    return params;
}

class Usac_RigidOptions : public UsacProblem
{};
INSTANTIATE_TEST_CASE_P(/**/, Usac_RigidOptions, testing::ValuesIn(SPACE_PROBLEMS));

struct Option
{
    const char* name;
    int first, last;
};

//! With each value of each of these options, the motion must be found accurately.
TEST_P(Usac_RigidOptions, every_component)
{
    const Option options[] = {{"sampler", SAMPLER_UNIFORM, SAMPLER_IMPORTANCE},
                              {"quality", QUALITY_INLIERS, QUALITY_MAGSAC_PLUS_PLUS},
                              {"localOptimization", 0, 6},
                              {"polishing", 1, 3},
                              {"verification", 0, 2},
                              {"ordering", 0, 3},
                              {"neighborhood", 0, 2}};
    int tried = 0;
    for (const Option& option : options)
        for (int value = option.first; value <= option.last; ++value)
            for (int seed = 1; seed <= 3; ++seed)
            {
                SCOPED_TRACE(cv::format("%s %d, seed %d", option.name, value, seed));
                RigidSceneOptions sceneOptions = optionsOf(problem(), 0.6);
                sceneOptions.seed = seed;
                const RigidScene scene = makeRigidScene(sceneOptions);
                const bool median = option.name == std::string("quality") && value == QUALITY_LMEDS;
                Params params = median ? Params::lmeds() : Params();
                params.threshold = scene.threshold;
                Assignment(params, option.name, value);
                if (option.name == std::string("verification") && value != VERIFICATION_SPRT)
                    params.termination = TERMINATION_STANDARD;
                params.neighborRadius = 0.5;
                params.scoreOrder = SCORES_HIGHER_IS_BETTER;
                for (float score : scene.scores)
                    params.scores.push_back(1 - score);
                params.check(scene.size());
                ++tried;
                const Estimate found = checkedMotion(problem(), scene, params);
                ASSERT_FALSE(found.model.empty());
                EXPECT_LE(motionError(scene, found.motion()), 0.005);
                EXPECT_LE(found.report.chance, 1e-6);
            }
    EXPECT_GT(tried, 80);
}

TEST_P(Usac_RigidOptions, every_termination)
{
    const RigidScene scene = makeRigidScene(optionsOf(problem(), 0.5));
    const int reasons[] = {STOP_STANDARD, STOP_PROSAC, STOP_P_NAPSAC, STOP_SPRT, STOP_MAGSAC};
    const int flags[] = {TERMINATION_STANDARD, TERMINATION_PROSAC, TERMINATION_P_NAPSAC,
                         TERMINATION_SPRT, TERMINATION_MAGSAC};
    for (int k = 0; k < 5; ++k)
    {
        SCOPED_TRACE(k);
        Params params = paramsOf(scene);
        params.termination = flags[k];
        params.scores = scene.scores;
        if (flags[k] == TERMINATION_SPRT)
            params.verification = VERIFICATION_SPRT;
        if (flags[k] == TERMINATION_MAGSAC)
        {
            params.quality = QUALITY_MAGSAC;
            params.threshold = 3 * scene.threshold;  // MAGSAC treats the threshold as an upper
                                                     // bound of the noise
        }
        const Estimate found = checkedMotion(problem(), scene, params);
        ASSERT_FALSE(found.model.empty());
        EXPECT_EQ(reasons[k], found.report.stop);
        EXPECT_LT(found.report.iterations, 2000);
        EXPECT_LE(motionError(scene, found.motion()),
                  flags[k] == TERMINATION_MAGSAC ? 0.012 : 0.006);
    }
}

//! Informative scores must save samples if the termination criterion (PROSAC's) takes them into
//! account.
TEST_P(Usac_RigidOptions, scores_save_samples)
{
    double with = 0, without = 0;
    for (int seed = 1; seed <= 20; ++seed)
    {
        RigidSceneOptions options = optionsOf(problem(), 0.15);
        options.seed = seed;
        options.size = 1000;
        options.scoreInformation = 0.95;
        const RigidScene scene = makeRigidScene(options);
        Params params = paramsOf(scene);
        without += checkedMotion(problem(), scene, params).report.iterations;
        params = Params::prosac();
        params.ordering = ORDERING_AUTO;
        params.threshold = scene.threshold;
        params.scores = scene.scores;
        const Estimate found = checkedMotion(problem(), scene, params);
        EXPECT_LE(motionError(scene, found.motion()), 0.015);
        with += found.report.iterations;
    }
    EXPECT_LT(with, 0.5 * without);
}

//! With 90 % outliers, a single sample finds no motion, so that the correct motion must come from
//! the initial model. With many samples, a wrong initial model must do no harm.
TEST_P(Usac_RigidOptions, initial_model)
{
    RigidSceneOptions options = optionsOf(problem(), 0.1);
    options.size = 1000;
    const RigidScene scene = makeRigidScene(options);
    for (double widestReach : {1., 8.})
    {
        Params params = paramsOf(scene);
        params.maxIterations = 200000;
        params.widestReach = widestReach;
        const Estimate first = estimate(problem(), scene, params);
        ASSERT_FALSE(first.model.empty());
        Params tracking = params;
        tracking.maxIterations = 1;
        // the motion of the previous frame differs slightly
        const Matx33d turn(1, -0.004, 0, 0.004, 1, 0, 0, 0, 1);
        Matx34d before = motionFrom(1, turn * first.motion().get_minor<3, 3>(0, 0),
                                    moved(first.motion(), Point3d()));
        before(0, 3) += 0.005 * scene.unit;
        for (const Matx34d& given : {first.motion(), before})
        {
            tracking.setInitialModel(given);
            const Estimate tracked = checkedMotion(problem(), scene, tracking);
            ASSERT_FALSE(tracked.model.empty());
            EXPECT_LE(tracked.report.iterations, 1);
            EXPECT_GE(tracked.report.inliers, 0.98 * first.report.inliers);
        }
        RNG rng(3);
        for (int trial = 0; trial < 10; ++trial)  // wrong initial models
        {
            Mat wrong(3, 4, CV_64F);
            rng.fill(wrong, RNG::NORMAL, 0, 1);
            params.setInitialModel(trial ? wrong : Mat::zeros(3, 4, CV_64F));
            const Estimate other = checkedMotion(problem(), scene, params);
            EXPECT_GE(other.report.inliers, 0.95 * first.report.inliers);
        }
    }
}

//! If the threshold is too small for the noise, models must be more accurate if Params::reach can
//! grow (Params::widestReach is 10 instead of 1).
TEST_P(Usac_RigidOptions, widest_reach)
{
    double narrow = 0, wide = 0;
    for (int seed = 1; seed <= 10; ++seed)
    {
        RigidSceneOptions options = optionsOf(problem(), 0.7);
        options.seed = seed;
        const RigidScene scene = makeRigidScene(options);
        Params params = paramsOf(scene);
        params.threshold = 0.1 * scene.threshold;
        params.significance = 1;
        params.maxIterations = 300;
        const Estimate first = checkedMotion(problem(), scene, params);
        narrow += first.model.empty() ? 1 : motionError(scene, first.motion());
        params.widestReach = 10;
        const Estimate second = checkedMotion(problem(), scene, params);
        wide += second.model.empty() ? 1 : motionError(scene, second.motion());
    }
    EXPECT_LE(wide, 0.05);
    EXPECT_LT(wide, narrow);
}

//! The distance in space 2 as a residual of the caller, in which errors along z have a different
//! weight.
class OwnResidual : public Residual
{
public:
    explicit OwnResidual(double along_) : along(along_) {}

    void squaredErrors(const Correspondences& p, const Model& model, int begin, int end,
                       float* errors) const CV_OVERRIDE
    {
        std::vector<double> precise(end - begin);
        const double* columns[6];
        for (int k = 0; k < 6; ++k)
            columns[k] = p.exact[k] + begin;
        squaredErrors(model, columns, end - begin, precise.data());
        std::copy(precise.begin(), precise.end(), errors);
    }

    void squaredErrors(const Model& model, const double* const* c, int count,
                       double* errors) const CV_OVERRIDE
    {
        for (int i = 0; i < count; ++i)
        {
            const Vec3d off = moved(Matx34d(model), Point3d(c[0][i], c[1][i], c[2][i])) -
                              Vec3d(c[3][i], c[4][i], c[5][i]);
            errors[i] = off[0] * off[0] + off[1] * off[1] + off[2] * off[2] * along * along;
        }
    }

    int error(const Model& model, const double* d, double* e) const CV_OVERRIDE
    {
        const Vec3d off = moved(Matx34d(model), Point3d(d[0], d[1], d[2])) -
                          Vec3d(d[3], d[4], d[5]);
        e[0] = off[0];
        e[1] = off[1];
        e[2] = off[2] * along;
        return 3;
    }

private:
    const double along;  //!< factor of errors along z; below 1 if depth is less accurate
};

//! A replaced residual must be used for scores, fits and the mask. If its errors equal those of the
//! built-in residual, the motion must be nearly the same.
TEST_P(Usac_RigidOptions, own_residual)
{
    const RigidScene scene = makeRigidScene(optionsOf(problem(), 0.6));
    for (double along : {1., 0.25})
    {
        SCOPED_TRACE(along);
        const Ptr<Usac> usac = Usac::create(problem(), scene.points1, scene.points2,
                                            paramsOf(scene));
        Mat mask, ownMask;
        const Mat builtIn = usac->run(mask);
        ASSERT_FALSE(builtIn.empty());
        usac->components().residual = makePtr<OwnResidual>(along);
        const Mat own = usac->run(ownMask);
        ASSERT_FALSE(own.empty());
        const Matx34d motion(own);
        int inliers = 0;
        for (int i = 0; i < scene.size(); ++i)
        {
            Vec3d off = moved(motion, scene.points1[i]) - Vec3d(scene.points2[i]);
            off[2] *= along;
            const double error = cv::norm(off);
            inliers += ownMask.at<uchar>(i);
            if (std::abs(error - scene.threshold) > 1e-9)
            {
                EXPECT_EQ(error <= scene.threshold ? 1 : 0, ownMask.at<uchar>(i)) << error;
            }
        }
        EXPECT_GE(inliers, countNonZero(mask) - 2);
        EXPECT_LE(motionError(scene, motion), 0.005);
        if (along == 1)
        {
            EXPECT_LE(motionError(scene, motion - Matx34d(builtIn) + scene.motion), 1e-3);
        }
    }
}

//! A Usac object that is run again with other points must give the results of a new object.
TEST_P(Usac_RigidOptions, run_again)
{
    const Ptr<Usac> usac = Usac::create(problem(), makeRigidScene().points1,
                                        makeRigidScene().points2);
    for (int size : {300, 20, 1000, 300})
    {
        RigidSceneOptions options = optionsOf(problem(), 0.5);
        options.size = size;
        options.unit = 50;  // the noise, 0.5 or 1.25, suits the default threshold
        const RigidScene scene = makeRigidScene(options);
        usac->setPoints(scene.points1, scene.points2);
        for (int run = 0; run < 2; ++run)
        {
            Mat mask;
            Report report;
            const Mat motion = usac->run(mask, &report);
            const Estimate once = estimate(problem(), scene, Params());
            EXPECT_TRUE(sameBits(once.model, motion)) << size;
            EXPECT_TRUE(sameBits(once.mask, mask)) << size;
            EXPECT_EQ(once.report.iterations, report.iterations);
        }
    }
}

//! The neighbors must be those with the smallest distances, found by exhaustive search. For rigid
//! motions, distances are measured in both spaces; for similarities only in space 2, because space
//! 1 can have a different unit.
TEST_P(Usac_RigidOptions, nearest_neighbors)
{
    RigidSceneOptions options = optionsOf(problem(), 0.6);
    const RigidScene scene = makeRigidScene(options);
    Params params = paramsOf(scene);
    params.neighborhood = NEIGHBORHOOD_KNN;
    params.neighbors = 6;
    const Ptr<Usac> usac = Usac::create(problem(), scene.points1, scene.points2, params);
    const Correspondences& p = usac->points();
    const RunContext run(p, usac->components(), params);
    for (int i = 0; i < p.size; ++i)
    {
        std::vector<std::pair<double, int>> all;
        for (int k = 0; k < p.size; ++k)
        {
            const int a = p.inputIndex[i], b = p.inputIndex[k];
            const Point3d off1 = scene.points1[a] - scene.points1[b],
                          off2 = scene.points2[a] - scene.points2[b];
            all.push_back(
                std::make_pair((problem() == RIGID_3D ? off1.dot(off1) : 0) + off2.dot(off2), k));
        }
        std::sort(all.begin(), all.end());
        const int* members = 0;
        ASSERT_EQ(7, usac->components().neighborhood->members(run, 0, i, members));
        for (int k = 0; k < 7; ++k)
            EXPECT_EQ(all[k].second, members[k]) << i;
    }
}

}  // namespace
}  // namespace opencv_test
