// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUN_HPP
#define OPENCV_USACV20_RUN_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include <algorithm>
#include <limits>
#include "opencv2/usac/arena.hpp"
#include "opencv2/usac/data.hpp"
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"
#include "opencv2/usac/rng.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

//! Parameters of one design of the sequential probability ratio test (SPRT), and the number of
//! samples that this design was used for.
struct SequentialTest
{
    double epsilon;  //!< probability that a point is an inlier of a good model
    double delta;    //!< probability that a point is an inlier of a bad model
    double A;  //!< decision threshold: a good model is rejected with a probability of at most 1/A
    int samples;  //!< number of samples with this design for which State::counts was true
};

struct Context;

//! Kinds of samples that a termination criterion can ask for, see State::wanted.
enum WantedSamples {
    SAMPLES_MIXED,   //!< samples that follow the order of the points, mixed with uniform ones, see
                     //!< Params::orderedEvery
    SAMPLES_HALF,    //!< mixed samples of which every second one follows the order
    SAMPLES_ORDERED  //!< only samples that follow the order
};

//! Everything that changes during a run.
struct CV_EXPORTS State
{
    State()
        : iteration(0), counts(true), successProbability(1), countedSamples(0), repeatedSamples(0),
          orderedSamples(0), forgotten(0), wanted(SAMPLES_MIXED), unexplainedSamples(0), order(0),
          degenerate(false)
    {}

    //! Number of samples that are not forgotten, see `forgotten`.
    int remembered() const { return iteration - std::max(forgotten, 0); }

    //! The indices of the points in the sequence given by the Ordering, best point first. The first
    //! call sorts them.
    const int* bestFirst(const Context& context)
    {
        if (!order)
            sort(context);
        return order;
    }

    Rng rng;        //!< generator of the current iteration
    int iteration;  //!< number of samples drawn so far
    bool counts;    //!< the termination criteria count the current sample like a sample drawn
                    //!< uniformly from all points; true unless the sampler sets `counts` to false
    double successProbability;  //!< probability that an all-inlier sample leads to the best model,
                                //!< see Degeneracy::successProbability()
    int countedSamples;   //!< number of samples so far for which `counts` was true; the confidence
                          //!< is computed from this number
    int repeatedSamples;  //!< number of samples that would count, but contain the same match twice
    int orderedSamples;   //!< number of samples that follow a known order (scores, order of input)
    int forgotten;        //!< number of samples at the start of the run that do not count, because
                          //!< the threshold has changed since; -k: k samples that were drawn for
                          //!< #THRESHOLD_ESTIMATED count, too
    int wanted;           //!< @ref WantedSamples; used only by samplers that follow a known order
    //! Set by a criterion that ends the search with #STOP_ORDER: number of samples that are drawn
    //! from the outliers of the best model before the search ends. The search continues if these
    //! samples lead to a better model.
    int unexplainedSamples;
    const int* order;                 //!< result of bestFirst(); null before its first call
    Model best;                       //!< the best model so far
    Quality bestQuality;              //!< score of `best`
    Quality sampleQuality;            //!< the best score of a model of a sample before optimization
    ArenaList<SequentialTest> tests;  //!< designs of the verifier's test; the last one is current
    bool degenerate;  //!< true if a sample or model was degenerate, for example dominated by a
                      //!< plane
    Report report;    //!< statistics of the run so far

private:
    void sort(const Context& context);
};

struct Components;
class Neighborhood;
class NonMinimalSolver;
class Watch;

//! What does not change during a run; passed to components that need more than their own data.
struct CV_EXPORTS Context
{
    //! The object keeps references to all arguments, which must outlive it.
    Context(const Correspondences& points_, const Components& components_, const Params& params_,
            Arena& arena_, Watch* watch_ = 0)
        : points(points_), components(components_), params(params_), arena(arena_), watch(watch_)
    {}

    /** @brief The score of a model over all points.
    @param model the model to score
    @param bound scoring stops when the cost reaches this value; the returned cost can then be
    incomplete, but is not lower than `bound`.

    Only one thread at a time is allowed to call rate(), because it takes memory from the arena. */
    Quality rate(const Model& model, double bound = std::numeric_limits<double>::infinity()) const;

    //! Components::neighborhood; raises cv::Exception if there is none.
    Neighborhood& neighborhood() const;
    //! Components::nonMinimalSolver; raises cv::Exception if there is none.
    const NonMinimalSolver& nonMinimalSolver() const;

    //! Error, not squared, up to which Quality::inliers counts a point (unless Score::usesThreshold
    //! is false). If there is no score component: Correspondences::threshold.
    double inlierThreshold() const;
    //! Probability that a point is an inlier of a wrong model, see Problem::randomInlierRatio.
    double randomInlierRatio() const;

    //! True if the run must end now (Params::maxTime, ProgressScope); the component then returns
    //! its best result so far. For loops that process all points in each iteration. To be called by
    //! the thread that began the run.
    bool stop() const { return watch && mustStop(); }
    //! The same for loops with shorter iterations.
    //! @param work work done since the last call, in point tests of 2 ns each, see SampleCost
    bool stop(double work) const { return watch && mustStop(work); }
    //! To be called before a step that cannot be interrupted: true if the run must end now or if
    //! this step would exceed Params::maxTime. The caller then skips the step, and the run ends.
    //! @param work work of the step, in point tests
    bool stopBefore(double work) const { return watch && mustStopBefore(work); }

    const Correspondences& points;  //!< points of the run
    const Components& components;   //!< all parts of the estimator
    const Params& params;           //!< options
    Arena& arena;                   //!< memory of the run
    Watch* const watch;             //!< stops the run early; null: nothing stops it early

private:
    bool mustStop() const;
    bool mustStop(double work) const;
    bool mustStopBefore(double work) const;
};

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
