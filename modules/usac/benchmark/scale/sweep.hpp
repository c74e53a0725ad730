// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SWEEP_HPP
#define OPENCV_USACV20_BENCHMARK_SWEEP_HPP

#include <ostream>
#include <string>
#include <vector>
#include "meter.hpp"
#include "scale_options.hpp"
#include "summary.hpp"

namespace benchmark {

/** Measures the time of all methods on scenes of increasing difficulty: more matches, or a lower
inlier ratio.

On each scene all methods run one after the other. A method whose median time exceeds
ScaleOptions::limit does not run on harder scenes. */
class Sweep
{
public:
    enum Kind { OVER_SIZE, OVER_INLIERS };

    Sweep(Kind kind, ProblemType problem, const ScaleOptions& options);

    void run(const std::vector<cv::Ptr<Method>>& methods, Meter& meter, Progress& progress);

    //! Number of steps of the sweep (sizes or inlier ratios), for Progress.
    size_t size() const { return points.size(); }
    void markdown(std::ostream& out) const;
    static void csvHeader(std::ostream& out);
    void csv(std::ostream& out) const;

private:
    //! A step of the sweep.
    struct Point
    {
        int size;                   //!< number of matches
        double part;                //!< inlier ratio
        std::vector<Summary> rows;  //!< one for each method; Summary::lists is 0 if it did not run
    };

    //! Measures the methods on the scenes of a point. @param active true for the methods to run;
    //! becomes false for methods whose median time exceeds ScaleOptions::limit
    void measure(Point& point, const std::vector<cv::Ptr<Method>>& methods,
                 std::vector<bool>& active, Meter& meter) const;
    std::string label(const Point& point) const;

    const Kind kind;
    const ProblemType problem;
    const ScaleOptions& options;
    std::vector<Point> points;
};

}  // namespace benchmark

#endif
