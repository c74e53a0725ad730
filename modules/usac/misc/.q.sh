#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Runs all tests of the module, each version of OpenCV in one way: inside the newest OpenCV 4 whose source Debian has, C++, a short
# pass of the performance tests, Python (cv2 of this build), a program against it, and OpenCV's own tests with this module's flags in
# the place of OpenCV's; against the OpenCV of the system, C++ with AddressSanitizer and UndefinedBehaviorSanitizer, the Python package
# with and without the system's cv2, programs against the installed library, the benchmark's. Does all its own set-up on Debian (as
# root or with sudo). Each part ends with its time; the last line is "<N> passed, <M> failed".
#
# usage: run_tests.sh [opencv | --installed]
#
#   opencv       only OpenCV's own tests with this module's flags; the list of what may differ is for OpenCV 4.6 and 4.10
#   --installed  without OpenCV's source: library, C++ tests, Python package and consumer against the OpenCV of the system
#                (libopencv-dev), all but the performance tests and OpenCV's own
#
#   OPENCV_SOURCE_DIR  OpenCV's source; default: the one of Debian's source package, fetched once
#   OPENCV_SUITE       of Debian, whose source package that is; default: trixie (4.10), on a newer system its own
#   USAC_BUILD_DIR     everything this script writes; default ${TMPDIR:-/tmp}/opencv_usac, kept for the next run

set -eu
case "$*" in
    "" | opencv | --installed) ;;
    *) echo "usage: run_tests.sh [opencv | --installed]" >&2; exit 2 ;;
esac
. "$(dirname "$0")/common.sh"

in_build()  # where findDataFile looks for test data, and where the tests may leave files
{
    cd "$build" && "$@"
}

python_tests()
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python_loader:$source/modules/python/test" /usr/bin/python3 -c "$run_unittests" "test_usac*.py"
}

# The package as a user gets it: a source distribution, from it a wheel, which is installed in a virtual environment. All
# without the network; CMake's build folder is kept for the next run.
build_python_package()
{
    folder=$work/python-$(printf %s "$project" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    rm -rf "$folder/dist" "$folder/source" "$folder/venv"
    mkdir -p "$folder/source"
    /usr/bin/python3 -m build --no-isolation --sdist --outdir "$folder/dist" "$module" &&
    tar -xf "$folder"/dist/usacv20-*.tar.gz -C "$folder/source" --strip-components=1 &&
    USACV20_BUILD_DIR="$folder/build" CMAKE_ARGS="-DUSAC_WERROR=ON -DUSAC_PRECOMPILED_HEADERS=ON" /usr/bin/python3 -m build --no-isolation --wheel \
        --outdir "$folder/dist" "$folder/source" &&
    rm -r "$folder/source" &&
    /usr/bin/python3 -m venv --system-site-packages "$folder/venv" &&
    python=$folder/venv/bin/python3 &&
    "$folder/venv/bin/pip" install --no-index "$folder"/dist/usacv20-*.whl &&
    [ -z "$(find "$module" -name '*.egg-info' -o -path "$module/build" -o -path "$module/LICENSE")" ]  # nothing is left beside the sources
}

# The same tests, beside the system's cv2 and as if there were none.
package_tests() # with | none
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="${site:-}" USAC_TEST_MODULE=usacv20 USAC_TEST_CV2="$1" \
        "$python" -c "$run_unittests" "test_usac*.py"
}

# Both at the same time, as each has one busy process; what the second has shown is in python_package_alone.part.
python_package_tests()
{
    package_tests none > "$work/python_package_alone.part" 2>&1 &
    alone=$!
    package_tests with && rc=0 || rc=1
    wait $alone || rc=1
    return $rc
}

# The readers of the data sets and the plots of the benchmark; without matplotlib and scipy some tests are skipped.
benchmark_tests()
{
    cd "$project/samples/benchmark" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python_loader" USAC_BENCHMARK="$work/consumer/build/bin/usac_benchmark" \
        /usr/bin/python3 -c "$run_unittests" "test_*.py"
}

# Compiled from OpenCV's source as they are there; what may differ is in misc/opencv_tests/differences.txt.
opencv_tests()
{
    tests=$work/opencv_tests-$(printf %s "$project $source" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    cmake -S "$module/misc/opencv_tests" -B "$tests" -DCMAKE_BUILD_TYPE=Release -DOPENCV_SOURCE="$source" \
        -DOPENCV_BUILD="$build" &&
    cmake --build "$tests" &&
    in_build "$tests/usac_opencv_tests"
}

# Against the OpenCV of the system.
sanitized_tests()
{
    USAC_BUILD_DIR="$work" sh "$module/misc/sanitize.sh" asan
}

# The build of the consumer checks with the C++ tests: the library is compiled once.
installed_tests()
{
    cmake --build "$built" --target opencv_test_usac &&
    cd "$built" && in_shards bin/opencv_test_usac
}

# The package of that build, which is linked with its library.
installed_python()
{
    site=$work/site python=/usr/bin/python3
    rm -rf "$site" && mkdir "$site" &&
    cp -r "$module/misc/python/package/usacv20" "$site" && cp "$built"/_native.* "$site/usacv20" && python_package_tests
}

if [ "$*" = --installed ]; then
    install_packages libgtest-dev
    folder=$work/installed-$(printf %s "$project" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    built=$folder/build
    failed=0
    run sources "$count_passed" "$count_failed" bash "$module/misc/check_sources.sh"
    export USAC_CONSUMER_OPTIONS=-DBUILD_TESTS=ON
    run consumer "$count_passed" "$count_failed" sh "$module/misc/consumer/check.sh" "$folder"
    run cpp "$count_passed" "$count_failed" installed_tests
    run python_package "$count_passed" "$count_failed" installed_python
    run python_package_alone "$count_passed" "$count_failed" cat "$work/python_package_alone.part"
    [ "$failed" = 0 ]
    exit
fi

export OPENCV_SAMPLES_DATA_PATH="$source/samples/data"
failed=0
for step in $STEPS; do
case $step in
python) run python "$count_passed" "$count_failed" python_tests ;;
consumer) run consumer "$count_passed" "$count_failed" sh "$module/misc/consumer/check.sh" "$work/consumer" "$build" ;;
package) build_python_package
run python_package "$count_passed" "$count_failed" python_package_tests
run python_package_alone "$count_passed" "$count_failed" cat "$work/python_package_alone.part" ;;
benchmark) run benchmark "$count_passed" "$count_failed" benchmark_tests ;;
esac
done
times
