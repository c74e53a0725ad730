// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP

#include <string>
#include "image_pair.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Matches of a minimal sample.
int sampleSizeOf(ProblemType problem);

/** One cell of the grid: scenes that differ in their seed only. */
struct Cell
{
    ProblemType problem;
    std::string motion;  //!< see setMotion
    std::string kind;    //!< see setKind
    int size;      //!< matches; kind `copies`: different ones; kind `second`: of the right model
    double ratio;  //!< part of right matches
    std::string order;  //!< `none`: without scores; else see setOrder

    //! Points, but for noise and seed. @return false if there is no such scene, or it holds less
    //! than `spare` right matches more than a sample.
    bool options(int spare, opencv_test::SceneOptions& result) const;
    bool scored() const { return order != "none"; }
    //! Kind `second`: all is given by the size, whatever `ratio` is.
    bool fixedRatio() const { return kind == "second"; }
    //! Of one of problem, motion, kind, size, ratio, order.
    std::string value(const std::string& axis) const;
    //! As in tables: "F general plane95 300 0.5 none".
    std::string name() const;
};

/** Motions:

    general    12 degrees, mostly sideways                  planar    in the horizontal plane, 12
    degrees forward    along the optical axis, 2 degrees            car       on a circle, up to 12
    degrees forward0   the same without rotation                    narrow    general with 1/100 of
    the distance sideways   parallel to the image, 2 degrees             rotation  the same with
    1/1000 rectified  along the rows, no rotation                  frontal   sideways without
    rotation over a plane parallel to the image aerial     rectified, depths within 10 % of one (E,
    F)            (E, H: all points on it; F is not determined)

@return false for any other name. */
bool setMotion(const std::string& name, opencv_test::SceneOptions& options);

/** Wrong matches and repetitions:

    generic      wrong matches anywhere                     clustered   from one square of 80 pixels
    to one of image 2 local        right but for 5 to 50 pixels               manyToOne   about ten
    with the same point of image 2 targets      to two points of image 2                   line
    every second one on one line of image 2 planeN       generic, N percent of the right ones on one
    plane (F, E) duplicates   half of the right ones repeat others       copies      all are there
    five times second       right ones of another model, 90 % as many as of the right one, from a
    square of 160 pixels partSecond   the same, 70 % as many, and the others anywhere shiftN       N
    percent of all matches shifted by the same 30 to 100 pixels, the other wrong ones anywhere
    movingN      the same on a plane that another motion has seen placeN       the same in image 2
    at one place, but for 0.4 pixels clusters     each point in one of five squares of 20 pixels
    center       both points near the middle of their image window       displaced by up to 60
    pixels border       both points on the border of their image

@return false for any other name. */
bool setKind(const std::string& name, opencv_test::SceneOptions& options);

/** Scores: the probability that a right match has a better one than a wrong one, above 0 up to 1,
or

    second  those of the second motion are the best, the others random
    place   the right ones of a square of 160 pixels are the best, the others random
    near    the nearer to one point of image 1, the better, right or wrong

@return false for anything else. */
bool setOrder(const std::string& name, opencv_test::SceneOptions& options);

}  // namespace benchmark

#endif
