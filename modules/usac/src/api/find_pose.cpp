// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "api/argument_names.hpp"
#include "api/find_method.hpp"

namespace cv {

using usacv20::Params;

//! Arguments to which calib3d's function gives other names than this module does. The names of the
//! arrays do not differ.
static const usacv20::ArgumentName POSE_NAMES[] = {{"threshold", "reprojectionError"},
                                                   {"maxIterations", "iterationsCount"}};

//! Reads three numbers from a row, a column or a single element with three channels.
static Vec3d readVector(InputArray array, const char* name)
{
    const Mat given = array.getMat();
    if (given.total() * given.channels() != 3 || given.dims > 2)
        CV_Error_(Error::StsBadArg, ("%s: useExtrinsicGuess needs 3 numbers, not %d", name,
                                     (int)(given.total() * given.channels())));
    Mat numbers;
    given.convertTo(numbers, CV_64F);
    const Mat flat = numbers.reshape(1, 3);
    return Vec3d(flat.at<double>(0), flat.at<double>(1), flat.at<double>(2));
}

static void setGuess(InputArray rvec, InputArray tvec, Params& params)
{
    const Vec3d rotation = readVector(rvec, "rvec"), t = readVector(tvec, "tvec");
    if (!checkRange(rotation) || !checkRange(t))
        CV_Error(Error::StsBadArg, "rvec, tvec: useExtrinsicGuess needs finite numbers");
    Matx33d R;
    Rodrigues(rotation, R);
    const Matx34d pose(R(0, 0), R(0, 1), R(0, 2), t[0], R(1, 0), R(1, 1), R(1, 2), t[1], R(2, 0),
                       R(2, 1), R(2, 2), t[2]);
    params.setInitialModel(pose);
}

static void writeInliers(const Mat& mask, OutputArray inliers)
{
    if (!inliers.needed())
        return;
    std::vector<int> indices;
    for (int i = 0; i < mask.rows; ++i)
        if (mask.at<uchar>(i))
            indices.push_back(i);
    if (indices.empty())
        inliers.release();
    else
        Mat((int)indices.size(), 1, CV_32S, indices.data()).copyTo(inliers);
}

bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                    InputArray distCoeffs, OutputArray rvec, OutputArray tvec, OutputArray inliers,
                    const Params& params)
{
    Mat mask;
    const Mat pose = usacv20::estimateAbsolutePose(objectPoints, imagePoints, cameraMatrix,
                                                   distCoeffs, params, mask);
    writeInliers(mask, inliers);
    if (pose.empty())
        return false;
    Matx31d rotation;
    Rodrigues(pose.colRange(0, 3), rotation);
    Mat(rotation).copyTo(rvec);
    pose.col(3).copyTo(tvec);
    return true;
}

bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                    InputArray distCoeffs, OutputArray rvec, OutputArray tvec,
                    bool useExtrinsicGuess, int iterationsCount, float reprojectionError,
                    double confidence, OutputArray inliers, UsacV20Method flags)
{
    Params params = usacv20::paramsOf(flags, reprojectionError, confidence, iterationsCount,
                                      "flags");
    if (useExtrinsicGuess)
        setGuess(rvec, tvec, params);
    return usacv20::calling(POSE_NAMES, [&] {
        return solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                              inliers, params);
    });
}

namespace usacv20 {

bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                    InputArray distCoeffs, OutputArray rvec, OutputArray tvec,
                    bool useExtrinsicGuess, int iterationsCount, float reprojectionError,
                    double confidence, OutputArray inliers, int flags)
{
    if (isOurs(flags, "flags"))
        return cv::solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                                  useExtrinsicGuess, iterationsCount, reprojectionError, confidence,
                                  inliers, methodFromInt(flags));
    return cv::solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                              useExtrinsicGuess, iterationsCount, reprojectionError, confidence,
                              inliers, flags);
}

}  // namespace usacv20
}  // namespace cv
