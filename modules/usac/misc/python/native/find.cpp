// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// The functions of calib3d with a flag of this module or of OpenCV, and solvePnPRansac with Params.
// They run on copies of the arrays and without the interpreter's lock.

#include "arrays.hpp"
#include "unlocked.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Calls, without the interpreter's lock, a function that returns a model and writes a mask.
//! @return the model and the mask
template <class Function>
py::tuple unlocked(const Function& find)
{
    Mat model, mask;
    {
        const Unlocked unlocked;
        model = find(mask);
    }
    return py::make_tuple(arrayOf(model), arrayOf(mask));
}

py::tuple homography(const py::object& srcPoints, const py::object& dstPoints, int method,
                     double threshold, int maxIters, double confidence)
{
    const Mat points1 = own(srcPoints, "srcPoints"), points2 = own(dstPoints, "dstPoints");
    return unlocked([&](Mat& mask) {
        return usacv20::findHomography(points1, points2, method, threshold, mask, maxIters,
                                       confidence);
    });
}

py::tuple fundamental(const py::object& array1, const py::object& array2, int method,
                      double threshold, double confidence, int maxIters)
{
    const Mat points1 = own(array1, "points1"), points2 = own(array2, "points2");
    return unlocked([&](Mat& mask) {
        return usacv20::findFundamentalMat(points1, points2, method, threshold, confidence,
                                           maxIters, mask);
    });
}

py::tuple essential(const py::object& array1, const py::object& array2,
                    const py::object& cameraMatrix, int method, double prob, double threshold,
                    int maxIters)
{
    const Mat points1 = own(array1, "points1"), points2 = own(array2, "points2"),
              K = own(cameraMatrix, "cameraMatrix");
    return unlocked([&](Mat& mask) {
        return usacv20::findEssentialMat(points1, points2, K, method, prob, threshold, maxIters,
                                         mask);
    });
}

py::tuple essentialOfFocal(const py::object& array1, const py::object& array2, double focal,
                           const std::pair<double, double>& pp, int method, double prob,
                           double threshold, int maxIters)
{
    const Mat points1 = own(array1, "points1"), points2 = own(array2, "points2");
    const Point2d center(pp.first, pp.second);
    return unlocked([&](Mat& mask) {
        return usacv20::findEssentialMat(points1, points2, focal, center, method, prob, threshold,
                                         maxIters, mask);
    });
}

py::tuple essentialOfCameras(const py::object& array1, const py::object& array2,
                             const py::object& cameraMatrix1, const py::object& distCoeffs1,
                             const py::object& cameraMatrix2, const py::object& distCoeffs2,
                             int method, double prob, double threshold)
{
    const Mat points1 = own(array1, "points1"), points2 = own(array2, "points2");
    const Mat K1 = own(cameraMatrix1, "cameraMatrix1"), K2 = own(cameraMatrix2, "cameraMatrix2");
    const Mat d1 = own(distCoeffs1, "distCoeffs1"), d2 = own(distCoeffs2, "distCoeffs2");
    return unlocked([&](Mat& mask) {
        return usacv20::findEssentialMat(points1, points2, K1, d1, K2, d2, method, prob, threshold,
                                         mask);
    });
}

typedef Mat (*MapFunction)(InputArray, InputArray, OutputArray, int, double, size_t, double,
                           size_t);

template <MapFunction function>
py::tuple map(const py::object& from, const py::object& to, int method, double threshold,
              int maxIters, double confidence, int refineIters)
{
    const Mat points1 = own(from, "from_"), points2 = own(to, "to");
    return unlocked([&](Mat& mask) {
        return function(points1, points2, mask, method, threshold, (size_t)maxIters, confidence,
                        (size_t)refineIters);
    });
}

py::tuple pose(bool found, const Mat& rvec, const Mat& tvec, const Mat& inliers)
{
    return py::make_tuple(found, arrayOf(rvec), arrayOf(tvec), arrayOf(inliers));
}

py::tuple solve(const py::object& objectPoints, const py::object& imagePoints,
                const py::object& cameraMatrix, const py::object& distCoeffs,
                const py::object& rotation, const py::object& translation, bool useExtrinsicGuess,
                int iterationsCount, float reprojectionError, double confidence, int flags)
{
    const Mat X = own(objectPoints, "objectPoints"), x = own(imagePoints, "imagePoints");
    const Mat K = own(cameraMatrix, "cameraMatrix"), d = own(distCoeffs, "distCoeffs");
    Mat rvec = own(rotation, "rvec"), tvec = own(translation, "tvec"), inliers;
    bool found;
    {
        const Unlocked unlocked;
        found = usacv20::solvePnPRansac(X, x, K, d, rvec, tvec, useExtrinsicGuess, iterationsCount,
                                        reprojectionError, confidence, inliers, flags);
    }
    return pose(found, rvec, tvec, inliers);
}

py::tuple solveOfParams(const py::object& objectPoints, const py::object& imagePoints,
                        const py::object& cameraMatrix, const py::object& distCoeffs, Params params)
{
    const Mat X = own(objectPoints, "objectPoints"), x = own(imagePoints, "imagePoints");
    const Mat K = own(cameraMatrix, "cameraMatrix"), d = own(distCoeffs, "distCoeffs");
    Mat rvec, tvec, inliers;
    bool found;
    {
        const Unlocked unlocked;
        found = cv::solvePnPRansac(X, x, K, d, rvec, tvec, inliers, params);
    }
    return pose(found, rvec, tvec, inliers);
}

//! The values of the flags of cv::solvePnPRansac by name. They differ between OpenCV 4 and 5.
py::dict solvePnPFlags()
{
    py::dict flags;
    flags["SOLVEPNP_ITERATIVE"] = (int)SOLVEPNP_ITERATIVE;
    flags["SOLVEPNP_EPNP"] = (int)SOLVEPNP_EPNP;
    flags["SOLVEPNP_P3P"] = (int)SOLVEPNP_P3P;
    flags["SOLVEPNP_AP3P"] = (int)SOLVEPNP_AP3P;
    flags["SOLVEPNP_IPPE"] = (int)SOLVEPNP_IPPE;
    flags["SOLVEPNP_IPPE_SQUARE"] = (int)SOLVEPNP_IPPE_SQUARE;
    flags["SOLVEPNP_SQPNP"] = (int)SOLVEPNP_SQPNP;
    return flags;
}

}  // namespace

void addFind(py::module_& module)
{
    module.def("isUsacV20Method", &isUsacV20Method, py::arg("method"));
    module.def("lastWarning", [] { return (std::string)lastWarning(); });
    module.def("findHomography", &homography);
    module.def("findFundamentalMat", &fundamental);
    module.def("findEssentialMat", &essential);
    module.def("findEssentialMatOfFocal", &essentialOfFocal);
    module.def("findEssentialMatOfCameras", &essentialOfCameras);
    module.def("estimateAffine2D", &map<&usacv20::estimateAffine2D>);
    module.def("estimateAffinePartial2D", &map<&usacv20::estimateAffinePartial2D>);
    module.def("solvePnPRansac", &solve);
    module.def("solvePnPRansacOfParams", &solveOfParams);
    module.attr("solvePnPFlags") = solvePnPFlags();
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
