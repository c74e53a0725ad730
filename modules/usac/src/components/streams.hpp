// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_STREAMS_HPP
#define OPENCV_USACV20_STREAMS_HPP

#include "opencv2/core/cvdef.h"

namespace cv {
namespace usacv20 {

//! What random numbers are drawn for, apart from the samples of the main loop, which use the
//! streams 0 .. 2^31 of Rng. Each purpose has streams of its own.
enum Stream {
    STREAM_ROTATION = 1,  //!< point at which the verification of a model begins
    STREAM_REFINEMENT,    //!< local optimization and degeneracy checks of an iteration
    STREAM_UNEXPLAINED,   //!< samples of the points that the best model does not explain
    STREAM_PLANE,         //!< triples of points, to find a plane
    STREAM_RESTARTS,      //!< restarts of the final polishing
    STREAM_FIT,           //!< samples that a fit without a search starts from
    STREAM_LEVERAGE       //!< check for points of high leverage: planes, samples of other points
};

//! Number of a stream of Rng; each purpose has 2^40 streams.
inline uint64 streamOf(Stream stream, uint64 number = 0) { return ((uint64)stream << 40) + number; }

}  // namespace usacv20
}  // namespace cv

#endif
