// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_USAC_HPP
#define OPENCV_USACV20_PYTHON_USAC_HPP

// Only OpenCV's own Python module uses this file: the generator of bindings reads the file, and the
// generated code includes it.

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include "opencv2/usac.hpp"

namespace cv {

#ifdef OPENCV_BINDING_PARSER
// The generator would name the enumerators of an enum class cv2.UsacV20Method_USACV20 and so on.
// Therefore it reads this enum instead; the generated code uses the constants of params.hpp.
enum UsacV20Method {
    USACV20 = 0x4000,
    USACV20_FAST = 0x4001,
    USACV20_ACCURATE = 0x4002,
    USACV20_PROSAC = 0x4003,
    USACV20_MAGSAC = 0x4004,
    USACV20_PARALLEL = 0x4005,
    USACV20_AUTO = 0x4006
};
#endif

namespace usacv20 {

/** @brief Used by usacv20.progress in Python: lets another thread observe runs and stop them.

OpenCV's generator cannot bind functions as arguments. Therefore the threads that run estimations
call enter() and leave(), and the thread that waits for them calls the other functions. */
class CV_EXPORTS_W RunControl
{
public:
    CV_WRAP RunControl() : stopped(false) { latest.cost = 1; }

    //! From now on, this object observes the runs of the calling thread, until that
    //! thread calls leave().
    CV_WRAP void enter()
    {
        std::unique_ptr<ProgressScope> scope(new ProgressScope([this](const Report& report) {
            const std::lock_guard<std::mutex> lock(mutex);
            latest = report;
            return !stopped;
        }));
        const std::lock_guard<std::mutex> lock(mutex);
        scopes[std::this_thread::get_id()].swap(scope);
    }

    CV_WRAP void leave()
    {
        const std::lock_guard<std::mutex> lock(mutex);
        scopes.erase(std::this_thread::get_id());
    }

    //! Stops all observed runs; they return the best model so far.
    CV_WRAP void cancel() { stopped = true; }
    CV_WRAP bool cancelled() const { return stopped; }

    //! The report of the run that has last reported its progress; if none has, that of a run
    //! without a model.
    CV_WRAP Report report() const
    {
        const std::lock_guard<std::mutex> lock(mutex);
        return latest;
    }

private:
    mutable std::mutex mutex;
    std::map<std::thread::id, std::unique_ptr<ProgressScope>> scopes;
    Report latest;
    std::atomic<bool> stopped;
};

/** @brief #estimateBatch for OpenCV's generator, which cannot bind lists of objects as arguments or
results. Tasks are added, and results are fetched, one by one. */
class CV_EXPORTS_W Batch
{
public:
    CV_WRAP Batch() {}

    //! Adds a task with the arguments of #estimateModel. The points are not copied.
    CV_WRAP void add(int problem, InputArray points1, InputArray points2, const Params& params,
                     InputArray cameraMatrix1 = noArray(), InputArray cameraMatrix2 = noArray(),
                     InputArray distCoeffs1 = noArray(), InputArray distCoeffs2 = noArray())
    {
        Task task((ProblemType)problem, points1.getMat(), points2.getMat(), params);
        task.cameraMatrix1 = cameraMatrix1.getMat();
        task.cameraMatrix2 = cameraMatrix2.getMat();
        task.distCoeffs1 = distCoeffs1.getMat();
        task.distCoeffs2 = distCoeffs2.getMat();
        tasks.push_back(task);
    }

    CV_WRAP void run(int threads) { results = estimateBatch(tasks, threads); }

    // Results of a task, valid after run().
    CV_WRAP Mat model(int task) const { return results.at(task).model; }
    CV_WRAP Mat mask(int task) const { return results.at(task).mask; }
    CV_WRAP Report report(int task) const { return results.at(task).report; }
    CV_WRAP String error(int task) const { return results.at(task).error; }

private:
    std::vector<Task> tasks;
    std::vector<Estimate> results;
};

// The functions of find.hpp, find_affine.hpp and find_pose.hpp with Params in place of the flag,
// for Python only. In C++ they exist only in the namespace cv. The same functions in cv::usacv20
// would make calls ambiguous after `using namespace cv`, because an argument of the class Params
// adds the namespace cv::usacv20 to the lookup.

//! @overload
CV_EXPORTS_W inline Mat findHomography(InputArray srcPoints, InputArray dstPoints, OutputArray mask,
                                       const Params& params)
{
    return cv::findHomography(srcPoints, dstPoints, mask, params);
}

//! @overload
CV_EXPORTS_W inline Mat findFundamentalMat(InputArray points1, InputArray points2, OutputArray mask,
                                           const Params& params)
{
    return cv::findFundamentalMat(points1, points2, mask, params);
}

//! @overload
CV_EXPORTS_W inline Mat findEssentialMat(InputArray points1, InputArray points2,
                                         InputArray cameraMatrix1, InputArray cameraMatrix2,
                                         InputArray dist_coeff1, InputArray dist_coeff2,
                                         OutputArray mask, const Params& params)
{
    return cv::findEssentialMat(points1, points2, cameraMatrix1, cameraMatrix2, dist_coeff1,
                                dist_coeff2, mask, params);
}

//! @overload
CV_EXPORTS_W inline Mat estimateAffine2D(InputArray pts1, InputArray pts2, OutputArray inliers,
                                         const Params& params)
{
    return cv::estimateAffine2D(pts1, pts2, inliers, params);
}

//! @overload
CV_EXPORTS_W inline Mat estimateAffinePartial2D(InputArray pts1, InputArray pts2,
                                                OutputArray inliers, const Params& params)
{
    return cv::estimateAffinePartial2D(pts1, pts2, inliers, params);
}

//! @overload
// In Python, `params` must be the last argument, as in OpenCV's function. Therefore it has a
// default: the generator moves arguments without a default before the outputs.
CV_EXPORTS_W inline bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints,
                                        InputOutputArray cameraMatrix, InputArray distCoeffs,
                                        OutputArray rvec, OutputArray tvec, OutputArray inliers,
                                        const Params& params = usacv20::Params())
{
    return cv::solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                              inliers, params);
}

}  // namespace usacv20
}  // namespace cv

#endif
