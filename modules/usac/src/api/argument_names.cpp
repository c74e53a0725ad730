// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#include "precomp.hpp"
#include "api/argument_names.hpp"

namespace cv {
namespace usacv20 {

namespace {

bool isNameCharacter(char c) { return c == '_' || std::isalnum((unsigned char)c); }

String callersName(const ArgumentName* names, size_t count, const String& inner)
{
    for (size_t i = 0; i < count; ++i)
        if (inner == names[i].inner)
            return names[i].callers;
    return inner;
}

}  // namespace

String inWordsOf(const ArgumentName* names, size_t count, const String& text)
{
    const size_t colon = text.find(": ");
    String head;
    for (size_t at = 0; colon != String::npos && at < colon;)
    {
        size_t end = at;
        while (isNameCharacter(text[end]))
            ++end;
        head += callersName(names, count, text.substr(at, end - at));
        const char* const separator = end == colon                      ? ""
                                      : text.compare(end, 2, ", ") == 0 ? ", "
                                                                        : " and ";
        const size_t length = std::strlen(separator);
        if (end == at || text.compare(end, length, separator) != 0 ||
            (length > 0 && end + length == colon))
            return text;
        head += separator;
        at = end + length;
    }
    return head.empty() ? text : head + text.substr(colon);
}

void throwInWordsOf(const ArgumentName* names, size_t count, const Exception& mistake)
{
    const String text = inWordsOf(names, count, mistake.err);
    if (text != mistake.err)
        throw Exception(mistake.code, text, mistake.func, mistake.file, mistake.line);
}

}  // namespace usacv20
}  // namespace cv
