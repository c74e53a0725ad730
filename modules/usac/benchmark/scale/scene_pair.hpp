// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_PAIR_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_PAIR_HPP

#include "image_pair.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! A synthetic scene as a pair of the benchmark. The right matches without noise are the truth.
ImagePair toImagePair(const opencv_test::Scene& scene);

}  // namespace benchmark

#endif
