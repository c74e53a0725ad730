// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PREDICTIONS_HPP
#define OPENCV_USACV20_PREDICTIONS_HPP

#include "opencv2/usac/problem.hpp"

namespace cv {
namespace usacv20 {

/** @brief The derivative of a model's prediction for a datum with respect to the model. The
prediction is the position of the mapped, projected or moved point; for F and E, it is the signed
distance of the point of image 2 from its epipolar line. */
class Prediction
{
public:
    //! Maximum number of components of a prediction.
    enum { MOST = 3 };

    //! Camera matrices as for Usac::create; not used by problems without cameras.
    Prediction(ProblemType problem, InputArray cameraMatrix1, InputArray cameraMatrix2);

    //! Number of components of a prediction: 1 to 3.
    int components() const { return kind == LINE ? 1 : kind == MOTION ? 3 : 2; }
    //! True if the prediction also depends on the point of array 2.
    bool needsBoth() const { return kind == LINE; }
    /** @brief Computes the derivatives of the components with respect to the entries of the model.
    @param model 3x3, or 3x4 for points of space; [R t] for an absolute pose, otherwise as returned
    by Problem::ofOutput
    @param datum coordinates of the point of array 1; for F and E, followed by those of the point of
    array 2
    @param derivative output, components() rows of Model::size() numbers; not finite if the
    prediction is not finite */
    void linearize(const Model& model, const double* datum, double* derivative) const;

private:
    enum Kind { MAP, LINE, CAMERA, MOTION };

    static Kind kindOf(ProblemType problem);
    void project(const Model& model, const double* datum, double* derivative) const;
    void lineDistance(const Model& model, const double* datum, double* derivative) const;

    const Kind kind;
    Matx33d K;              //!< camera matrix for absolute poses, otherwise the identity
    Matx33d first, second;  //!< for E, inverse camera matrices; otherwise the identity
};

}  // namespace usacv20
}  // namespace cv

#endif
