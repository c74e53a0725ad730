// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "opencv2/usac/data.hpp"
#include "opencv2/usac/params_fields.hpp"

namespace cv {
namespace usacv20 {

namespace {

struct FieldInitializer
{
    Params& params;
    template <class T>
    void operator()(const char*, T Params::*field, const FieldValues& values)
    {
        params.*field = (T)values.initial;
    }
    template <class T>
    void operator()(const char*, std::vector<T> Params::*, const FieldValues&)
    {}
};

void checkRange(const char* name, double value, const FieldValues& values)
{
    if (values.contain(value))
        return;
    if (values.kind == FIELD_PIXELS)
        CV_Error_(Error::StsOutOfRange,
                  ("%s: a positive number of pixels is expected, not %g", name, value));
    if (values.kind == FIELD_PROBABILITY)
        CV_Error_(Error::StsOutOfRange,
                  ("%s: a number between 0 and 1 is expected, not %g", name, value));
    CV_Error_(Error::StsOutOfRange,
              ("%s: %g .. %g is expected, not %g", name, values.low, values.high, value));
}

struct FieldChecker
{
    const Params& params;
    template <class T>
    void operator()(const char* name, T Params::*field, const FieldValues& values)
    {
        checkRange(name, params.*field, values);
    }
    template <class T>
    void operator()(
        const char*, std::vector<T> Params::*,
        const FieldValues&)  // checked in checkScores(), checkSigmas() and checkInitialModel()
    {}
};

//! Raises a cv::Exception if a combination of options is impossible.
void checkCombination(bool impossible, const char* message)
{
    if (impossible)
        CV_Error(Error::StsBadArg, message);
}

void checkCombinations(const Params& p)
{
    const int criteria = p.termination & ~TERMINATION_EXACT;
    checkCombination((criteria & TERMINATION_SPRT) && p.verification != VERIFICATION_SPRT,
                     "termination: TERMINATION_SPRT needs verification VERIFICATION_SPRT");
    checkCombination((criteria & TERMINATION_PROSAC) && p.sampler != SAMPLER_PROSAC &&
                         p.sampler != SAMPLER_P_NAPSAC,
                     "termination: TERMINATION_PROSAC needs SAMPLER_PROSAC or SAMPLER_P_NAPSAC, "
                     "whose set of points grows");
    checkCombination((criteria & TERMINATION_PROSAC) &&
                         !(p.ordering == ORDERING_INPUT_ORDER ||
                           (p.ordering == ORDERING_AUTO && !p.scores.empty())),
                     "termination: TERMINATION_PROSAC needs points in an order, by scores or by "
                     "ORDERING_INPUT_ORDER; in an order by density, many wrong models fit the "
                     "first points");
    checkCombination(criteria == TERMINATION_ORDER,
                     "termination: TERMINATION_ORDER ends a search only if the order proves to be "
                     "good, and needs "
                     "another criterion beside it");
    checkCombination(p.termination == TERMINATION_EXACT,
                     "termination: TERMINATION_EXACT modifies other criteria, and none is given");
    checkCombination(
        p.sampler == SAMPLER_IMPORTANCE &&
            (p.scores.empty() || p.scoreOrder != SCORES_HIGHER_IS_BETTER),
        "sampler: SAMPLER_IMPORTANCE needs scores that are probabilities, with scoreOrder "
        "SCORES_HIGHER_IS_BETTER");
    if (p.quality != QUALITY_LMEDS)
        return;
    checkCombination(p.reach != 1, "reach: QUALITY_LMEDS has no threshold to multiply");
    checkCombination(p.widestReach != 1, "widestReach: QUALITY_LMEDS has no threshold to multiply");
    checkCombination(p.verification != VERIFICATION_NONE,
                     "verification: SPRT and T(d,d) count inliers, for which QUALITY_LMEDS has no "
                     "threshold yet");
    checkCombination(
        p.localOptimization != LOCAL_OPTIMIZATION_NONE,
        "localOptimization: local optimization selects inliers, for which QUALITY_LMEDS has no "
        "threshold yet");
    checkCombination((p.degeneracy & DEGENERACY_DEGENSAC) != 0,
                     "degeneracy: DEGENERACY_DEGENSAC selects inliers, for which QUALITY_LMEDS has "
                     "no threshold yet");
    checkCombination((criteria & (TERMINATION_PROSAC | TERMINATION_MAGSAC)) != 0,
                     "termination: TERMINATION_PROSAC and TERMINATION_MAGSAC need the threshold, "
                     "which QUALITY_LMEDS does "
                     "not have yet");
}

//! Raises a cv::Exception if there are scores, but not one for each of the `count` correspondences
//! (not checked if `count` is negative, that is, unknown), if all of them are NaN, or if the
//! sampler is #SAMPLER_IMPORTANCE and a score is not finite or is negative.
void checkScores(const Params& p, int count)
{
    if (count >= 0 && !p.scores.empty() && (int)p.scores.size() != count)
        CV_Error_(Error::StsUnmatchedSizes,
                  ("scores: one for each of the %d correspondences is expected, not %d", count,
                   (int)p.scores.size()));
    const auto isNaN = [](float score) { return score != score; };
    if (!p.scores.empty() && std::all_of(p.scores.begin(), p.scores.end(), isNaN))
        CV_Error(Error::StsBadArg, "scores: numbers are expected, but all of them are NaN");
    if (p.sampler != SAMPLER_IMPORTANCE)
        return;
    for (size_t i = 0; i < p.scores.size(); ++i)
        if (!(p.scores[i] >= 0 && p.scores[i] <= FLT_MAX))
            CV_Error_(Error::StsOutOfRange,
                      ("scores: SAMPLER_IMPORTANCE expects finite numbers of at least 0, not %g",
                       p.scores[i]));
}

//! Bounds of Params::sigmas, so that the squared ratio of any two sigmas is finite as a float.
constexpr float SMALLEST_SIGMA = 1e-6f, LARGEST_SIGMA = 1e6f;
//! Smallest ratio of the determinant of a covariance to the product of its two variances. At this
//! value, the standard deviations along the principal axes differ by a factor of at least 2000. As
//! the numbers are of type float, the ratio has a rounding error of about 1e-7.
constexpr double SMALLEST_DETERMINANT = 1e-6;

//! Raises a cv::Exception if the covariance c[0], c[1], c[2] (xx, xy, yy) of a point is invalid.
//! @param exact true: three zeros, which mean a point without noise, are valid
void checkCovariance(const float* c, bool exact)
{
    if (exact && c[0] == 0 && c[1] == 0 && c[2] == 0)
        return;
    const double smallest = (double)SMALLEST_SIGMA * SMALLEST_SIGMA,
                 largest = (double)LARGEST_SIGMA * LARGEST_SIGMA, xx = c[0], xy = c[1], yy = c[2];
    const bool inRange = xx >= smallest && xx <= largest && yy >= smallest && yy <= largest;
    if (!inRange || !(xx * yy - xy * xy >= SMALLEST_DETERMINANT * xx * yy))
        CV_Error_(Error::StsOutOfRange,
                  ("sigmas: a positive definite covariance xx, xy, yy with variances from %g to %g "
                   "is expected, not %g, %g, %g",
                   smallest, largest, xx, xy, yy));
}

//! Raises a cv::Exception if one of the sigmas or covariances in `numbers` is invalid.
//! @param each how many of the numbers describe one match: 1 (sigma), 3 or 6 (covariances)
void checkSigmas(const std::vector<float>& numbers, int each)
{
    for (int i = 0; i < (int)numbers.size(); i += each == 1 ? 1 : 3)
    {
        if (each > 1)
            checkCovariance(&numbers[i], each == 6 && i % 6 == 3);
        else if (!(numbers[i] >= SMALLEST_SIGMA && numbers[i] <= LARGEST_SIGMA))
            CV_Error_(Error::StsOutOfRange, ("sigmas: numbers from %g to %g are expected, not %g",
                                             SMALLEST_SIGMA, LARGEST_SIGMA, numbers[i]));
    }
}

//! Raises a cv::Exception if Params::sigmas are not one, three or six valid numbers for each of
//! `count` matches. If `count` is negative, the number of matches is unknown; it is then enough
//! that the numbers are valid in one of these three forms.
void checkSigmas(const Params& p, int count)
{
    const int numbers = (int)p.sigmas.size();
    if (numbers == 0)
        return;
    if (count < 0)
    {
        bool inRange = true;
        for (float each : p.sigmas)
            inRange = inRange && each >= SMALLEST_SIGMA && each <= LARGEST_SIGMA;
        checkSigmas(p.sigmas, inRange || numbers % 3 != 0 ? 1 : numbers % 6 == 0 ? 6 : 3);
        return;
    }
    const int each = count > 0 ? numbers / count : 0;
    if (each * count != numbers || (each != 1 && each != 3 && each != 6))
        CV_Error_(Error::StsUnmatchedSizes,
                  ("sigmas: one, three or six numbers for each of the %d correspondences are "
                   "expected, not %d numbers",
                   count, numbers));
    checkSigmas(p.sigmas, each);
}

void checkFinite(const char* name, const std::vector<double>& numbers, int most)
{
    if ((int)numbers.size() > most)
        CV_Error_(Error::StsOutOfRange,
                  ("%s: at most %d numbers are expected, not %d", name, most, (int)numbers.size()));
    for (size_t i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i]) <= DBL_MAX))
            CV_Error_(Error::StsOutOfRange,
                      ("%s: finite numbers are expected, not %g", name, numbers[i]));
}

//! Checks that there are not too many entries, that all are finite, and that there is no covariance
//! without a model. The run checks whether the entries are a model of the problem and a covariance
//! of this model.
void checkInitialModel(const Params& p)
{
    checkFinite("initialModel", p.initialModel, MAX_MODEL_SIZE);
    checkFinite("initialCovariance", p.initialCovariance, MAX_MODEL_SIZE * MAX_MODEL_SIZE);
    checkCombination(p.initialModel.empty() && !p.initialCovariance.empty(),
                     "initialCovariance: it is the covariance of initialModel, which is empty");
}

//! Raises a cv::Exception if the model has as many numbers as the models of some built-in problem,
//! but another shape, such as that of a transposed matrix. A row or a column of numbers is valid,
//! and so is any shape with another count of numbers, which only a custom problem can accept.
void checkModelShape(const Mat& model)
{
    for (const Size& shape : {Size(3, 2), Size(3, 3), Size(4, 3)})
        if (model.rows > 1 && model.cols > 1 && model.total() == (size_t)shape.area() &&
            model.size() != shape)
            CV_Error_(Error::StsBadArg,
                      ("model: a %dx%d matrix, or a row or a column, is expected for %d numbers, "
                       "not %dx%d",
                       shape.height, shape.width, shape.area(), model.rows, model.cols));
}

void checkCovarianceShape(const Mat& covariance)
{
    if (covariance.rows != covariance.cols)
        CV_Error_(Error::StsBadArg, ("covariance: a square matrix is expected, not %dx%d",
                                     covariance.rows, covariance.cols));
}

//! The entries of a matrix, row by row.
//! @param checkShape raises a cv::Exception if the matrix, which is not empty, has a wrong shape
std::vector<double> entriesOf(InputArray matrix, const char* name, void (*checkShape)(const Mat&))
{
    const Mat given = matrix.getMat();
    if (given.empty())
        return std::vector<double>();
    if (given.channels() != 1 || given.dims > 2)
        CV_Error_(Error::StsBadArg, ("%s: a matrix is expected, not %d channels and %d dimensions",
                                     name, given.channels(), given.dims));
    checkShape(given);
    Mat numbers;
    given.convertTo(numbers, CV_64F);
    return std::vector<double>(numbers.begin<double>(), numbers.end<double>());
}

}  // namespace

Params::Params()
{
    FieldInitializer initialize = {*this};
    visitFields(initialize);
}

void Params::setInitialModel(InputArray model, InputArray itsCovariance)
{
    const std::vector<double> entries = entriesOf(model, "model", checkModelShape);
    initialCovariance = entriesOf(itsCovariance, "covariance",
                                  checkCovarianceShape);  // if it throws, *this is unchanged
    initialModel = entries;
}

void Params::check(int count) const
{
    FieldChecker checkField = {*this};
    visitFields(checkField);
    checkCombinations(*this);
    checkScores(*this, count);
    checkSigmas(*this, count);
    checkInitialModel(*this);
}

namespace {

struct FieldWriter
{
    const Params& params;
    FileStorage& fs;
    template <class T>
    void operator()(const char* name, T Params::*field, const FieldValues&)
    {
        fs << name << params.*field;
    }
};

struct FieldReader
{
    Params& params;
    const FileNode& node;
    template <class T>
    void operator()(const char* name, T Params::*field, const FieldValues&)
    {
        if (!node[name].empty())
            node[name] >> params.*field;
    }
};

}  // namespace

void Params::write(FileStorage& fs) const
{
    FieldWriter writer = {*this, fs};
    visitFields(writer);
}

void Params::read(const FileNode& node)
{
    FieldReader reader = {*this, node};
    visitFields(reader);
}

void write(FileStorage& fs, const String&, const Params& params)
{
    fs << "{";
    params.write(fs);
    fs << "}";
}

void read(const FileNode& node, Params& params, const Params& defaults)
{
    params = defaults;
    params.read(node);
}

bool isUsacV20Method(int method) { return method >= (int)USACV20 && method <= (int)USACV20_AUTO; }

UsacV20Method methodFromInt(int method)
{
    if (!isUsacV20Method(method))
        CV_Error_(Error::StsBadArg,
                  ("method: one of the flags USACV20* is expected, not %d", method));
    return (UsacV20Method)method;
}

}  // namespace usacv20
}  // namespace cv
