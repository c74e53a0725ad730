// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COMPONENTS_HPP
#define OPENCV_USACV20_COMPONENTS_HPP

#ifndef OPENCV_BINDING_PARSER  // nothing here is for other languages

#include <vector>
#include "opencv2/usac/arena.hpp"
#include "opencv2/usac/data.hpp"
#include "opencv2/usac/params.hpp"
#include "opencv2/usac/report.hpp"
#include "opencv2/usac/rng.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20
//! @{

/** @name Components The parts of Algorithm 1 of @cite ivashechkin2021usacv20. Each is a small
abstract class; Usac::create makes the default set and any of them can be replaced before Usac::run.
A virtual call covers a sample, a model or a block of points, never a point.

If Params::threads is not 1, several threads call at once the methods of Residual and MinimalSolver,
Score::accumulate, Verifier::preTest, nextBlock and proceed, and Degeneracy::validSample, mayBeGood
and validModel. These are `const`, and must take no memory from Context::arena. All others are
called by one thread.
@{ */

//! One design of the sequential probability ratio test, and how long it was in use.
struct SequentialTest
{
    double epsilon;  //!< probability that a point is an inlier of a good model
    double delta;    //!< probability that a point is an inlier of a bad model
    double A;     //!< decision threshold: a good model is dropped with a probability of at most 1/A
    int samples;  //!< samples whose models it has tested, of those that count (State::counts)
};

struct Context;

//! Which samples the criteria want to be drawn, see State::wanted.
enum WantedSamples {
    SAMPLES_MIXED,   //!< those that follow the order and uniform ones, see Params::orderedEvery
    SAMPLES_HALF,    //!< the same, but every second one follows the order
    SAMPLES_ORDERED  //!< those that follow the order
};

//! All that changes during a run.
struct CV_EXPORTS State
{
    State()
        : iteration(0), counts(true), yield(1), countedSamples(0), repeatedSamples(0),
          orderedSamples(0), wanted(SAMPLES_MIXED), unexplainedSamples(0), order(0)
    {}

    //! The points, best first, as the Ordering says; sorted at the first call.
    const int* bestFirst(const Context& context)
    {
        if (!order)
            sort(context);
        return order;
    }

    Rng rng;        //!< generator of the current iteration
    int iteration;  //!< samples drawn so far
    bool counts;  //!< the present sample is as good as a uniform one of all points; true unless the
                  //!< sampler says no
    double yield;  //!< part of the samples of inliers only that lead to the best model; 1, but for
                   //!< degenerate scenes
    int countedSamples;   //!< samples so far that count: what the confidence rests on
    int repeatedSamples;  //!< samples that do not count only because a match was in them twice
    int orderedSamples;   //!< samples drawn so far that follow an order that is known (scores, the
                          //!< order of the input)
    int wanted;  //!< @ref WantedSamples; only samplers that follow a known order look at it
    //! So many samples of the points that the best model does not explain has a criterion that ends
    //! the search with #STOP_ORDER drawn before: they must not lead to a better model.
    int unexplainedSamples;
    const int* order;     //!< what bestFirst() has returned; null before
    Model best;           //!< the best model so far
    Quality bestQuality;  //!< and what it is worth
    Quality
        sampleQuality;  //!< the best of a model as it came from its sample, before any optimization
    ArenaList<SequentialTest> tests;  //!< those of the verifier so far, the last one is in use
    Report report;                    //!< what the run has learned so far

private:
    void sort(const Context& context);
};

struct Components;
class Neighborhood;
class NonMinimalSolver;
class Watch;

//! What does not change during a run; handed to the components that need more than their own data.
struct CV_EXPORTS Context
{
    //! Keeps references: all must outlive it.
    Context(const Correspondences& points_, const Components& components_, const Params& params_,
            Arena& arena_, Watch* watch_ = 0)
        : points(points_), components(components_), params(params_), arena(arena_), watch(watch_)
    {}

    /** @brief Quality of a model over all points.
    @param model what is rated
    @param bound stop as soon as the cost reaches it; the result is then only known not to be
    better. For one thread at a time, as it takes memory from the arena. */
    Quality rate(const Model& model, double bound = std::numeric_limits<double>::infinity()) const;

    //! Those of Components; raise cv::Exception that names what is missing.
    Neighborhood& neighborhood() const;
    const NonMinimalSolver& nonMinimalSolver() const;  //!< the same

    //! Not squared: within it of a model a point is one of Quality::inliers. Without a score that
    //! of the points.
    double inlierThreshold() const;
    //! Probability that a point is that by chance, see Problem::randomInlierRatio.
    double randomInlierRatio() const;

    //! Has the run to end at once (Params::maxTime, ProgressScope)? For loops of components that
    //! take all points in each turn: they leave with the best that they have. For the thread that
    //! began the run.
    bool stop() const { return watch && mustStop(); }
    //! The same in a loop of short turns. @param work since the question before, in tests of a
    //! point, 2 ns each
    bool stop(double work) const { return watch && mustStop(work); }
    //! The same before a step that cannot be left: also if Params::maxTime would be over before so
    //! much more work is done. The run ends then; the step is left out.
    bool stopBefore(double work) const { return watch && mustStopBefore(work); }

    const Correspondences& points;  //!< those of the run
    const Components& components;   //!< all parts of the estimator
    const Params& params;           //!< its options
    Arena& arena;                   //!< memory of the run
    Watch* const watch;             //!< null: nothing ends the run before its criteria do

private:
    bool mustStop() const;
    bool mustStop(double work) const;
    bool mustStopBefore(double work) const;
};

//! What all components have in common.
class CV_EXPORTS Component
{
public:
    virtual ~Component();
    /** @brief A run begins. Called once a run, before anything else, also if there are too few
    points for a model.

    A component that knows something of a run (of its points, say, or what it has learned) begins
    anew here: the same object is used again for the next run, which may have other points of
    another number. What it has taken from Context::arena in the run before is gone. Other
    components may not have begun yet. Default: nothing. */
    virtual void start(const Context& context);
};

//! Order of the points, best first (paper, section "Other features").
class CV_EXPORTS Ordering : public Component
{
public:
    virtual ~Ordering();
    //! Writes a permutation of 0 .. size-1 to `order`, which has room for as many as there are
    //! points.
    virtual void sort(const Context& context, int* order) = 0;
    //! Does the order come from knowledge of the matches, their scores, say? False: it is a guess
    //! from the points themselves, on which samplers rely less. May be asked before sort().
    //! Default: true.
    virtual bool informative(const Context& context) const;
};

//! Sparse neighborhood graph of the points, O(N) memory, built at first use.
class CV_EXPORTS Neighborhood : public Component
{
public:
    virtual ~Neighborhood();
    //! Number of neighborhood sizes, from the finest 0 to the coarsest.
    virtual int layers() const = 0;
    //! Neighbors of a point in a layer, the point itself among them. @return their number,
    //! `members` points to them.
    virtual int members(const Context& context, int layer, int point, const int*& members) = 0;
    //! Undirected edges of the graph, each once, at most a constant times N. @return their number,
    //! `edges` points to them.
    virtual int edges(const Context& context, const Vec2i*& edges) = 0;
};

//! Draws minimal samples (paper, section "Sampling").
class CV_EXPORTS Sampler : public Component
{
public:
    virtual ~Sampler();
    /** @brief Draws the next sample with `state.rng`.

    Sets `state.counts` to false if the criteria of termination must not take the sample for one
    that is uniform among all points: what is drawn from a part of the points may never meet the
    best model.
    @param context, state what does not change during the run, and what does
    @param sample output, as many distinct point indices as the minimal solver needs */
    virtual void sample(const Context& context, State& state, int* sample) = 0;
    //! The samples that are not uniform come from so many of the best points (State::bestFirst())
    //! now. Default: all.
    virtual int subsetSize(const Context& context) const;
    //! Part of the samples that are drawn as PROSAC does, from its growing set, and that its
    //! criterion may count. Default: 0, so that this criterion never ends the search.
    virtual double growingShare(const Context& context) const;
};

//! From a minimal sample to models.
class CV_EXPORTS MinimalSolver : public Component
{
public:
    virtual ~MinimalSolver();
    virtual int sampleSize() const = 0;  //!< points of a sample, at most #MAX_SAMPLE_SIZE
    //! Writes at most #MAX_MODELS models. @return their number; 0 for a degenerate sample.
    virtual int solve(const Correspondences& points, const int* sample, Model* models) const = 0;
};

//! From many points to one model.
class CV_EXPORTS NonMinimalSolver : public Component
{
public:
    virtual ~NonMinimalSolver();
    /** @brief Fits a model to `count` points.
    @param points the correspondences
    @param indices which of them
    @param count number of indices
    @param weights one per index, or null for ones
    @param model input: where to start; output: the fit
    @param iterations an iterative solver may stop after as many steps; >= 1
    @return false if the points do not determine a model; `model` is then as before. */
    virtual bool fit(const Correspondences& points, const int* indices, int count,
                     const double* weights, Model& model, int iterations = 10) const = 0;
};

//! Error of points under a model.
class CV_EXPORTS Residual : public Component
{
public:
    //! Formulas of the built-in errors, see kind().
    enum Kind {
        TRANSFER,
        SAMPSON,
        SYMMETRIC_TRANSFER,
        SYMMETRIC_EPIPOLAR,
        REPROJECTION,
        SPACE_TRANSFER,
        CUSTOM
    };
    enum { MAX_COMPONENTS = 4 /*!< most components of an error */ };

    virtual ~Residual();
    //! Squared errors of the points begin .. end-1. Where the error is not defined the value is NaN
    //! or infinite.
    virtual void squaredErrors(const Correspondences& points, const Model& model, int begin,
                               int end, float* errors) const = 0;
    //! The same in double, for `count` points in any coordinates, given as columns.
    virtual void squaredErrors(const Model& model, const double* const* columns, int count,
                               double* errors) const = 0;
    /** @brief The error of one datum as a vector whose squared length is the squared error.
    @param model what it is compared with
    @param datum one number of each column
    @param error output, at most #MAX_COMPONENTS numbers
    @return their number. Default: one, the root of the squared error. That is the distance to a
    curve but for its sign; for an error with two or three components it is better to write this
    method: the root has no derivative where the error is 0.
  */
    virtual int error(const Model& model, const double* datum, double* error) const;
    /** @brief The same, with the derivative by the entries of the model: what a model is fitted
    with.
    @param model, datum, error as above
    @param derivative output, a row of Model::size() numbers for each component
    Default: central differences, 2 Model::size() + 1 calls of error(). */
    virtual int linearize(const Model& model, const double* datum, double* error,
                          double* derivative) const;
    //! Names the formula, so that a Score can offer a fused kernel for it. Default: CUSTOM, which
    //! has none.
    virtual Kind kind() const;
    //! True, the default: any multiple of a model is the same model, so that a FusedKernel gets it
    //! with the largest number 1. False: it gets the numbers as they are.
    virtual bool homogeneous() const;
};

/** Computes errors and accumulates the quality of the points begin to end-1 in one pass over
Correspondences::column. `model` are the Model::size() numbers as float, see Residual::homogeneous.
It is worth its while if it becomes vector code, also for blocks of 32 points. */
typedef void (*FusedKernel)(const Correspondences& points, const float* model,
                            float squaredThreshold, int begin, int end, Quality& sum);

//! What errors are worth (paper, section "Quality").
class CV_EXPORTS Score : public Component
{
public:
    virtual ~Score();
    /** @brief Adds a block of points to `sum`; the cost of a point lies between 0 (perfect) and 1
    (outlier). NaN is an outlier. `squaredThreshold` is that of the errors' coordinates. The array
    of errors may be changed. */
    virtual void accumulate(float* squaredErrors, int count, float squaredThreshold,
                            Quality& sum) const = 0;
    //! A kernel that does the same without the array of errors, or null.
    virtual FusedKernel fused(const Residual& residual) const;
    //! True: the cost is no sum over the points; accumulate is called once for a model, with all of
    //! them. Default: false.
    virtual bool wholeModel() const;
    //! The part of the threshold of the points, 0 to 1, within which accumulate() counts inliers;
    //! points beyond it add to the cost alone. Default: 1.
    virtual double inlierPart() const;
    //! The threshold, not squared, of the mask and of what follows the search. Default: that of the
    //! points.
    virtual double threshold(const Context& context, const Model& model) const;
};

//! Drops bad models early (paper, section "Pre-emptive verification").
class CV_EXPORTS Verifier : public Component
{
public:
    virtual ~Verifier();
    /** @brief Looks at single points of a model, before the blocks. Default: at none.
    @param context, model what is tested
    @param rng generator of the sample
    @param inliers, tested output: the number of points looked at, and of inliers among them
    @return false: the model is dropped. */
    virtual bool preTest(const Context& context, const Model& model, Rng& rng, int& inliers,
                         int& tested) const;
    //! How many points to look at before the next decision, after `tested`.
    virtual int nextBlock(int tested) const = 0;
    //! False: the model, of whose first `tested` points `inliers` are inliers, is dropped.
    virtual bool proceed(int inliers, int tested) const = 0;
    /** @brief Probability that a good model passes preTest(), which takes more samples accordingly.
    Default: 1.
    @param context the points
    @param inliers of the model, of all points
    @param withoutRepetition no point is drawn twice: hypergeometric, not binomial */
    virtual double keptProbability(const Context& context, double inliers,
                                   bool withoutRepetition) const;
    //! A sample has been dealt with; its models had `inliers` among the `tested` points that each
    //! was tested with first.
    virtual void sampleTested(State& state, int inliers, int tested) = 0;
    //! Called before the first sample and between batches of samples: may adapt the test.
    virtual void adapt(const Context& context, State& state) = 0;
};

//! Degenerate configurations (paper, section "Degeneracy"). Members of Components::degeneracies are
//! asked in turn, until one says no.
class CV_EXPORTS Degeneracy : public Component
{
public:
    virtual ~Degeneracy();
    //! False: no model shall be computed from the sample. Default: true.
    virtual bool validSample(const Context& context, const int* sample) const;
    //! Of a sample that validSample() has refused: might all of it be inliers (a match is in it
    //! twice), so that it does not count as one that failed? Default: false.
    virtual bool mayBeGood(const Context& context, const int* sample) const;
    //! False: the model shall not be tested. Default: true.
    virtual bool validModel(const Context& context, const int* sample, const Model& model) const;
    /** @brief Looks at a new so-far-the-best model and may replace it by a better one, lower its
    quality, or set `state.yield`.
    @param sample the sample that the model was computed from; null after the local optimization
    @param context, state, model, quality what does not change, what does, the model and its quality
    @return false: the model is degenerate and could not be mended, it is dropped. Default: true. */
    virtual bool recover(const Context& context, State& state, const int* sample, Model& model,
                         Quality& quality);
};

//! Improves each so-far-the-best model (paper, section "Local optimization").
class CV_EXPORTS LocalOptimizer : public Component
{
public:
    virtual ~LocalOptimizer();
    //! Replaces the model by a better one. @return false if there is none; model and quality are
    //! then as before.
    virtual bool optimize(const Context& context, State& state, Model& model, Quality& quality) = 0;
};

//! When to stop (paper, section "Termination criterion").
class CV_EXPORTS Termination : public Component
{
public:
    virtual ~Termination();
    //! Number of samples after which the run can stop, given the best model so far. INT_MAX: not
    //! yet known. Asked when the best model changes, and when the verifier begins another of
    //! `state.tests`. Which samples are counted, countsAll() says.
    virtual int iterations(const Context& context, const State& state) const = 0;
    //! True, the default: the number is one of all samples. False: of those for which State::counts
    //! is true, or of all where one model has more than half of the points beside its sample.
    virtual bool countsAll() const;
    /** @brief Called between batches of samples: may set State::wanted, so that the sampler draws
    what the criterion needs. Default: does nothing.
    @return true if iterations() may have changed; all criteria are then asked again. */
    virtual bool adapt(const Context& context, State& state);
    //! @ref StopReason. Default #STOP_CUSTOM.
    virtual int reason() const;
};

//! Last step: a better model from all inliers.
class CV_EXPORTS Polisher : public Component
{
public:
    virtual ~Polisher();
    //! Replaces the model by a better one if it can.
    virtual void polish(const Context& context, Model& model) = 0;
};

//! The parts of one estimator.
struct CV_EXPORTS Components
{
    //! Component::start of all.
    void start(const Context& context) const;

    Ptr<Residual> residual;                      //!< required
    Ptr<Score> score;                            //!< required
    Ptr<Ordering> ordering;                      //!< empty: State::order is 0, 1, 2, ...
    Ptr<Neighborhood> neighborhood;              //!< required by P-NAPSAC and graph cut
    Ptr<Sampler> sampler;                        //!< required
    Ptr<MinimalSolver> minimalSolver;            //!< required
    Ptr<NonMinimalSolver> nonMinimalSolver;      //!< required by graph cut and least squares
    std::vector<Ptr<Degeneracy>> degeneracies;   //!< asked in this order
    Ptr<Verifier> verifier;                      //!< empty: none
    Ptr<LocalOptimizer> localOptimizer;          //!< empty: none
    std::vector<Ptr<Termination>> terminations;  //!< the first that fires ends the run
    Ptr<Polisher> polisher;                      //!< empty: none
};

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
