// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_PARAMS_FIELDS_HPP
#define OPENCV_USACV20_PARAMS_FIELDS_HPP

#include <cfloat>
#include <climits>
#include <vector>
#include "opencv2/usac/params.hpp"

#ifndef OPENCV_BINDING_PARSER

namespace cv {
namespace usacv20 {

//! @addtogroup usacv20_extend
//! @{

//! Kinds of values of the fields of Params.
enum FieldKind {
    FIELD_OPTION,       //!< one enumerator
    FIELD_FLAGS,        //!< a set of bits
    FIELD_NUMBER,       //!< a number in a closed interval
    FIELD_PIXELS,       //!< a positive and finite number of pixels
    FIELD_PROBABILITY,  //!< a number in the open interval (0, 1)
    FIELD_SCORES,       //!< one number for each correspondence
    FIELD_SIGMAS,       //!< one, three or six numbers for each correspondence
    FIELD_MODEL,        //!< the numbers of a model
    FIELD_COVARIANCE    //!< the numbers of the covariance of a model
};

//! Default and range of a field of Params. The numbers are `double` for integer fields, too; a
//! `double` represents these integers exactly. The numbers are not used for FIELD_SCORES and the
//! kinds after it.
struct FieldValues
{
    FieldKind kind;  //!< kind of value
    double initial;  //!< default value
    double low;      //!< lower bound; not itself valid for FIELD_PIXELS and FIELD_PROBABILITY
    double high;     //!< upper bound; not itself valid for FIELD_PROBABILITY

    //! True if the value is in the range. Always true for FIELD_SCORES and the kinds after it:
    //! which values are valid depends on other fields and on the points.
    bool contain(double value) const
    {
        if (kind >= FIELD_SCORES)
            return true;
        const bool openBelow = kind == FIELD_PIXELS || kind == FIELD_PROBABILITY,
                   openAbove = kind == FIELD_PROBABILITY;
        return (openBelow ? value > low : value >= low) &&
               (openAbove ? value < high : value <= high);  // NaN is never valid
    }

    //! An enumerator from `low` to `high`.
    static FieldValues option(int initial, int low, int high)
    {
        return of(FIELD_OPTION, initial, low, high);
    }
    //! Any subset of the bits of `all`.
    static FieldValues flags(int initial, int all) { return of(FIELD_FLAGS, initial, 0, all); }
    //! A number from `low` to `high`.
    static FieldValues number(double initial, double low, double high)
    {
        return of(FIELD_NUMBER, initial, low, high);
    }
    //! A positive and finite number of pixels.
    static FieldValues pixels(double initial) { return of(FIELD_PIXELS, initial, 0, DBL_MAX); }
    //! A number between 0 and 1, both excluded.
    static FieldValues probability(double initial) { return of(FIELD_PROBABILITY, initial, 0, 1); }
    //! Scores of the matches.
    static FieldValues scores() { return of(FIELD_SCORES, 0, 0, 0); }
    //! Standard deviations or covariances of the noise of the matches.
    static FieldValues sigmas() { return of(FIELD_SIGMAS, 0, 0, 0); }
    //! The initial model.
    static FieldValues model() { return of(FIELD_MODEL, 0, 0, 0); }
    //! The covariance of the initial model.
    static FieldValues covariance() { return of(FIELD_COVARIANCE, 0, 0, 0); }

private:
    static FieldValues of(FieldKind kind, double initial, double low, double high)
    {
        const FieldValues values = {kind, initial, low, high};
        return values;
    }
};

/** @brief Calls `visit(name, &Params::field, values)` for each field of Params.

`name` is a `const char*`, the second argument a pointer to a member of type `int`, an enumeration,
`double`, `std::vector<float>` or `std::vector<double>`, and `values` a FieldValues. This is the
only list of the fields: the default values, Params::check, reading and writing of files, tests, the
fuzzer and the options of the benchmark are derived from it. Programs can use it to set fields by
name. */
template <class Visitor>
void visitFields(Visitor& visit)
{
    typedef FieldValues V;
    visit("threshold", &Params::threshold, V::pixels(1.5));
    visit("thresholdType", &Params::thresholdType,
          V::option(THRESHOLD_GIVEN, THRESHOLD_GIVEN, THRESHOLD_ESTIMATED));
    visit("confidence", &Params::confidence, V::probability(0.99));
    visit("maxIterations", &Params::maxIterations, V::number(5000, 1, INT_MAX));
    visit("maxTime", &Params::maxTime, V::number(0, 0, 1e9));
    visit("seed", &Params::seed, V::number(0, INT_MIN, INT_MAX));
    visit("threads", &Params::threads, V::number(1, 0, 1024));
    visit("sampler", &Params::sampler,
          V::option(SAMPLER_P_NAPSAC, SAMPLER_UNIFORM, SAMPLER_IMPORTANCE));
    visit("ordering", &Params::ordering, V::option(ORDERING_AUTO, ORDERING_AUTO, ORDERING_NONE));
    visit("scores", &Params::scores, V::scores());
    visit("sigmas", &Params::sigmas, V::sigmas());
    visit("initialModel", &Params::initialModel, V::model());
    visit("initialCovariance", &Params::initialCovariance, V::covariance());
    visit("scoreOrder", &Params::scoreOrder,
          V::option(SCORES_LOWER_IS_BETTER, SCORES_LOWER_IS_BETTER, SCORES_HIGHER_IS_BETTER));
    visit("neighborhood", &Params::neighborhood,
          V::option(NEIGHBORHOOD_GRID, NEIGHBORHOOD_GRID, NEIGHBORHOOD_RADIUS));
    visit("neighbors", &Params::neighbors, V::number(10, 1, 1000));
    visit("neighborRadius", &Params::neighborRadius, V::pixels(40));
    visit("residual", &Params::residual,
          V::option(RESIDUAL_STANDARD, RESIDUAL_STANDARD, RESIDUAL_SYMMETRIC));
    visit("quality", &Params::quality,
          V::option(QUALITY_MSAC, QUALITY_INLIERS, QUALITY_MAGSAC_PLUS_PLUS));
    visit("reach", &Params::reach, V::number(1, 1, 10));
    visit("widestReach", &Params::widestReach, V::number(1, 1, 1e6));
    visit("verification", &Params::verification,
          V::option(VERIFICATION_SPRT, VERIFICATION_NONE, VERIFICATION_TDD));
    visit("tddPoints", &Params::tddPoints, V::number(1, 1, 100));
    visit("localOptimization", &Params::localOptimization,
          V::option(LOCAL_OPTIMIZATION_GRAPH_CUT, LOCAL_OPTIMIZATION_NONE,
                    LOCAL_OPTIMIZATION_GC_RANSAC));
    visit("localIterations", &Params::localIterations, V::number(5, 1, 1000));
    visit("localSampleMultiple", &Params::localSampleMultiple, V::number(3, 2, 100));
    visit("localSamples", &Params::localSamples, V::number(1, 0, 1000));
    visit("spatialWeight", &Params::spatialWeight, V::number(0.14, 0, 10));
    visit("runnersUp", &Params::runnersUp, V::number(16, 0, 100));
    visit("orderedEvery", &Params::orderedEvery, V::number(8, 1, 1000));
    visit("termination", &Params::termination,
          V::flags(TERMINATION_SPRT | TERMINATION_P_NAPSAC | TERMINATION_EXACT | TERMINATION_ORDER,
                   2 * TERMINATION_ORDER - 1));
    visit("relaxation", &Params::relaxation, V::number(0.05, 0, 1));
    visit("persistence", &Params::persistence, V::number(1, 1, 100));
    visit("degeneracy", &Params::degeneracy,
          V::flags(2 * DEGENERACY_REPEATED - 1, 2 * DEGENERACY_REPEATED - 1));
    visit("polishing", &Params::polishing,
          V::option(POLISHING_ROBUST, POLISHING_NONE, POLISHING_ROBUST));
    visit("polishingSteps", &Params::polishingSteps, V::number(6, 1, 100));
    visit("significance", &Params::significance, V::number(0, 0, 1));
    visit("covariance", &Params::covariance, V::number(0, 0, 1));
}

//! @}

}  // namespace usacv20
}  // namespace cv

#endif

#endif
