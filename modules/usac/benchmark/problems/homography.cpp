// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plane_map.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

namespace {

//! Problem H: the homography from image 1 to image 2.
class Homography : public PlaneMap
{
public:
    Homography() : PlaneMap(cv::usacv20::HOMOGRAPHY, 'H', cv::Size(3, 3), 2, 10000) {}

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::findHomography(pair.points1, pair.points2, estimate.mask, params);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::findHomography(pair.points1, pair.points2, flag, settings.threshold,
                                            estimate.mask, settings.maxIterations,
                                            settings.confidence);
    }
};

}  // namespace

const ProblemKind& kindOfHomography()
{
    static const Homography kind;
    return kind;
}

}  // namespace benchmark
