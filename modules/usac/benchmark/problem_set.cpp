// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "problem_set.hpp"

#include <stdexcept>
#include "problems/problem_kind.hpp"

namespace benchmark {

ProblemSet::ProblemSet(const char* letters_) : letters(letters_)
{
    ProblemType ignored;
    bool known = !letters.empty();
    for (size_t i = 0; i < letters.size(); ++i)
        known = known && problemOf(letters[i], ignored);
    if (!known)
        throw std::runtime_error("'" + letters + "': expected problems, some of the letters " +
                                 problemLetters());
}

}  // namespace benchmark
