// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "test_precomp.hpp"
#include "support/params_fields.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

// visitFields, the list of the fields of Params, must agree with their declarations and
// documentation in params.hpp.

namespace opencv_test {
namespace {

std::string readHeader()
{
    std::string path = USAC_TEST_DATA_DIR;
    path += "/../modules/usac/include/opencv2/usac/params.hpp";
    std::ifstream in(path.c_str());
    return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
}

struct Declaration
{
    std::string type, name, comment;  //!< the comment without line breaks
};

//! The fields of Params in the order of their declaration.
std::vector<Declaration> declarationsOf(const std::string& header)
{
    std::istringstream lines(header.substr(header.find("struct CV_EXPORTS_W_SIMPLE Params")));
    const std::regex field("^ *(?:CV_PROP_RW )?([a-zA-Z][a-zA-Z0-9:<>]*) ([a-zA-Z]+);$"),
        marks("^ *(//!|/\\*\\*)? *");
    std::vector<Declaration> result;
    std::string line, comment;
    std::smatch match;
    while (std::getline(lines, line) && line != "};")
        if (std::regex_search(line, match, field))
        {
            result.push_back(Declaration{match[1], match[2], comment});
            comment.clear();
        }
        else
        {
            if (line.empty() || line.find("/**") != std::string::npos)
                comment.clear();
            comment += std::regex_replace(line, marks, "") + " ";
        }
    return result;
}

//! The values of all enumerators of the header, and for each enumeration the lowest value, the
//! highest value and the sum of all values.
struct Enumerations
{
    struct Range
    {
        int low, high, sum;
    };
    std::map<std::string, int> values;
    std::map<std::string, Range> ranges;

    explicit Enumerations(const std::string& header)
    {
        const std::regex enumerator("([A-Z_]+) =\\s+([0-9]+)");
        for (size_t at = header.find("\nenum "); at != std::string::npos;
             at = header.find("\nenum ", at + 1))
        {
            const std::string text = header.substr(at, header.find("\n};", at) - at);
            const std::string name = text.substr(6, text.find_first_of(" :", 6) - 6);
            Range range = {INT_MAX, INT_MIN, 0};
            for (std::sregex_iterator i(text.begin(), text.end(), enumerator), end; i != end; ++i)
            {
                const int value = values[(*i)[1]] = std::atoi((*i)[2].str().c_str());
                range.low = std::min(range.low, value);
                range.high = std::max(range.high, value);
                range.sum += value;
            }
            ranges[name] = range;
        }
    }
};

//! Kind, default and range of a field according to its comment in the header. Without a documented
//! range, all values of int are allowed.
FieldValues documentedValues(const std::string& comment, const Enumerations& enumerations)
{
    const std::regex type("^ *(Set of )?@ref (\\w+)"),
        interval("([0-9]+) ?(?:\\([a-z]+\\) )?\\.\\. ?([0-9]+(?:e[0-9])?)");
    const std::regex initial("Default (#\\w+(?: \\| #\\w+)*|[0-9]+(?:\\.[0-9]+)?|all|none)"),
        name("#(\\w+)");
    FieldValues result = {FIELD_NUMBER, 0, INT_MIN, INT_MAX};
    std::smatch match;
    if (std::regex_search(comment, match, type))
    {
        EXPECT_EQ(1u, enumerations.ranges.count(match[2])) << match[2];
        const Enumerations::Range range = enumerations.ranges.at(match[2]);
        if (match[1].matched)
            result = FieldValues::flags(0, range.sum);
        else
            result = FieldValues::option(0, range.low, range.high);
    }
    else if (comment.find("ixels") != std::string::npos &&
             comment.find("; > 0.") != std::string::npos)
        result = FieldValues::pixels(0);
    else if (comment.find("in (0, 1).") != std::string::npos)
        result = FieldValues::probability(0);
    else if (comment.find(">= 1.") != std::string::npos)
        result.low = 1;
    else if (std::regex_search(comment, match, interval))
    {
        result.low = std::atof(match[1].str().c_str());
        result.high = std::atof(match[2].str().c_str());
    }
    else if (comment.find("or none;") != std::string::npos)
        result = FieldValues::scores();
    else if (comment.find("or no sigmas;") != std::string::npos)
        result = FieldValues::sigmas();
    else if (comment.find("or no model;") != std::string::npos)
        result = FieldValues::model();
    else if (comment.find("or no covariance;") != std::string::npos)
        result = FieldValues::covariance();
    if (!std::regex_search(comment, match, initial))
    {
        ADD_FAILURE() << "no default: " << comment;
        return result;
    }
    const std::string text = match[1];
    for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i)
        result.initial += enumerations.values.at((*i)[1]);
    if (text == "all")
        result.initial = result.high;
    else if (text[0] != '#')
        result.initial = std::atof(text.c_str());
    return result;
}

//! A visitor that compares each field of visitFields with its declaration and documentation.
struct DocumentationReader
{
    std::vector<Declaration> declarations;
    Enumerations enumerations;
    size_t count;

    template <class T>
    void operator()(const char* name, T Params::*, const FieldValues& values)
    {
        ASSERT_LT(count, declarations.size()) << name;
        const Declaration& declared = declarations[count++];
        SCOPED_TRACE(declared.name + ": " + declared.comment);
        EXPECT_EQ(declared.name, name);
        EXPECT_EQ(declared.type, typeName((T*)0, declared.comment));
        const FieldValues documented = documentedValues(declared.comment, enumerations);
        EXPECT_EQ(documented.kind, values.kind);
        EXPECT_EQ(documented.initial, values.initial);
        EXPECT_EQ(documented.low, values.low);
        EXPECT_EQ(documented.high, values.high);
    }

    typedef const std::string& Comment;
    static std::string typeName(int*, Comment) { return "int"; }
    static std::string typeName(double*, Comment) { return "double"; }
    static std::string typeName(std::vector<float>*, Comment) { return "std::vector<float>"; }
    static std::string typeName(std::vector<double>*, Comment) { return "std::vector<double>"; }
    //! An enumeration, whose name is the first word of the comment after "@ref".
    template <class T>
    static std::string typeName(T*, Comment comment)
    {
        std::smatch match;
        const bool found = std::regex_search(comment, match, std::regex("^ *@ref (\\w+)"));
        return found ? match[1].str() : "";
    }
};

//! Fails if visitFields lacks a field of the header, or if the default or range of a field differs
//! from its comment in the header.
TEST(Usac_ParamsFields, are_as_declared_and_documented)
{
    const std::string header = readHeader();
    ASSERT_FALSE(header.empty());
    DocumentationReader reader = {declarationsOf(header), Enumerations(header), 0};
    visitFields(reader);
    for (size_t i = reader.count; i < reader.declarations.size(); ++i)
        ADD_FAILURE() << "visitFields lacks " << reader.declarations[i].name;
}

//! A visitor that checks that each field directly follows the previous one in memory, apart from
//! alignment.
struct Layout
{
    const Params& params;
    size_t end;

    static size_t aligned(size_t offset, size_t alignment)
    {
        return (offset + alignment - 1) / alignment * alignment;
    }

    template <class T>
    void operator()(const char* name, T Params::*member, const FieldValues&)
    {
        const size_t offset = (size_t)((const char*)&(params.*member) - (const char*)&params);
        EXPECT_EQ(aligned(end, alignof(T)), offset) << "visitFields lacks a field before " << name;
        end = offset + sizeof(T);
    }
};

//! The fields in visitFields must fill the whole class without gaps, so that a field cannot be
//! forgotten even if its declaration in the header has an unexpected form.
TEST(Usac_ParamsFields, fill_the_class)
{
    const Params params;
    Layout layout = {params, 0};
    visitFields(layout);
    EXPECT_EQ(sizeof(Params), Layout::aligned(layout.end, alignof(Params)))
        << "visitFields lacks the last field";
}

struct DefaultChecker
{
    Params params;
    template <class T>
    void operator()(const char* name, T Params::*member, const FieldValues& values)
    {
        EXPECT_EQ(values.initial, params.*member) << name;
    }
    template <class T>
    void operator()(const char* name, std::vector<T> Params::*member, const FieldValues&)
    {
        EXPECT_TRUE((params.*member).empty()) << name;
    }
};

TEST(Usac_ParamsFields, have_their_defaults)
{
    DefaultChecker checker;
    visitFields(checker);
}

}  // namespace
}  // namespace opencv_test
