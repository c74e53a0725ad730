// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP

#include "method.hpp"

namespace benchmark {

/** A flag of calib3d, called as a user calls it.

H: `cv::findHomography(points1, points2, flag, threshold, mask, maxIters, confidence)`. F:
`cv::findFundamentalMat(points1, points2, flag, threshold, confidence, maxIters, mask)`. E:
`cv::findEssentialMat(points1, points2, K1, dist, K2, dist, flag, confidence, threshold, mask)` for
1000 iterations, which is what that function always does. For another number: OpenCV's RANSAC and
LMEDS take the form with one camera matrix, after the same change of coordinates to the mean camera
that the function with two makes; its USAC flags take the form with cv::UsacParams, filled with what
the flag stands for (calib3d sets the lengths of the iterated local optimization of USAC_FAST in a
way that cv::UsacParams cannot express).

A: `cv::estimateAffine2D(points1, points2, mask, flag, threshold, maxIters, confidence)`, with 10
steps of its last refinement. S: the same of `cv::estimateAffinePartial2D`, which has RANSAC and
LMEDS only.

P: `cv::solvePnPRansac(objectPoints, points2, K2, distortion, rvec, tvec, false, maxIters,
threshold, confidence, inliers, flag)`; PNP_ITERATIVE is its flag SOLVEPNP_ITERATIVE and so on. To
make a matrix of the rotation and a mask of the indices takes a microsecond or two, which is in the
time.

R and M: no flags of calib3d, but its functions for affine maps of space, see RigidMotion::Rival.

These functions seed themselves; every repeat gives the same answer (USAC_PARALLEL: nearly). */
class OpenCVMethod : public Method
{
public:
    //! @param flag without "cv:". @param scores USAC_PROSAC: the points are sorted by score inside
    //! of the time measured.
    OpenCVMethod(const std::string& name, const std::string& flag, bool scores);

    bool solves(ProblemType problem) const CV_OVERRIDE;
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    static std::string names();

private:
    void runSorted(const ImagePair& pair, Estimate& estimate) const;

    int flag;
    std::string problems;  //!< letters of those that it solves
    bool sortPoints;
    Settings settings;
};

}  // namespace benchmark

#endif
