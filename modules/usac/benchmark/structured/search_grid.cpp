// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "search_grid.hpp"

#include <algorithm>
#include "call.hpp"
#include "judge.hpp"
#include "module_method.hpp"
#include "scene_pair.hpp"

namespace benchmark {

namespace {

const char SUFFIX[] = "+scores";

//! Adds the suffix for scores to a method's name: "USACV20{runnersUp=1}" becomes
//! "USACV20+scores{runnersUp=1}".
std::string scoredName(std::string name)
{
    return name.insert(std::min(name.find('{'), name.size()), SUFFIX);
}

//! False for flags of calib3d, except USAC_PROSAC. All other methods can use scores.
bool takesScores(const std::string& name)
{
    return name.compare(0, 3, "cv:") != 0 || name == "cv:USAC_PROSAC";
}

}  // namespace

SearchGrid::SearchGrid(const StructuredOptions& options_) : options(options_)
{
    for (size_t i = 0; i < options.methods.size(); ++i)
    {
        const std::string& name = options.methods[i];
        Entry entry;
        if (name.find(SUFFIX) != std::string::npos)
            entry.scored = createMethod(name);
        else
        {
            entry.plain = createMethod(name);
            if (takesScores(name))
                entry.scored = createMethod(scoredName(name));
        }
        methods.push_back(entry);
    }
}

std::vector<Cell> SearchGrid::cells() const
{
    std::vector<Cell> result;
    opencv_test::SceneOptions scene;
    for (ProblemType problem : options.problems)
        for (const std::string& motion : options.motions)
            for (const std::string& kind : options.kinds)
                for (const std::string& order : options.orders)
                    for (int size : options.sizes)
                    {
                        int last = 0;
                        for (double ratio : options.ratios)
                        {
                            const Cell cell = {problem, motion, kind, size, ratio, order};
                            if (!cell.options(options.spare, scene) || scene.inliers == last)
                                continue;  // with few matches, several ratios give the same number
                                           // of inliers
                            last = scene.inliers;
                            result.push_back(cell);
                        }
                    }
    return result;
}

Method* SearchGrid::methodOf(size_t index, const Cell& cell) const
{
    Method* const method = cell.scored() ? methods[index].scored.get() : methods[index].plain.get();
    return method && method->solves(cell.problem) ? method : 0;
}

void SearchGrid::run(std::ostream* csv)
{
    if (csv)
        *csv << "problem,motion,kind,size,ratio,order,method," << Tally::csvHeader() << "\n";
    const std::vector<Cell> all = cells();
    require(!all.empty(), "there is no such scene");
    Progress progress((int)all.size());
    opencv_test::SceneOptions scene;
    for (size_t i = 0; i < all.size(); ++i)
    {
        progress.step(all[i].name());
        all[i].options(options.spare, scene);
        measure(all[i], scene, csv);
    }
}

void SearchGrid::measure(const Cell& cell, const opencv_test::SceneOptions& sceneOptions,
                         std::ostream* csv)
{
    std::vector<Tally> tallies(methods.size());
    opencv_test::SceneOptions own = sceneOptions;
    Settings settings = options.settings(cell);
    own.noise = options.noise;
    for (int run = 0; run < options.runs; ++run)
    {
        own.seed = settings.seed = options.seed + run;
        const opencv_test::Scene scene = opencv_test::makeScene(cell.problem, own);
        const ImagePair pair = toImagePair(scene);
        const Judge judge(scene, pair, settings, own.noise);
        for (size_t m = 0; m < methods.size(); ++m)
            if (Method* const method = methodOf(m, cell))
            {
                const Call call(*method, pair, settings);
                Verdict verdict = judge.judge(call.estimate);
                if (options.startsTrue && verdict.failed && !verdict.none &&
                    dynamic_cast<ModuleMethod*>(method))
                {
                    const Call begun(*method, pair, settings, judge.trueModel());
                    verdict.failed = !judge.judge(begun.estimate).failed;
                }
                tallies[m].add(call, verdict);
            }
    }
    for (size_t m = 0; m < methods.size(); ++m)
    {
        if (!methodOf(m, cell))
            continue;
        tallyOf(groupOf(cell), m).add(tallies[m]);
        if (csv)
            *csv << letterOf(cell.problem) << ',' << cell.motion << ',' << cell.kind << ','
                 << cell.size << ',' << cell.value("ratio") << ',' << cell.order << ",\""
                 << options.methods[m] << "\"," << tallies[m].csv() << std::endl;
    }
}

std::string SearchGrid::groupOf(const Cell& cell) const
{
    std::string result;
    for (const std::string& axis : options.by)
        result += cell.value(axis) + " | ";
    return result;
}

Tally& SearchGrid::tallyOf(const std::string& group, size_t method)
{
    size_t i = 0;
    while (i < groups.size() && groups[i].first != group)
        ++i;
    if (i == groups.size())
        groups.push_back(Group(group, std::vector<Tally>(methods.size())));
    return groups[i].second[method];
}

void SearchGrid::markdown(std::ostream& out) const
{
    if (options.brief)
        brief(out);
    else
        full(out);
}

void SearchGrid::head(std::ostream& out, const std::string& names, size_t columns) const
{
    out << "\n| ";
    for (const std::string& axis : options.by)
        out << axis << " | ";
    out << names << "\n|";
    for (size_t i = 0; i < options.by.size() + columns; ++i)
        out << "---|";
    out << "\n";
}

void SearchGrid::full(std::ostream& out) const
{
    head(out, "method | " + Tally::markdownHeader(), Tally::COLUMNS + 1);
    for (const Group& group : groups)
        for (size_t m = 0; m < methods.size(); ++m)
            if (!group.second[m].empty())
                out << "| " << group.first << options.methods[m] << " | "
                    << group.second[m].markdown() << "\n";
}

void SearchGrid::brief(std::ostream& out) const
{
    std::string names = "calls of each |";
    for (const std::string& method : options.methods)
        names += " " + method + " |";
    head(out, names, methods.size() + 1);
    for (const Group& group : groups)
    {
        int calls = 0;
        for (const Tally& tally : group.second)
            calls = std::max(calls, tally.size());
        out << "| " << group.first << calls << " |";
        for (const Tally& tally : group.second)
            out << " " << (tally.empty() ? std::string("-") : tally.brief()) << " |";
        out << "\n";
    }
}

}  // namespace benchmark
