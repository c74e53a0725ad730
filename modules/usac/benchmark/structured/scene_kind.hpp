// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP

#include <string>
#include "image_pair.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Number of matches in a minimal sample.
int sampleSizeOf(ProblemType problem);

/** One cell of the grid of scenes. Its scenes differ only in their seed. */
struct Cell
{
    ProblemType problem;
    std::string motion;  //!< see setMotion
    std::string kind;    //!< see setKind
    int size;            //!< number of matches; kind `copies`: number of different matches, each of
                         //!< which occurs five times; kind `second`: number of right matches
    double ratio;        //!< inlier ratio
    std::string order;   //!< `none`: no scores; otherwise see setOrder

    //! Sets the options of the scenes, except noise and seed. @return false if there is no such
    //! scene, or if it has fewer right matches than a minimal sample plus `spare`.
    bool options(int spare, opencv_test::SceneOptions& result) const;
    bool scored() const { return order != "none"; }
    //! True for the kind `second`, where `size` and SECOND determine the inlier ratio and `ratio`
    //! has no effect.
    bool fixedRatio() const { return kind == "second"; }
    //! The value of the property `axis`: problem, motion, kind, size, ratio or order.
    std::string value(const std::string& axis) const;
    //! The name in tables, for example "F general plane95 300 0.5 none".
    std::string name() const;
};

/** Sets the motion by name:

    general    12 degrees, mostly sideways
    planar     in the horizontal plane, 12 degrees
    forward    along the optical axis, 2 degrees
    forward0   along the optical axis, no rotation
    car        on a circle, up to 12 degrees
    narrow     general with 1/100 of the distance
    rotation   general with 1/1000 of the distance
    baselineN  general with N percent of the distance
    sideways   parallel to the image, 2 degrees
    rectified  along the rows, no rotation
    frontal    sideways without rotation over a plane parallel to the image (E and H: all points on
               it; F would not be determined)
    aerial     rectified, depths within 10 % of their mean

@return false for any other name. */
bool setMotion(const std::string& name, opencv_test::SceneOptions& options);

/** Sets the kind of wrong matches or repetitions by name:

    generic     wrong matches anywhere
    clustered   from a square of 80 pixels in image 1 to one in image 2
    local       displaced from the true position by 5 to 50 pixels
    manyToOne   about ten with the same point of image 2
    targets     to two points of image 2
    line        every second wrong match leads to a point of one line of image 2
    planeN      generic, and N percent of the right matches on a plane (F, E)
    duplicates  generic, and half of the right matches repeat others
    copies      every match is there five times
    second      right matches of another model, 90 % as many as of the right model, from a square of
                160 pixels
    partSecond  like second, but 70 % as many; the other wrong matches are generic
    shiftN      N percent of all matches shifted by the same 30 to 100 pixels, the others generic
    movingN     N percent of all matches on a plane with another motion, the others generic
    placeN      N percent of all matches at one point of image 2, with Gaussian noise of 0.4 pixels
    clusters    each point in one of five squares of 20 pixels of its image
    center      both points near the middle of their image
    window      in image 2 up to 60 pixels from the position in image 1
    border      both points on the border of their image

@return false for any other name. */
bool setKind(const std::string& name, opencv_test::SceneOptions& options);

/** Sets the scores by name. A number above 0 up to 1 is the probability that a right match has a
better score than a wrong match. Names of misleading scores:

    second  the best scores are those of the second motion, the others random
    place   the best scores are those of the right matches in a square of 160 pixels, the others
            random
    near    the score is better the nearer the match is to a point of image 1, right or wrong

@return false for anything else. */
bool setOrder(const std::string& name, opencv_test::SceneOptions& options);

}  // namespace benchmark

#endif
