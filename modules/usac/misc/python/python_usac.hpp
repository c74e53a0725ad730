// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PYTHON_USAC_HPP
#define OPENCV_USACV20_PYTHON_USAC_HPP

// Only the Python bindings see this file.

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include "opencv2/usac.hpp"

namespace cv {

#ifdef OPENCV_BINDING_PARSER
// The enumerators of an enum class would become cv2.UsacV20Method_USACV20 and so on. The generator
// takes the names from here; the code that it writes uses the constants of params.hpp.
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

/** @brief What usacv20.progress does in Python: another thread sees how far the runs are, and stops
them.

OpenCV's generator binds no functions as arguments: the threads that run enter it, and the one that
waits for them asks. */
class CV_EXPORTS_W RunControl
{
public:
    CV_WRAP RunControl() : stopped(false) {}

    //! The runs of this thread, until it leaves.
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

    //! All runs end, with what they have found.
    CV_WRAP void cancel() { stopped = true; }
    CV_WRAP bool cancelled() const { return stopped; }

    //! Of the run that was asked last; that of no run before.
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

/** @brief #estimateBatch for OpenCV's generator, which binds no lists of a class as arguments or
results: tasks are added, and results asked for, one by one. */
class CV_EXPORTS_W Batch
{
public:
    CV_WRAP Batch() {}

    //! The arguments of #estimateModel. The points are not copied.
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

    // The result of a task, after run().
    CV_WRAP Mat model(int task) const { return results.at(task).model; }
    CV_WRAP Mat mask(int task) const { return results.at(task).mask; }
    CV_WRAP Report report(int task) const { return results.at(task).report; }
    CV_WRAP String error(int task) const { return results.at(task).error; }

private:
    std::vector<Task> tasks;
    std::vector<Estimate> results;
};

// The functions of find.hpp, find_affine.hpp and find_pose.hpp with Params in the place of the
// flag. In C++ they are in the namespace cv alone: a second set would make a call below `using
// namespace cv` ambiguous, as the class Params leads to the namespace cv::usacv20.

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
// `params` has a default for its place among the arguments: the last one, as in OpenCV's function.
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
