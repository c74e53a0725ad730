#!/bin/bash
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
#
# Checks rules for the sources that a compiler does not check. Prints violations; the last line is
# "<N> passed, <M> failed", the numbers of rules.
# Usage: check_sources.sh [PROJECT]

set -u
cd "${1:-$(dirname "$0")/../../..}" || exit 1
src=modules/usac/src
mistakes=$(mktemp)
passed=0 failed=0
# Counts a rule as failed if the file $mistakes is not empty. Each line of this file is a violation;
# $1 describes the violations.
report()
{
    if [ -s "$mistakes" ]; then
        echo "$1:"
        sed 's/^/  /' "$mistakes"
        failed=$((failed + 1))
    else
        passed=$((passed + 1))
    fi
}

types=$(sed -nE 's/^USACV20_PROBLEM\((\w+),.*/\1/p' "$src/problems/registry.inl.hpp" | paste -sd '|')
grep -rnE '\bproblem(Type)?\b *(==|!=)|\[[A-Za-z_.>()-]*\bproblem(Type)?\]|switch *\([A-Za-z_.>-]*\bproblem(Type)?\)|case ('"$types"')\b' \
    --include='*.[ch]pp' "$src" | grep -v "^$src/problems/" > "$mistakes"
report "compares or counts problems outside $src/problems"
# Adding a problem must require only a folder, a row of the table of problems and the declarations; a
# script writes the Python part. The check covers problems for which no function of OpenCV accepts a
# flag; the other problems are also named in find*.cpp.
python=modules/usac/misc/python
grep -oE '^USACV20_PROBLEM\(\w+, \w+, \w+, (IMAGES|SPACES)' "$src/problems/registry.inl.hpp" | tr -d ' ' | tr '(' ',' | while IFS=, read -r _ type name plural _; do
    case $type in HOMOGRAPHY|FUNDAMENTAL|AFFINITY|SIMILARITY) continue ;; esac
    found=$(grep -rlwE "$type|(estimate|create)($name|$plural)(Problem)?" modules/usac/include "$src" "$python" --include='*.[ch]pp' --include='*.py' --include='*.pyi' |
        grep -vE "^$src/problems/|^$python/test/" | LC_ALL=C sort | tr '\n' ' ')
    allowed="modules/usac/include/opencv2/usac/batch.hpp modules/usac/include/opencv2/usac/estimate.hpp modules/usac/include/opencv2/usac/params.hpp"
    allowed="$allowed $(printf "$python/package/usacv20/%s " __init__.py _enumerations.py _problems.py)"
    allowed="$allowed$src/api/batch.cpp $src/api/estimate.cpp "
    [ "$found" = "$allowed" ] || echo "$type: $found"
done > "$mistakes"
report "problems named in files outside $src/problems, apart from their declarations, public functions and the files of make_names.py"
/usr/bin/python3 "$python/make_names.py" --check > "$mistakes" || [ -s "$mistakes" ] || echo "make_names.py failed" > "$mistakes"
report "declarations that do not match the table of problems, or files that make_names.py would write differently"
find "$src" modules/usac/include modules/usac/test modules/usac/benchmark samples -name '*.[ch]pp' -exec awk 'END { if (NR > 500) print FILENAME ": " NR " lines" }' {} \; > "$mistakes"
report "files of more than 500 lines"
find "$src" modules/usac/include modules/usac/test modules/usac/benchmark samples -name '*.[ch]pp' -exec awk 'length > 100 { print FILENAME ":" FNR ": " length " columns" }' {} \; > "$mistakes"
report "lines of more than 100 columns"
if command -v clang-format > /dev/null && clang-format --version | grep -q 'version 14'; then
    find "$src" modules/usac/include modules/usac/test modules/usac/perf modules/usac/benchmark samples -name '*.[ch]pp' -exec clang-format --dry-run {} + 2>&1 |
        sed -n 's/:[0-9]*:[0-9]*: .*//p' | sort -u > "$mistakes"
    report "not formatted as .clang-format requires"
fi
grep -ohE '`(src|test)/[A-Za-z0-9_/*.]+`' doc/paper_map.md doc/design.md | tr -d '`' | sort -u | while read -r path; do
    compgen -G "modules/usac/$path" > /dev/null || echo "$path"
done > "$mistakes"
report "files that doc/ names and that do not exist"
find README.md doc modules/usac -name '*.md' -o -name '*.markdown' | while read -r document; do
    grep -noE '\]\([A-Za-z0-9_./-]+[)#]' "$document" | tr -d ')#' | while IFS=: read -r line link; do
        [ -e "$(dirname "$document")/${link#](}" ] || echo "$document:$line: ${link#](}"
    done
done > "$mistakes"
grep -noE '\brun: .*' .github/workflows/*.yml | sed -E 's/run: (sh )?//' | while IFS=: read -r workflow line command; do
    [ -f "${command%% *}" ] || echo "$workflow:$line: ${command%% *}"
done >> "$mistakes"
report "broken links, and scripts of workflows that do not exist"
# Each folder of the tests must also exist in $src, except contracts (tests with arbitrary input), fuzz
# (the fuzzer and its stored inputs), runs (tests of whole estimations), and support (scenes, oracles
# and other shared code).
(cd modules/usac/test && find . -mindepth 1 -type d | sed 's|^\./||') | grep -vE '^(contracts|fuzz|runs|support)$' | while read -r dir; do
    [ -d "$src/$dir" ] || echo "modules/usac/test/$dir"
done > "$mistakes"
report "folders of the tests that $src does not have"
# Apart from its own files, a folder is allowed to include only files of folders on lines of $layers
# above its own line.
layers='numeric
control
components
input
lanes
residual
scoring
optimization
problems
samplers ordering neighborhood verification local_optimization polishing termination significance
loop
two_view
api'
grep -rnoE '#include "[a-z_]+/' --include='*.[ch]pp' "$src"/*/ | grep -v opencv2 | sed -E "s|^$src/||; s|:#include \"| |; s|/\$||" | while read -r place to; do
    from=${place%%/*}
    [ "$from" = "$to" ] && continue
    lower=$(echo "$layers" | grep -nw "$to" | cut -d: -f1)
    upper=$(echo "$layers" | grep -nw "$from" | cut -d: -f1)
    [ "${lower:-99}" -lt "${upper:-0}" ] || echo "$place includes from $to/"
done > "$mistakes"
find "$src" -maxdepth 1 -name '*.[ch]pp' ! -name precomp.hpp >> "$mistakes"
report "files without a folder, and folders that include files of folders that are not above them in the list of layers"
rm "$mistakes"
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
