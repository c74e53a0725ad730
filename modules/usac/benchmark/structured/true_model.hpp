// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP
#define OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP

#include <vector>
#include "support/scenes.hpp"

namespace benchmark {

/** A model as a point of its manifold: H up to scale, F of rank 2, or E = [t]x R. Models are in the
coordinates of the normalized image plane, where their entries have a size of about 1. Errors there
are proportional to errors in pixels, since both images have the same camera matrix, with a single
focal length. */
class TrueModel
{
public:
    enum { MAX_DIRECTIONS = 9 };

    //! Starts from the model that the scene was made with.
    explicit TrueModel(const opencv_test::Scene& scene);

    /** The model that minimizes the squared transfer errors (H) or Sampson distances (F, E) of the
    noisy points. The Levenberg-Marquardt method, with numeric derivatives, starts from this model
    and iterates until it converges. No code of the module is used, since the module is measured.
    @param rows the rows of the scene to use */
    TrueModel leastSquares(const std::vector<int>& rows) const;

    //! The model in the form that an estimator returns: H and F for pixels, E for the normalized
    //! image plane.
    cv::Mat matrix() const;

private:
    //! Number of dimensions of the tangent space, including the scale.
    int directions() const;
    int residualsOfRow() const { return scene->problem == cv::usacv20::HOMOGRAPHY ? 2 : 1; }
    void setMatrix(const cv::Matx33d& M);
    //! The model after a step in its tangent space. One direction of this space, radial(), changes
    //! only the scale.
    TrueModel moved(const cv::Vec<double, MAX_DIRECTIONS>& step) const;
    cv::Vec<double, MAX_DIRECTIONS> radial() const;
    //! Signed errors of the rows in the normalized image plane: for H two coordinates of each row,
    //! otherwise one distance.
    void residuals(const std::vector<int>& rows, std::vector<double>& values) const;
    //! A = J^T J plus a term that fixes the radial direction, b = -J^T r, for the residuals r and
    //! their derivatives J with respect to a step.
    void normalEquations(const std::vector<int>& rows, cv::Mat& A, cv::Mat& b) const;

    const opencv_test::Scene* scene;
    cv::Matx33d model, U, Vt;  //!< model: unit Frobenius norm; U, Vt: singular vectors of F
    cv::Matx33d R;             //!< rotation of E
    cv::Vec3d t;
};

}  // namespace benchmark

#endif
