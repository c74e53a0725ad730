// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/check_components.hpp"

namespace cv {
namespace usacv20 {

namespace {

template <class T>
void checkPresent(const Ptr<T>& part, const char* name)
{
    if (!part)
        CV_Error_(Error::StsNullPtr, ("components().%s: it is empty", name));
}

template <class T>
void checkEntries(const std::vector<Ptr<T>>& parts, const char* name)
{
    for (size_t i = 0; i < parts.size(); ++i)
        if (!parts[i])
            CV_Error_(Error::StsNullPtr, ("components().%s[%d]: it is empty", name, (int)i));
}

}  // namespace

void checkScore(const Score& score, int size)
{
    if (!(score.inlierPart() > 0 && score.inlierPart() <= 1))
        CV_Error_(Error::StsOutOfRange,
                  ("components().score: inlierPart() is %g; above 0 and at most 1 is expected",
                   score.inlierPart()));
    const int count = score.wholeModel() ? size : std::min(size, 16);
    const float errors[] = {0, FLT_MAX};
    for (int far = 0; far < 2 && count > 0; ++far)
    {
        std::vector<float> values(count, errors[far]);
        const int before = 2 * count;  // more than accumulate() is allowed to add
        Quality sum(before, before);
        score.accumulate(values.data(), count, 1, sum);
        const double cost = sum.cost - before;
        const int inliers = sum.inliers - before;
        if (!(cost >= 0 && cost <= count * (1 + FLT_EPSILON)) || inliers < 0 || inliers > count ||
            (!far && inliers != count))
            CV_Error_(Error::StsOutOfRange,
                      ("components().score: for %d points %s, accumulate() has added the cost %g "
                       "and %d inliers; a cost from 0 to 1 per point is expected, "
                       "and points without error must be inliers",
                       count, far ? "far from the model" : "without error", cost, inliers));
    }
}

String findWrongNumber(const Problem& problem, int residual)
{
    const Ptr<MinimalSolver> solver = problem.createMinimalSolver();
    if (!solver || !problem.createResidual(residual))
        return "createResidual() or createMinimalSolver() has returned a null pointer";
    const int dimensions = problem.errorDimension(), m = solver->sampleSize();
    const int first = problem.coordinates(0), second = problem.coordinates(1);
    if (first < 1 || first > 3 || second < 0 || second > 3)
        return format("coordinates: points of 1 to 3 coordinates are expected, not of %d and %d",
                      first, second);
    if (dimensions < 1 || dimensions > std::min(3, second > 0 ? second : first))
        return format("errorDimension: errors of 1 to 3 dimensions, no more than a point has, are "
                      "expected, not of %d",
                      dimensions);
    if (m < 1 || m > MAX_SAMPLE_SIZE)
        return format("createMinimalSolver: samples of 1 to %d points are expected, not of %d",
                      (int)MAX_SAMPLE_SIZE, m);
    const int dimension = problem.dimension();
    if (dimension < 1 || m * dimensions < dimension)
        return format("dimension: %d points with errors of %d dimensions cannot determine a model "
                      "with %d degrees of freedom",
                      m, dimensions, dimension);
    const Ptr<Parameterization> rule = problem.createParameterization();
    if (rule && rule->dimension() != dimension)
        return format("dimension: it is %d, but that of createParameterization() is %d", dimension,
                      rule->dimension());
    const int normalization = problem.normalization(residual);
    if (normalization < SCALE_NONE || normalization > SCALE_FIRST)
        return format("normalization: %d is not a Normalization", normalization);
    const SampleCost cost = problem.sampleCost();
    if (!(cost.time > 0 && cost.models > 0))
        return format("sampleCost: numbers above 0 are expected, not a time of %g and %g models",
                      cost.time, cost.models);
    return String();
}

void checkComponents(const Components& parts)
{
    checkPresent(parts.residual, "residual");
    checkPresent(parts.score, "score");
    checkPresent(parts.sampler, "sampler");
    checkPresent(parts.minimalSolver, "minimalSolver");
    checkEntries(parts.degeneracies, "degeneracies");
    checkEntries(parts.terminations, "terminations");
    const int m = parts.minimalSolver->sampleSize();
    if (m < 1 || m > MAX_SAMPLE_SIZE)
        CV_Error_(Error::StsOutOfRange,
                  ("components().minimalSolver: samples of 1 to %d points are expected, not of %d",
                   (int)MAX_SAMPLE_SIZE, m));
}

void checkEdges(const Vec2i* edges, int count, int size)
{
    for (int e = 0; e < count; ++e)
    {
        const int a = edges[e][0], b = edges[e][1];
        if (a < 0 || a >= size || b < 0 || b >= size)
            CV_Error_(Error::StsOutOfRange, ("components().neighborhood: an edge joins the points "
                                             "%d and %d, 0 to %d are expected",
                                             a, b, size - 1));
        if (a == b)
            CV_Error_(Error::StsBadArg,
                      ("components().neighborhood: an edge joins the point %d with itself", a));
    }
}

void checkSample(const int* sample, int m, int size)
{
    for (int k = 0; k < m; ++k)
    {
        if (sample[k] < 0 || sample[k] >= size)
            CV_Error_(Error::StsOutOfRange,
                      ("components().sampler: a sample has the index %d, 0 to %d are expected",
                       sample[k], size - 1));
        if (std::find(sample, sample + k, sample[k]) != sample + k)
            CV_Error_(Error::StsBadArg,
                      ("components().sampler: a sample has the index %d twice", sample[k]));
    }
}

void checkModels(const Model* models, int count)
{
    bool written = count <= MAX_MODELS;
    for (int k = 0; written && k < count; ++k)
        written = models[k].size() > 0;
    if (!written)
        CV_Error_(Error::StsOutOfRange,
                  ("components().minimalSolver: at most %d models are expected, each a matrix",
                   (int)MAX_MODELS));
}

}  // namespace usacv20
}  // namespace cv
