// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_LOCAL_OPTIMIZATION_HPP
#define OPENCV_USACV20_LOCAL_OPTIMIZATION_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Creates a faster variant of the local optimization of GC-RANSAC, see GraphCutOptimizer.
Ptr<LocalOptimizer> createGraphCutOptimizer();
//! Creates the local optimization of GC-RANSAC as in its paper, see GcRansacOptimizer.
Ptr<LocalOptimizer> createGcRansacOptimizer();
//! Creates the local optimization of LO-RANSAC, see LoRansacOptimizer.
Ptr<LocalOptimizer> createLoRansacOptimizer();
//! Creates the local optimization of FLO-RANSAC, a LoRansacOptimizer with fits of bounded size.
Ptr<LocalOptimizer> createFloRansacOptimizer();
//! Creates the local optimization of MAGSAC, see SigmaConsensus.
Ptr<LocalOptimizer> createSigmaConsensus();
//! Creates the local optimization of MAGSAC++, see SigmaConsensusPlusPlus.
Ptr<LocalOptimizer> createSigmaConsensusPlusPlus();

}  // namespace usacv20
}  // namespace cv

#endif
