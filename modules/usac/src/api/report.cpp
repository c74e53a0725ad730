// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

namespace {

//! describe() calls a model no better than chance if its Report::chance is above this number, which
//! is also the usual bound for Params::significance 0.
constexpr double SIGNIFICANT = 0.01;
//! describe() says that few inliers are independent of each other (most are nearly equal to other
//! inliers) if there are more than this many inliers for each independent inlier.
constexpr int FEW = 4;

}  // namespace

Report::Report()
    : stop(STOP_NOT_RUN), iterations(0), rejectedSamples(0), degenerateSamples(0), models(0),
      rejectedModels(0), refusedModels(0), droppedModels(0), localOptimizations(0),
      localImprovements(0), degenerate(false), inliers(0), inlierRatio(0), independentInliers(0),
      chance(1), threshold(0), sigma(0), priorChance(0), wideThreshold(false), cost(0), setupMs(0),
      searchMs(0), localMs(0), polishMs(0)
{}

String Report::describe() const
{
    static const char* const reasons[] = {
        "nothing was run",
        "no model: too few finite correspondences",
        "no model: no sample led to one with enough inliers",
        "maximum number of iterations",
        "standard criterion",
        "SPRT criterion",
        "P-NAPSAC criterion",
        "custom criterion",
        "PROSAC criterion",
        "MAGSAC criterion",
        "no model is significantly better than those of random points",
        "the order of the points",
        "Params::maxTime",
        "canceled",
        "no search"};
    const char* reason = stop >= STOP_NOT_RUN && stop <= STOP_NO_SEARCH ? reasons[stop]
                                                                        : "unknown reason";
    const bool model = stop >= STOP_MAX_ITERATIONS && stop != STOP_NOT_SIGNIFICANT &&
                       stop != STOP_NO_SEARCH && (inliers > 0 || cost > 0);
    const String few = model && FEW * independentInliers < inliers && independentInliers > 0
                           ? format("; only %d inliers are independent", independentInliers)
                           : String();
    return format(
        "%d inliers, cost %.4f, %d iterations, %d local optimizations, stopped by: %s%s%s%s%s%s",
        inliers, cost, iterations, localOptimizations, reason,
        degenerate ? "; a dominant plane was found" : "", warning.empty() ? "" : "; ",
        warning.c_str(), few.c_str(),
        model && chance > SIGNIFICANT ? "; no better than chance" : "");
}

}  // namespace usacv20
}  // namespace cv
