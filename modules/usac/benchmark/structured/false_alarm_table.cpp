// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "false_alarm_table.hpp"

#include "call.hpp"
#include "progress.hpp"
#include "scene_pair.hpp"
#include "tally.hpp"

namespace benchmark {

FalseAlarmTable::FalseAlarmTable(const StructuredOptions& options_) : options(options_)
{
    for (const std::string& name : options.methods)
        methods.push_back(createMethod(name));
}

std::vector<int> FalseAlarmTable::measure(const Cell& cell) const
{
    std::vector<int> models(methods.size(), 0);
    opencv_test::SceneOptions scene;
    setKind(cell.kind, scene);
    scene.inliers = 0;
    scene.outliers = cell.size;
    Settings settings = options.settings(cell);
    for (int run = 0; run < options.runs; ++run)
    {
        scene.seed = settings.seed = options.seed + run;
        const ImagePair pair = toImagePair(opencv_test::makeScene(cell.problem, scene));
        for (size_t m = 0; m < methods.size(); ++m)
            if (methods[m]->solves(cell.problem))
                models[m] += !Call(*methods[m], pair, settings).estimate.model.empty();
    }
    return models;
}

void FalseAlarmTable::run(std::ostream& out, std::ostream* csv)
{
    if (csv)
        *csv << "problem,kind,size,method,calls,models\n";
    out << "\n| problem | kind | matches | calls of each |";
    for (const std::string& name : options.methods)
        out << " " << name << " |";
    out << "\n|---|---|---:|---:|";
    for (size_t m = 0; m < methods.size(); ++m)
        out << "---:|";
    out << "\n";
    Progress progress((int)(options.problems.size() * options.kinds.size() * options.sizes.size()));
    for (ProblemType problem : options.problems)
        for (const std::string& kind : options.kinds)
            for (int size : options.sizes)
            {
                const Cell cell = {problem, options.motions[0], kind, size, 0, "none"};
                progress.step(cell.name());
                const std::vector<int> models = measure(cell);
                out << "| " << letterOf(problem) << " | " << kind << " | " << size << " | "
                    << options.runs << " |";
                for (size_t m = 0; m < methods.size(); ++m)
                {
                    const bool solves = methods[m]->solves(problem);
                    out << " " << Proportion(models[m], solves ? options.runs : 0).text() << " |";
                    if (csv && solves)
                        *csv << letterOf(problem) << ',' << kind << ',' << size << ",\""
                             << options.methods[m] << "\"," << options.runs << ',' << models[m]
                             << std::endl;
                }
                out << std::endl;
            }
}

}  // namespace benchmark
