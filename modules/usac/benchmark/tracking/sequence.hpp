// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SEQUENCE_HPP
#define OPENCV_USACV20_BENCHMARK_SEQUENCE_HPP

#include "image_pair.hpp"

namespace benchmark {

//! What the frames of a sequence have in common.
struct SequenceOptions
{
    ProblemType problem;  //!< HOMOGRAPHY or ABSOLUTE_POSE
    int size;             //!< matches of a frame
    double inliers;       //!< part of them that is right
    double noise;  //!< standard deviation of the points of the image in each coordinate, pixels
    double speed;  //!< 1: about 1.4 pixels a frame
    int jump;      //!< frame before which the camera jumps to another place
    int seed;
};

/** Frames of a camera that moves smoothly about a box of object points (P) or a picture on a plane
(H), 640 x 480 pixels, and once jumps. Each frame has matches of its own, wrong ones anywhere in the
image. */
class Sequence
{
public:
    explicit Sequence(const SequenceOptions& options_) : options(options_) {}

    //! Matches and truth; the same for the same frame.
    ImagePair frame(int number) const;

private:
    void setPose(int number, ImagePair& pair) const;

    const SequenceOptions options;
};

}  // namespace benchmark

#endif
