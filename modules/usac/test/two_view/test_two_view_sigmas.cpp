// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"

#include "two_view_scenes.hpp"

// Tests of estimateTwoViewGeometry with a given noise level for each match (TwoViewPair::sigmas).

namespace opencv_test {
namespace {

//! A pair in which the noise of the true matches has a standard deviation of `small` pixels in even
//! rows and of 5 `small` pixels in odd rows. The sigmas of all matches are those of their rows.
TwoViewPair pairOfMixedNoise(const Scene& scene, double small)
{
    TwoViewPair pair = pairOf(scene);
    RNG rng(scene.size());
    for (int i = 0; i < scene.size(); ++i)
    {
        const double noise = i % 2 ? 5 * small : small;
        pair.sigmas.push_back((float)noise);
        if (!scene.truth[i])
            continue;
        for (int k = 0; k < 2; ++k)
        {
            pair.points1.ptr<double>(i)[k] = (&scene.clean1[i].x)[k] + rng.gaussian(noise);
            pair.points2.ptr<double>(i)[k] = (&scene.clean2[i].x)[k] + rng.gaussian(noise);
        }
    }
    return pair;
}

//! With sigmas, the sum of the rotation errors must be less than 0.7 times that without them, and
//! the mask must mark the matches whose error is at most the threshold times their sigma.
TEST(Usac_TwoViewSigmas, mask_and_accuracy)
{
    double with = 0, without = 0;
    Params params = twoPixels();
    params.threshold = 3;
    for (uint64 seed = 1; seed <= 20; ++seed)
    {
        const Scene scene = twoViewScene(seed);
        TwoViewPair pair = pairOfMixedNoise(scene, 0.2);
        const TwoViewGeometry found = estimateTwoViewGeometry(pair, params);
        ASSERT_EQ((int)TWO_VIEW_CALIBRATED, found.configuration) << seed;
        checkFields(found, pair);
        with += angleBetween(found.R, scene.R);
        const Mat errors = modelErrors(FUNDAMENTAL, found.F, pair.points1, pair.points2);
        for (int i = 0; i < errors.rows; ++i)
        {
            const double ratio = errors.at<double>(i) / pair.sigmas[i] / params.threshold;
            if (std::abs(ratio - 1) > 0.01)
            {
                EXPECT_EQ(ratio < 1, found.mask.at<uchar>(i) != 0) << seed << " " << i;
            }
        }
        pair.sigmas.clear();
        without += angleBetween(estimateTwoViewGeometry(pair, params).R, scene.R);
    }
    EXPECT_LT(with, 0.7 * without);
}

//! The result if the sigmas are multiplied by `factor` and the threshold is divided by it, which
//! must have hardly any effect.
TwoViewGeometry estimateScaled(TwoViewPair pair, double threshold, double factor)
{
    Params params = twoPixels();
    params.threshold = threshold / factor;
    for (float& sigma : pair.sigmas)
        sigma = (float)(sigma * factor);
    return estimateTwoViewGeometry(pair, params);
}

TEST(Usac_TwoViewSigmas, of_planes)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const TwoViewPair pair = pairOfMixedNoise(twoViewScene(seed, 1, 60), 0.2);
        const TwoViewGeometry found = estimateScaled(pair, 3, 1);
        EXPECT_EQ((int)TWO_VIEW_PLANAR, found.configuration) << seed;
        for (double factor : {0.25, 4.})
        {
            const TwoViewGeometry other = estimateScaled(pair, 3, factor);
            EXPECT_EQ((int)TWO_VIEW_PLANAR, other.configuration) << seed << " " << factor;
            EXPECT_NEAR(found.inliers, other.inliers, 1) << seed << " " << factor;
        }
    }
}

TEST(Usac_TwoViewSigmas, of_wrong_focal_lengths)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        TwoViewPair pair = pairOfMixedNoise(twoViewScene(seed, seed % 2 ? 0.5 : 0.8), 0.2);
        pair.cameraMatrix1.at<double>(0, 0) *= 4;
        pair.cameraMatrix1.at<double>(1, 1) *= 4;
        for (double factor : {0.1, 1., 4.})
            EXPECT_TRUE(estimateScaled(pair, 3, factor).E.empty()) << seed << " " << factor;
    }
}

TEST(Usac_TwoViewSigmas, of_wrong_number_or_value)
{
    TwoViewPair pair = pairOf(twoViewScene(1));
    pair.sigmas.assign(pair.points1.rows - 1, 1.f);
    EXPECT_THROW(estimateTwoViewGeometry(pair, twoPixels()), cv::Exception);
    pair.sigmas.assign(pair.points1.rows, 0.f);
    EXPECT_THROW(estimateTwoViewGeometry(pair, twoPixels()), cv::Exception);
}

TEST(Usac_TwoViewSigmas, of_rotations)
{
    for (uint64 seed = 1; seed <= 10; ++seed)
    {
        const Scene scene = turnedScene(seed);
        const TwoViewGeometry found = estimateScaled(pairOfMixedNoise(scene, 0.2), 3, 4);
        EXPECT_EQ((int)TWO_VIEW_PANORAMIC, found.configuration) << seed;
        EXPECT_LT(angleBetween(found.R, scene.R), 0.5 * DEGREE) << seed;
    }
}

}  // namespace
}  // namespace opencv_test
