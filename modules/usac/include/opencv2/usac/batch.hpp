// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_HPP
#define OPENCV_USACV20_BATCH_HPP

#ifndef OPENCV_BINDING_PARSER  // other languages have their own functions for this

#include <vector>
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief One estimation of a batch: the arguments of #estimateHomography and similar functions. */
struct CV_EXPORTS Task
{
    Task() : problem(HOMOGRAPHY) {}
    //! Sets all members except camera matrices and distortions, which can be set afterward.
    Task(ProblemType problem_, const Mat& points1_, const Mat& points2_,
         const Params& params_ = Params())
        : problem(problem_), points1(points1_), points2(points2_), params(params_)
    {}

    ProblemType problem;  //!< what is estimated
    Mat points1;          //!< points of image 1; #ABSOLUTE_POSE: object points; #RIGID_3D and
                          //!< #SIMILARITY_3D: 3-D points
    Mat points2;          //!< their counterparts: points of image 2; #ABSOLUTE_POSE: image points;
                          //!< #RIGID_3D and #SIMILARITY_3D: 3-D points
    Params params;        //!< options; Params::scores, if any, belong to these points
    Mat cameraMatrix1;    //!< for #ESSENTIAL and #ABSOLUTE_POSE
    Mat cameraMatrix2;    //!< for #ESSENTIAL; empty: the same as `cameraMatrix1`
    Mat distCoeffs1;      //!< distortion of camera 1; empty: none
    Mat distCoeffs2;      //!< distortion of camera 2; empty: none
};

//! @brief The result of a Task.
struct CV_EXPORTS Estimate
{
    Mat model;      //!< in the form that #estimateHomography and similar functions return; empty if
                    //!< there is none
    Mat mask;       //!< N x 1, CV_8U; empty if the estimation raised an exception, or if the batch
                    //!< was canceled before the task began
    Report report;  //!< statistics of the run
    String error;   //!< message of the cv::Exception that the estimation raised; empty: none
};

/** @brief Runs many estimations in parallel.

@param tasks what to estimate; different problems and sizes can be mixed
@param threads how many tasks run at once, at most cv::getNumThreads(); 0: cv::getNumThreads()
@return an Estimate for each task, in the order of the tasks.

Each result, except for the times in the report, is bit-identical to that of the same estimation
alone, whatever `threads` is, unless Params::maxTime or a ProgressScope ends the estimation. The
threads are those of cv::parallel_for_; each thread takes the next task when it has finished one, so
that tasks of different sizes keep all threads busy. When several tasks run at once, each has one
thread, whatever Params::threads says. An error in a task ends only that task and is described in
Estimate::error. Raises cv::Exception if `threads` is negative. */
CV_EXPORTS std::vector<Estimate> estimateBatch(const std::vector<Task>& tasks, int threads = 0);

//! Options of a batch: one Params for all tasks, or one for each.
class CV_EXPORTS ParamsOfTasks
{
public:
    //! The same options for all tasks.
    ParamsOfTasks(const Params& params) : list(1, params) {}
    //! One Params for each task.
    ParamsOfTasks(const std::vector<Params>& params) : list(params) {}

    //! Number of stored options: 1 if they are the same for all tasks, else the number of tasks.
    size_t size() const { return list.size(); }
    //! The options of a task.
    const Params& operator[](size_t task) const { return list[list.size() == 1 ? 0 : task]; }

private:
    std::vector<Params> list;
};

/** @name Batches of one problem
Each of these functions calls #estimateBatch with tasks of one problem.
@param points1, points2 lists of the same length, one entry per task:
`std::vector<std::vector<Point2f>>`, `std::vector<Mat>` and the like; each entry has the form of the
points of #estimateHomography and similar functions
@param params one Params for all tasks, or a `std::vector<Params>` with one for each, for example
because each task has its own match scores
@param threads as in #estimateBatch
@return one Estimate for each task, in the same order. An error in the arguments of one task is
reported in its Estimate::error. Raises cv::Exception for lists of different lengths, and if
`threads` is negative.
@{ */
//! Batch version of #estimateHomography.
CV_EXPORTS std::vector<Estimate> estimateHomographies(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! Batch version of #estimateAffinity2D.
CV_EXPORTS std::vector<Estimate> estimateAffinities2D(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! Batch version of #estimateSimilarity2D.
CV_EXPORTS std::vector<Estimate> estimateSimilarities2D(InputArrayOfArrays points1,
                                                        InputArrayOfArrays points2,
                                                        const ParamsOfTasks& params = Params(),
                                                        int threads = 0);
//! Batch version of #estimateFundamental.
CV_EXPORTS std::vector<Estimate> estimateFundamentals(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! Batch version of #estimateRigid3D.
CV_EXPORTS std::vector<Estimate> estimateRigids3D(InputArrayOfArrays points1,
                                                  InputArrayOfArrays points2,
                                                  const ParamsOfTasks& params = Params(),
                                                  int threads = 0);
//! Batch version of #estimateSimilarity3D.
CV_EXPORTS std::vector<Estimate> estimateSimilarities3D(InputArrayOfArrays points1,
                                                        InputArrayOfArrays points2,
                                                        const ParamsOfTasks& params = Params(),
                                                        int threads = 0);
//! Batch version of #estimateTranslation2D.
CV_EXPORTS std::vector<Estimate> estimateTranslations2D(InputArrayOfArrays points1,
                                                        InputArrayOfArrays points2,
                                                        const ParamsOfTasks& params = Params(),
                                                        int threads = 0);
/** Batch version of #estimateEssential. Camera matrices and distortions are lists, too, with one
entry per task or a single entry for all tasks. If `cameraMatrices2` is empty, `cameraMatrices1` are
used for both images; empty distortion lists mean no distortion. */
CV_EXPORTS std::vector<Estimate> estimateEssentials(
    InputArrayOfArrays points1, InputArrayOfArrays points2, InputArrayOfArrays cameraMatrices1,
    InputArrayOfArrays cameraMatrices2 = noArray(), InputArrayOfArrays distCoeffs1 = noArray(),
    InputArrayOfArrays distCoeffs2 = noArray(), const ParamsOfTasks& params = Params(),
    int threads = 0);
//! Batch version of #estimateAbsolutePose; cameras and distortions as in #estimateEssentials.
CV_EXPORTS std::vector<Estimate> estimateAbsolutePoses(InputArrayOfArrays objectPoints,
                                                       InputArrayOfArrays imagePoints,
                                                       InputArrayOfArrays cameraMatrices,
                                                       InputArrayOfArrays distCoeffs = noArray(),
                                                       const ParamsOfTasks& params = Params(),
                                                       int threads = 0);
//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
