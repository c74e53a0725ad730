// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "correspondences.hpp"

namespace cv {
namespace usacv20 {
namespace python {

py::tuple fieldsOf(const Correspondences& points, int sampleSize, const std::vector<float>& given)
{
    const int size = points.size, columns = points.columns();
    py::array_t<double> data({size, columns});
    for (int i = 0; i < size; ++i)
        for (int k = 0; k < columns; ++k)
            *data.mutable_data(i, k) = points.exact[k][i];
    py::object scores = py::none();
    if (points.scores)
    {
        py::array_t<float> own(size);
        for (int i = 0; i < size; ++i)
            *own.mutable_data(i) = given.at(points.inputIndex[i]);
        scores = std::move(own);
    }
    return py::make_tuple(data, py::array_t<int>(size, points.inputIndex), scores, points.threshold,
                          sampleSize);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
