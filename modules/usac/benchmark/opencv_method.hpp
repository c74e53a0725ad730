// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP

#include "method.hpp"

namespace benchmark {

/** A method that runs a flag of calib3d, called as a user calls it.

H: `cv::findHomography(points1, points2, flag, threshold, mask, maxIters, confidence)`. F:
`cv::findFundamentalMat(points1, points2, flag, threshold, confidence, maxIters, mask)`.

E: with 1000 iterations, `cv::findEssentialMat(points1, points2, K1, dist, K2, dist, flag,
confidence, threshold, mask)`, which always does 1000 iterations. For another number, RANSAC and
LMEDS call the overload with one camera matrix, after the same change of coordinates to the mean
camera that the overload with two matrices makes. The USAC flags call the overload with
cv::UsacParams, filled with the values that the flag stands for. (For USAC_FAST, calib3d sets
iteration counts of the local optimization that cv::UsacParams cannot express.)

A: `cv::estimateAffine2D(points1, points2, mask, flag, threshold, maxIters, confidence)`, with 10
iterations of the final refinement. S: likewise `cv::estimateAffinePartial2D`, which has RANSAC and
LMEDS only.

P: `cv::solvePnPRansac(objectPoints, points2, K2, distortion, rvec, tvec, false, maxIters,
threshold, confidence, inliers, flag)`; PNP_ITERATIVE is its flag SOLVEPNP_ITERATIVE and so on. The
measured time includes the conversion of the rotation vector and the indices to a matrix and a mask,
which takes a few microseconds.

R and M: calib3d has no flags for them, but functions for affine maps of space, see
RigidMotion::Rival.

These functions use fixed seeds; every repeat gives the same result (USAC_PARALLEL: nearly). */
class OpenCVMethod : public Method
{
public:
    //! @param flag without "cv:". @param scores true for USAC_PROSAC: the points are sorted by
    //! score, within the measured time.
    OpenCVMethod(const std::string& name, const std::string& flag, bool scores);

    bool solves(ProblemType problem) const CV_OVERRIDE;
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    static std::string names();

private:
    void runSorted(const ImagePair& pair, Estimate& estimate) const;

    int flag;
    std::string problems;  //!< letters of the problems that it solves
    bool sortPoints;
    Settings settings;
};

}  // namespace benchmark

#endif
