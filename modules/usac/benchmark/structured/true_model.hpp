// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP
#define OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP

#include <vector>
#include "support/scenes.hpp"

namespace benchmark {

/** A model as a point of its manifold: H up to scale, F of rank 2, or E = [t]x R. Models are in the
coordinates of the normalized image plane, where their entries are of about unit size. Both images
have the same camera matrix with a single focal length, so errors remain proportional to pixels. */
class TrueModel
{
public:
    enum { MAX_DIRECTIONS = 9 };

    //! Starts from the model that the scene was made with.
    explicit TrueModel(const opencv_test::Scene& scene);

    /** Least squares of the transfer (H) or Sampson distances of the noisy points, starting from
    this model. It uses Levenberg-Marquardt with numeric derivatives until convergence. It shares no
    code with the module, whose solvers are being measured.
    @param rows the rows of the scene to use */
    TrueModel leastSquares(const std::vector<int>& rows) const;

    //! The model in the form that an estimator returns: H and F in pixels, E.
    cv::Mat matrix() const;

private:
    int directions() const;
    int residualsOfRow() const { return scene->problem == cv::usacv20::HOMOGRAPHY ? 2 : 1; }
    void setMatrix(const cv::Matx33d& M);
    //! Moves the model by a step in its tangent space. One direction of this space, `radial`,
    //! changes the scale only.
    TrueModel moved(const cv::Vec<double, MAX_DIRECTIONS>& step) const;
    cv::Vec<double, MAX_DIRECTIONS> radial() const;
    //! Signed distances in the normalized image plane; two for each row for H, otherwise one.
    void residuals(const std::vector<int>& rows, std::vector<double>& values) const;
    //! J^T J plus a term that fixes the radial direction, and -J^T r.
    void normalEquations(const std::vector<int>& rows, cv::Mat& A, cv::Mat& b) const;

    const opencv_test::Scene* scene;
    cv::Matx33d model, U, Vt;  //!< model: unit Frobenius norm; U, Vt: singular vectors of F
    cv::Matx33d R;             //!< rotation of E
    cv::Vec3d t;
};

}  // namespace benchmark

#endif
