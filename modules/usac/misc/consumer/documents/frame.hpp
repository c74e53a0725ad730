// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// Variables that the parts of programs in the documents assume, with a known true model. Two images
// show 3-D points. A third of the points lies in a plane parallel to both image planes, so that its
// homography is also an affine map and a similarity. A fifth of the matches is wrong. Each part
// becomes a program, which consists of the code `before` of its rule in table.py and the part itself.

#include <atomic>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <opencv2/usac.hpp>

namespace truth {
const cv::Matx33d K(700, 0, 320, 0, 700, 240, 0, 0, 1);
const cv::Matx33d R(std::cos(0.1), -std::sin(0.1), 0, std::sin(0.1), std::cos(0.1), 0, 0, 0, 1);
const cv::Vec3d t(1, 0.2, 0);
const double depth = 10;  // depth of the plane
}

const cv::Mat K(truth::K);
const cv::Mat distortion, distCoeffs;  // empty: no distortion
std::vector<cv::Point2f> points1, points2, imagePoints;
std::vector<cv::Point3f> objectPoints, space1, space2;
std::vector<float> ratios;  // scores of the matches; lower is better

namespace frame {

inline cv::Point2f project(const cv::Vec3d& X)
{
    const cv::Vec3d x = truth::K * X;
    return cv::Point2f((float)(x[0] / x[2]), (float)(x[1] / x[2]));
}

struct Maker
{
    Maker()
    {
        cv::RNG rng(1);
        for (int i = 0; i < 300; i++)
        {
            const bool right = i % 5 != 0;
            const double z = i % 3 == 0 ? truth::depth : rng.uniform(4., 8.);
            const cv::Vec3d X(rng.uniform(-0.4, 0.4) * z, rng.uniform(-0.3, 0.3) * z, z);
            const cv::Vec3d Y = right ? truth::R * X + truth::t : X + cv::Vec3d(rng.uniform(-2., 2.), rng.uniform(-2., 2.), 1);
            objectPoints.push_back(cv::Point3f((float)X[0], (float)X[1], (float)X[2]));
            space2.push_back(cv::Point3f((float)Y[0], (float)Y[1], (float)Y[2]));
            points1.push_back(project(X));
            points2.push_back(project(Y));
            ratios.push_back((float)(right ? rng.uniform(0.3, 0.7) : rng.uniform(0.6, 0.9)));
        }
        imagePoints = points2;
        space1 = objectPoints;
    }
} const maker;
}
