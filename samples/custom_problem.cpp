// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

// A user-defined problem: the affine map between two images, from samples of three matches. Such a
// problem can use all parts of the module: samplers, verification, graph cut, polishing,
// termination criteria, threads, the report. The matches come from a text file with a row
// "x1 y1 x2 y2" for each match, such as test_data/graf.txt.

#include <iostream>
#include "affine_problem.hpp"
#include "matches_file.hpp"

int main(int argc, char** argv)
{
    cv::CommandLineParser parser(
        argc, argv,
        "{help h usage ? |     | print this help}"
        "{@matches       |     | text file with a row x1 y1 x2 y2 for "
        "each match, such as test_data/graf.txt}"
        "{threshold      | 10  | inlier threshold in pixels; wide, "
        "because the true map between two views of a plane is not affine}");
    parser.about("A user-defined problem: the affine map between two images.");
    if (parser.has("help") || !parser.has("@matches"))
    {
        parser.printMessage();
        return parser.has("help") ? 0 : 1;
    }
    try
    {
        std::vector<cv::Point2d> points1, points2;
        readMatches(parser.get<std::string>("@matches"), points1, points2);
        using namespace cv::usacv20;
        Params params;  // default: P-NAPSAC, SPRT, graph cut, robust polishing
        params.threshold = parser.get<double>("threshold");
        std::cout << points1.size() << " matches\n";
        const cv::Ptr<Usac> usac = Usac::create(cv::makePtr<custom::AffineProblem>(), points1,
                                                points2, params);
        cv::Mat mask;
        Report report;
        const cv::Mat A = usac->run(mask, &report);
        std::cout << report.describe() << "\n" << A << "\n";
        return A.empty() ? 1 : 0;
    }
    catch (const cv::Exception& error)
    {
        std::cerr << error.what() << std::endl;
        return 1;
    }
}
