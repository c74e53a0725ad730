// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "fuzz/fuzz_rigid.hpp"

#include <algorithm>
#include "problems/rigid_motion/rigid_scenes.hpp"

using cv::Point3d;

namespace opencv_test {

namespace {

void readRigidScene(Bytes& bytes, FuzzInput& input)
{
    RigidSceneOptions options;
    options.size = 4 + bytes.below(90);
    options.inlierRatio = (1 + bytes.below(10)) / 10.;
    options.noise = bytes.below(8) / 400.;
    options.seed = (uint64)bytes.byte();
    options.shape = (RigidShape)bytes.below(RIGID_CLUSTER + 1);
    options.outliers = (RigidOutliers)bytes.below(RIGID_OUTLIERS_SECOND_MOTION + 1);
    options.modelScale = input.problem == cv::usacv20::SIMILARITY_3D ? (1 + bytes.below(20)) / 5.
                                                                     : 1;
    options.copies = 1 + bytes.below(2);
    options.unit = 1 << bytes.below(12);
    const RigidScene scene = makeRigidScene(options);
    input.object = scene.points1;
    input.space2 = scene.points2;
}

//! Makes at most one change: of one or two rows, of all rows, or of the number of rows.
void edit(Bytes& bytes, std::vector<Point3d>& points1, std::vector<Point3d>& points2)
{
    if (points1.empty() || points2.empty())
        return;
    const int kind = bytes.below(9), which = bytes.below(6);
    std::vector<Point3d>& points = which < 3 ? points1 : points2;
    const int row = bytes.byte(), other = bytes.byte();
    if (kind == 0)
        coordinateOf(points[row % points.size()], which % 3) = bytes.number();
    else if (kind == 1)
        points[row % points.size()] = Point3d(points[other % points.size()]);
    else if (kind == 2)
        for (int i = 0; i < other % 64; ++i)
        {
            points1.push_back(Point3d(points1[row % points1.size()]));
            points2.push_back(Point3d(points2[row % points2.size()]));
        }
    else if (kind == 3)
        points.resize(bytes.below(16) == 0 ? other : points.size());
    else if (kind == 4)
        points2 = points1;
    else
    {
        const double number = bytes.number();
        for (size_t i = 0; i < points.size(); ++i)
            if (kind == 5)
                points[i] *= number;
            else
                coordinateOf(points[i], which % 3) = number + (kind == 6) * coordinateOf(points[i],
                                                                                         which % 3);
    }
}

}  // namespace

void readSpacePoints(Bytes& bytes, FuzzInput& input)
{
    const int kind = bytes.kindOfPoints(), edits = std::max(bytes.below(16) - 4, 0),
              most = bytes.below(120);
    if (kind > 3)
        readRigidScene(bytes, input);
    for (int i = 0; i < most && bytes.left() > 0; ++i)
    {
        double x[6];
        for (double& value : x)
            value = bytes.coordinate(kind % 6);
        input.object.push_back(Point3d(x[0], x[1], x[2]));
        input.space2.push_back(Point3d(x[3], x[4], x[5]));
    }
    for (int i = 0; i < edits; ++i)
        edit(bytes, input.object, input.space2);
}

}  // namespace opencv_test
