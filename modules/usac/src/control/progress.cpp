// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"

namespace cv {
namespace usacv20 {

namespace {

thread_local ProgressScope* innermost = 0;

}  // namespace

ProgressScope::ProgressScope(const Progress& progress_) : ProgressScope(progress_, innermost) {}

ProgressScope::ProgressScope(const Progress& progress_, ProgressScope* outer_)
    : progress(progress_), outer(outer_), before(innermost)
{
    if (!progress)
        CV_Error(Error::StsNullPtr, "progress: it is empty");
    innermost = this;
}

ProgressScope::~ProgressScope()
{
    if (innermost == this)
    {
        innermost = before;
        return;
    }
    ProgressScope* inner = innermost;
    while (inner && inner->before != this)
        inner = inner->before;
    if (!inner)
        return;
    inner->before = before;
    if (inner->outer == this)
        inner->outer = outer;
}

ProgressScope* ProgressScope::current() { return innermost; }

bool ProgressScope::ask(const Report& report) const
{
    return progress(report) && (!outer || outer->ask(report));
}

}  // namespace usacv20
}  // namespace cv
