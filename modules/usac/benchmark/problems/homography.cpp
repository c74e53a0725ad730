// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "homography.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

Homography::Homography() : PlaneMap(cv::usacv20::HOMOGRAPHY, 'H', cv::Size(3, 3), 2, 10000) {}

void Homography::callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                            Estimate& estimate) const
{
    estimate.model = cv::findHomography(pair.points1, pair.points2, estimate.mask, params);
}

void Homography::callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                            Estimate& estimate) const
{
    estimate.model = cv::findHomography(pair.points1, pair.points2, flag, settings.threshold,
                                        estimate.mask, settings.maxIterations, settings.confidence);
}

}  // namespace benchmark
