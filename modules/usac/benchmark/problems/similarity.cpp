// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plane_map.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

namespace {

//! Problem S: a rotation, uniform scale and translation from image 1 to image 2. The default
//! threshold and limit of iterations are those of cv::estimateAffinePartial2D in calib3d.
class Similarity : public PlaneMap
{
public:
    Similarity() : PlaneMap(cv::usacv20::SIMILARITY, 'S', cv::Size(3, 2), 3, 2000) {}

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::estimateAffinePartial2D(pair.points1, pair.points2, estimate.mask,
                                                     params);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::estimateAffinePartial2D(
            pair.points1, pair.points2, estimate.mask, flag, settings.threshold,
            (size_t)settings.maxIterations, settings.confidence);
    }
};

}  // namespace

const ProblemKind& kindOfSimilarity2D()
{
    static const Similarity kind;
    return kind;
}

}  // namespace benchmark
