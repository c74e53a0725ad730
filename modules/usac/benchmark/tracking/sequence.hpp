// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SEQUENCE_HPP
#define OPENCV_USACV20_BENCHMARK_SEQUENCE_HPP

#include "image_pair.hpp"

namespace benchmark {

//! Properties that the frames of a sequence share.
struct SequenceOptions
{
    ProblemType problem;  //!< HOMOGRAPHY or ABSOLUTE_POSE
    int size;             //!< number of matches in a frame
    double inliers;       //!< inlier ratio
    double noise;  //!< standard deviation of the noise of right matches in image 2, per coordinate,
                   //!< pixels
    double speed;  //!< 1: image points move by about 1.4 pixels per frame
    int jump;      //!< number of the first frame after the camera has jumped to another place
    int seed;
};

/** A sequence of frames of 640 x 480 pixels. A camera moves smoothly in front of a box of object
points (P) or a picture on a plane (H), and jumps once. The matches of each frame are drawn anew;
image points of wrong matches are uniform in the frame. */
class Sequence
{
public:
    explicit Sequence(const SequenceOptions& options_) : options(options_) {}

    //! The matches and the ground truth of a frame. The same number gives the same result.
    ImagePair frame(int number) const;

private:
    void setPose(int number, ImagePair& pair) const;

    const SequenceOptions options;
};

}  // namespace benchmark

#endif
