// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "plane_map.hpp"

namespace benchmark {

namespace {

//! Problem T: a translation from image 1 to image 2. OpenCV 4 has no function for this problem, so
//! the default threshold and limit of iterations are those of problem S (similarity).
class Translation : public PlaneMap
{
public:
    Translation() : PlaneMap(cv::usacv20::TRANSLATION_2D, 'T', cv::Size(3, 2), 3, 2000) {}

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::usacv20::estimateTranslation2D(pair.points1, pair.points2, params,
                                                            estimate.mask);
    }

    void callOpenCV(const ImagePair&, int, const Settings&, Estimate&) const CV_OVERRIDE
    {
        throw std::runtime_error("T: calib3d estimates no translations");
    }
};

}  // namespace

const ProblemKind& kindOfTranslation2D()
{
    static const Translation kind;
    return kind;
}

}  // namespace benchmark
