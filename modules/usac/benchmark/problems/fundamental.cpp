// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "epipolar.hpp"

#include "opencv2/usac/geometry.hpp"

namespace benchmark {

namespace {

//! Problem F: the fundamental matrix.
class Fundamental : public Epipolar
{
public:
    Fundamental() : Epipolar(cv::usacv20::FUNDAMENTAL, 'F', cv::Size(3, 3), 1, 1000) {}

    void callModule(const ImagePair& pair, const cv::usacv20::Params& params,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::findFundamentalMat(pair.points1, pair.points2, estimate.mask, params);
    }

    void callOpenCV(const ImagePair& pair, int flag, const Settings& settings,
                    Estimate& estimate) const CV_OVERRIDE
    {
        estimate.model = cv::findFundamentalMat(pair.points1, pair.points2, flag,
                                                settings.threshold, settings.confidence,
                                                settings.maxIterations, estimate.mask);
    }

protected:
    cv::Matx33d toFundamental(const ImagePair&, const cv::Matx33d& model) const CV_OVERRIDE
    {
        return model;
    }

    cv::Matx33d toEssential(const ImagePair& pair, const cv::Matx33d& model) const CV_OVERRIDE
    {
        return pair.K2.t() * model * pair.K1;
    }
};

}  // namespace

const ProblemKind& kindOfFundamental()
{
    static const Fundamental kind;
    return kind;
}

}  // namespace benchmark
