# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Rewrites the links of Markdown files for doxygen, whose pages are all in one folder:
#   [text](#heading), [text](file.md#heading)  doxygen before 1.9.7 does not name headings as other readers of Markdown do: "## Own method"
#                                              of file.md gets the name file-own-method, which no other page has; links are
#                                              written with @ref, because [text](#name) ends a list in doxygen 1.17
#   [text](folder/name.hpp)                    the page of the source
#   [text](folder/name.markdown)               the page whose label is in the first line of that file
#   [text](folder/name.png), .cff, LICENSE     the file next to the page, see HTML_EXTRA_FILES

function name_of(path) # doc/file.md: file
{
    if (path ~ /modules\/usac\/README\.md$/)
        return "module"
    sub(/\.md$/, "", path)
    sub(/.*\//, "", path)
    gsub(/\./, "_", path)  # a dot ends a name
    return tolower(path)
}

function slug(heading)
{
    heading = tolower(heading)
    gsub(/[^a-z0-9 _-]/, "", heading)
    gsub(/ /, "-", heading)
    return heading
}

function label_of(path, line)  # {#label}
{
    getline line < path
    close(path)
    return sub(/.*\{#/, "", line) && sub(/\}.*/, "", line) ? line : ""
}

function target_of(link, at, base)
{
    at = index(link, "#")
    if (at == 1)
        return "@ref " file "-" substr(link, 2)
    if (at > 1)
        return "@ref " name_of(substr(link, 1, at - 1)) "-" substr(link, at + 1)
    base = FILENAME
    sub(/[^\/]*$/, "", base)
    if (link ~ /\.markdown$/ && label_of(base link) != "")
        return "@ref " label_of(base link)
    base = link
    sub(/.*\//, "", base)
    if (base ~ /\.hpp$/) {
        gsub(/_/, "__", base)
        sub(/\.hpp$/, "_8hpp_source.html", base)
        return base
    }
    return base ~ /\.(png|cff)$/ || base == "LICENSE" ? base : link
}

FNR == 1 { file = name_of(FILENAME); code = 0 }
/^ *```/ { code = !code }
!code && /^#+ / { gsub(/`/, "") }  # doxygen would show them as tags
!code && /^##+ / {
    id = $0
    sub(/^##+ +/, "", id)
    id = file "-" slug(id)
    if (!(id in seen))
        $0 = $0 " {#" id "}"
    seen[id] = 1
}
!code {
    rest = $0
    line = ""
    while (match(rest, /\]\([A-Za-z0-9_.\/#-]+\)/)) {
        line = line substr(rest, 1, RSTART + 1) target_of(substr(rest, RSTART + 2, RLENGTH - 3)) ")"
        rest = substr(rest, RSTART + RLENGTH)
    }
    $0 = line rest
}
{ print }
