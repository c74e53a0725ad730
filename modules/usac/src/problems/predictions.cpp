// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "input/read_arrays.hpp"
#include "problems/predictions.hpp"

namespace cv {
namespace usacv20 {

Prediction::Kind Prediction::kindOf(ProblemType problem)
{
    switch (problem)
    {
    case FUNDAMENTAL:
    case ESSENTIAL: return LINE;
    case ABSOLUTE_POSE: return CAMERA;
    case RIGID_3D:
    case SIMILARITY_3D: return MOTION;
    default: return MAP;
    }
}

Prediction::Prediction(ProblemType problem, InputArray cameraMatrix1, InputArray cameraMatrix2)
    : kind(kindOf(problem)), K(Matx33d::eye()), first(Matx33d::eye()), second(Matx33d::eye())
{
    if (kind == CAMERA)
        K = readCamera(cameraMatrix1, "cameraMatrix1");
    if (problem != ESSENTIAL)
        return;
    first = readCamera(cameraMatrix1, "cameraMatrix1").inv();
    second = cameraMatrix2.empty() ? first : readCamera(cameraMatrix2, "cameraMatrix2").inv();
}

void Prediction::linearize(const Model& model, const double* datum, double* derivative) const
{
    std::fill(derivative, derivative + components() * model.size(), 0.);
    if (kind == LINE)
        lineDistance(model, datum, derivative);
    else if (kind != MOTION)
        project(model, datum, derivative);
    else
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 4; ++k)
                derivative[i * model.size() + 4 * i + k] = k < 3 ? datum[k] : 1;
}

//! The image point is K M x divided by its third component. M is the model, and x is the datum in
//! homogeneous coordinates.
void Prediction::project(const Model& model, const double* datum, double* derivative) const
{
    const int cols = model.cols, size = model.size();
    double x[4], y[3] = {0, 0, 0};
    for (int k = 0; k < cols; ++k)
        x[k] = k + 1 < cols ? datum[k] : 1;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < cols; ++k)
            y[i] += model(i, k) * x[k];
    const Vec3d image = K * Vec3d(y);
    for (int c = 0; c < 2; ++c)
        for (int i = 0; i < 3; ++i)
        {
            // derivative of coordinate c of the image point with respect to y[i]
            const double factor = (K(c, i) - image[c] / image[2] * K(2, i)) / image[2];
            for (int k = 0; k < cols; ++k)
                derivative[c * size + cols * i + k] = factor * x[k];
        }
}

//! The epipolar line in image 2 is l = second^T M first x1, where M is the model. The signed
//! distance of x2 from this line is l^T x2 / |(l_1, l_2)|.
void Prediction::lineDistance(const Model& model, const double* datum, double* derivative) const
{
    const Vec3d x1 = first * Vec3d(datum[0], datum[1], 1), x2(datum[2], datum[3], 1);
    const Vec3d line = second.t() * (Matx33d(model) * x1);
    const double norm = std::sqrt(line[0] * line[0] + line[1] * line[1]);
    const double distance = line.dot(x2) / norm;
    const Vec3d byLine((x2[0] - distance * line[0] / norm) / norm,
                       (x2[1] - distance * line[1] / norm) / norm, 1 / norm);
    const Vec3d rows = second * byLine;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            derivative[3 * i + k] = rows[i] * x1[k];
}

}  // namespace usacv20
}  // namespace cv
