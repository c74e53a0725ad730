// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "native.hpp"
#include "opencv2/usac/params_fields.hpp"

namespace cv {
namespace usacv20 {
namespace python {

namespace {

//! Adds each field as a property. An enumerator is an integer in Python. If a field is a list, the
//! property returns an array with a copy of the list.
struct FieldAdder
{
    py::class_<Params>& type;
    template <class T>
    void operator()(const char* name, T Params::*field, const FieldValues&)
    {
        typedef typename std::conditional<std::is_enum<T>::value, int, T>::type Value;
        type.def_property(
            name, [field](const Params& params) { return (Value)(params.*field); },
            [field](Params& params, Value value) { params.*field = (T)value; });
    }
    template <class T>
    void operator()(const char* name, std::vector<T> Params::*field, const FieldValues&)
    {
        type.def_property(
            name,
            [field](const Params& params) {
                return py::array_t<T>((py::ssize_t)(params.*field).size(), (params.*field).data());
            },
            [field](Params& params,
                    const py::array_t<T, py::array::c_style | py::array::forcecast>& values) {
                (params.*field).assign(values.data(), values.data() + values.size());
            });
    }
};

}  // namespace

void addParams(py::module_& module)
{
    py::class_<Params> type(module, "Params");
    type.def(py::init<>());
    FieldAdder add = {type};
    visitFields(add);
    type.def("check", &Params::check, py::arg("count") = -1);
    type.def_static(
        "fromMethod", [](int method) { return Params::fromMethod(method); }, py::arg("method"));
    type.def_static("usacV20", &Params::usacV20);
    type.def_static("fast", &Params::fast);
    type.def_static("accurate", &Params::accurate);
    type.def_static("sorted", &Params::sorted);
    type.def_static("trustedScores", &Params::trustedScores);
    type.def_static("parallel", &Params::parallel);
    type.def_static("automatic", &Params::automatic);
    type.def_static("ransac", &Params::ransac);
    type.def_static("msac", &Params::msac);
    type.def_static("lmeds", &Params::lmeds);
    type.def_static("mlesac", &Params::mlesac);
    type.def_static("prosac", &Params::prosac);
    type.def_static("loRansac", &Params::loRansac);
    type.def_static("floRansac", &Params::floRansac);
    type.def_static("gcRansac", &Params::gcRansac);
    type.def_static("usac2013", &Params::usac2013);
    type.def_static("paper", &Params::paper);
    type.def_static("magsac", &Params::magsac);
    type.def_static("magsacPlusPlus", &Params::magsacPlusPlus);
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
