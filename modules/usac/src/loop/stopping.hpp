// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_STOPPING_HPP
#define OPENCV_USACV20_STOPPING_HPP

#include "opencv2/usac/components.hpp"

namespace cv {
namespace usacv20 {

//! Decides when the search ends: lines 2 and 26 of Algorithm 1. A run can also be ended by its time
//! limit or by a ProgressScope.
class Stopping
{
public:
    Stopping(const Context& context, const State& state);

    //! Line 2: true if the search ends before the next sample.
    bool reached();
    //! Why the search ended when reached() was last true, see StopReason.
    int reason() const { return ending; }
    //! True if the time limit or a ProgressScope ends the run. To be called once per sample or per
    //! optimized model: counts the work of one sample, and reads the clock if this is due.
    bool interrupt() const { return context.stop(sampleWork); }
    //! True if interrupt() or another check of the clock has ended the run.
    bool interrupted() const;
    //! Line 26: asks the criteria for the required number of samples.
    void update();
    //! Calls Termination::adapt of all criteria. @return true if the required number of samples
    //! might have changed, so that update() has to be called
    bool adapt(State& state) const;

private:
    int samplesThatCount() const;
    void require(double wanted, bool all, int reason);

    const Context& context;
    const State& state;
    const int m;              //!< sample size
    const double sampleWork;  //!< work to solve a sample and to score one model, in point tests
    const int exhaustive;     //!< see exhaustiveSamples()
    //! The search can end after `required` samples that count, see samplesThatCount(), or after
    //! `requiredOfAll` samples of any kind. The reasons are the StopReason of the criteria that
    //! require these numbers.
    int required, requiredReason, requiredOfAll, reasonOfAll;
    int ending;  //!< see reason()
};

}  // namespace usacv20
}  // namespace cv

#endif
