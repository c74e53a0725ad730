// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "numeric/tails.hpp"
#include "numeric/unit_norm.hpp"
#include "control/batch_tasks.hpp"
#include "input/read_arrays.hpp"
#include "two_view/essential_motion.hpp"
#include "two_view/pair_models.hpp"

namespace cv {
namespace usacv20 {

//! Name of a model for messages, and its minimal sample size.
struct ModelKind
{
    const char* name;
    int sampleSize;
};

namespace {

const ModelKind OF_E = {"E", 5}, OF_F = {"F", 7}, OF_H = {"H", 4};

//! Additional degrees of freedom of F (seven) compared with E (five). With each additional degree
//! of freedom, F can fit one more match, right or wrong.
constexpr int FREEDOM_MORE = 2;
/* If E was rejected although the cameras are known, a valid F would mean that the focal lengths are
wrong. To accept only strong evidence, the search for F then uses the significance (10^-4 by
default) raised to the power ALONE, that is, 10^-8. It draws at most LEAST_SAMPLES samples. */
constexpr double ALONE = 2;
//! F is preferred to E only if its surplus of inliers exceeds this many standard deviations of the
//! number of inliers that is expected by chance. By chance, about one surplus in a thousand is that
//! large.
constexpr double DEVIATIONS = 3;
//! If most inliers of E are on a plane, F is preferred only if chanceOfEpipole() is at most this
//! probability, the usual limit of Report::chance.
constexpr double CHANCE = 0.01;
//! The number of matches whose errors are between one and BESIDE thresholds shows how many wrong
//! matches are within one threshold by chance: 1 / (BESIDE - 1) times as many, because errors of
//! wrong matches are as dense within one threshold as just beyond it.
constexpr double BESIDE = 3;
//! An inlier of E is lost if F replaces E and the error of the match under F exceeds this many
//! thresholds. The errors of right matches are seldom that large, even if the threshold is narrow
//! for their noise.
constexpr double LOST = 1.5;
//! F replaces E only if the root mean square of its errors, over the matches that both explain, is
//! at most WORSE times that of E. If F fits wrong matches, it fits right ones worse, which shows
//! even if the threshold is so wide that no inlier is lost.
constexpr double WORSE = 1.2;
//! Maximum number of samples of a search for F that starts from E, or for E that starts from F. Few
//! samples are enough, because local optimization finds the model.
constexpr int SAMPLES_FROM_E = 10;
//! Maximum number of samples of the search for H among inliers of E or F. An H that fits 80 % of
//! these inliers is found within 18 samples with probability 1 - 10^-4, because 0.8^4 of the
//! samples consist of inliers of this H.
constexpr int SAMPLES_IN_INLIERS = 100;
//! Largest Report::chance (a probability) of an accepted model if Params::significance is 0. It is
//! a hundredth of the usual limit for a single estimation, because most pairs of a collection do
//! not overlap.
constexpr double SIGNIFICANCE = 1e-4;

Points pointsOf(const Mat& given, const char* name, const Mat& camera, const Mat& distCoeffs)
{
    Arena arena;
    Arena::Scope scope(arena);
    Mat rows = readPoints(given, 2, name, scope);
    if (!distCoeffs.empty())
        rows = removeDistortion(rows, camera, distCoeffs);
    Points points(rows.rows);
    for (int i = 0; i < rows.rows; ++i)
        points[i] = Point2d(rows.ptr<double>(i)[0], rows.ptr<double>(i)[1]);
    return points;
}

//! The elements of `all` that a mask marks. `all` may be empty; the result is then empty, too.
template <class T>
std::vector<T> chosen(const std::vector<T>& all, const Mat& mask)
{
    std::vector<T> result;
    for (size_t i = 0; i < all.size(); ++i)
        if (mask.at<uchar>((int)i))
            result.push_back(all[i]);
    return result;
}

//! Divides errors by the sigmas of their matches; does nothing if there are no sigmas.
std::vector<double> inSigmas(std::vector<double> errors, const std::vector<float>& sigmas)
{
    for (size_t i = 0; i < sigmas.size(); ++i)
        errors[i] /= sigmas[i];
    return errors;
}

std::vector<double> numbersOf(const Matx33d& matrix)
{
    return std::vector<double>(matrix.val, matrix.val + 9);
}

//! Describes why a search has found no model.
String whyNot(const Report& report)
{
    switch (report.stop)
    {
    case STOP_NOT_SIGNIFICANT:
        return format("random matches would give as good a model with a chance of %.2g",
                      report.chance);
    case STOP_TOO_FEW_POINTS: return "too few points";
    case STOP_TIME: return "the time limit was reached";
    default: return "no model";
    }
}

}  // namespace

PairModels::PairModels(const TwoViewPair& pair, const Params& params_, const TwoViewRules& rules_)
    : params(params_), rules(rules_), iterations(0), cancelled(false),
      isCalibrated(!pair.cameraMatrix1.empty() && !pair.cameraMatrix2.empty()), sigma(0),
      scores(pair.scores), sigmas(pair.sigmas)
{
    const Mat* const cameras[] = {&pair.cameraMatrix1, &pair.cameraMatrix2};
    const Mat* const lenses[] = {&pair.distCoeffs1, &pair.distCoeffs2};
    for (int k = 0; k < 2; ++k)
    {
        if (!cameras[k]->empty())
            (k ? camera2 : camera1) = readCamera(*cameras[k],
                                                 k ? "cameraMatrix2" : "cameraMatrix1");
        else if (!lenses[k]->empty())
            CV_Error_(
                Error::StsBadArg,
                ("distCoeffs%d: a distortion needs cameraMatrix%d, which is empty", k + 1, k + 1));
        readDistortion(*lenses[k], k ? "distCoeffs2" : "distCoeffs1");
    }
    points1 = pointsOf(pair.points1, "points1", pair.cameraMatrix1, pair.distCoeffs1);
    points2 = pointsOf(pair.points2, "points2", pair.cameraMatrix2, pair.distCoeffs2);
    if (points1.size() != points2.size())
        CV_Error_(Error::StsUnmatchedSizes,
                  ("points1 and points2: lists of the same length are expected, not of %d and %d",
                   (int)points1.size(), (int)points2.size()));
    checkTaken(pair.taken1, "taken1");
    checkTaken(pair.taken2, "taken2");
    if (scores.empty())
        scores = params.scores;
    if (sigmas.empty())
        sigmas = params.sigmas;
    if (!sigmas.empty() && (int)sigmas.size() != size())
        CV_Error_(Error::StsUnmatchedSizes,
                  ("sigmas: one for each of the %d correspondences is expected, not %d", size(),
                   (int)sigmas.size()));
    options(params.maxIterations).check(size());
}

void PairModels::checkTaken(const Mat& given, const char* name) const
{
    Arena arena;
    Arena::Scope scope(arena);
    const int count = given.empty() ? size() : readPoints(given, 2, name, scope).rows;
    if (count != size())
        CV_Error_(Error::StsUnmatchedSizes,
                  ("%s: 0 or %d points are expected, not %d", name, size(), count));
}

Params PairModels::options(int most) const
{
    Params result = params;
    result.maxIterations = std::min(params.maxIterations, most);
    result.significance = params.significance > 0 ? params.significance : SIGNIFICANCE;
    result.scores = scores;
    result.sigmas = sigmas;
    return result;
}

int PairModels::samples(int sampleSize) const
{
    return (int)std::min((double)params.maxIterations, rules.samples(params, sampleSize, size()));
}

void PairModels::search()
{
    if (isCalibrated)
        searchEssential();
    searchFundamental();
    if (isCalibrated && F && (!E || explainsMore()))
        improveEssential();
    searchHomography();
    if (E && H && mostlyOnPlane(E))
        chooseMotion();
}

Ptr<Usac> PairModels::essential(const Params& given) const
{
    return Usac::create(ESSENTIAL, points1, points2, given, camera1, camera2);
}

void PairModels::searchEssential()
{
    Mat mask;
    Report report;
    const Mat found = essential(options(samples(OF_E.sampleSize)))->run(mask, &report);
    take(OF_E, found, mask, report, E);
    if (E)
        settle(report, 1);
}

void PairModels::searchFundamental()
{
    Params given;
    if (E)
    {
        given = options(SAMPLES_FROM_E);
        given.initialModel = numbersOf(fundamental(E.matrix));
    }
    else if (isCalibrated)
    {
        given = options(LEAST_SAMPLES);
        // DBL_MIN if the power underflows to 0, because a significance of 0 means the default
        given.significance = std::max(std::pow(given.significance, ALONE), DBL_MIN);
    }
    else
        given = options(samples(OF_F.sampleSize));
    Mat mask;
    Report report;
    const Mat found = Usac::create(FUNDAMENTAL, points1, points2, given)->run(mask, &report);
    take(OF_F, found, mask, report, F);
    if (F)
        settle(report, 1);
}

void PairModels::improveEssential()
{
    Params given = options(SAMPLES_FROM_E);
    given.initialModel = numbersOf(essentialOf(F.matrix, camera1, camera2));
    Mat mask;
    Report report;
    const Mat found = essential(given)->run(mask, &report);
    if (!found.empty() && countNonZero(mask) > E.inliers)
        take(OF_E, found, mask, report, E);
    else
        account(report);
}

void PairModels::searchHomography()
{
    const PairModel& explained = E ? E : F;  // E even if base() is F: base() compares H with E
    if (explained)
    {
        homographyOfInliers(explained);
        return;
    }
    Params given = options(samples(OF_H.sampleSize));
    given.threshold *= planarReach();
    Mat mask;
    Report report;
    const Mat found = Usac::create(HOMOGRAPHY, points1, points2, given)->run(mask, &report);
    take(OF_H, found, mask, report, H);
    if (H)
        settle(report, planarReach());
}

void PairModels::homographyOfInliers(const PairModel& explained)
{
    const Points first = chosen(points1, explained.mask), second = chosen(points2, explained.mask);
    // The error of H is measured in its second image. This should be the image in which the points
    // are closer together; otherwise the images are swapped.
    const bool swapped = squaredArea(second) > squaredArea(first);
    Params given = options(SAMPLES_IN_INLIERS);
    given.threshold *= planarReach();
    given.significance = 1;  // not tested: only the number of inliers that H explains matters
    given.scores = chosen(scores, explained.mask);
    given.sigmas = chosen(sigmas, explained.mask);
    Report report;
    // A report takes time because it contains Report::chance, which is not needed here. Therefore a
    // report is requested only if the run can be canceled.
    Report* const asked = BatchProgress::isWatched() ? &report : 0;
    const Mat found = Usac::create(HOMOGRAPHY, swapped ? second : first, swapped ? first : second,
                                   given)
                          ->run(noArray(), asked);
    cancelled = cancelled || report.stop == STOP_CANCELLED;
    if (found.empty())
        return;
    Matx33d map(found.ptr<double>());
    if (swapped)
        map = map.inv();
    const std::vector<double> errors = inSigmas(mapDistances(map, first, second), given.sigmas);
    PairModel model;
    model.mask = Mat::zeros(size(), 1, CV_8U);
    for (int i = 0, k = 0; i < size(); ++i)
        if (explained.mask.at<uchar>(i))
            model.mask.at<uchar>(i) = errors[k++] <= planarDistance() * params.threshold;
    model.inliers = countNonZero(model.mask);
    model.matrix = map(2, 2) != 0 ? map * (1 / map(2, 2)) : map;
    if (model.inliers >= rules.minInliers)
        H = model;
}

void PairModels::chooseMotion()
{
    const EssentialMotions motions(essential(options(params.maxIterations)));
    EssentialMotion best, other;
    best.essential = Mat(E.matrix);
    best.report = E.report;
    motions.read(best, params.threshold);
    const Matx33d map = camera2.inv() * H.matrix * camera1;
    const int onPlane = (int)(std::find(H.mask.begin<uchar>(), H.mask.end<uchar>(), 1) -
                              H.mask.begin<uchar>());
    motions.otherOfPlane(best, map, motions.x1[onPlane], other);
    cancelled = cancelled || other.report.stop == STOP_CANCELLED;
    preferCheaper(best, other);
    E.matrix = best.essential;
    E.mask = best.mask;
    E.inliers = best.inliers;
    E.report = best.report;
    if (!(E.report.sigma > 0))  // as in take()
        E.report.sigma = sigma;
}

void PairModels::account(const Report& report)
{
    iterations += report.iterations;
    cancelled = cancelled || report.stop == STOP_CANCELLED;
}

void PairModels::take(const ModelKind& kind, const Mat& matrix, const Mat& mask,
                      const Report& report, PairModel& model)
{
    account(report);
    const int inliers = matrix.empty() ? 0 : countNonZero(mask);
    if (inliers < rules.minInliers)
    {
        refuse(kind, matrix, inliers, report);
        return;
    }
    model.matrix = Matx33d(matrix.ptr<double>());
    model.mask = mask;
    model.inliers = inliers;
    model.report = report;
    if (!(report.sigma > 0))  // 0: the noise was not estimated by this search
        model.report.sigma = sigma;
}

void PairModels::settle(const Report& report, double reach)
{
    if (params.thresholdType == THRESHOLD_GIVEN)
        return;
    params.thresholdType = THRESHOLD_GIVEN;
    params.threshold = report.threshold / reach;
    sigma = report.sigma;
}

//! Stores the reason and the report if the rejected search has the lowest Report::chance of all
//! rejected searches so far. Adds the confidence reached to `limited` if Params::maxIterations has
//! ended the search too early.
void PairModels::refuse(const ModelKind& kind, const Mat& matrix, int inliers, const Report& report)
{
    if (why.empty() || report.chance < refused.chance)
    {
        why = String(kind.name) + ": " +
              (matrix.empty() ? whyNot(report)
                              : format("%d inliers, %d are needed", inliers, rules.minInliers));
        refused = report;
    }
    if (report.iterations < params.maxIterations ||
        params.maxIterations >= rules.samples(params, kind.sampleSize, size()))
        return;
    // rounded down, so that the message never shows the requested confidence as reached
    const double reached = std::floor(1e4 * rules.reached(params, kind.sampleSize, size())) / 1e4;
    limited += format("%s%g for %s", limited.empty() ? "" : ", ", reached, kind.name);
}

String PairModels::reason() const
{
    if (size() < leastMatches())
        return format("%d matches, %d are needed", size(), leastMatches());
    if (limited.empty())
        return why;
    return why + format("; all %d samples drawn, confidence ", params.maxIterations) + limited;
}

const PairModel* PairModels::base() const
{
    if (E && F && contradictsCameras())
        return &F;
    return E ? &E : F ? &F : H ? &H : 0;
}

bool PairModels::explainsMore() const
{
    const double surplus = rules.calibrationRatio * F.inliers - E.inliers - FREEDOM_MORE;
    if (surplus <= 0)
        return false;
    const std::vector<double> errors = errorsOf(fundamental(E.matrix));
    const double within = withinDistances(errors, params.threshold);
    const double beside = withinDistances(errors, BESIDE * params.threshold) - within;
    return surplus > DEVIATIONS * std::sqrt(beside / (BESIDE - 1));
}

bool PairModels::contradictsCameras() const
{
    if (!explainsMore())
        return false;
    const double threshold = params.threshold;
    const std::vector<double> ofE = errorsOf(fundamental(E.matrix)), ofF = errorsOf(F.matrix);
    double lost = 0, beside = 0, squaresOfE = 0, squaresOfF = 0;
    for (size_t i = 0; i < ofF.size(); ++i)
        if (ofF[i] > LOST * threshold)
        {
            lost += ofE[i] <= threshold;
            beside += ofE[i] > threshold && ofE[i] <= BESIDE * threshold;
        }
        else if (ofE[i] <= threshold && ofF[i] <= threshold)
        {
            squaresOfE += ofE[i] * ofE[i];
            squaresOfF += ofF[i] * ofF[i];
        }
    const double lostByChance = beside / (BESIDE - 1);
    if (lost - lostByChance > (1 - rules.calibrationRatio) * E.inliers ||
        squaresOfF > WORSE * WORSE * squaresOfE)
        return false;
    return !mostlyOnPlane(E) || chanceOfEpipole(ofE, ofF) <= CHANCE;
}

double PairModels::chanceOfEpipole(const std::vector<double>& ofE,
                                   const std::vector<double>& ofF) const
{
    const double threshold = params.threshold;
    const std::vector<double> ofH = inSigmas(mapDistances(H.matrix, points1, points2), sigmas);
    int unexplained = 0, gained = 0, beside = 0;
    for (size_t i = 0; i < ofF.size(); ++i)
    {
        if (ofE[i] <= threshold || ofH[i] <= planarDistance() * threshold)
            continue;
        ++unexplained;
        gained += ofF[i] <= threshold;
        beside += ofF[i] > threshold && ofF[i] <= BESIDE * threshold;
    }
    gained -= FREEDOM_MORE;
    if (gained <= 0)
        return 1;
    const double choices = 0.5 * unexplained * (unexplained - 1);
    return std::min(choices * binomialTail(gained, gained + beside, 1 / BESIDE), 1.);
}

std::vector<double> PairModels::errorsOf(const Matx33d& fundamental) const
{
    return inSigmas(sampsonDistances(fundamental, points1, points2), sigmas);
}

double PairModels::pixels() const
{
    double sum = 0;
    for (float each : sigmas)
        sum += each;
    return sigmas.empty() ? params.threshold : params.threshold * sum / (double)sigmas.size();
}

int PairModels::withinDistances(const std::vector<double>& errors, double limit) const
{
    return (int)std::count_if(errors.begin(), errors.end(),
                              [limit](double error) { return error <= limit; });
}

Matx33d PairModels::fundamental(const Matx33d& essential) const
{
    return ofUnitNorm(camera2.inv().t() * essential * camera1.inv());
}

void PairModels::directions(const Mat& mask, std::vector<Vec3d>& first,
                            std::vector<Vec3d>& second) const
{
    const Matx33d inverse1 = camera1.inv(), inverse2 = camera2.inv();
    for (int i = 0; i < mask.rows; ++i)
        if (mask.at<uchar>(i))
        {
            first.push_back(inverse1 * Vec3d(points1[i].x, points1[i].y, 1));
            second.push_back(inverse2 * Vec3d(points2[i].x, points2[i].y, 1));
        }
}

bool PairModels::turn(const PairModel& explained, Matx33d& R) const
{
    std::vector<Vec3d> first, second;
    directions(H.mask, first, second);
    R = fitRotation(first, second);
    const std::vector<double> errors = inSigmas(mapDistances(camera2 * R * camera1.inv(),
                                                             chosen(points1, explained.mask),
                                                             chosen(points2, explained.mask)),
                                                chosen(sigmas, explained.mask));
    return withinDistances(errors, planarDistance() * params.threshold) >
           rules.planarRatio * explained.inliers;
}

}  // namespace usacv20
}  // namespace cv
