// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP
#define OPENCV_USACV20_BENCHMARK_SCENE_KIND_HPP

#include <string>
#include "image_pair.hpp"
#include "support/scenes.hpp"

namespace benchmark {

//! Number of matches in a minimal sample for H, F or E.
int sampleSizeOf(ProblemType problem);

/** A kind of scenes: one cell of a grid of properties. The scenes of a cell differ only in their
seeds. */
struct Cell
{
    ProblemType problem;
    std::string motion;  //!< see setMotion
    std::string kind;    //!< see setKind
    int size;            //!< number of matches; kind `copies`: number of different matches, each of
                         //!< which occurs five times; kind `second`: number of right matches
    double ratio;        //!< inlier ratio
    std::string order;   //!< `none`: no scores; otherwise see setOrder

    //! Sets the options of the scenes, except noise and seed. @return false if there are no such
    //! scenes, or if they have fewer different right matches than a minimal sample plus `spare`.
    bool options(int spare, opencv_test::SceneOptions& result) const;
    bool scored() const { return order != "none"; }
    //! True for the kind `second`, whose inlier ratio is always 1 / 1.9; `ratio` has no effect.
    bool fixedRatio() const { return kind == "second"; }
    //! The value of the property `axis` (problem, motion, kind, size, ratio or order) as text.
    std::string value(const std::string& axis) const;
    //! The name in tables, for example "F general plane95 300 0.5 none".
    std::string name() const;
};

/** Sets the motion of the camera by name, see opencv_test::Motion. Degrees are rotation angles:

    general    mostly sideways, 12 degrees, and then turned toward the scene
    planar     in the horizontal plane, 12 degrees
    forward    along the optical axis, 2 degrees
    forward0   along the optical axis, no rotation
    car        forward, turning up to 12 degrees
    narrow     general with 1/100 of the distance between the cameras
    rotation   general with 1/1000 of this distance
    baselineN  general with N percent of this distance
    sideways   parallel to the image, 2 degrees
    rectified  along the rows, no rotation
    frontal    parallel to the image, no rotation; all points are on a plane that is also parallel
               to the image (H and E only, since such points do not determine F)
    aerial     rectified, depths within 10 % of their mean

@return false for any other name. */
bool setMotion(const std::string& name, opencv_test::SceneOptions& options);

/** Sets the kind of wrong matches or repetitions by name. A row describes all wrong matches unless
the row says otherwise. For shiftN, movingN and placeN, N is a number; the row describes wrong
matches that are N percent of all matches, and the other wrong matches are generic:

    generic     anywhere in both images
    clustered   from a square of side 80 pixels in image 1 to one in image 2
    local       displaced from the true position in image 2 by 5 to 50 pixels
    manyToOne   about ten wrong matches share each point of image 2
    targets     from anywhere in image 1 to one of two points of image 2
    line        half of them to points on one line of image 2, the others generic
    planeN      generic; N percent of the right matches are on a plane (F, E)
    duplicates  generic; half of the right matches are copies of other right matches
    copies      generic; every match, right or wrong, occurs five times
    second      true matches of another model, 90 % as many as right matches, in image 1 in a
                square of side 160 pixels
    partSecond  like second, but only 70 % as many as right matches, or all wrong matches if there
                are fewer; the other wrong matches are generic
    shiftN      shifted by the same vector of 30 to 100 pixels
    movingN     true matches of another plane that moves differently from the scene
    placeN      to one point of image 2, with Gaussian noise of 0.4 pixels
    clusters    each point in one of five squares of side 20 pixels of its image
    center      each point Cauchy-distributed about the middle of its image
    window      in image 2 up to 60 pixels per coordinate from the position in image 1
    border      each point on the border of its image

@return false for any other name. */
bool setKind(const std::string& name, opencv_test::SceneOptions& options);

/** Sets the scores by name. A number above 0 up to 1 is the probability that a right match has a
better score than a wrong match. Names of misleading scores:

    second  wrong matches of a second model (kinds `second`, `partSecond`) have the best scores
    place   right matches in a square of side 160 pixels of image 1 have the best scores
    near    the nearer a match, right or wrong, is to one point of image 1, the better its score

@return false for anything else. */
bool setOrder(const std::string& name, opencv_test::SceneOptions& options);

}  // namespace benchmark

#endif
