// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_SEARCH_GRID_HPP
#define OPENCV_USACV20_BENCHMARK_SEARCH_GRID_HPP

#include <ostream>
#include <string>
#include <utility>
#include <vector>
#include "progress.hpp"
#include "structured_options.hpp"
#include "tally.hpp"

namespace benchmark {

/** Measures how often methods miss the true model, over a grid of kinds of scenes. On each scene,
all methods run one after the other. */
class SearchGrid
{
public:
    //! Unknown methods raise std::runtime_error.
    explicit SearchGrid(const StructuredOptions& options);

    //! @param csv gets a row for each cell and method as soon as the cell is measured; null: no
    //! such file is written
    void run(std::ostream* csv);
    //! Writes the full table, with a row for each group of cells and method, or the brief one, with
    //! a row for each group and a column for each method.
    void markdown(std::ostream& out) const;

private:
    //! A method without and with scores; a null pointer if the method cannot be run that way.
    struct Entry
    {
        cv::Ptr<Method> plain, scored;
    };

    std::vector<Cell> cells() const;
    Method* methodOf(size_t index, const Cell& cell) const;
    void measure(const Cell& cell, const opencv_test::SceneOptions& scene, std::ostream* csv);
    void full(std::ostream& out) const;
    void brief(std::ostream& out) const;
    //! Writes the head of a table. The first columns are the properties of a group.
    //! @param names names of the further columns @param columns number of the further columns
    void head(std::ostream& out, const std::string& names, size_t columns) const;
    //! The name of the group of a cell: the values of the properties in StructuredOptions::by.
    std::string groupOf(const Cell& cell) const;
    Tally& tallyOf(const std::string& group, size_t method);

    const StructuredOptions& options;
    std::vector<Entry> methods;
    typedef std::pair<std::string, std::vector<Tally>> Group;
    std::vector<Group> groups;  //!< in the order of the cells
};

}  // namespace benchmark

#endif
