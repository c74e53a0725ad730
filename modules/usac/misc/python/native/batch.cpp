// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "arrays.hpp"
#include "unlocked.hpp"

namespace cv {
namespace usacv20 {
namespace python {

//! The entry for a task in a list that has an entry for each task, or one entry for all tasks.
//! Returns `None` if the list is empty.
static py::object entryOf(const py::list& list, size_t task)
{
    if (list.empty())
        return py::none();
    return list[list.size() == 1 ? 0 : task];
}

/** Makes many estimations of one problem. Arrays and options are copied while the interpreter's
lock is held. The run does not hold the lock; other threads can then change the originals.
@return for each task (model, mask, report, error message or empty string) */
static py::list estimateBatch(int problem, const py::list& points1, const py::list& points2,
                              const py::list& params, const py::list& cameraMatrices1,
                              const py::list& cameraMatrices2, const py::list& distCoeffs1,
                              const py::list& distCoeffs2, int threads)
{
    CV_Assert(points1.size() == points2.size());
    std::vector<Task> tasks(points1.size());
    for (size_t i = 0; i < tasks.size(); ++i)
    {
        Task& task = tasks[i];
        task.problem = (ProblemType)problem;
        task.points1 = ArrayMat(points1[i], "points1").own();
        task.points2 = ArrayMat(points2[i], "points2").own();
        task.params = entryOf(params, i).cast<Params>();
        task.cameraMatrix1 = ArrayMat(entryOf(cameraMatrices1, i), "cameraMatrix1").own();
        task.cameraMatrix2 = ArrayMat(entryOf(cameraMatrices2, i), "cameraMatrix2").own();
        task.distCoeffs1 = ArrayMat(entryOf(distCoeffs1, i), "distCoeffs1").own();
        task.distCoeffs2 = ArrayMat(entryOf(distCoeffs2, i), "distCoeffs2").own();
    }
    std::vector<Estimate> found;
    {
        const Unlocked unlocked;
        found = usacv20::estimateBatch(tasks, threads);
    }
    py::list results;
    for (const Estimate& estimate : found)
        results.append(py::make_tuple(arrayOf(estimate.model), arrayOf(estimate.mask),
                                      estimate.report, (std::string)estimate.error));
    return results;
}

void addBatch(py::module_& module)
{
    module.def("estimateBatch", &estimateBatch, py::arg("problem"), py::arg("points1"),
               py::arg("points2"), py::arg("params"), py::arg("cameraMatrices1"),
               py::arg("cameraMatrices2"), py::arg("distCoeffs1"), py::arg("distCoeffs2"),
               py::arg("threads"));
}

}  // namespace python
}  // namespace usacv20
}  // namespace cv
