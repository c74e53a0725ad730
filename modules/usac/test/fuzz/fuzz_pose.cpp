// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "fuzz/fuzz_pose.hpp"

#include <algorithm>
#include "problems/absolute_pose/pose_scenes.hpp"

using cv::Point2d;
using cv::Point3d;

namespace opencv_test {

namespace {

//! Reads the options of a scene with true and wrong matches, and makes this scene, without lens
//! distortion.
void readPoseScene(Bytes& bytes, FuzzInput& input)
{
    PoseSceneOptions options;
    options.size = 4 + bytes.below(90);
    options.inlierRatio = (1 + bytes.below(10)) / 10.;
    options.noise = bytes.below(8) / 4.;
    options.seed = (uint64)bytes.byte();
    options.shape = (PoseShape)bytes.below(POSE_CLUSTER + 1);
    options.outliers = (PoseOutliers)bytes.below(POSE_OUTLIERS_SECOND_POSE + 1);
    const int wrong = options.size - std::max(3, cvRound(options.size * options.inlierRatio));
    options.behind = wrong * bytes.below(4) / 4;
    options.atCenter = (wrong - options.behind) * bytes.below(4) / 8;
    options.copies = 1 + bytes.below(2);
    PoseScene scene = makePoseScene(options);
    input.object = scene.object;
    input.points2 = scene.image;
}

//! Makes at most one change: of one or two rows, of all rows, or of the number of rows.
void edit(Bytes& bytes, std::vector<Point3d>& object, std::vector<Point2d>& image)
{
    if (object.empty() || image.empty())
        return;
    const int kind = bytes.below(8), which = bytes.below(5);
    const int row = bytes.byte(), other = bytes.byte();
    Point3d& space = object[row % object.size()];
    Point2d& seen = image[row % image.size()];
    if (kind == 0)
        (which < 3 ? coordinateOf(space, which) : which == 3 ? seen.x : seen.y) = bytes.number();
    else if (kind == 1)
        space = Point3d(object[other % object.size()]);
    else if (kind == 2)
        seen = Point2d(image[other % image.size()]);
    else if (kind == 3)
        for (int i = 0; i < other % 64; ++i)
        {
            object.push_back(Point3d(object[row % object.size()]));
            image.push_back(Point2d(image[row % image.size()]));
        }
    else if (kind == 4 && bytes.below(16) == 0)
        object.resize(other);
    else
    {
        const double number = bytes.number();
        for (size_t i = 0; i < object.size(); ++i)
            if (kind == 5)
                object[i] *= number;
            else if (which < 3)
                coordinateOf(object[i], which) = number +
                                                 (kind == 6) * coordinateOf(object[i], which);
        for (size_t i = 0; i < image.size() && which >= 3 && kind != 5; ++i)
            (which == 3 ? image[i].x : image[i].y) = number +
                                                     (kind == 6) *
                                                         (which == 3 ? image[i].x : image[i].y);
    }
}

}  // namespace

void readPosePoints(Bytes& bytes, FuzzInput& input)
{
    const int kind = bytes.kindOfPoints(), edits = std::max(bytes.below(16) - 4, 0),
              most = bytes.below(120);
    if (kind > 3)
        readPoseScene(bytes, input);
    for (int i = 0; i < most && bytes.left() > 0; ++i)
    {
        const double x = bytes.coordinate(kind % 6), y = bytes.coordinate(kind % 6),
                     z = bytes.coordinate(kind % 6);
        const double u = bytes.coordinate(kind % 6), v = bytes.coordinate(kind % 6);
        input.object.push_back(Point3d(x, y, z));
        input.points2.push_back(Point2d(u, v));
    }
    for (int i = 0; i < edits; ++i)
        edit(bytes, input.object, input.points2);
}

}  // namespace opencv_test
