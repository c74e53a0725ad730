// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// A user-defined component: a different error of matches under a fundamental matrix replaces the
// Sampson distance. The new error is used for the quality of models, for fitting, and for the mask.
// The matches come from a text file with a row "x1 y1 x2 y2" for each match, such as
// test_data/office01_F.txt.

#include <iostream>
#include "line_distance.hpp"
#include "matches_file.hpp"

namespace {

//! Runs the estimator with the default components for `params` and prints the report. `residual`
//! replaces the default residual unless it is empty. @return the fundamental matrix
cv::Mat run(const char* name, const std::vector<cv::Point2d>& points1,
            const std::vector<cv::Point2d>& points2, const cv::usacv20::Params& params,
            const cv::Ptr<cv::usacv20::Residual>& residual)
{
    using namespace cv::usacv20;
    cv::Ptr<Usac> usac = Usac::create(FUNDAMENTAL, points1, points2, params);
    if (residual)
        usac->components().residual = residual;
    Report report;
    const cv::Mat F = usac->run(cv::noArray(), &report);
    std::cout << cv::format("%-8s %s\n", name, report.describe().c_str());
    return F;
}

}  // namespace

int main(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv,
                                 "{help h usage ? |     | print this help}"
                                 "{@matches       |     | text file with a row x1 y1 x2 y2 for "
                                 "each match, such as test_data/office01_F.txt}"
                                 "{threshold      | 1   | inlier threshold in pixels}");
    parser.about("Fundamental matrix with a user-defined error.");
    if (parser.has("help") || !parser.has("@matches"))
    {
        parser.printMessage();
        return parser.has("help") ? 0 : 1;
    }
    try
    {
        std::vector<cv::Point2d> points1, points2;
        readMatches(parser.get<std::string>("@matches"), points1, points2);
        cv::usacv20::Params params;
        params.threshold = parser.get<double>("threshold");
        std::cout << points1.size() << " matches\n";
        const cv::Mat F = run("Sampson", points1, points2, params,
                              cv::Ptr<cv::usacv20::Residual>());
        const cv::Mat own = run("line", points1, points2, params,
                                cv::makePtr<custom::LineDistance>());
        return F.empty() || own.empty() ? 1 : 0;
    }
    catch (const cv::Exception& error)
    {
        std::cerr << error.what() << std::endl;
        return 1;
    }
}
