// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP
#define OPENCV_USACV20_BENCHMARK_OPENCV_METHOD_HPP

#include "method.hpp"

namespace benchmark {

/** A method that calls a function of calib3d with a flag, as a user does.

H: `cv::findHomography(points1, points2, flag, threshold, mask, maxIters, confidence)`. F:
`cv::findFundamentalMat(points1, points2, flag, threshold, confidence, maxIters, mask)`.

E: if the limit is 1000 iterations, `cv::findEssentialMat(points1, points2, K1, dist, K2, dist,
flag, confidence, threshold, mask)`, whose limit is always 1000. For other limits there are two
ways. With RANSAC and LMEDS, the overload with one camera matrix is called; the pixels of both
images are first converted to those of a camera with the mean of K1 and K2, as the overload with two
matrices does. With the USAC flags, the overload with cv::UsacParams is called, with the values that
calib3d uses for the flag. (For USAC_FAST, calib3d sets iteration counts of the local optimization
that cv::UsacParams cannot express.)

A: `cv::estimateAffine2D(points1, points2, mask, flag, threshold, maxIters, confidence)`, with 10
iterations of the final refinement. S: `cv::estimateAffinePartial2D` with the same arguments, which
accepts only RANSAC and LMEDS.

P: `cv::solvePnPRansac(objectPoints, points2, K2, distortion, rvec, tvec, false, maxIters,
threshold, confidence, inliers, flag)`. The method cv:PNP_ITERATIVE stands for the flag
SOLVEPNP_ITERATIVE; the other names that begin with PNP_ are formed in the same way.
The measured time includes the conversion of the rotation vector to a matrix and of the indices of
the inliers to a mask, which takes a few microseconds.

R and M: calib3d has no function for these problems; its functions for affine maps of space are
called instead, see RigidMotion::Rival. T: calib3d has no function.

These functions use fixed seeds; every repeat gives the same result (USAC_PARALLEL: nearly). */
class OpenCVMethod : public Method
{
public:
    //! @param flag name of the flag, without "cv:"
    //! @param scores true: the matches are sorted by their scores before the call of calib3d; the
    //! measured time includes the sorting
    //!
    //! An unknown flag, or scores with a flag other than USAC_PROSAC, raises std::runtime_error.
    OpenCVMethod(const std::string& name, const std::string& flag, bool scores);

    bool solves(ProblemType problem) const CV_OVERRIDE;
    void prepare(const ImagePair& pair, const Settings& settings) CV_OVERRIDE;
    void run(const ImagePair& pair, Estimate& estimate) CV_OVERRIDE;

    static std::string names();

private:
    void runSorted(const ImagePair& pair, Estimate& estimate) const;

    int flag;
    std::string problems;  //!< letters of the problems that the flag can be used for
    bool sortPoints;
    Settings settings;
};

}  // namespace benchmark

#endif
