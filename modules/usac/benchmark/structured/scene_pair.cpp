// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "scene_pair.hpp"

namespace benchmark {

ImagePair toImagePair(const opencv_test::Scene& scene)
{
    ImagePair pair;
    pair.name = cv::format("%d matches", scene.size());
    pair.points1.assign(scene.points1.begin(), scene.points1.end());
    pair.points2.assign(scene.points2.begin(), scene.points2.end());
    pair.scores = scene.scores;
    pair.size1 = pair.size2 = cv::Size2d(opencv_test::SCENE_WIDTH, opencv_test::SCENE_HEIGHT);
    pair.hasCamera1 = pair.hasCamera2 = pair.hasPose = true;
    pair.K1 = pair.K2 = scene.K;
    pair.R = scene.R;
    pair.t = scene.t;
    for (int i = 0; i < scene.size(); ++i)
        if (scene.truth[i])
        {
            pair.truth1.push_back(scene.clean1[i]);
            pair.truth2.push_back(scene.clean2[i]);
        }
    return pair;
}

}  // namespace benchmark
