// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "support/own_points.hpp"
#include "support/problem_objects.hpp"

#include <algorithm>

namespace opencv_test {

using namespace cv;
using namespace cv::usacv20;

OwnPoints::OwnPoints(ProblemType problem, const std::vector<Point2d>& points1,
                     const std::vector<Point2d>& points2, double inlierThreshold)
{
    const int size = (int)points1.size();
    floats = Mat::zeros(4, (int)alignSize(std::max(size, 1), 16), CV_32F);
    for (int k = 0; k < 4; ++k)
        doubles[k].resize(size);
    for (int i = 0; i < size; ++i)
    {
        const double p[4] = {points1[i].x, points1[i].y, points2[i].x, points2[i].y};
        for (int k = 0; k < 4; ++k)
        {
            doubles[k][i] = p[k];
            floats.at<float>(k, i) = (float)p[k];
        }
        index.push_back(i);
    }
    points.problem = &problemObject(problem);
    points.size = points.inputSize = size;
    points.coordinates[0] = points.coordinates[1] = 2;
    for (int k = 0; k < 4; ++k)
    {
        points.column[k] = floats.ptr<float>(k);
        points.exact[k] = doubles[k].data();
    }
    points.inputIndex = index.data();
    points.scores = 0;
    points.unit = 1;
    points.threshold = inlierThreshold;
    points.frame[0] = points.frame[1] = Frame();
    for (int k = 0; k < 4; ++k)
    {
        points.lower[k] = size
                              ? *std::min_element(floats.ptr<float>(k), floats.ptr<float>(k) + size)
                              : 0;
        points.upper[k] = size
                              ? *std::max_element(floats.ptr<float>(k), floats.ptr<float>(k) + size)
                              : 0;
    }
}

}  // namespace opencv_test
