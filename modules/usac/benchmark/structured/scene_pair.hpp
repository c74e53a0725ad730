// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_PAIR_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_PAIR_HPP

#include "image_pair.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Converts a synthetic scene to a pair of the benchmark. The true points of the pair are the
//! noise-free right matches. The pair has the cameras and the pose, but no homography.
ImagePair toImagePair(const opencv_test::Scene& scene);

}  // namespace benchmark

#endif
