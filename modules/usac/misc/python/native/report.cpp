// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include <pybind11/stl.h>
#include "arrays.hpp"
#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

void addReport(py::module_& module)
{
    py::class_<Report>(module, "Report")
        .def(py::init<>())
        .def_readwrite("stop", &Report::stop)
        .def_readwrite("iterations", &Report::iterations)
        .def_readwrite("rejectedSamples", &Report::rejectedSamples)
        .def_readwrite("degenerateSamples", &Report::degenerateSamples)
        .def_readwrite("models", &Report::models)
        .def_readwrite("rejectedModels", &Report::rejectedModels)
        .def_readwrite("refusedModels", &Report::refusedModels)
        .def_readwrite("droppedModels", &Report::droppedModels)
        .def_readwrite("localOptimizations", &Report::localOptimizations)
        .def_readwrite("localImprovements", &Report::localImprovements)
        .def_readwrite("degenerate", &Report::degenerate)
        .def_readwrite("inliers", &Report::inliers)
        .def_property(
            "sample", [](const Report& report) { return py::tuple(py::cast(report.sample)); },
            [](Report& report, const std::vector<int>& sample) { report.sample = sample; })
        .def_readwrite("inlierRatio", &Report::inlierRatio)
        .def_readwrite("independentInliers", &Report::independentInliers)
        .def_readwrite("chance", &Report::chance)
        .def_readwrite("threshold", &Report::threshold)
        .def_readwrite("sigma", &Report::sigma)
        .def_property(
            "covariance", [](const Report& report) { return arrayOf(report.covariance); },
            [](Report& report, const py::object& covariance) {
                report.covariance = ArrayMat(covariance, "covariance").own();
            })
        .def_readwrite("priorChance", &Report::priorChance)
        .def_readwrite("wideThreshold", &Report::wideThreshold)
        .def_property(
            "warning", [](const Report& report) { return (std::string)report.warning; },
            [](Report& report, const std::string& warning) { report.warning = warning; })
        .def_readwrite("cost", &Report::cost)
        .def_readwrite("setupMs", &Report::setupMs)
        .def_readwrite("searchMs", &Report::searchMs)
        .def_readwrite("localMs", &Report::localMs)
        .def_readwrite("polishMs", &Report::polishMs)
        .def("describe", [](const Report& report) { return (std::string)report.describe(); });
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
