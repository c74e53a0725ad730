// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP
#define OPENCV_USACV20_BENCHMARK_TRUE_MODEL_HPP

#include <vector>
#include "support/scenes.hpp"

namespace benchmark {

/** A model as a point of its manifold: H up to scale, F of rank 2, E = [t]x R. All in the
coordinates of the normalized image plane, where entries are of about unit size; one camera matrix
with one focal length keeps errors proportional to pixels. */
class TrueModel
{
public:
    enum { MAX_DIRECTIONS = 9 };

    //! The model that made the scene.
    explicit TrueModel(const opencv_test::Scene& scene);

    /** Least squares of the transfer (H) or Sampson distances of the points with noise, from this
    model: Levenberg-Marquardt with numeric derivatives until nothing changes any more. Shares no
    code with the module, whose solvers are what is measured.
    @param rows which rows of the scene take part */
    TrueModel leastSquares(const std::vector<int>& rows) const;

    //! As an estimator returns it: H, F in pixels, E.
    cv::Mat matrix() const;

private:
    int directions() const;
    int residualsOfRow() const { return scene->problem == cv::usacv20::HOMOGRAPHY ? 2 : 1; }
    void setMatrix(const cv::Matx33d& M);
    //! A step along the tangent space; one direction of it, `radial`, changes the scale only.
    TrueModel moved(const cv::Vec<double, MAX_DIRECTIONS>& step) const;
    cv::Vec<double, MAX_DIRECTIONS> radial() const;
    //! Signed distances, one or two a row.
    void residuals(const std::vector<int>& rows, std::vector<double>& values) const;
    //! J^T J with a unit weight in the radial direction, and -J^T r.
    void normalEquations(const std::vector<int>& rows, cv::Mat& A, cv::Mat& b) const;

    const opencv_test::Scene* scene;
    cv::Matx33d model, U, Vt;  //!< unit Frobenius norm; F: its singular vectors
    cv::Matx33d R;             //!< E
    cv::Vec3d t;
};

}  // namespace benchmark

#endif
