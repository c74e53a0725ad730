// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_STREAMS_HPP
#define OPENCV_USACV20_STREAMS_HPP

#include "opencv2/core/cvdef.h"

namespace cv {
namespace usacv20 {

//! Who draws random numbers beside the samples, which have the streams 0 .. 2^31 of Rng. Each has
//! numbers of its own.
enum Stream {
    STREAM_ROTATION = 1,  //!< where the verifier begins
    STREAM_REFINEMENT,    //!< of an iteration: local optimization and checks
    STREAM_UNEXPLAINED,   //!< samples of the points that the best model leaves
    STREAM_PLANE,         //!< triples of points that show a plane
    STREAM_RESTARTS,      //!< of the polishing
    STREAM_FIT,           //!< samples that a fit without a search begins with
    STREAM_LEVERAGE       //!< where a model may hang on few points: a plane, samples of the others
};

//! Stream of Rng, one of 2^40.
inline uint64 streamOf(Stream stream, uint64 number = 0) { return ((uint64)stream << 40) + number; }

}  // namespace usacv20
}  // namespace cv

#endif
