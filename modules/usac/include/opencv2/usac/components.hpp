// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_COMPONENTS_HPP
#define OPENCV_USACV20_COMPONENTS_HPP

#ifndef OPENCV_BINDING_PARSER  // C++ only, no bindings

#include <vector>
#include "opencv2/usac/run.hpp"

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

/** @name Components
The parts of Algorithm 1 of @cite ivashechkin2021usacv20. Each part is a small abstract class;
Usac::create makes the default set, and any part can be replaced before Usac::run. Nearly all
virtual calls cover a sample, a model or a block of points, not a single point.

If Params::threads is not 1, several threads can call the following methods at the same time: all
`const` methods of Residual and MinimalSolver, Score::accumulate, fused, wholeModel and inlierPart,
Verifier::preTest, nextBlock and proceed, and Degeneracy::validSample, mayBeGood and validModel.
These methods must not take memory from Context::arena. All other methods are called by one thread.
@{ */

//! Base class of all components.
class CV_EXPORTS Component
{
public:
    virtual ~Component();
    /** @brief Begins a run. Called before the run uses the component (except for constants such as
    MinimalSolver::sampleSize), even if there are too few points for a model. Called again in the
    run if the points change (the search uses at most 32768 random points, polishing uses all, and
    #THRESHOLD_ESTIMATED first uses 512), and for sampler, verifier and criteria if samples are
    forgotten (State::forgotten). Correspondences::threshold can change without another call, but
    see Degeneracy::thresholdChanged.

    A component that stores data about a run (for example its points or learned values) resets them
    here: the same object is used for the next run, whose points and number of points can differ.
    Memory from Context::arena of the previous run is no longer valid. Other components might not
    have been started yet. Default: does nothing. */
    virtual void start(const Context& context);
};

//! Order of the points, best first (paper, section "Other features").
class CV_EXPORTS Ordering : public Component
{
public:
    virtual ~Ordering();
    //! Writes a permutation of 0 .. size-1 to `order`, where `size` is the number of points.
    virtual void sort(const Context& context, int* order) = 0;
    //! True if the order comes from knowledge about the matches, such as their scores. False if the
    //! order is guessed from the points themselves; samplers rely less on such an order. Can be
    //! called before sort(). Default: true.
    virtual bool informative(const Context& context) const;
};

//! Sparse graph that links neighboring points. It needs O(N) memory and is built at its first use.
class CV_EXPORTS Neighborhood : public Component
{
public:
    virtual ~Neighborhood();
    //! Number of layers, that is, of neighborhood sizes; layer 0 has the smallest neighborhoods.
    virtual int layers() const = 0;
    //! Sets `members` to the point itself and its neighbors in a layer. @return their number.
    virtual int members(const Context& context, int layer, int point, const int*& members) = 0;
    /** @brief Undirected edges of the graph, each listed once, at most a constant times N.
    @param context the run. If edgesOfFirstPoints() is true, `context.points` can be the first N
    points of the run, which are a random subset; all edges are then between these N points.
    @param wanted a value for each of the N points, or null for all edges. To save time, an edge
    between two points with value 0 can be left out.
    @param edges output: pointer to the edges, which are valid until the next call
    @return their number */
    virtual int edges(const Context& context, const uchar* wanted, const Vec2i*& edges) = 0;
    //! Upper bound of the number of edges of a point. Default: -1, which means that the bound is
    //! unknown; the graph cut then counts the edges of all points.
    virtual int mostEdges() const;
    //! True if edges() can be called for the first points of the run, each time for another number
    //! of them, in O(N) time. Default: false, so that edges() is always called for all points.
    virtual bool edgesOfFirstPoints() const;
};

//! Draws minimal samples (paper, section "Sampling").
class CV_EXPORTS Sampler : public Component
{
public:
    virtual ~Sampler();
    /** @brief Draws the next sample with `state.rng`.

    Sets `state.counts` to false if the termination criteria must not treat the sample like one
    drawn uniformly from all points. For example, samples from a subset of the points might never
    consist of inliers of the best model.
    @param context, state the fixed and the changing data of the run
    @param sample output, as many distinct point indices as the minimal solver needs */
    virtual void sample(const Context& context, State& state, int* sample) = 0;
    //! Fraction of the samples that are drawn from a growing set of the best points as in PROSAC.
    //! PROSAC's termination criterion counts only these samples. Default: 0, so that this criterion
    //! never ends the search.
    virtual double growingShare(const Context& context) const;
};

//! Computes models from a minimal sample.
class CV_EXPORTS MinimalSolver : public Component
{
public:
    virtual ~MinimalSolver();
    virtual int sampleSize() const = 0;  //!< points in a sample, at most #MAX_SAMPLE_SIZE
    //! Writes at most #MAX_MODELS models. @return their number; 0 for a degenerate sample.
    virtual int solve(const Correspondences& points, const int* sample, Model* models) const = 0;
    /** @brief The same for several samples; override it if this is faster than one at a time.
    @param points the correspondences
    @param samples for each sample, an array of point indices
    @param count number of samples
    @param models output: for each sample an array of at most #MAX_MODELS models
    @param found output: number of models of each sample

    The models of a sample must not depend on the other samples. Default: calls solve() for each
    sample. */
    virtual void solveMany(const Correspondences& points, const int* const* samples, int count,
                           Model* const* models, int* found) const;
    //! Number of samples for which solveMany() is fastest, at most #MAX_TOGETHER. Default: 1, so
    //! that no sample is solved needlessly when the run ends.
    virtual int together() const;
    enum { MAX_TOGETHER = 8 /*!< maximum number of samples that are solved at once */ };
};

//! Fits a model to many points.
class CV_EXPORTS NonMinimalSolver : public Component
{
public:
    virtual ~NonMinimalSolver();
    /** @brief Fits a model to `count` points.
    @param points the correspondences
    @param indices indices of the points to fit
    @param count number of indices
    @param weights weight of the squared error of each of these points; null: all are 1
    @param model input: initial model; output: the fit
    @param iterations an iterative solver is allowed to stop after this many steps; >= 1
    @return false if the points do not determine a model; `model` is then unchanged. */
    virtual bool fit(const Correspondences& points, const int* indices, int count,
                     const double* weights, Model& model, int iterations = 10) const = 0;
};

struct ResidualKernels;

//! Error of points under a model.
class CV_EXPORTS Residual : public Component
{
public:
    enum { MAX_COMPONENTS = 4 /*!< maximum number of components of an error */ };

    virtual ~Residual();
    //! Writes the squared errors of the points begin .. end-1 to errors[0 .. end-begin-1]; NaN or
    //! infinite where the error is not defined.
    virtual void squaredErrors(const Correspondences& points, const Model& model, int begin,
                               int end, float* errors) const = 0;
    //! The same in double precision, for `count` points that are given as columns and can be other
    //! points than those of the run.
    virtual void squaredErrors(const Model& model, const double* const* columns, int count,
                               double* errors) const = 0;
    /** @brief The error of one datum as a vector whose squared length is the squared error.
    @param model the model
    @param datum one number of each column
    @param error output, at most #MAX_COMPONENTS numbers
    @return the number of components. Default: one component, the square root of the squared error,
    which suits distances to a curve. For an error with more components, override this method,
    because the root has no derivative where the error is 0. */
    virtual int error(const Model& model, const double* datum, double* error) const;
    /** @brief The same, with the derivative of the error with respect to the entries of the model,
    for least-squares fits.
    @param model, datum, error as above
    @param derivative output, a row of Model::size() numbers for each component

    Default: central differences, 2 Model::size() + 1 calls of error(). */
    virtual int linearize(const Model& model, const double* datum, double* error,
                          double* derivative) const;
    //! The loops over points that the module has compiled from the formula of the error. Default:
    //! null, there are none; scores and fits then call the methods above.
    virtual const ResidualKernels* kernels() const;
    //! True (default): models are homogeneous. A FusedKernel gets them scaled so that the largest
    //! absolute entry is 1, and a fit can change scale and sign. False: a FusedKernel gets the
    //! entries unchanged.
    virtual bool homogeneous() const;
};

/** Computes errors and accumulates the quality of the points begin .. end-1 in one pass over
Correspondences::column. `model` has the Model::size() entries as float, see Residual::homogeneous.
A kernel saves time only if the compiler vectorizes its loop; it is then faster than two separate
loops (Residual::squaredErrors, Score::accumulate) even for blocks of 32 points. */
typedef void (*FusedKernel)(const Correspondences& points, const float* model,
                            float squaredThreshold, int begin, int end, Quality& sum);

//! Converts errors to costs (paper, section "Quality").
class CV_EXPORTS Score : public Component
{
public:
    virtual ~Score();
    /** @brief Adds the costs and inliers of a block of points to `sum`; the cost of a point lies
    between 0 (no error) and 1 (outlier). A point whose error is NaN is an outlier.
    `squaredThreshold` has the unit of the squared errors. The method is allowed to modify the array
    of errors. */
    virtual void accumulate(float* squaredErrors, int count, float squaredThreshold,
                            Quality& sum) const = 0;
    //! A kernel that computes errors and score in one pass, without an array of errors. Default:
    //! null, there is none.
    virtual FusedKernel fused(const Residual& residual) const;
    //! True: the cost is not a sum over the points; accumulate() is called once per model, with all
    //! points. Default: false.
    virtual bool wholeModel() const;
    //! True: the cost is the number of points that are not inliers. Default: false.
    virtual bool countsInliers() const;
    //! False: the score does not use Correspondences::threshold but counts a fixed fraction of the
    //! points as inliers, as least median of squares does. Default: true.
    virtual bool usesThreshold() const;
    //! accumulate() counts a point as an inlier if its error is at most this fraction (above 0 and
    //! at most 1) of the threshold; points with larger errors affect only the cost. Default: 1.
    virtual double inlierPart() const;
    //! The threshold, not squared, for the mask and for the steps after the search. Default:
    //! Correspondences::threshold, which means that the score has no threshold of its own; the mask
    //! then uses Params::threshold.
    virtual double threshold(const Context& context, const Model& model) const;
};

//! Rejects bad models early (paper, section "Pre-emptive verification").
class CV_EXPORTS Verifier : public Component
{
public:
    virtual ~Verifier();
    /** @brief Tests single points before blocks of points are tested. Default: tests none.
    @param context, model the data of the run and the model to test
    @param rng random number generator for the models of the sample
    @param inliers, tested output: the number of inliers among the tested points, and the number of
    tested points
    @return false: the model is rejected. */
    virtual bool preTest(const Context& context, const Model& model, Rng& rng, int& inliers,
                         int& tested) const;
    //! Number of points to test before the next decision, when `tested` points have been tested.
    virtual int nextBlock(int tested) const = 0;
    //! False: the model is rejected after `tested` points, of which `inliers` were inliers.
    virtual bool proceed(int inliers, int tested) const = 0;
    /** @brief Probability that a good model passes preTest(). The lower it is, the more samples the
    termination criteria require. Default: 1.
    @param context the data of the run
    @param inliers number of inliers of the model among all points
    @param withoutRepetition true: the probability for points that preTest() draws without
    replacement (hypergeometric distribution); false: with replacement (binomial) */
    virtual double keptProbability(const Context& context, double inliers,
                                   bool withoutRepetition) const;
    //! Called after each sample: the first tests of its models (preTest(), or the first block) used
    //! `tested` points, of which `inliers` were inliers, both summed over the models.
    virtual void sampleTested(State& state, int inliers, int tested) = 0;
    //! Adapts the test; called when a search begins or is continued, and after each batch of
    //! samples.
    virtual void adapt(const Context& context, State& state) = 0;
};

//! Checks for degenerate configurations (paper, section "Degeneracy"). The members of
//! Components::degeneracies are called in turn until one rejects the sample or model.
class CV_EXPORTS Degeneracy : public Component
{
public:
    virtual ~Degeneracy();
    //! False: the sample is rejected, no model is computed from it. Default: true.
    virtual bool validSample(const Context& context, const int* sample) const;
    /** @brief The same for several samples; override it, too, if this is faster than one at a time.
    The results must be those of validSample(), which is also called.
    @param context the fixed data of the run
    @param samples for each sample, an array of point indices
    @param count number of samples, at most MinimalSolver::MAX_TOGETHER
    @param valid output: result for each sample

    Default: calls validSample() for each sample. */
    virtual void validSamples(const Context& context, const int* const* samples, int count,
                              bool* valid) const;
    //! Called for a sample that validSample() has rejected. True: its points might all be inliers
    //! (two of them repeat one match), so it is counted in State::repeatedSamples instead of
    //! State::countedSamples. Default: false.
    virtual bool mayBeGood(const Context& context, const int* sample) const;
    //! False: the model is rejected and not scored. Default: true.
    virtual bool validModel(const Context& context, const int* sample, const Model& model) const;
    /** @brief Examines a model that is better than all before, or a runner-up, and can replace it
    by a better one.
    @param sample the sample that the model was computed from; null for a model of another origin,
    such as an optimized or initial model
    @param context, state the fixed and the changing data of the run
    @param model, quality the model and its score
    @return false: the model is rejected, because it is degenerate and cannot be corrected. Default:
    true */
    virtual bool recover(const Context& context, State& state, const int* sample, Model& model,
                         Quality& quality);
    //! Called when Correspondences::threshold might have changed since start(), before recover()
    //! and discount() are called again. For checks that store results that depend on the threshold.
    //! Default: does nothing.
    virtual void thresholdChanged(const Context& context);
    //! Lowers the quality of a model if some of its inliers are not independent of each other, such
    //! as repeated matches. Default: does nothing.
    virtual void discount(const Context& context, const Model& model, Quality& quality);
    //! Probability that an all-inlier sample leads to this model, which has just become the best
    //! one, and not to a wrong model with nearly as many inliers. At most 1, which is the default;
    //! the lower it is, the more samples are drawn.
    virtual double successProbability(const Context& context, const State& state,
                                      const Model& model);
};

//! Improves each model that is better than all before, and runners-up (paper, section "Local
//! optimization").
class CV_EXPORTS LocalOptimizer : public Component
{
public:
    virtual ~LocalOptimizer();
    //! Replaces the model by a better one. @return false if no better model was found; model and
    //! quality are then unchanged.
    virtual bool optimize(const Context& context, State& state, Model& model, Quality& quality) = 0;
};

//! When to stop (paper, section "Termination criterion").
class CV_EXPORTS Termination : public Component
{
public:
    virtual ~Termination();
    //! Number of samples after which the run can stop, given the best model so far; countsAll()
    //! determines which samples are counted. INT_MAX: the number is not yet known. Called when the
    //! best model changes, and when other data of the criteria have changed, for example
    //! `state.tests`.
    virtual int iterations(const Context& context, const State& state) const = 0;
    //! True (default): iterations() is a number of samples of any kind. False: only samples with
    //! State::counts are counted; all samples are counted nevertheless if more than half of the
    //! points outside the sample of the best model are its inliers, unless State::degenerate is
    //! true or State::successProbability is below 1.
    virtual bool countsAll() const;
    /** @brief Called between batches of samples: can set State::wanted, so that the sampler draws
    what the criterion needs. Default: does nothing.
    @return true if the result of iterations() might have changed; all criteria are then evaluated
    again. */
    virtual bool adapt(const Context& context, State& state);
    //! The @ref StopReason that is reported. Default: #STOP_CUSTOM.
    virtual int reason() const;
};

//! The last step: improves the model with all inliers.
class CV_EXPORTS Polisher : public Component
{
public:
    virtual ~Polisher();
    //! Replaces the model by a better one if it can.
    virtual void polish(const Context& context, Model& model) = 0;
    /** @brief The error up to which points influence a polished model, for Report::covariance. The
    polished model must be an M-estimate: the sum over these points of weight times error times the
    derivative of the error with respect to the parameters is 0.
    @param context context of polish()
    @param squaredErrors squared errors of all points under the polished model
    @return an error in the coordinates of the points, not squared. Default: 0, which means that it
    is unknown what polish() minimizes; Report::covariance is then NaN. */
    virtual double support(const Context& context, const float* squaredErrors) const;
    //! The weight of a point whose error is within support(). `square` is its squared error divided
    //! by the squared support, 0 to 1; `degrees` is Problem::errorDimension. Default: 1.
    virtual double weight(double square, int degrees) const;
};

//! The components of one estimator.
struct CV_EXPORTS Components
{
    //! Calls Component::start of all components.
    void start(const Context& context) const;

    Ptr<Residual> residual;                      //!< required
    Ptr<Score> score;                            //!< required
    Ptr<Ordering> ordering;                      //!< empty: State::order is 0, 1, 2, ...
    Ptr<Neighborhood> neighborhood;              //!< required by NAPSAC, P-NAPSAC and graph cuts
    Ptr<Sampler> sampler;                        //!< required
    Ptr<MinimalSolver> minimalSolver;            //!< required
    Ptr<NonMinimalSolver> nonMinimalSolver;      //!< required for local optimization, polishing
    std::vector<Ptr<Degeneracy>> degeneracies;   //!< called in this order
    Ptr<Verifier> verifier;                      //!< empty: none
    Ptr<LocalOptimizer> localOptimizer;          //!< empty: none
    std::vector<Ptr<Termination>> terminations;  //!< the first to fire ends the search
    Ptr<Polisher> polisher;                      //!< empty: none
};

//! @}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
