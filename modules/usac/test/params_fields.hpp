// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PARAMS_FIELDS_HPP
#define OPENCV_USACV20_TEST_PARAMS_FIELDS_HPP

#include <string>
#include <utility>
#include <vector>
#include "opencv2/usac.hpp"

namespace opencv_test {

using cv::usacv20::Params;

//! The fields of Params but for the scores, by name.
struct Fields
{
    static std::vector<std::pair<std::string, int Params::*>> ints()
    {
        std::vector<std::pair<std::string, int Params::*>> f;
        f.push_back(std::make_pair("maxIterations", &Params::maxIterations));
        f.push_back(std::make_pair("seed", &Params::seed));
        f.push_back(std::make_pair("threads", &Params::threads));
        f.push_back(std::make_pair("sampler", &Params::sampler));
        f.push_back(std::make_pair("ordering", &Params::ordering));
        f.push_back(std::make_pair("scoreOrder", &Params::scoreOrder));
        f.push_back(std::make_pair("neighborhood", &Params::neighborhood));
        f.push_back(std::make_pair("neighbors", &Params::neighbors));
        f.push_back(std::make_pair("residual", &Params::residual));
        f.push_back(std::make_pair("quality", &Params::quality));
        f.push_back(std::make_pair("verification", &Params::verification));
        f.push_back(std::make_pair("tddPoints", &Params::tddPoints));
        f.push_back(std::make_pair("localOptimization", &Params::localOptimization));
        f.push_back(std::make_pair("localIterations", &Params::localIterations));
        f.push_back(std::make_pair("localSampleMultiple", &Params::localSampleMultiple));
        f.push_back(std::make_pair("localSamples", &Params::localSamples));
        f.push_back(std::make_pair("termination", &Params::termination));
        f.push_back(std::make_pair("runnersUp", &Params::runnersUp));
        f.push_back(std::make_pair("orderedEvery", &Params::orderedEvery));
        f.push_back(std::make_pair("persistence", &Params::persistence));
        f.push_back(std::make_pair("degeneracy", &Params::degeneracy));
        f.push_back(std::make_pair("polishing", &Params::polishing));
        f.push_back(std::make_pair("polishingSteps", &Params::polishingSteps));
        return f;
    }

    static std::vector<std::pair<std::string, double Params::*>> doubles()
    {
        std::vector<std::pair<std::string, double Params::*>> f;
        f.push_back(std::make_pair("threshold", &Params::threshold));
        f.push_back(std::make_pair("confidence", &Params::confidence));
        f.push_back(std::make_pair("neighborRadius", &Params::neighborRadius));
        f.push_back(std::make_pair("reach", &Params::reach));
        f.push_back(std::make_pair("widestReach", &Params::widestReach));
        f.push_back(std::make_pair("spatialWeight", &Params::spatialWeight));
        f.push_back(std::make_pair("relaxation", &Params::relaxation));
        f.push_back(std::make_pair("significance", &Params::significance));
        return f;
    }

    //! Names of the fields that differ, in the order above.
    static std::string difference(const Params& a, const Params& b)
    {
        std::string names;
        for (size_t i = 0; i < ints().size(); ++i)
            if (a.*ints()[i].second != b.*ints()[i].second)
                names += ints()[i].first + " ";
        for (size_t i = 0; i < doubles().size(); ++i)
            if (a.*doubles()[i].second != b.*doubles()[i].second)
                names += doubles()[i].first + " ";
        return names + (a.scores != b.scores ? "scores " : "");
    }
};

}  // namespace opencv_test

#endif
