// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Arrays with this number of dimensions or more are refused, as in cv2.
constexpr int TOO_MANY = 32;

//! The depth of a cv::Mat with elements of this type; -1 if there is none.
int depthOf(const py::dtype& type)
{
    const char kind = type.kind();
    switch (type.itemsize())
    {
    case 1: return kind == 'u' ? CV_8U : kind == 'i' ? CV_8S : -1;
    case 2: return kind == 'u' ? CV_16U : kind == 'i' ? CV_16S : -1;
    case 4: return kind == 'i' ? CV_32S : kind == 'f' ? CV_32F : -1;
    case 8: return kind == 'f' ? CV_64F : -1;
    default: return -1;
    }
}

//! True if a cv::Mat can have this memory layout: the last `solid` dimensions have no gaps, and the
//! stride of each other dimension is a multiple of the element size and at least the extent of the
//! next dimension.
bool fits(const py::array& array, int solid)
{
    py::ssize_t gapless = array.itemsize(), least = gapless;
    for (int i = (int)array.ndim() - 1; i >= 0; --i)
    {
        const py::ssize_t stride = array.strides(i), size = array.shape(i);
        const bool inside = i >= array.ndim() - solid;
        if (size > 1 &&
            (inside ? stride != gapless : stride < least || stride % array.itemsize() != 0))
            return false;
        gapless *= size;
        least = size > 1 ? stride * size : std::max(least, gapless);
    }
    return true;
}

//! A NumPy array with a copy of the matrix.
template <class T>
py::object copyOf(const Mat& mat)
{
    py::array_t<T> result({(py::ssize_t)mat.rows, (py::ssize_t)mat.cols});
    Mat target(mat.rows, mat.cols, mat.type(), result.mutable_data());
    mat.copyTo(target);
    return std::move(result);
}

}  // namespace

ArrayMat::ArrayMat(const py::object& given, const char* name)
{
    if (given.is_none())
        return;
    if (!py::isinstance<py::array>(given))
        CV_Error_(Error::StsBadArg, ("%s: an array is expected", name));
    py::array array = py::reinterpret_borrow<py::array>(given);
    const int depth = depthOf(array.dtype()), dimensions = (int)array.ndim();
    if (depth < 0 || dimensions < 1 || dimensions >= TOO_MANY)
        CV_Error_(Error::StsBadArg, ("%s: %d-byte elements in %d dimensions do not form a matrix",
                                     name, (int)array.itemsize(), dimensions));
    const bool channels = dimensions == 3 && array.shape(2) <= CV_CN_MAX && array.shape(2) > 0;
    if (!fits(array, channels ? 2 : 1))
        array = py::array::ensure(array.attr("copy")("C"));
    std::vector<int> sizes;
    std::vector<size_t> steps;
    for (int i = 0; i < dimensions - (channels ? 1 : 0); ++i)
    {
        if (array.shape(i) > INT_MAX)
            CV_Error_(Error::StsOutOfRange,
                      ("%s: at most %d rows and columns are expected", name, INT_MAX));
        sizes.push_back((int)array.shape(i));
        steps.push_back((size_t)array.strides(i));
    }
    const int type = CV_MAKETYPE(depth, channels ? (int)array.shape(2) : 1);
    if (sizes.size() == 1)
        sizes.push_back(1);
    if (array.size() == 0)
    {
        matrix = Mat((int)sizes.size(), sizes.data(), type);
        return;
    }
    // NumPy's strides of dimensions of size 1 are arbitrary. They are replaced with the strides
    // that a cv::Mat has.
    size_t step = CV_ELEM_SIZE(type);
    steps.resize(sizes.size(), step);
    for (size_t i = sizes.size(); i-- > 0; step = steps[i] * sizes[i])
        if (sizes[i] == 1)
            steps[i] = step;
    matrix = Mat((int)sizes.size(), sizes.data(), type, const_cast<void*>(array.data()),
                 steps.data());
    owner = array;
}

py::object arrayOf(const Mat& mat)
{
    if (mat.empty())
        return py::none();
    CV_Assert(mat.dims == 2 && mat.channels() == 1);
    switch (mat.depth())
    {
    case CV_8U: return copyOf<uchar>(mat);
    case CV_32S: return copyOf<int>(mat);
    case CV_32F: return copyOf<float>(mat);
    default: CV_Assert(mat.depth() == CV_64F); return copyOf<double>(mat);
    }
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
