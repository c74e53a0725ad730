// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "native.hpp"

namespace {

//! Raises ImportError if the extension was built with a pybind11 before 2.12, but runs with NumPy 2
//! or later, in which the memory layout of type descriptors is different.
void checkNumPy()
{
#if PYBIND11_VERSION_HEX < 0x020C0000
    const std::string version = pybind11::str(
        pybind11::module_::import("numpy").attr("__version__"));
    if (std::atoi(version.c_str()) >= 2)
        throw pybind11::import_error(
            "it was built with pybind11 " CVAUX_STR(PYBIND11_VERSION_MAJOR) "." CVAUX_STR(
                PYBIND11_VERSION_MINOR) ", which knows NumPy 1 only, and this is NumPy " +
            version + ": build it with pybind11 2.12 or later, or install \"numpy < 2\"");
#endif
}

//! Makes copies and pickles of the objects of a module raise a TypeError. Without this, the pickle
//! protocols 0 and 1 create an object of a base class of pybind11, which aborts the process.
void refuseCopies(pybind11::module_& module)
{
    using namespace pybind11;
    for (const auto& member : module.attr("__dict__").cast<dict>())
        if (isinstance<type>(member.second))
            setattr(member.second, "__reduce_ex__",
                    cpp_function(
                        [](const object& self, const object&) -> object {
                            throw type_error(repr(type::of(self)).cast<std::string>() +
                                             ": its objects cannot be copied or pickled");
                        },
                        is_method(member.second)));
}

}  // namespace

PYBIND11_MODULE(_native, module)
{
    using namespace cv::usacv20::python;
    checkNumPy();
    module.attr("pybind11Version") = pybind11::make_tuple(PYBIND11_VERSION_MAJOR,
                                                          PYBIND11_VERSION_MINOR);
    module.doc() = "The compiled part of the package usacv20.";
    addErrors(module);
    addParams(module);
    addReport(module);
    addEstimate(module);
    addBatch(module);
    addFind(module);
    addLens(module);
    addGiven(module);
    addCovariance(module);
    addTwoView(module);
    addProgress(module);
    addRng(module);
    addUsac(module);
    refuseCopies(module);
}
