// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "python_sampler.hpp"
#include "correspondences.hpp"

namespace cv {
namespace usacv20 {
namespace python {

PythonSampler::PythonSampler(const py::object& sampler_)
    : sampler(sampler_), rng(py::cast(Rng())), sampleSize(0)
{}

PythonSampler::~PythonSampler()
{
    py::gil_scoped_acquire locked;
    sampler = py::object();
    rng = py::object();
}

void PythonSampler::start(const Context& context)
{
    sampleSize = context.components.minimalSolver->sampleSize();
    py::gil_scoped_acquire locked;
    sampler.attr("_begin")(*fieldsOf(context.points, sampleSize, context.params.scores));
}

void PythonSampler::sample(const Context&, State& state, int* sample)
{
    py::gil_scoped_acquire locked;
    Rng& generator = rng.cast<Rng&>();
    generator = state.rng;
    const py::object drawn = sampler.attr("sample")(rng, state.iteration);
    state.rng = generator;
    const py::array given = py::array::ensure(drawn);
    const bool integers = given && (given.dtype().kind() == 'i' || given.dtype().kind() == 'u');
    if (!integers || given.ndim() != 1 || given.size() != sampleSize)
    {
        PyErr_Clear();
        CV_Error_(Error::StsBadArg,
                  ("components.sampler: sample() has to return %d integers, not %s", sampleSize,
                   py::repr(drawn).cast<std::string>().substr(0, 60).c_str()));
    }
    const py::array_t<int64, py::array::c_style | py::array::forcecast> indices(given);
    for (int i = 0; i < sampleSize; ++i)  // a number that is too large becomes -1, which is refused
        sample[i] = indices.at(i) == (int)indices.at(i) ? (int)indices.at(i) : -1;
    state.counts = py::bool_(sampler.attr("counts"));
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
