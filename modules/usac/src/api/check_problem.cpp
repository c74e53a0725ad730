// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "components/check_components.hpp"
#include "components/written.hpp"
#include "numeric/decompositions.hpp"

namespace cv {
namespace usacv20 {

namespace {

typedef Eigen::Map<const Eigen::VectorXd> Entries;

//! A law counts as broken if more than this fraction of the cases break it. Some models of random
//! samples are so ill-conditioned that rounding errors break a law.
constexpr double MANY = 0.25;
//! The models of SAMPLES samples are examined, each with at most SEEN points.
constexpr int SAMPLES = 40, SEEN = 50;
//! Permitted deviations of errors, relative to the error plus the extent of the points: TIGHT in
//! double precision, LOOSE in single precision and for models that solvers approximate.
constexpr double TIGHT = 1e-6, LOOSE = 1e-3;
//! Lengths relative to the extent of the points: the points are moved randomly by up to MOVED, so
//! that no error is 0; LITTLE is the change of an error for finite differences.
constexpr double MOVED = 0.1, LITTLE = 1e-4;

struct Law
{
    const char* text;  //!< message if the law is broken
    String detail;     //!< of the first failure
    int tested, failed;
};

class ProblemCheck
{
public:
    ProblemCheck(const Ptr<Problem>& problem_, InputArray points1, InputArray points2)
        : usac(Usac::create(problem_, points1, points2)), problem(*problem_), given(usac->points()),
          moved(given), residual(*usac->components().residual),
          solver(*usac->components().minimalSolver), rule(problem.createParameterization())
    {
        if (given.size < solver.sampleSize())
            CV_Error_(Error::StsBadArg, ("points1: at least %d finite points are expected, not %d",
                                         solver.sampleSize(), given.size));
        movePoints();
    }

    //! @return the first broken law; empty if there is none
    String run()
    {
        const std::vector<Model> models = solve();
        residual.start(Context(moved, usac->components(), params, arena));
        for (const Model& model : models)
            check(model);
        for (const Law& law : laws)
            if (law.failed > MANY * law.tested)
                return format("%s%s (in %d of %d cases)", law.text, law.detail.c_str(), law.failed,
                              law.tested);
        return String();
    }

private:
    //! Counts a case of a law. Laws are reported in the order of their first cases. @return `holds`
    bool test(const char* text, bool holds, const String& detail = String())
    {
        size_t k = 0;
        while (k < laws.size() && laws[k].text != text)
            ++k;
        if (k == laws.size())
            laws.push_back({text, String(), 0, 0});
        ++laws[k].tested;
        if (!holds && ++laws[k].failed == 1)
            laws[k].detail = detail;
        return holds;
    }

    void movePoints()
    {
        Rng rng(1);
        const int n = moved.size = std::min<int>(given.size, SEEN);
        for (int k = 0; k < given.columns(); ++k)
        {
            const int array = k >= given.coordinates[0], first = array ? given.coordinates[0] : 0,
                      end = first + given.coordinates[array];
            const double reach = end == given.columns() ? MOVED : 0;
            extent[k] = 0;
            for (int c = first; c < end; ++c)
                extent[k] = std::max(extent[k], (double)given.upper[c] - given.lower[c]);
            double *const exact = arena.take<double>(n), *const caller = arena.take<double>(n);
            float* const single = arena.take<float>(n);
            const Frame& frame = given.frame[array];
            for (int i = 0; i < n; ++i)
            {
                exact[i] = given.exact[k][i] + reach * extent[k] * (rng.uniform(2001) * 1e-3 - 1);
                single[i] = (float)exact[i];
                caller[i] = exact[i] / frame.scale + frame.center[k - first];
            }
            moved.exact[k] = exact;
            moved.column[k] = single;
            original[k] = caller;
        }
        unit = extent[given.columns() - 1];
    }

    //! @return the models of random samples
    std::vector<Model> solve()
    {
        const Context context(given, usac->components(), params, arena);
        residual.start(context);
        solver.start(context);
        std::vector<Model> models;
        Rng rng;
        for (int s = 0; s < SAMPLES; ++s)
        {
            int sample[MAX_SAMPLE_SIZE];
            rng.distinct(given.size, solver.sampleSize(), sample);
            Model found[2 * MAX_MODELS];
            const int count = solver.solve(given, sample, found);
            if (!test("createMinimalSolver: solve() has to fill at most MAX_MODELS models",
                      count >= 0 && count <= MAX_MODELS && found[MAX_MODELS].size() == 0 &&
                          (count == 0 || found[count - 1].size() > 0)))
                continue;
            for (int k = 0; k < count; ++k)
                checkSample(found[k], sample);
            models.insert(models.end(), found, found + count);
        }
        test("createMinimalSolver: solve() has found no model", !models.empty());
        return models;
    }

    void checkSample(const Model& model, const int* sample)
    {
        const int m = solver.sampleSize();
        for (int i = 0; i < m; ++i)
        {
            double datum[MAX_COLUMNS];
            for (int k = 0; k < given.columns(); ++k)
                datum[k] = given.exact[k][sample[i]];
            double error;
            residual.Residual::error(model, datum, &error);  // the root of squaredErrors()
            if (m * problem.errorDimension() == problem.dimension())
                test("createMinimalSolver: points have errors under the model of their sample",
                     error <= LOOSE * unit);
            if (!(error <= TIGHT * unit))
                continue;
            const Eigen::MatrixXd near = increase(model, datum, LITTLE);
            const double far = increase(model, datum, 2 * LITTLE).trace();
            test("squaredErrors: near a model, they do not grow with the squared distance",
                 std::abs(far / near.trace() - 4) < 1);
            const Eigen::VectorXd values = singularValues(near);
            test("errorDimension: it is not the number of directions that lead away from a model",
                 (values.array() > LITTLE * values[0]).count() == problem.errorDimension());
        }
    }

    //! The squared error near a datum without error, as a quadratic form of the distance from this
    //! datum, for distances of `step` times the extent of the points.
    Eigen::MatrixXd increase(const Model& model, const double* datum, double step) const
    {
        const int n = given.columns();
        Eigen::MatrixXd form(n, n);
        for (int a = 0; a < n; ++a)
            for (int b = a; b >= 0; --b)
            {
                double squares = 0;
                for (int sign = -1; sign <= 1; sign += 2)
                {
                    double there[MAX_COLUMNS], error;
                    std::copy(datum, datum + n, there);
                    there[a] += sign * step * extent[a];
                    there[b] += a == b ? 0 : sign * step * extent[b];
                    residual.Residual::error(model, there, &error);
                    squares += error * error / 2;
                }
                form(a, b) = form(b, a) = a == b ? squares
                                                 : (squares - form(a, a) - form(b, b)) / 2;
            }
        return form;
    }

    //! Errors, not squared, of all points under a model in the coordinates of the search or of the
    //! caller; the unit is that of the search.
    std::vector<double> errors(const Model& model, bool caller)
    {
        Written<double> squares(moved.size);
        residual.squaredErrors(model, caller ? original : moved.exact, moved.size, squares.data());
        test("squaredErrors: in double precision, it has to write `count` numbers",
             squares.exactly(moved.size));
        std::vector<double> roots;
        for (int i = 0; i < moved.size; ++i)
            roots.push_back(std::sqrt(squares.data()[i]) * (caller ? given.frame[1].scale : 1));
        return roots;
    }

    //! Compares an error with the expected one; undefined errors (NaN or infinite) are equal.
    bool same(double found, size_t point, double tolerance) const
    {
        const double right = expected[point];
        return std::abs(found - right) <= tolerance * (unit + right) ||
               (!(found <= DBL_MAX) && !(right <= DBL_MAX));
    }

    void compare(const char* text, const Model& model, bool caller, double tolerance = TIGHT)
    {
        const std::vector<double> found = errors(model, caller);
        for (size_t i = 0; i < found.size(); ++i)
            test(text, same(found[i], i, tolerance));
    }

    void check(const Model& found)
    {
        const Model model = problem.closest(found);
        expected = errors(model, false);
        compare("closest: it changes the errors under a model of a sample", found, false, LOOSE);
        checkSingle(model);
        for (int i = 0; i < moved.size; ++i)
            if (expected[i] <= DBL_MAX)
                checkDatum(model, i);
        Model multiple = model;
        Eigen::Map<Eigen::VectorXd>(multiple.val, model.size()) *= 3;
        if (residual.homogeneous())
            compare("homogeneous: it is true, but a multiple of a model has other errors", multiple,
                    false);
        if (rule)
        {
            const String text = checkParameterization(*rule, model);
            test("createParameterization: ", text.empty(), text);
            const double zero[MAX_MODEL_SIZE] = {0};
            compare("createParameterization: plus() with parameters 0 changes the errors",
                    rule->plus(model, zero), false);
        }
        checkConversions(model);
    }

    //! Computes the errors of the points in two parts.
    void checkSingle(const Model& model)
    {
        const int ends[] = {0, moved.size / 3, moved.size};
        for (int part = 0; part < 2; ++part)
        {
            const int begin = ends[part], count = ends[part + 1] - begin;
            Written<float> squares(count);
            residual.squaredErrors(moved, model, begin, begin + count, squares.data());
            test("squaredErrors: in single precision, it has to write end - begin numbers",
                 squares.exactly(count));
            for (int i = 0; i < count; ++i)
                test("squaredErrors: the versions in single and double precision differ",
                     same(std::sqrt(squares.data()[i]), begin + i, LOOSE));
        }
    }

    void checkDatum(const Model& model, int point)
    {
        double datum[MAX_COLUMNS];
        for (int k = 0; k < given.columns(); ++k)
            datum[k] = moved.exact[k][point];
        const int most = Residual::MAX_COMPONENTS;
        Written<double> error(most), again(most), derivative(most * MAX_MODEL_SIZE);
        const int rows = residual.error(model, datum, error.data());
        if (!test("error: it has to return how many numbers it writes, 1 to MAX_COMPONENTS",
                  rows >= 1 && rows <= most && error.exactly(rows)))
            return;
        test("error: for fits, it needs at least errorDimension() components",
             !rule || rows >= problem.errorDimension());
        const Entries vector(error.data(), rows);
        test("error: its squared length is not the result of squaredErrors()",
             same(vector.norm(), point, TIGHT));
        const int count = residual.linearize(model, datum, again.data(), derivative.data());
        if (!test("linearize: it has to write a number and a row of derivatives per component",
                  count == rows && again.exactly(rows) && derivative.exactly(rows * model.size())))
            return;
        const double deviation = (vector - Entries(again.data(), rows)).norm();
        test("linearize: its error is not that of error()",
             deviation <= TIGHT * (unit + vector.norm()));
        test("linearize: its derivative is not that of error()",
             isDerivative(derivative.data(), rows, model, datum));
    }

    //! Compares a derivative with central differences. If it is right, the steps change neither
    //! model nor error by more than LITTLE, relative to their sizes.
    bool isDerivative(const double* derivative, int rows, const Model& model,
                      const double* datum) const
    {
        const Eigen::Map<const Eigen::MatrixXd> claimed(derivative, model.size(), rows);
        const double little = LITTLE * unit, size = Entries(model.val, model.size()).norm();
        for (int k = 0; k < model.size(); ++k)
        {
            const double length = claimed.row(k).norm(), most = LITTLE * size,
                         step = length * most > little ? little / length : most;
            Model above = model, below = model;
            above.val[k] += step;
            below.val[k] -= step;
            double more[Residual::MAX_COMPONENTS] = {0}, less[Residual::MAX_COMPONENTS] = {0};
            residual.error(above, datum, more);
            residual.error(below, datum, less);
            const Eigen::VectorXd change = (Entries(more, rows) - Entries(less, rows)) / 2;
            if (!((change - claimed.row(k).transpose() * step).norm() <= 0.01 * little))
                return false;
        }
        return true;
    }

    void checkConversions(const Model& model)
    {
        Model result, back;
        if (!test("toInput: it has to return true and a model",
                  problem.toInput(model, given, result) && result.size() > 0))
            return;
        compare("toInput: the errors in the caller's coordinates are not those of the search",
                result, true);
        const Mat output = problem.toOutput(result);
        if (!test("toOutput: it has to return a matrix of type CV_64F",
                  !output.empty() && output.type() == CV_64F))
            return;
        if (problem.fromOutput(std::vector<double>(output.begin<double>(), output.end<double>()),
                               given, back))
            compare("fromOutput: it changes the errors under a model of toOutput()", back, false);
        const Model direct = problem.ofOutput(output);
        if (direct.size() > 0)
            compare("ofOutput: it changes the errors under a model of toOutput()", direct, true);
    }

    const Ptr<Usac> usac;
    const Problem& problem;
    const Params params;
    Arena arena;
    const Correspondences given;  //!< the caller's points
    Correspondences moved;        //!< some of these points, moved in the last array
    Residual& residual;
    MinimalSolver& solver;
    const Ptr<Parameterization> rule;
    const double* original[MAX_COLUMNS];  //!< `moved` in the coordinates of toModelCoordinates()
    double extent[MAX_COLUMNS];           //!< extent of the points in the array of each column
    double unit;                          //!< extent in the last array, in the unit of errors
    std::vector<double> expected;         //!< errors under the model that is being checked
    std::vector<Law> laws;
};

}  // namespace

String checkProblem(const Ptr<Problem>& problem, InputArray points1, InputArray points2)
{
    if (!problem)
        CV_Error(Error::StsNullPtr, "problem: it is empty");
    const String wrong = findWrongNumber(*problem, RESIDUAL_STANDARD);
    return wrong.empty() ? ProblemCheck(problem, points1, points2).run() : wrong;
}

}  // namespace usacv20
}  // namespace cv
