// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_RUNNERS_UP_HPP
#define OPENCV_USACV20_RUNNERS_UP_HPP

#include "opencv2/usac/components.hpp"

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

/** @brief The best models of samples that were never the best of all.

With noise, the better sample often gives the worse model, and only local optimization tells @cite lebeda2012fixing.
Those that beat all samples before are optimized at once; the best of the others, when the search is about to end. Each
is given once. */
class RunnersUp
{
public:
    //! @param most models that are kept, not negative @param arena memory
    RunnersUp(int most, Arena& arena);

    //! A model that costs as much is of no use any more. @param best cost of the best model of all samples
    double uselessCost(double best) const { return most > 0 ? limit : best; }
    //! Keeps the model if it is one of the best.
    void add(const Candidate& candidate);
    //! Gives those kept since the last call, best first; valid until the next add(). @return their number
    int take(const Candidate*& candidates);
    //! Forgets all, also those that it has given.
    void clear();

private:
    const int most;
    double limit;     //!< of the cost
    Candidate* kept;  //!< best first, with room for one more
    int count;        //!< of those kept
};

}  // namespace usacv20
}  // namespace cv

#endif
