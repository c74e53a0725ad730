// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// A user-defined component: a sampler that spreads its samples over image 1 replaces the default
// sampler.

#include "spread_sampler.hpp"
#include "tools.hpp"

namespace {

//! Runs the estimator with the default components for `params` and prints the report. `sampler`
//! replaces the default sampler unless it is empty.
void run(const char* name, const tools::Matches& matches, const cv::usacv20::Params& params,
         const cv::Ptr<cv::usacv20::Sampler>& sampler)
{
    using namespace cv::usacv20;
    cv::Ptr<Usac> usac = Usac::create(HOMOGRAPHY, matches.points1, matches.points2, params);
    if (sampler)
        usac->components().sampler = sampler;
    cv::Mat mask;
    Report report;
    const cv::Mat H = usac->run(mask, &report);
    std::cout << cv::format("%-13s  %s\n", name, report.describe().c_str());
    CV_Assert(!H.empty());
}

int sample(const cv::CommandLineParser& parser)
{
    const cv::Mat image1 = tools::readImage(parser.get<std::string>("@image1"));
    const cv::Mat image2 = tools::readImage(parser.get<std::string>("@image2"));
    const tools::Matches matches = tools::match(image1, image2, parser);
    cv::usacv20::Params params;
    params.threshold = parser.get<double>("threshold");
    params.confidence = parser.get<double>("confidence");
    params.maxIterations = parser.get<int>("iterations");
    std::cout << matches.points1.size() << " matches\n";
    run("P-NAPSAC", matches, params, cv::Ptr<cv::usacv20::Sampler>());
    run("SpreadSampler", matches, params, cv::makePtr<custom::SpreadSampler>());
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string
        keys = "{help h usage ? |           | print this help}"
               "{@image1        | graf1.png | image 1, a path or the name of one of OpenCV's "
               "sample images}"
               "{@image2        | graf3.png | image 2}"
               "{ratio          | 0.8       | largest ratio of the descriptor distances of the "
               "best and the second best match}"
               "{features       | 8000      | largest number of features per image}"
               "{confidence     | 0.99      | probability of finding the best model}"
               "{threshold      | 2         | inlier threshold in pixels}"
               "{iterations     | 10000     | largest number of samples}";
    return tools::runSample(argc, argv, keys,
                            "Homography of two images with a user-defined sampler.", sample);
}
