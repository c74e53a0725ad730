// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// A user-defined component: another quality function replaces MSAC. The matches come from a text
// file with a row "x1 y1 x2 y2" for each match (the rest of a row is ignored), such as
// test_data/graf.txt.

#include <iostream>
#include "opencv2/core.hpp"
#include "matches_file.hpp"
#include "tukey_score.hpp"

namespace {

//! Runs the estimator with the default components for `params` and prints the report. `score`
//! replaces the default quality function unless it is empty. @return the homography
cv::Mat run(const char* name, const std::vector<cv::Point2d>& points1,
            const std::vector<cv::Point2d>& points2, const cv::usacv20::Params& params,
            const cv::Ptr<cv::usacv20::Score>& score)
{
    using namespace cv::usacv20;
    cv::Ptr<Usac> usac = Usac::create(HOMOGRAPHY, points1, points2, params);
    if (score)
        usac->components().score = score;
    Report report;
    const cv::Mat H = usac->run(cv::noArray(), &report);
    std::cout << cv::format("%-6s %s\n", name, report.describe().c_str());
    return H;
}

}  // namespace

int main(int argc, char** argv)
{
    cv::CommandLineParser parser(argc, argv,
                                 "{help h usage ? |     | print this help}"
                                 "{@matches       |     | text file with a row x1 y1 x2 y2 for "
                                 "each match, such as test_data/graf.txt}"
                                 "{threshold      | 2   | inlier threshold in pixels}");
    parser.about("Homography with a user-defined quality function.");
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
        const cv::Mat H = run("MSAC", points1, points2, params, cv::Ptr<cv::usacv20::Score>());
        const cv::Mat tukey = run("Tukey", points1, points2, params,
                                  cv::makePtr<custom::TukeyScore>());
        return H.empty() || tukey.empty() ? 1 : 0;
    }
    catch (const cv::Exception& error)
    {
        std::cerr << error.what() << std::endl;
        return 1;
    }
}
