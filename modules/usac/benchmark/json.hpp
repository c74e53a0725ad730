// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_BENCHMARK_JSON_HPP
#define OPENCV_USACV20_BENCHMARK_JSON_HPP

#include <map>
#include <string>
#include <vector>

namespace benchmark {

/** A value of a JSON document (RFC 8259).

This class is used because cv::FileStorage refuses documents with `null`, which the description of a
pair contains wherever something is unknown. number(), string(), array() and operator[] raise
std::runtime_error if the value is of another type. */
class Json
{
public:
    enum Type { NUL, BOOLEAN, NUMBER, STRING, ARRAY, OBJECT };

    Json() : kind(NUL), firstLine(1), scalar(0) {}

    //! Reads a document. A syntax error raises std::runtime_error with the text "file:line: what".
    static Json parse(const std::string& text, const std::string& file);

    Type type() const { return kind; }
    //! The line where the value starts in its file; 1 for a member that does not exist.
    int line() const { return firstLine; }
    bool isNull() const { return kind == NUL; }
    double number() const;
    const std::string& string() const;
    const std::vector<Json>& array() const;
    //! A member of an object; a null value if there is no member of this name.
    const Json& operator[](const std::string& name) const;

private:
    friend class JsonParser;

    void require(Type wanted, const char* what) const;

    Type kind;
    int firstLine;
    double scalar;
    std::string text;
    std::vector<Json> elements;
    std::map<std::string, Json> members;
};

}  // namespace benchmark

#endif
