// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "accuracy_table.hpp"

#include <algorithm>
#include <limits>
#include "call.hpp"
#include "progress.hpp"
#include "scene_pair.hpp"

namespace benchmark {

namespace {

//! Below this ratio of noise to threshold, the table shows the errors, not their ratios to those of
//! least squares: without noise, the ratios would reflect only rounding errors.
const double LITTLE_NOISE = 0.05;
//! Inlier ratio for the motion "aerial", a plane with relief seen from a drone, unless the user
//! sets ratios.
const double AERIAL_RATIO = 0.9;

double medianOf(std::vector<double> values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

double meanOf(const std::vector<double>& values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for (size_t i = 0; i < values.size(); ++i)
        sum += values[i];
    return sum / values.size();
}

double percentOf(const std::vector<bool>& flags)
{
    return 100. * std::count(flags.begin(), flags.end(), true) / flags.size();
}

//! The end of a table entry: the median pose error in degrees if the problem has one, and the
//! percentage of wrong results.
std::string poseText(const std::vector<double>& poses, const std::vector<bool>& wrong)
{
    const double pose = medianOf(poses);
    return (pose < 0 ? std::string() : std::string(cv::format(" / %.3g deg", pose))) +
           cv::format(" (%.0f) |", percentOf(wrong));
}

//! The ratios values[i] / by[i] of the runs i. Runs whose model is far from the truth are left out,
//! since their ratios are arbitrary.
std::vector<double> quotients(const std::vector<double>& values, const std::vector<bool>& far,
                              const std::vector<double>& by)
{
    std::vector<double> result;
    for (size_t i = 0; i < values.size(); ++i)
        if (!far[i])
            result.push_back(values[i] / by[i]);
    return result;
}

}  // namespace

AccuracyTable::AccuracyTable(const StructuredOptions& options_) : options(options_)
{
    for (size_t i = 0; i < options.methods.size(); ++i)
        methods.push_back(createMethod(options.methods[i]));
}

Cell AccuracyTable::cellOf(ProblemType problem, const std::string& motion, int size,
                           double ratio) const
{
    const bool aerial = motion == "aerial" && !options.ratiosGiven;
    const Cell cell = {problem, motion, "generic", size, aerial ? AERIAL_RATIO : ratio, "none"};
    return cell;
}

void AccuracyTable::run(std::ostream& out, std::ostream* csv)
{
    if (csv)
        *csv << "problem,motion,size,ratio,noise,method,runs,median_error,median_ratio,mean_ratio,"
                "median_pose,wrong_"
                "percent\n";
    const size_t each = options.motions.size() * options.sizes.size() * options.ratios.size() *
                        options.noises.size();
    Progress progress((int)(each * options.problems.size()));
    opencv_test::SceneOptions unused;
    for (ProblemType problem : options.problems)
    {
        progress.clear();
        header(problem, out);
        for (const std::string& motion : options.motions)
            for (int size : options.sizes)
                for (double ratio : options.ratios)
                    for (double noise : options.noises)
                    {
                        const Cell cell = cellOf(problem, motion, size, ratio);
                        progress.step(cell.name());
                        if (cell.options(0, unused))
                            row(cell, noise, out, csv);
                    }
    }
}

void AccuracyTable::header(ProblemType problem, std::ostream& out) const
{
    out << "\n## " << letterOf(problem)
        << "\n\n| motion | matches | right | noise / threshold | least squares |";
    for (size_t m = 0; m < methods.size(); ++m)
        out << (methods[m]->solves(problem) ? " " + options.methods[m] + " |" : "");
    out << "\n|---|---:|---:|---:|---:|";
    for (size_t m = 0; m < methods.size(); ++m)
        out << (methods[m]->solves(problem) ? "---:|" : "");
    out << "\n";
}

void AccuracyTable::add(const Verdict& verdict, Errors& errors)
{
    errors.errors.push_back(verdict.error);
    errors.poses.push_back(verdict.poseError);
    errors.far.push_back(verdict.far);
    errors.wrong.push_back(verdict.wrong);
}

void AccuracyTable::row(const Cell& cell, double noise, std::ostream& out, std::ostream* csv) const
{
    opencv_test::SceneOptions sceneOptions;
    cell.options(0, sceneOptions);
    sceneOptions.noise = noise * options.threshold;
    Settings settings = options.settings(cell);
    std::vector<Errors> all(methods.size() + 1);  // the last element has those of least squares
    for (int run = 0; run < options.runs; ++run)
    {
        sceneOptions.seed = settings.seed = options.seed + run;
        const opencv_test::Scene scene = opencv_test::makeScene(cell.problem, sceneOptions);
        const ImagePair pair = toImagePair(scene);
        const Judge judge(scene, pair, settings, sceneOptions.noise);
        Estimate reference;
        reference.model = judge.leastSquares();
        add(judge.judge(reference), all.back());
        for (size_t m = 0; m < methods.size(); ++m)
            if (methods[m]->solves(cell.problem))
                add(judge.judge(Call(*methods[m], pair, settings).estimate), all[m]);
    }
    const Errors& reference = all.back();
    out << "| " << cell.motion << " | " << cell.size << " | " << cell.ratio
        << cv::format(" | %.3g | %.4g", noise, medianOf(reference.errors))
        << poseText(reference.poses, reference.wrong);
    for (size_t m = 0; m < methods.size(); ++m)
    {
        if (all[m].errors.empty())
            continue;
        const std::vector<double> ratios = quotients(all[m].errors, all[m].far, reference.errors);
        out << (noise < LITTLE_NOISE ? cv::format(" %.2e", medianOf(all[m].errors))
                                     : cv::format(" %.3f", medianOf(ratios)))
            << poseText(all[m].poses, all[m].wrong);
        if (csv)
            csvRow(cell, noise, options.methods[m], all[m], reference, *csv);
    }
    out << std::endl;
    if (csv)
        csvRow(cell, noise, "least squares", reference, reference, *csv);
}

void AccuracyTable::csvRow(const Cell& cell, double noise, const std::string& method,
                           const Errors& errors, const Errors& reference, std::ostream& csv) const
{
    const std::vector<double> ratios = quotients(errors.errors, errors.far, reference.errors);
    csv << letterOf(cell.problem) << ',' << cell.motion << ',' << cell.size << ',' << cell.ratio
        << ',' << noise << ",\"" << method << "\"," << errors.errors.size()
        << cv::format(",%.6g,%.6g,%.6g", medianOf(errors.errors), medianOf(ratios), meanOf(ratios))
        << cv::format(",%.6g,%.6g", medianOf(errors.poses), percentOf(errors.wrong)) << std::endl;
}

}  // namespace benchmark
