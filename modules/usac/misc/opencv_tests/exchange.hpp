// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_EXCHANGE_HPP
#define OPENCV_USACV20_EXCHANGE_HPP

// This file is included before the first line of each of OpenCV's test files. The tests' calls of
// findHomography, findFundamentalMat, findEssentialMat, estimateAffine2D, estimateAffinePartial2D
// and solvePnPRansac are redirected to functions with the same arguments, which replace OpenCV's
// flag with a flag of this module. OpenCV's headers are included first, so that the macros do not
// rename their declarations.

#include "opencv2/ts.hpp"
#include "opencv2/calib3d.hpp"
#include "opencv2/usac.hpp"

namespace cv {

//! The flag that replaces all flags of OpenCV, and the number of estimations with this flag.
struct Exchange
{
    static UsacV20Method flag;
    static int calls;
};

Mat exchangedHomography(InputArray points1, InputArray points2, int method = 0,
                        double threshold = 3, OutputArray mask = noArray(), int maxIters = 2000,
                        double confidence = 0.995);
Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask, int method = 0,
                        double threshold = 3);
Mat exchangedHomography(InputArray points1, InputArray points2, OutputArray mask,
                        const UsacParams& params);

Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int method, double threshold,
                            double confidence, int maxIters, OutputArray mask = noArray());
Mat exchangedFundamentalMat(InputArray points1, InputArray points2, int method = FM_RANSAC,
                            double threshold = 3, double confidence = 0.99,
                            OutputArray mask = noArray());
Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                            int method = FM_RANSAC, double threshold = 3, double confidence = 0.99);
Mat exchangedFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                            const UsacParams& params);

Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int method = RANSAC,
                          double confidence = 0.999, double threshold = 1, int maxIters = 1000,
                          OutputArray mask = noArray());
Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K, int method,
                          double confidence, double threshold, OutputArray mask);
Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal = 1,
                          Point2d pp = Point2d(), int method = RANSAC, double confidence = 0.999,
                          double threshold = 1, int maxIters = 1000, OutputArray mask = noArray());
Mat exchangedEssentialMat(InputArray points1, InputArray points2, double focal, Point2d pp,
                          int method, double confidence, double threshold, OutputArray mask);
Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1,
                          InputArray distortion1, InputArray K2, InputArray distortion2,
                          int method = RANSAC, double confidence = 0.999, double threshold = 1,
                          OutputArray mask = noArray());
Mat exchangedEssentialMat(InputArray points1, InputArray points2, InputArray K1, InputArray K2,
                          InputArray distortion1, InputArray distortion2, OutputArray mask,
                          const UsacParams& params);

Mat exchangedAffine2D(InputArray from, InputArray to, OutputArray inliers = noArray(),
                      int method = RANSAC, double threshold = 3, size_t maxIters = 2000,
                      double confidence = 0.99, size_t refineIters = 10);
Mat exchangedAffine2D(InputArray from, InputArray to, OutputArray inliers,
                      const UsacParams& params);
Mat exchangedAffinePartial2D(InputArray from, InputArray to, OutputArray inliers = noArray(),
                             int method = RANSAC, double threshold = 3, size_t maxIters = 2000,
                             double confidence = 0.99, size_t refineIters = 10);

bool exchangedPnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray K,
                        InputArray distortion, OutputArray rvec, OutputArray tvec,
                        bool useExtrinsicGuess = false, int maxIters = 100, float threshold = 8,
                        double confidence = 0.99, OutputArray inliers = noArray(),
                        int method = SOLVEPNP_ITERATIVE);
bool exchangedPnPRansac(InputArray objectPoints, InputArray imagePoints, InputOutputArray K,
                        InputArray distortion, OutputArray rvec, OutputArray tvec,
                        OutputArray inliers, const UsacParams& params = UsacParams());

}  // namespace cv

#define findHomography exchangedHomography
#define findFundamentalMat exchangedFundamentalMat
#define findEssentialMat exchangedEssentialMat
#define estimateAffine2D exchangedAffine2D
#define estimateAffinePartial2D exchangedAffinePartial2D
#define solvePnPRansac exchangedPnPRansac

#endif
