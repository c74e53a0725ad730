// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "json.hpp"

#include <cctype>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace benchmark {

//! A recursive-descent parser. Each parsing function begins at an element of the document, or at
//! white space before it, and ends just after this element.
class JsonParser
{
public:
    JsonParser(const std::string& text_, const std::string& file_)
        : text(text_), file(file_), at(0), line(1), depth(0)
    {}

    Json document()
    {
        Json result = value();
        skipSpace();
        if (at != text.size())
            fail("unexpected text after the end of the document");
        return result;
    }

private:
    enum { MAX_DEPTH = 64 };

    void fail(const std::string& what) const
    {
        std::ostringstream message;
        message << file << ":" << line << ": " << what << " (byte " << at << ")";
        throw std::runtime_error(message.str());
    }

    char peek()
    {
        skipSpace();
        return at < text.size() ? text[at] : '\0';
    }

    void skipSpace()
    {
        while (at < text.size() && std::strchr(" \t\r\n", text[at]) && text[at])
            line += text[at++] == '\n';
    }

    void expect(char c)
    {
        if (peek() != c)
            fail(std::string("expected '") + c + "'");
        ++at;
    }

    bool accept(const char* word)
    {
        const size_t length = std::strlen(word);
        if (text.compare(at, length, word) != 0)
            return false;
        at += length;
        return true;
    }

    Json value()
    {
        if (++depth > MAX_DEPTH)
            fail("nested too deeply");
        Json result;
        const char c = peek();
        result.firstLine = line;
        if (c == '{')
            object(result);
        else if (c == '[')
            array(result);
        else if (c == '"')
        {
            result.kind = Json::STRING;
            result.text = string();
        }
        else if (c == '-' || std::isdigit((unsigned char)c))
            number(result);
        else if (accept("true") || accept("false"))
        {
            result.kind = Json::BOOLEAN;
            result.scalar = text[at - 2] == 'u';
        }
        else if (!accept("null"))
            fail("expected a value");
        --depth;
        return result;
    }

    void object(Json& result)
    {
        result.kind = Json::OBJECT;
        expect('{');
        if (peek() == '}')
        {
            ++at;
            return;
        }
        for (;;)
        {
            if (peek() != '"')
                fail("expected a name in quotes");
            const std::string name = string();
            expect(':');
            result.members[name] = value();
            if (peek() != ',')
                break;
            ++at;
        }
        expect('}');
    }

    void array(Json& result)
    {
        result.kind = Json::ARRAY;
        expect('[');
        if (peek() == ']')
        {
            ++at;
            return;
        }
        for (;;)
        {
            result.elements.push_back(value());
            if (peek() != ',')
                break;
            ++at;
        }
        expect(']');
    }

    void number(Json& result)
    {
        const char* begin = text.c_str() + at;
        char* end = 0;
        result.kind = Json::NUMBER;
        result.scalar = std::strtod(begin, &end);
        if (end == begin)
            fail("expected a number");
        at += end - begin;
    }

    //! Unknown escape sequences, including \u with four hexadecimal digits, are kept as written;
    //! the strings in the benchmark's files do not need them.
    std::string string()
    {
        std::string result;
        expect('"');
        while (at < text.size() && text[at] != '"')
        {
            if (text[at] != '\\')
            {
                result += text[at++];
                continue;
            }
            static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
            const char* found = at + 1 < text.size() && text[at + 1]
                                    ? std::strchr(from, text[at + 1])
                                    : 0;
            result += found ? std::string(1, to[found - from]) : text.substr(at, 2);
            at += 2;
        }
        if (at >= text.size())
        {
            at = text.size();
            fail("a string without an end");
        }
        ++at;
        return result;
    }

    const std::string& text;
    const std::string& file;
    size_t at;
    int line;  //!< line number of `at`; line breaks in strings, which JSON forbids, do not count
    int depth;
};

Json Json::parse(const std::string& text, const std::string& file)
{
    return JsonParser(text, file).document();
}

void Json::require(Type wanted, const char* what) const
{
    if (kind != wanted)
        throw std::runtime_error(std::string("expected ") + what);
}

double Json::number() const
{
    require(NUMBER, "a number");
    return scalar;
}

const std::string& Json::string() const
{
    require(STRING, "a string");
    return text;
}

const std::vector<Json>& Json::array() const
{
    require(ARRAY, "an array");
    return elements;
}

const Json& Json::operator[](const std::string& name) const
{
    static const Json none;
    require(OBJECT, "an object");
    const std::map<std::string, Json>::const_iterator found = members.find(name);
    return found == members.end() ? none : found->second;
}

}  // namespace benchmark
