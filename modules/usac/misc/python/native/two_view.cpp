// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <pybind11/stl.h>
#include "arrays.hpp"
#include "unlocked.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

Size sizeOf(const py::handle& size)
{
    if (size.is_none())
        return Size();
    const std::pair<int, int> given = size.cast<std::pair<int, int>>();
    return Size(given.first, given.second);
}

//! The numbers of an array; none if `given` is None.
std::vector<float> floatsOf(const py::handle& given)
{
    if (given.is_none())
        return std::vector<float>();
    const auto array = given.cast<py::array_t<float, py::array::c_style | py::array::forcecast>>();
    return std::vector<float>(array.data(), array.data() + array.size());
}

//! Converts a tuple (points1, points2, cameraMatrix1, cameraMatrix2, distCoeffs1, distCoeffs2,
//! imageSize1, imageSize2, taken1, taken2, scores, sigmas). All are arrays, except the sizes, which
//! are pairs of integers; all except the points can be None.
TwoViewPair pairOf(const py::tuple& given)
{
    TwoViewPair pair;
    pair.points1 = own(given[0], "points1");
    pair.points2 = own(given[1], "points2");
    pair.cameraMatrix1 = own(given[2], "cameraMatrix1");
    pair.cameraMatrix2 = own(given[3], "cameraMatrix2");
    pair.distCoeffs1 = own(given[4], "distCoeffs1");
    pair.distCoeffs2 = own(given[5], "distCoeffs2");
    pair.imageSize1 = sizeOf(given[6]);
    pair.imageSize2 = sizeOf(given[7]);
    pair.taken1 = own(given[8], "taken1");
    pair.taken2 = own(given[9], "taken2");
    pair.scores = floatsOf(given[10]);
    pair.sigmas = floatsOf(given[11]);
    return pair;
}

py::tuple tupleOf(const TwoViewGeometry& found)
{
    return py::make_tuple(found.configuration, arrayOf(found.mask), found.inliers, arrayOf(found.F),
                          arrayOf(found.E), arrayOf(found.H), arrayOf(found.R), arrayOf(found.t),
                          arrayOf(found.rotations), found.report, found.iterations,
                          found.milliseconds, (std::string)found.reason, (std::string)found.error);
}

py::tuple one(const py::tuple& given, const Params& params, const TwoViewRules& rules)
{
    const TwoViewPair pair = pairOf(given);
    const Params options = params;
    const TwoViewRules ownRules = rules;
    TwoViewGeometry found;
    {
        const Unlocked unlocked;
        found = estimateTwoViewGeometry(pair, options, ownRules);
    }
    return tupleOf(found);
}

//! Arrays and options are copied while the interpreter's lock is held. The run does not hold the
//! lock; other threads can then change the originals.
py::list many(const py::list& given, const Params& params, const TwoViewRules& rules, int threads)
{
    std::vector<TwoViewPair> pairs;
    for (const py::handle& pair : given)
        pairs.push_back(pairOf(py::reinterpret_borrow<py::tuple>(pair)));
    const Params options = params;
    const TwoViewRules ownRules = rules;
    std::vector<TwoViewGeometry> found;
    {
        const Unlocked unlocked;
        found = estimateTwoViewGeometries(pairs, options, ownRules, threads);
    }
    py::list results;
    for (const TwoViewGeometry& geometry : found)
        results.append(tupleOf(geometry));
    return results;
}

}  // namespace

void addTwoView(py::module_& module)
{
    py::class_<TwoViewRules>(module, "TwoViewRules")
        .def(py::init<>())
        .def_readwrite("minInliers", &TwoViewRules::minInliers)
        .def_readwrite("inlierRatio", &TwoViewRules::inlierRatio)
        .def_readwrite("ratios", &TwoViewRules::ratios)
        .def_readwrite("planarRatio", &TwoViewRules::planarRatio)
        .def_readwrite("calibrationRatio", &TwoViewRules::calibrationRatio)
        .def("samples", &TwoViewRules::samples, py::arg("params"), py::arg("sampleSize"),
             py::arg("matches"))
        .def("reached", &TwoViewRules::reached, py::arg("params"), py::arg("sampleSize"),
             py::arg("matches"))
        .def("check", [](const TwoViewRules& rules) { rules.check(); });
    module.def("estimateTwoViewGeometry", &one, py::arg("pair"), py::arg("params"),
               py::arg("rules"));
    module.def("estimateTwoViewGeometries", &many, py::arg("pairs"), py::arg("params"),
               py::arg("rules"), py::arg("threads"));
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
