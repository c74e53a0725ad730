// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUNNERS_UP_HPP
#define OPENCV_USACV20_RUNNERS_UP_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Marks which of the first points are inliers of a model, one bit per point. The points are in
//! random order, so that the first ones represent all.
class InlierBits
{
public:
    //! Maximum number of points.
    enum { MOST = 256 };

    //! No inliers.
    InlierBits();
    //! @param width threshold of the inliers, in units of Context::inlierThreshold
    InlierBits(const Context& context, const Model& model, double width = 1);

    //! Number of inliers.
    int count() const;
    //! Number of inliers that are not in `others`.
    int without(const InlierBits& others) const;

private:
    enum { WORDS = MOST / 64 };

    uint64 words[WORDS];
};

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

//! A model that is worse than the so-far-the-best one, but may beat it after local optimization.
struct RunnerUp
{
    Candidate candidate;
    InlierBits inliers;
    int unexplained;  //!< number of its inliers that are not inliers of the best model
};

/** @brief The most promising models that were never the so-far-the-best one.

With noise, a better sample often gives a worse model, and only local optimization shows which is
better @cite lebeda2012fixing. Models that beat all previous samples are optimized at once. Of the
others, those with the most inliers that are not inliers of the best model are optimized when the
search is about to end. Choosing them by cost could give only variants of one wrong model: points
with a common shift, or on an independently moving plane, agree with a family of F. If an optimized
F of this family is the best model, all its other members cost less than models of all-inlier
samples that are not yet optimized. take() gives each model once. */
class RunnersUp
{
public:
    //! @param most maximum number of models kept, not negative @param arena memory of the run
    RunnersUp(int most, Arena& arena);

    //! True if no models are kept.
    bool none() const { return most == 0; }
    //! False if a model with this RunnerUp::unexplained would not be kept.
    bool wants(int unexplained) const
    {
        return count < most || unexplained >= kept[most - 1].unexplained;
    }
    //! Keeps the model if it is among the most promising ones.
    void add(const Candidate& candidate, const InlierBits& inliers);
    //! Sets the inliers of the best model.
    void setBest(const InlierBits& inliers);
    const InlierBits& best() const { return known; }
    //! The largest RunnerUp::unexplained of the models kept.
    int mostUnexplained() const { return count > 0 ? kept[0].unexplained : 0; }
    //! Gives the models kept since the last call, by descending RunnerUp::unexplained, then by
    //! ascending cost; valid until the next call. @return their number
    int take(const RunnerUp*& taken);
    //! Forgets all models, also those given by take().
    void clear();

private:
    void insert(const RunnerUp& item);

    const int most;
    InlierBits known;  //!< inliers of the best model
    RunnerUp* kept;    //!< in the order of take(), with one spare place; null before add()
    RunnerUp* given;   //!< models given by the last take()
    int count;         //!< number of models kept
    Arena& arena;
};

}  // namespace usacv20
}  // namespace cv

#endif
