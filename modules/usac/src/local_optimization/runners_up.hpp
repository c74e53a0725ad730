// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUNNERS_UP_HPP
#define OPENCV_USACV20_RUNNERS_UP_HPP

#include "scoring/inlier_bits.hpp"

namespace cv {
namespace usacv20 {

typedef Vec<int, MAX_SAMPLE_SIZE> Sample;

//! A model and the sample that it comes from.
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

//! A candidate that may become the best model when it is optimized.
struct RunnerUp
{
    Candidate candidate;
    InlierBits inliers;
    int unexplained;  //!< of these, those that are not inliers of the best model
};

/** @brief Models of samples that never were the best of all.

With noise, the better sample often gives the worse model, and only local optimization tells
@cite lebeda2012fixing. Those that beat all samples before are optimized at once; some of the
others, when the search is about to end: those with the most inliers that the best model does not
explain. By their cost they would be variants of one wrong model where there is one: the F of points
with a common shift, or of a plane that moves by itself, is a family, of which the optimized member
is the best model and all others cost less than what samples of right matches give before they are
optimized. Each is given once. */
class RunnersUp
{
public:
    //! @param most models that are kept, not negative @param arena memory
    RunnersUp(int most, Arena& arena);

    //! True if it keeps nothing.
    bool none() const { return most == 0; }
    //! False if a model with so many unexplained inliers would not be kept.
    bool wants(int unexplained) const
    {
        return count < most || unexplained >= kept[most - 1].unexplained;
    }
    //! Keeps the model if it is one of those to be kept.
    void add(const Candidate& candidate, const InlierBits& inliers);
    //! The best model has these inliers now.
    void setBest(const InlierBits& inliers);
    const InlierBits& best() const { return known; }
    //! The most unexplained inliers of those kept.
    int mostUnexplained() const { return count > 0 ? kept[0].unexplained : 0; }
    //! Gives those kept since the last call, most unexplained inliers first, for equal numbers the
    //! lowest cost; valid until the next call. @return their number
    int take(const RunnerUp*& taken);
    //! Forgets all, also those that it has given.
    void clear();

private:
    void insert(const RunnerUp& item);

    const int most;
    InlierBits known;  //!< of the best model
    RunnerUp* kept;   //!< in the order of take(), with room for one more; memory once there was one
    RunnerUp* given;  //!< by the last take()
    int count;        //!< of those kept
    Arena& arena;
};

}  // namespace usacv20
}  // namespace cv

#endif
