// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SCENE_GEOMETRY_HPP
#define OPENCV_USACV20_TEST_SCENE_GEOMETRY_HPP

#include "support/scenes.hpp"

// The cameras of a Scene, and what they see.

namespace opencv_test {

//! Points are so many pixels from the border of their image at least.
const double SCENE_MARGIN = 5;

bool inside(const cv::Point2d& p);

cv::Point2d randomPixel(cv::RNG& rng);

//! Cameras, and a plane n X = 1 in front of the first one. @return n
cv::Vec3d makeGeometry(Scene& scene, cv::RNG& rng, const SceneOptions& options);

//! Where the points are, and how they are seen.
struct Geometry
{
    Geometry(const Scene& scene_, const cv::Vec3d& normal_, const SceneOptions& options_)
        : scene(scene_), normal(normal_), options(options_)
    {}

    const Scene& scene;
    const cv::Vec3d normal;
    const SceneOptions& options;
};

//! The point of image 2 of one of image 1; false if it is out of sight. On the plane if `plane`.
bool follow(const Geometry& g, bool plane, cv::RNG& rng, const cv::Point2d& p1, cv::Point2d& p2);

//! A point that both cameras see; on the plane if `plane`.
void seenPoint(const Geometry& g, bool plane, cv::RNG& rng, cv::Point2d& p1, cv::Point2d& p2);

//! True for an affinity, a similarity or a translation.
bool isAffine(cv::usacv20::ProblemType problem);

}  // namespace opencv_test

#endif
