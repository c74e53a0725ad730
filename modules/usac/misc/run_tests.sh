#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Runs all tests of the module. With the module inside the OpenCV of a Debian source package (see
# OPENCV_SUITE): the C++ tests, a short run of the performance tests, the Python tests (with the cv2
# of this build), a program that uses this OpenCV, and OpenCV's own tests with this module's flags
# instead of OpenCV's. With the OpenCV of the system: the C++ tests with AddressSanitizer and
# UndefinedBehaviorSanitizer, the Python package with and without the system's cv2, programs that use
# the installed library, and the tests of the benchmark. Installs what it needs on Debian (as root or
# with sudo). Each part prints its time; the last line is "<N> passed, <M> failed".
#
# usage: run_tests.sh [opencv | --installed | --cpp]
#
#   opencv       only OpenCV's own tests with this module's flags; the list of allowed differences
#                is for OpenCV 4.6 and 4.10
#   --installed  without OpenCV's source: checks of the module's sources, library, C++ tests, Python
#                package and consumer (programs that use the installed library), all with the OpenCV
#                of the system (libopencv-dev). A second build of the library inside another
#                project is left out, unless USAC_CONSUMER_QUICK is set to an empty text in the
#                environment
#   --cpp        like --installed, but only checks of the sources, library and C++ tests, compiled and
#                run according to the variables USAC_CPP_*
#
#   OPENCV_SOURCE_DIR  OpenCV's source; default: that of Debian's source package, which is fetched
#                      once
#   OPENCV_SUITE       Debian suite of this source package; default: trixie (OpenCV 4.10) on Debian 11
#                      and 12, the suite of the system on other systems
#   USAC_CPP_OPTIONS   options for CMake
#   USAC_CPP_RUNNER    command that runs the test program, such as an emulator
#   USAC_CPP_FILTER    GoogleTest filter
#   USAC_BUILD_DIR     folder for all files that this script writes; default
#                      ${TMPDIR:-/tmp}/opencv_usac, kept for the next run

set -eu
case "$*" in
    "" | opencv | --installed | --cpp) ;;
    *) echo "usage: run_tests.sh [opencv | --installed | --cpp]" >&2; exit 2 ;;
esac
. "$(dirname "$0")/common.sh"

# Runs a command in OpenCV's build folder, where findDataFile looks for test data, and where the tests
# can leave files.
in_build()
{
    cd "$build" && "$@"
}

python_tests()
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python_loader:$source/modules/python/test" /usr/bin/python3 -c "$run_unittests" "test_usac*.py"
}

# Builds the package as a user gets it: a source distribution, and from it a wheel, which is
# installed into a virtual environment. Uses no network. CMake's build folder is kept for the next
# run.
build_python_package()
{
    folder=$work/python-$(printf %s "$project" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    rm -rf "$folder/dist" "$folder/source" "$folder/venv"
    mkdir -p "$folder/source"
    /usr/bin/python3 -m build --no-isolation --sdist --outdir "$folder/dist" "$module" &&
    tar -xf "$folder"/dist/usacv20-*.tar.gz -C "$folder/source" --strip-components=1 &&
    USACV20_BUILD_DIR="$folder/build" CMAKE_ARGS="-DUSAC_WERROR=ON -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON" /usr/bin/python3 -m build --no-isolation --wheel \
        --outdir "$folder/dist" "$folder/source" &&
    rm -r "$folder/source" &&
    /usr/bin/python3 -m venv --system-site-packages "$folder/venv" &&
    python=$folder/venv/bin/python3 &&
    "$folder/venv/bin/pip" install --no-index "$folder"/dist/usacv20-*.whl &&
    [ -z "$(find "$module" -name '*.egg-info' -o -path "$module/build" -o -path "$module/LICENSE")" ]  # the build must leave no files there
}

# Runs the Python tests on the package, with the system's cv2 or without cv2.
package_tests() # `with` (the system's cv2) or `none` (no cv2)
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="${site:-}" USAC_TEST_MODULE=usacv20 USAC_TEST_CV2="$1" \
        "$python" -c "$run_unittests" "test_usac*.py"
}

# Runs both variants in parallel, because each uses one processor. The output of the variant without
# cv2 is in python_package_alone.part.
python_package_tests()
{
    package_tests none > "$work/python_package_alone.part" 2>&1 &
    alone=$!
    package_tests with && rc=0 || rc=1
    wait $alone || rc=1
    return $rc
}

# Tests the programs of the benchmark, its readers of data sets and its plots; without matplotlib
# and scipy some tests are skipped.
benchmark_tests()
{
    cd "$project/modules/usac/benchmark" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python_loader" USAC_BENCHMARK="$work/consumer/build/bin/usac_benchmark" \
        /usr/bin/python3 -c "$run_unittests" "test_*.py"
}

# Compiles OpenCV's own tests from its unchanged source and runs them; misc/opencv_tests/differences.txt lists the allowed
# differences.
opencv_tests()
{
    tests=$work/opencv_tests-$(printf %s "$project $source" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    cmake -S "$module/misc/opencv_tests" -B "$tests" -DCMAKE_BUILD_TYPE=Release -DOPENCV_SOURCE="$source" \
        -DOPENCV_BUILD="$build" &&
    cmake --build "$tests" &&
    in_build "$tests/usac_opencv_tests"
}

# Runs the C++ tests under sanitizers, against the OpenCV of the system.
sanitized_tests()
{
    USAC_BUILD_DIR="$work" sh "$module/misc/sanitize.sh" asan
}

# Runs the C++ tests in the build of the consumer checks, so that the library is compiled once.
installed_tests()
{
    cd "$built" && in_shards bin/opencv_test_usac
}

# Tests the Python package that the consumer checks have built; it is linked with the library of the
# same build.
installed_python()
{
    site=$work/site python=/usr/bin/python3
    rm -rf "$site" && mkdir "$site" &&
    cp -r "$module/misc/python/package/usacv20" "$site" && cp "$built"/_native.* "$site/usacv20" && python_package_tests
}

# Runs the C++ tests in a separate build for each set of options, which can also enable the samples.
cpp_tests()
{
    folder=$work/cpp-$(printf %s "$project ${USAC_CPP_OPTIONS:-}" | cksum | cut -d ' ' -f 1)
    cmake -S "$project" -B "$folder" -DBUILD_TESTS=ON -DBUILD_SAMPLES=OFF -DUSAC_WERROR=ON -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON \
        ${USAC_CPP_OPTIONS:-} &&
    cmake --build "$folder" --target all opencv_test_usac &&
    cd "$folder" && in_shards ${USAC_CPP_RUNNER:-} bin/opencv_test_usac --gtest_filter="${USAC_CPP_FILTER:-*}"
}

if [ "$*" = --cpp ]; then
    install_packages libgtest-dev
    failed=0
    run sources "$count_passed" "$count_failed" bash "$module/misc/check_sources.sh"
    run cpp "$count_passed" "$count_failed" cpp_tests
    [ "$failed" = 0 ]
    exit
fi

if [ "$*" = --installed ]; then
    install_packages libgtest-dev
    folder=$work/installed-$(printf %s "$project" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
    built=$folder/build
    failed=0
    # The library is compiled once. The checks that use one processor run in parallel with the
    # tests.
    export USAC_CONSUMER_OPTIONS=-DBUILD_TESTS=ON USAC_CONSUMER_QUICK=${USAC_CONSUMER_QUICK-1}
    sh "$module/misc/consumer/check.sh" --build "$folder" opencv_test_usac
    bash "$module/misc/check_sources.sh" > "$work/sources.part" 2>&1 &
    sources=$!
    sh "$module/misc/consumer/check.sh" "$folder" > "$work/consumer.part" 2>&1 &
    consumer=$!
    run cpp "$count_passed" "$count_failed" installed_tests
    run python_package "$count_passed" "$count_failed" installed_python
    run python_package_alone "$count_passed" "$count_failed" cat "$work/python_package_alone.part"
    wait $sources || true  # the last lines of their outputs tell whether they failed
    wait $consumer || true
    run sources "$count_passed" "$count_failed" cat "$work/sources.part"
    run consumer "$count_passed" "$count_failed" cat "$work/consumer.part"
    [ "$failed" = 0 ]
    exit
fi

install_packages
[ -f "$source/CMakeLists.txt" ] || fetch_opencv
configure
if [ "$*" = opencv ]; then
    cmake --build "$build" --target opencv_ts opencv_usac
    failed=0
    run opencv "$count_passed" "$count_failed" opencv_tests
    [ "$failed" = 0 ]
    exit
fi
cmake --build "$build" --target opencv_test_usac opencv_perf_usac opencv_python3
export OPENCV_SAMPLES_DATA_PATH="$source/samples/data"

failed=0
run sources "$count_passed" "$count_failed" bash "$module/misc/check_sources.sh"
run cpp "$count_passed" "$count_failed" in_build in_shards bin/opencv_test_usac
run perf "$gtest_passed" "$gtest_failed" in_build bin/opencv_perf_usac --perf_min_samples=1 --perf_force_samples=1
run python "$count_passed" "$count_failed" python_tests
run consumer "$count_passed" "$count_failed" sh "$module/misc/consumer/check.sh" "$work/consumer" "$build"
build_python_package
run python_package "$count_passed" "$count_failed" python_package_tests
run python_package_alone "$count_passed" "$count_failed" cat "$work/python_package_alone.part"
run benchmark "$count_passed" "$count_failed" benchmark_tests
run opencv "$count_passed" "$count_failed" opencv_tests
run sanitized "$count_passed" "$count_failed" sanitized_tests

[ "$failed" = 0 ]
