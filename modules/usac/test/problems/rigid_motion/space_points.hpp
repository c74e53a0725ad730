// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_SPACE_POINTS_HPP
#define OPENCV_USACV20_TEST_SPACE_POINTS_HPP

#include <vector>
#include "opencv2/core.hpp"
#include "opencv2/usac.hpp"

namespace opencv_test {

//! Pairs of 3-D points as Correspondences for solvers; they are valid as long as this object
//! exists.
class SpacePoints
{
public:
    template <class Points>
    SpacePoints(const Points& points1, const Points& points2) : points()
    {
        const int count = (int)points1.size();
        floats = cv::Mat::zeros(6, (int)cv::alignSize(std::max(count, 1), 16), CV_32F);
        for (int k = 0; k < 6; ++k)
        {
            for (int i = 0; i < count; ++i)
            {
                const cv::Vec3d point(k < 3 ? points1[i] : points2[i]);
                doubles[k].push_back(point[k % 3]);
                floats.at<float>(k, i) = (float)point[k % 3];
            }
            points.exact[k] = doubles[k].data();
            points.column[k] = floats.ptr<float>(k);
        }
        for (int i = 0; i < count; ++i)
            all.push_back(i);
        points.size = points.inputSize = count;
        points.coordinates[0] = points.coordinates[1] = 3;
        points.inputIndex = all.data();
    }

    const cv::usacv20::Correspondences& view() const { return points; }
    //! The indices of all points: 0, 1, 2, ...
    const int* indices() const { return all.data(); }

private:
    cv::usacv20::Correspondences points;
    std::vector<double> doubles[6];
    cv::Mat floats;
    std::vector<int> all;

    SpacePoints(const SpacePoints&);
    SpacePoints& operator=(const SpacePoints&);
};

}  // namespace opencv_test

#endif
