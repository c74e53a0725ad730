// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plane_map.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

namespace {

//! Problem A: an affine map from image 1 to image 2. The default threshold and limit of
//! iterations are those of cv::estimateAffine2D in calib3d.
class Affinity : public PlaneMap
{
public:
    Affinity() : PlaneMap(cv::usacv20::AFFINITY, 'A', cv::Size(3, 2), 3, 2000) {}

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::estimateAffine2D(pair.points1, pair.points2, estimate.mask, params);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::estimateAffine2D(pair.points1, pair.points2, estimate.mask, flag,
                                              settings.threshold, (size_t)settings.maxIterations,
                                              settings.confidence);
    }
};

}  // namespace

const ProblemKind& kindOfAffinity2D()
{
    static const Affinity kind;
    return kind;
}

}  // namespace benchmark
