#!/bin/bash
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
#
# Rules of the sources that a compiler does not know. Ends with 1 and what is wrong.
# Usage: check_sources.sh [PROJECT]

set -u
cd "${1:-$(dirname "$0")/../../..}" || exit 1
src=modules/usac/src
wrong=0
# All lines of standard input are mistakes of the kind $1.
report()
{
    local found
    found=$(cat)
    if [ -n "$found" ]; then
        echo "$1:"
        echo "$found" | sed 's/^/  /'
        wrong=1
    fi
}

grep -rnE '\bproblem(Type)?\b *(==|!=)|\[[A-Za-z_.>()-]*\bproblem(Type)?\]|switch *\([A-Za-z_.>-]*\bproblem(Type)?\)|case (HOMOGRAPHY|FUNDAMENTAL|ESSENTIAL)\b' \
    --include='*.[ch]pp' "$src" | grep -v "^$src/problems/" | report "compares or counts problems outside $src/problems"
find "$src" modules/usac/include modules/usac/test samples -name '*.[ch]pp' -exec awk 'END { if (NR > 400) print FILENAME ": " NR " lines" }' {} \; \
    | report "files of more than 400 lines"
find "$src" modules/usac/include modules/usac/test samples -name '*.[ch]pp' -exec awk 'length > 130 { print FILENAME ":" FNR ": " length " columns" }' {} \; \
    | report "lines of more than 130 columns"
grep -ohE '`src/[A-Za-z0-9_/*.]+`' doc/paper_map.md doc/design.md | tr -d '`' | sort -u | while read -r path; do
    compgen -G "modules/usac/$path" > /dev/null || echo "$path"
done | report "files that doc/ names and that are not there"
exit $wrong
