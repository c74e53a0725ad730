// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_STREAMS_HPP
#define OPENCV_USACV20_STREAMS_HPP

#include "opencv2/core/cvdef.h"

namespace cv {
namespace usacv20 {

//! Purposes for which random numbers are drawn. The samples of the main loop are not listed: they
//! use the streams 0 to INT_MAX of Rng. Each purpose has its own range of streams.
enum Stream {
    STREAM_ROTATION = 1,  //!< point at which the verification of a model begins, and points of
                          //!< Verifier::preTest
    STREAM_REFINEMENT,    //!< local optimization and degeneracy checks of an iteration
    STREAM_UNEXPLAINED,   //!< samples of the points that the best model does not explain
    STREAM_PLANE,         //!< triples of points, to find a plane
    STREAM_RESTARTS,      //!< restarts of the final polishing
    STREAM_FIT,           //!< samples from which a fit without a search (Usac::fit) starts
    STREAM_LEVERAGE,      //!< correction of models that points of high leverage distort: triples of
                          //!< points, to find a plane, and samples for new models
    STREAM_WRONG          //!< artificial wrong points, drawn if a problem has only one array, see
                          //!< countAgreement()
};

//! Stream number for Rng. Each purpose has 2^40 streams; `number` is the index of the stream among
//! these.
inline uint64 streamOf(Stream stream, uint64 number = 0) { return ((uint64)stream << 40) + number; }

}  // namespace usacv20
}  // namespace cv

#endif
