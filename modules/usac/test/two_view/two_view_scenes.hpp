// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_TWO_VIEW_SCENES_HPP
#define OPENCV_USACV20_TEST_TWO_VIEW_SCENES_HPP

#include "support/scenes.hpp"
#include "opencv2/usac.hpp"

// Pairs of images for the tests of estimateTwoViewGeometry.

namespace opencv_test {

//! Options with a threshold of 2 pixels, a confidence of 0.999 and at most 10000 samples.
cv::usacv20::Params twoPixels();

//! Two views with 200 right matches, `planeFraction` of them on a plane, and `outliers` wrong ones.
Scene twoViewScene(uint64 seed, double planeFraction = 0, int outliers = 100);

//! A scene of twoViewScene() with 60 wrong matches, changed so that the camera only rotates between
//! the two views.
Scene turnedScene(uint64 seed);

//! 18 right matches, all on a plane, and 200 wrong ones. With so few right matches, E and F are
//! often not significant, whereas H is, because its error has two components per match.
Scene planeAlone(uint64 seed);

//! The matches of a scene, with its camera matrices if `known` is true.
cv::usacv20::TwoViewPair pairOf(const Scene& scene, bool known = true);

//! Checks the documented properties of a result with inliers.
void checkFields(const cv::usacv20::TwoViewGeometry& found, const cv::usacv20::TwoViewPair& pair);

}  // namespace opencv_test

#endif
