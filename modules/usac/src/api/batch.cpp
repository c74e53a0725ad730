// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "opencv2/usac/batch.hpp"
#include "api/argument_names.hpp"
#include "control/batch_tasks.hpp"

namespace cv {
namespace usacv20 {

namespace {

// Names of members of Task, and of the list arguments from which their values are taken.
const ArgumentName LISTS_OF_CAMERAS[] = {{"cameraMatrix1", "cameraMatrices1"},
                                         {"cameraMatrix2", "cameraMatrices2"}};
const ArgumentName LISTS_OF_POSES[] = {{"points1", "objectPoints"},
                                       {"points2", "imagePoints"},
                                       {"cameraMatrix1", "cameraMatrices"},
                                       {"distCoeffs1", "distCoeffs"}};

//! Calls estimateBatch() and translates the argument names in Estimate::error.
template <size_t COUNT>
std::vector<Estimate> estimateLists(const ArgumentName (&names)[COUNT],
                                    const std::vector<Task>& tasks, int threads)
{
    std::vector<Estimate> results = estimateBatch(tasks, threads);
    for (Estimate& result : results)
        result.error = inWordsOf(names, COUNT, result.error);
    return results;
}

Estimate estimate(const Task& task)
{
    Estimate result;
    const String mistake = mistakeOf([&] {
        result.model = Usac::create(task.problem, task.points1, task.points2, task.params,
                                    task.cameraMatrix1, task.cameraMatrix2, task.distCoeffs1,
                                    task.distCoeffs2)
                           ->run(result.mask, &result.report);
    });
    if (!mistake.empty())
    {
        result = Estimate();
        result.error = mistake;
    }
    return result;
}

bool isList(InputArrayOfArrays list)
{
    const int kind = list.kind();
    return list.isMatVector() || list.isUMatVector() || kind == _InputArray::STD_VECTOR_VECTOR ||
           kind == _InputArray::STD_ARRAY_MAT;
}

//! A list of arrays with one entry for each task, a single entry for all tasks, or, if
//! `noneIsRight`, no entry.
class OneOrEach
{
public:
    OneOrEach(InputArrayOfArrays list, const char* name, size_t tasks, bool noneIsRight)
    {
        if (isList(list))
            list.getMatVector(arrays);
        else if (!list.empty())
            arrays.push_back(list.getMat());
        if (arrays.size() != tasks && arrays.size() != 1 && !(arrays.empty() && noneIsRight))
            CV_Error_(Error::StsUnmatchedSizes, ("%s: 1 or %d entries are expected, not %d", name,
                                                 (int)tasks, (int)arrays.size()));
    }

    Mat operator[](size_t task) const
    {
        return arrays.empty() ? Mat() : arrays[arrays.size() == 1 ? 0 : task];
    }

private:
    std::vector<Mat> arrays;
};

std::vector<Mat> readLists(InputArrayOfArrays lists, const char* name)
{
    std::vector<Mat> result;
    if (isList(lists))
        lists.getMatVector(result);
    else if (!lists.empty())
        CV_Error_(Error::StsBadArg,
                  ("%s: a list of lists of points is expected, not one list", name));
    return result;
}

std::vector<Task> makeTasks(ProblemType problem, InputArrayOfArrays points1,
                            InputArrayOfArrays points2, const char* name1, const char* name2,
                            const ParamsOfTasks& params)
{
    const std::vector<Mat> first = readLists(points1, name1), second = readLists(points2, name2);
    const size_t count = first.size();
    if (count != second.size())
        CV_Error_(Error::StsUnmatchedSizes,
                  ("%s and %s: lists of the same length are expected, not of %d and %d", name1,
                   name2, (int)count, (int)second.size()));
    if (params.size() != 1 && params.size() != count)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("params: one for all tasks or one for each of the %d tasks is expected, not %d",
                   (int)count, (int)params.size()));
    std::vector<Task> tasks;
    tasks.reserve(count);
    for (size_t i = 0; i < count; ++i)
        tasks.push_back(Task(problem, first[i], second[i], params[i]));
    return tasks;
}

//! Sets the first or only camera of each task, with its distortion.
void setCameras(InputArrayOfArrays matrices, const char* nameOfMatrices, InputArrayOfArrays lenses,
                const char* nameOfLenses, std::vector<Task>& tasks)
{
    const size_t count = tasks.size();
    const OneOrEach camera(matrices, nameOfMatrices, count, count == 0),
        lens(lenses, nameOfLenses, count, true);
    for (size_t i = 0; i < count; ++i)
    {
        tasks[i].cameraMatrix1 = camera[i];
        tasks[i].distCoeffs1 = lens[i];
    }
}

//! Sets the second camera of each task, with its distortion, if the lists are not empty.
void setSecondCameras(InputArrayOfArrays matrices, InputArrayOfArrays lenses,
                      std::vector<Task>& tasks)
{
    const size_t count = tasks.size();
    const OneOrEach camera(matrices, "cameraMatrices2", count, true),
        lens(lenses, "distCoeffs2", count, true);
    for (size_t i = 0; i < count; ++i)
    {
        tasks[i].cameraMatrix2 = camera[i];
        tasks[i].distCoeffs2 = lens[i];
    }
}

}  // namespace

std::vector<Estimate> estimateBatch(const std::vector<Task>& tasks, int threads)
{
    std::vector<Estimate> results(tasks.size());
    forEachTask((int)tasks.size(), threads, [&](int i) { results[i] = estimate(tasks[i]); },
                [&](int i) { results[i].report.stop = STOP_CANCELLED; });
    return results;
}

std::vector<Estimate> estimateHomographies(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                           const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(HOMOGRAPHY, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateFundamentals(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                           const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(FUNDAMENTAL, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateAffinities2D(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                           const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(AFFINITY, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateSimilarities2D(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                             const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(SIMILARITY, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateTranslations2D(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                             const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(TRANSLATION_2D, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateRigids3D(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                       const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(RIGID_3D, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateSimilarities3D(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                             const ParamsOfTasks& params, int threads)
{
    return estimateBatch(makeTasks(SIMILARITY_3D, points1, points2, "points1", "points2", params),
                         threads);
}

std::vector<Estimate> estimateEssentials(InputArrayOfArrays points1, InputArrayOfArrays points2,
                                         InputArrayOfArrays cameraMatrices1,
                                         InputArrayOfArrays cameraMatrices2,
                                         InputArrayOfArrays distCoeffs1,
                                         InputArrayOfArrays distCoeffs2,
                                         const ParamsOfTasks& params, int threads)
{
    std::vector<Task> tasks = makeTasks(ESSENTIAL, points1, points2, "points1", "points2", params);
    setCameras(cameraMatrices1, "cameraMatrices1", distCoeffs1, "distCoeffs1", tasks);
    setSecondCameras(cameraMatrices2, distCoeffs2, tasks);
    return estimateLists(LISTS_OF_CAMERAS, tasks, threads);
}

std::vector<Estimate> estimateAbsolutePoses(InputArrayOfArrays objectPoints,
                                            InputArrayOfArrays imagePoints,
                                            InputArrayOfArrays cameraMatrices,
                                            InputArrayOfArrays distCoeffs,
                                            const ParamsOfTasks& params, int threads)
{
    std::vector<Task> tasks = makeTasks(ABSOLUTE_POSE, objectPoints, imagePoints, "objectPoints",
                                        "imagePoints", params);
    setCameras(cameraMatrices, "cameraMatrices", distCoeffs, "distCoeffs", tasks);
    return estimateLists(LISTS_OF_POSES, tasks, threads);
}

}  // namespace usacv20
}  // namespace cv
