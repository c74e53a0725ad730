// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "native.hpp"

namespace cv {
namespace usacv20 {
namespace python {

static py::array_t<int> distinct(Rng& rng, int n, int count)
{
    if (count < 0 || count > MAX_SAMPLE_SIZE || count > n)
        CV_Error_(Error::StsOutOfRange, ("count: 0 .. %d is expected, not %d",
                                         std::max(0, std::min<int>(n, MAX_SAMPLE_SIZE)), count));
    py::array_t<int> result(count);
    rng.distinct(n, count, result.mutable_data());
    return result;
}

static int uniform(Rng& rng, int n)
{
    if (n < 1)
        CV_Error_(Error::StsOutOfRange, ("n: a number of at least 1 is expected, not %d", n));
    return rng.uniform(n);
}

void addRng(py::module_& module)
{
    py::class_<Rng>(module, "Rng",
                    "Pseudo-random numbers; the same seed and stream always give the same numbers.")
        .def(py::init<uint64, uint64>(), py::arg("seed") = 0, py::arg("stream") = 0)
        .def("next", &Rng::next, "32 uniformly distributed bits.")
        .def("uniform", &uniform, py::arg("n"), "A uniformly distributed integer from 0 to n-1.")
        .def("distinct", &distinct, py::arg("n"), py::arg("count"),
             "An array of int32 with count distinct integers from 0 to n-1; count is at most 8.");
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
