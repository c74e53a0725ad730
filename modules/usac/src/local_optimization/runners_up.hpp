// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUNNERS_UP_HPP
#define OPENCV_USACV20_RUNNERS_UP_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Marks which of the first #MOST points are inliers of a model, with one bit per point. The points
//! are in random order, so that the first points represent all points.
class InlierBits
{
public:
    //! Maximum number of points.
    enum { MOST = 256 };

    //! An object without inliers.
    InlierBits();
    //! @param width threshold of these inliers, as a multiple of Context::inlierThreshold()
    InlierBits(const Context& context, const Model& model, double width = 1);

    //! Number of inliers.
    int count() const;
    //! Number of inliers that are not in `others`.
    int without(const InlierBits& others) const;

private:
    enum { WORDS = MOST / 64 };

    uint64 words[WORDS];
};

//! Indices of the points of a sample.
typedef Vec<int, MAX_SAMPLE_SIZE> Sample;

//! A model and the sample that it was computed from.
struct Candidate
{
    Candidate() {}
    Candidate(const Sample& sample_, const Model& model_, const Quality& quality_)
        : sample(sample_), model(model_), quality(quality_)
    {}

    Sample sample;
    Model model;
    Quality quality;
};

//! A model that is worse than the best model so far, but that local optimization might make better
//! than the best model.
struct RunnerUp
{
    Candidate candidate;
    InlierBits inliers;
    int unexplained;  //!< number of inliers in `inliers` that the best model does not explain
};

/** @brief The most promising of the models that were never the best model.

Because of noise, the model of one sample can be worse than that of another sample before local
optimization, but better after it @cite lebeda2012fixing. Models that are better than all models of
previous samples are optimized at once. Of the other models, those with the most inliers that the
best model does not explain are optimized when the search is about to end. (The best model explains
the points within #EXPLAINED thresholds.) If the models were chosen by their cost instead, they
might all be variants of one wrong model: points with a common shift, or on an independently moving
plane, fit a whole family of F. If an optimized F of this family is the best model, the other F of
the family can have a lower cost than models of all-inlier samples that are not yet optimized.
take() returns each model once. */
class RunnersUp
{
public:
    /** The best model explains the points whose errors are at most EXPLAINED times
    Context::inlierThreshold. The factor is above 1 because some correct matches lie beyond the
    threshold if the noise is wide. */
    static constexpr double EXPLAINED = 1.5;

    //! @param most maximum number of models that are stored, at least 0
    //! @param arena memory of the run
    RunnersUp(int most, Arena& arena);

    //! True if no models are ever stored.
    bool none() const { return most == 0; }
    //! False if a model with this RunnerUp::unexplained would not be stored, whatever its cost.
    bool wants(int unexplained) const
    {
        return count < most || unexplained >= kept[most - 1].unexplained;
    }
    //! A model of a sample with this cost or more becomes neither the best model nor, unless it is
    //! a rival (see RivalSearch), a runner-up; callers drop such models.
    //! @param best lowest cost of a model of a sample so far
    //! @param points number of points of the run
    double uselessCost(double best, double points) const
    {
        return none() ? best : std::max(best, points - PROMISING * (points - best));
    }
    //! Stores the model if it is among the most promising ones.
    void add(const Candidate& candidate, const InlierBits& inliers);
    //! Sets the points that the best model explains, and updates RunnerUp::unexplained of all
    //! stored models.
    void setBest(const InlierBits& inliers);
    //! The points that the best model explains.
    const InlierBits& best() const { return known; }
    //! The largest RunnerUp::unexplained of the stored models; 0 if there are none.
    int mostUnexplained() const { return count > 0 ? kept[0].unexplained : 0; }
    //! The value of mostUnexplained() at the beginning of the last call of take(); 0 before it.
    int mostTaken() const { return unexplainedBefore; }
    //! Returns the models stored since the last call of take(), in the order of descending
    //! RunnerUp::unexplained, then of ascending cost, and forgets them. `taken` is valid until the
    //! next call of take().
    //! @return number of models
    int take(const RunnerUp*& taken);
    //! Forgets all models.
    void clear();

private:
    //! A model can become a runner-up if its gain is more than this fraction of the gain of the
    //! best model that any sample has given so far. The gain is the number of points, which is the
    //! cost without any model, minus the cost.
    static constexpr double PROMISING = 0.6;

    void insert(const RunnerUp& item);

    const int most;
    InlierBits known;  //!< points that the best model explains
    RunnerUp* kept;    //!< stored models in the order of take(), and a spare element; null before
                       //!< the first add()
    RunnerUp* given;   //!< models returned by the last take()
    int count;         //!< number of models in `kept`
    int unexplainedBefore;  //!< see mostTaken()
    Arena& arena;
};

}  // namespace usacv20
}  // namespace cv

#endif
