// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PLANE_MAP_HPP
#define OPENCV_USACV20_PLANE_MAP_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief Common base of the problems whose model is an affine map of the plane, x2 = A x1 + t. A
model is a homography with the last row 0 0 1, so that errors, kernels and sums are those of a
homography; the caller gets the 2x3 matrix [A t], as from cv::estimateAffine2D. */
class PlaneMapProblem : public Problem
{
public:
    int errorDimension() const CV_OVERRIDE { return 2; }
    //! As for a homography: the transfer error is measured in image 2.
    int normalization(int residual) const CV_OVERRIDE;
    bool toInput(const Model& model, const Correspondences& points,
                 Model& result) const CV_OVERRIDE;
    bool fromOutput(const std::vector<double>& output, const Correspondences& points,
                    Model& model) const CV_OVERRIDE;
    Mat toOutput(const Model& model) const CV_OVERRIDE;
    Model ofOutput(const Mat& output) const CV_OVERRIDE;
    Ptr<Residual> createResidual(int type) const CV_OVERRIDE;
    void createDegeneracies(int flags,
                            std::vector<Ptr<Degeneracy>>& degeneracies) const CV_OVERRIDE;
};

}  // namespace usacv20
}  // namespace cv

#endif
