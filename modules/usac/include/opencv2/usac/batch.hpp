// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BATCH_HPP
#define OPENCV_USACV20_BATCH_HPP

#ifndef OPENCV_BINDING_PARSER  // other languages have functions of their own for it

#include <vector>
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @brief One estimation of many: what #estimateHomography and its kin take. */
struct CV_EXPORTS Task
{
    Task() : problem(HOMOGRAPHY) {}
    //! Of a problem without cameras; those are set afterwards.
    Task(ProblemType problem_, const Mat& points1_, const Mat& points2_,
         const Params& params_ = Params())
        : problem(problem_), points1(points1_), points2(points2_), params(params_)
    {}

    ProblemType problem;  //!< what is estimated
    Mat points1;          //!< of image 1; #ABSOLUTE_POSE: object points
    Mat points2;          //!< their counterparts; #ABSOLUTE_POSE: image points
    Params params;        //!< `scores` are those of these points
    Mat cameraMatrix1;    //!< #ESSENTIAL, #ABSOLUTE_POSE
    Mat cameraMatrix2;    //!< #ESSENTIAL; empty: as the first
    Mat distCoeffs1;      //!< of camera 1; empty: none
    Mat distCoeffs2;      //!< of camera 2; empty: none
};

//! @brief What has become of a Task.
struct CV_EXPORTS Estimate
{
    Mat model;      //!< as #estimateHomography and its kin return it; empty if there is none
    Mat mask;       //!< N x 1, CV_8U
    Report report;  //!< what the run learned
    String error;   //!< message of the cv::Exception that the call has raised, else empty
};

/** @brief Many estimations, side by side.

@param tasks what to estimate, of any problems and sizes, mixed
@param threads how many at once, at most cv::getNumThreads(); 0: as many as that
@return an Estimate for each task, in the order of the tasks.

Each result is to the bit that of the same call alone, whatever `threads` is. The threads are those
of cv::parallel_for_ and take the next task when they have done one, so that tasks of different
sizes keep all busy. Where several tasks run at once each has one thread, whatever Params::threads
says. A mistake in a task ends that task alone: its `error` says which; the others go on. Raises
cv::Exception if `threads` is below 0. */
CV_EXPORTS std::vector<Estimate> estimateBatch(const std::vector<Task>& tasks, int threads = 0);

//! Options of many tasks: one Params for all of them, or one for each.
class CV_EXPORTS ParamsOfTasks
{
public:
    //! One for all.
    ParamsOfTasks(const Params& params) : list(1, params) {}
    //! One for each.
    ParamsOfTasks(const std::vector<Params>& params) : list(params) {}

    //! 1 or as many as there are tasks.
    size_t size() const { return list.size(); }
    //! Those of a task.
    const Params& operator[](size_t task) const { return list[list.size() == 1 ? 0 : task]; }

private:
    std::vector<Params> list;
};

/** @name Batches of one problem
Each is #estimateBatch of tasks of one problem.
@param points1, points2 lists of the same length, one entry a task:
`std::vector<std::vector<Point2f>>`, `std::vector<Mat>` and the like; each entry as the points of
#estimateHomography and its kin
@param params one for all, or a `std::vector<Params>` with one for each task: match scores differ
from pair to pair
@param threads as of #estimateBatch
@return one Estimate for each pair, in this order. A mistake in an argument of one task is in its
Estimate::error. Raises cv::Exception for lists of different lengths.
@{ */
//! As #estimateHomography.
CV_EXPORTS std::vector<Estimate> estimateHomographies(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! As #estimateAffinity2D.
CV_EXPORTS std::vector<Estimate> estimateAffinities2D(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! As #estimateSimilarity2D.
CV_EXPORTS std::vector<Estimate> estimateSimilarities2D(InputArrayOfArrays points1,
                                                        InputArrayOfArrays points2,
                                                        const ParamsOfTasks& params = Params(),
                                                        int threads = 0);
//! As #estimateFundamental.
CV_EXPORTS std::vector<Estimate> estimateFundamentals(InputArrayOfArrays points1,
                                                      InputArrayOfArrays points2,
                                                      const ParamsOfTasks& params = Params(),
                                                      int threads = 0);
//! As #estimateRigid3D.
CV_EXPORTS std::vector<Estimate> estimateRigids3D(InputArrayOfArrays points1,
                                                  InputArrayOfArrays points2,
                                                  const ParamsOfTasks& params = Params(),
                                                  int threads = 0);
//! As #estimateSimilarity3D.
CV_EXPORTS std::vector<Estimate> estimateSimilarities3D(InputArrayOfArrays points1,
                                                        InputArrayOfArrays points2,
                                                        const ParamsOfTasks& params = Params(),
                                                        int threads = 0);
/** As #estimateEssential. Cameras and distortions are lists, too: with one entry a task, or a
single one for all. `cameraMatrices2` empty: as the first; distortions empty: none. */
CV_EXPORTS std::vector<Estimate> estimateEssentials(
    InputArrayOfArrays points1, InputArrayOfArrays points2, InputArrayOfArrays cameraMatrices1,
    InputArrayOfArrays cameraMatrices2 = noArray(), InputArrayOfArrays distCoeffs1 = noArray(),
    InputArrayOfArrays distCoeffs2 = noArray(), const ParamsOfTasks& params = Params(),
    int threads = 0);
//! As #estimateAbsolutePose; cameras and distortions as of #estimateEssentials.
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
