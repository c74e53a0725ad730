// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "two_view/pair_models.hpp"
#include "two_view_scenes.hpp"

namespace opencv_test {
namespace {

PairModel modelOf(const Matx33d& matrix, const std::vector<double>& errors, double threshold)
{
    PairModel model;
    model.matrix = matrix;
    model.mask = Mat::zeros((int)errors.size(), 1, CV_8U);
    for (size_t i = 0; i < errors.size(); ++i)
        model.mask.at<uchar>((int)i) = errors[i] <= threshold;
    model.inliers = countNonZero(model.mask);
    return model;
}

//! The point `to` of image 2 of a match, moved by `pixels` along the epipolar line of `from`.
Point2d movedAlong(const Matx33d& F, const Point2d& from, const Point2d& to, double pixels)
{
    const Vec3d line = F * Vec3d(from.x, from.y, 1);
    return to + Point2d(-line[1], line[0]) * (pixels / std::hypot(line[0], line[1]));
}

//! 100 matches without noise. A wrong E explains 60 of them, the true F all. If `off` is false, all
//! are on a plane, so that the true H explains them all. If it is true, 20 of the 40 that E does
//! not explain are moved along their epipolar lines, off the plane, and H explains the other 80.
class PlaneOfWrongE
{
public:
    explicit PlaneOfWrongE(bool off)
        : scene(make(ESSENTIAL)), pair(pairOf(scene)), params(twoPixels())
    {
        const Matx33d H = make(HOMOGRAPHY).model, K = scene.K.inv();
        const Vec3d t = normalize(scene.t + Vec3d(0.05, 0.1, -0.05));
        const Matx33d E = Matx33d(0, -t[2], t[1], t[2], 0, -t[0], -t[1], t[0], 0) * scene.R,
                      wrong = K.t() * E * K;
        std::vector<double> ofE = sampsonDistances(wrong, scene.points1, scene.points2);
        std::vector<double> sorted = ofE;
        std::sort(sorted.begin(), sorted.end());
        const double threshold = params.threshold = (sorted[59] + sorted[60]) / 2;
        for (int i = 0, left = off ? 20 : 0; i < scene.size() && left > 0; ++i)
        {
            if (ofE[i] <= threshold)
                continue;
            Point2d& to = scene.points2[i];
            const Point2d sides[] = {movedAlong(scene.F, scene.points1[i], to, 50),
                                     movedAlong(scene.F, scene.points1[i], to, -50)};
            const double d0 = errorOf(wrong, i, sides[0]), d1 = errorOf(wrong, i, sides[1]);
            to = sides[d1 > d0];
            --left;
        }
        pair = pairOf(scene);
        ofE = sampsonDistances(wrong, scene.points1, scene.points2);
        models = makePtr<PairModels>(pair, params, rules);
        models->E = modelOf(E * (1 / cv::norm(E)), ofE, threshold);
        models->F = modelOf(scene.F, sampsonDistances(scene.F, scene.points1, scene.points2),
                            threshold);
        models->H = modelOf(H, mapDistances(H, scene.points1, scene.points2), threshold);
    }

    static Scene make(ProblemType problem)
    {
        SceneOptions options;
        options.inliers = 100;
        options.outliers = 0;
        options.noise = 0;
        options.planeFraction = 1;
        return makeScene(problem, options);
    }

    static double errorOf(const Matx33d& F, const Point2d& from, const Point2d& to)
    {
        return sampsonDistances(F, Points(1, from), Points(1, to))[0];
    }
    double errorOf(const Matx33d& F, int i, const Point2d& to) const
    {
        return errorOf(F, scene.points1[i], to);
    }

    Scene scene;
    TwoViewPair pair;
    Params params;
    const TwoViewRules rules;
    Ptr<PairModels> models;
};

//! A plane does not determine the epipole. If F explains more matches than E, but H explains these
//! matches, too, F is no evidence that the focal lengths are wrong, and E must be preferred. If
//! these matches are off the plane, they are evidence, and F must be preferred.
TEST(Usac_PairModels, evidence_against_the_cameras)
{
    for (int off = 0; off < 2; ++off)
    {
        const PlaneOfWrongE plane(off != 0);
        const PairModels& models = *plane.models;
        EXPECT_EQ(60, models.E.inliers);
        EXPECT_EQ(100, models.F.inliers);
        EXPECT_EQ(off ? 80 : 100, models.H.inliers);
        EXPECT_TRUE(models.mostlyOnPlane(models.E));
        EXPECT_EQ(off ? &models.F : &models.E, models.base()) << off;
    }
}

//! The focal lengths are wrong, so that F replaces E. The report must contain the noise of the
//! inliers of F, as if F had been estimated alone with the threshold of the pair. The threshold has
//! been estimated from the errors of E, which are larger than those of F.
TEST(Usac_PairModels, noise_of_an_F_that_replaces_E)
{
    int replaced = 0;
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        TwoViewPair pair = pairOf(twoViewScene(seed));
        pair.cameraMatrix1.at<double>(0, 0) *= 1.5;
        pair.cameraMatrix1.at<double>(1, 1) *= 1.5;
        Params params = Params::automatic();
        params.covariance = 1;
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
        if (found.configuration != TWO_VIEW_UNCALIBRATED)
            continue;
        params.thresholdType = THRESHOLD_GIVEN;
        params.threshold = found.report.threshold;
        Mat mask;
        Report alone;
        estimateFundamental(pair.points1, pair.points2, params, mask, alone);
        EXPECT_NEAR(alone.sigma, found.report.sigma, 0.05 * alone.sigma) << seed;
        ++replaced;
    }
    EXPECT_GE(replaced, 5);
}

//! If E is rejected, F is accepted only if its Report::chance is at most the square of
//! Params::significance. The square of 1e-170 is 0 in double precision, but must not count as an
//! unset significance.
TEST(Usac_PairModels, significance_whose_square_is_zero)
{
    for (uint64 seed = 1; seed <= 5; ++seed)
    {
        SceneOptions options;
        options.seed = seed;
        options.inliers = 50;
        options.outliers = 50;
        const TwoViewPair pair = pairOf(makeScene(ESSENTIAL, options));
        Params params = twoPixels();
        EXPECT_EQ((int)TWO_VIEW_CALIBRATED, estimateTwoViewGeometry(pair, params).configuration);
        params.significance = 1e-170;
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
        EXPECT_EQ((int)TWO_VIEW_DEGENERATE, found.configuration) << seed;
        EXPECT_TRUE(found.F.empty()) << seed;
        EXPECT_GT(found.report.chance, params.significance) << seed;
    }
}

//! If only H is accepted, the scene is planar, whatever `planarRatio` is; with unknown cameras, it
//! can also be panoramic.
TEST(Usac_PairModels, onlyH)
{
    int only[2] = {0, 0};
    for (int i = 0; i < 60; ++i)
    {
        Params params;
        params.threshold = 4;
        TwoViewRules rules;
        rules.minInliers = 12;
        rules.planarRatio = 1;
        const TwoViewGeometry found = estimateTwoViewGeometry(
            pairOf(planeAlone(1 + i / 2), i % 2 != 0), params, rules);
        if (found.H.empty() || !found.E.empty() || !found.F.empty())
            continue;
        ++only[i % 2];
        EXPECT_EQ(i % 2 ? (int)TWO_VIEW_PLANAR : (int)TWO_VIEW_PLANAR_OR_PANORAMIC,
                  found.configuration)
            << i;
    }
    EXPECT_GT(only[0], 0);
    EXPECT_GT(only[1], 0);
}

//! Of the two motions that explain a plane, the one with the lower cost must be returned, as by
//! estimateRelativePose.
TEST(Usac_PairModels, motion_of_a_plane)
{
    int right = 0, expected = 0;
    for (uint64 seed = 1; seed <= 40; ++seed)
    {
        const Scene scene = twoViewScene(seed, 1, 60);
        Mat R, t, mask;
        RelativePose pose;
        ASSERT_TRUE(estimateRelativePose(scene.points1, scene.points2, scene.K, noArray(),
                                         noArray(), noArray(), twoPixels(), R, t, mask, pose));
        expected += angleBetween(R, scene.R) < 3 * DEGREE;
        const TwoViewGeometry found = estimateTwoViewGeometry(pairOf(scene), twoPixels());
        right += !found.R.empty() && angleBetween(found.R, scene.R) < 3 * DEGREE;
        EXPECT_EQ(found.inliers, found.report.inliers) << seed;
    }
    EXPECT_GE(right, expected - 1);
}

//! The camera of image 2 has three times the focal length, and the noise is the same in pixels of
//! both images: E must not be less accurate than F.
TEST(Usac_PairModels, two_focal_lengths)
{
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        Scene scene = twoViewScene(seed, 0, 60);
        RNG rng(seed);
        for (int i = 0; i < scene.size(); ++i)
            scene.points2[i] = scene.clean2[i] * 3. + gaussianPoint(rng, 0.5);
        TwoViewPair pair = pairOf(scene);
        pair.cameraMatrix2.rowRange(0, 2) *= 3;
        Params params = twoPixels();
        params.threshold = 1;
        EXPECT_EQ((int)TWO_VIEW_CALIBRATED, estimateTwoViewGeometry(pair, params).configuration)
            << seed;
    }
}

}  // namespace
}  // namespace opencv_test
