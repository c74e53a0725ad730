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

cv::FileStorage refuses documents with `null`, which the description of a pair has wherever
something is not known. A value of another type than the one asked for raises std::runtime_error. */
class Json
{
public:
    enum Type { NUL, BOOLEAN, NUMBER, STRING, ARRAY, OBJECT };

    Json() : kind(NUL), firstLine(1), scalar(0) {}

    //! Reads a document. A syntax error raises std::runtime_error "file:line: what".
    static Json parse(const std::string& text, const std::string& file);

    Type type() const { return kind; }
    //! Where the value starts in its file; 1 for a member that is not there.
    int line() const { return firstLine; }
    bool isNull() const { return kind == NUL; }
    double number() const;
    const std::string& string() const;
    const std::vector<Json>& array() const;
    //! Member of an object; null if there is none of this name.
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
