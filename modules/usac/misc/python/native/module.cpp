// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "native.hpp"

PYBIND11_MODULE(_native, module)
{
    using namespace cv::usacv20::python;
    module.doc() = "The compiled part of the package usacv20.";
    addErrors(module);
    addEnumerators(module);
    addParams(module);
    addReport(module);
    addEstimate(module);
    addBatch(module);
    addFind(module);
    addLens(module);
    addGiven(module);
    addProgress(module);
    addRng(module);
    addUsac(module);
}
