// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SCENE_GEOMETRY_HPP
#define OPENCV_USACV20_TEST_SCENE_GEOMETRY_HPP

#include "support/scenes.hpp"

// The cameras of a Scene and the points that they see.

namespace opencv_test {

//! Minimum distance in pixels of points without noise from the border of their image (except with
//! OUTLIERS_BORDER).
const double SCENE_MARGIN = 5;

//! Returns true if p is inside the image and farther than SCENE_MARGIN from its border.
bool inside(const cv::Point2d& p);

cv::Point2d randomPixel(cv::RNG& rng);

//! Sets the cameras and the models of the scene, and draws a plane n^T X = 1 in front of camera 1
//! (in its coordinates). @return n
cv::Vec3d makeGeometry(Scene& scene, cv::RNG& rng, const SceneOptions& options);

//! What is needed to draw points: the cameras, the plane and the options.
struct Geometry
{
    Geometry(const Scene& scene_, const cv::Vec3d& normal_, const SceneOptions& options_)
        : scene(scene_), normal(normal_), options(options_)
    {}

    const Scene& scene;
    const cv::Vec3d normal;
    const SceneOptions& options;
};

//! Finds the point p2 of image 2 that belongs to p1: for affine maps, where the model maps p1;
//! otherwise the image of a point in space, which is on the plane if `plane` is true and at a
//! random depth if not. @return inside(p2)
bool follow(const Geometry& g, bool plane, cv::RNG& rng, const cv::Point2d& p1, cv::Point2d& p2);

//! Draws the images p1 and p2 of a point in space that both cameras see. If `plane` is true, the
//! point is on the plane.
void seenPoint(const Geometry& g, bool plane, cv::RNG& rng, cv::Point2d& p1, cv::Point2d& p2);

//! True for an affinity, a similarity or a translation.
bool isAffine(cv::usacv20::ProblemType problem);

}  // namespace opencv_test

#endif
