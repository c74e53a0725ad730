#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Builds the module inside OpenCV and runs all its tests: C++, a short pass of the performance tests, Python (cv2 of this build, and
# the package with and without Debian's cv2), a program against this build and the stand-alone one, the benchmark's, OpenCV's own
# tests with this module's flags in the place of OpenCV's, and C++ once more with AddressSanitizer and
# UndefinedBehaviorSanitizer. Does all its own set-up on Debian (as root or with sudo); the last line is "<N> passed, <M> failed".
#
# usage: run_tests.sh [opencv | --installed]
#
#   opencv       only OpenCV's own tests with this module's flags; the list of what may differ is for OpenCV 4.6 and 4.10:
#                OPENCV_SUITE=trixie sh run_tests.sh opencv
#   --installed  without OpenCV's source: library, C++ tests, Python package and consumer against the OpenCV of the system
#                (libopencv-dev), all but the performance tests and OpenCV's own
#
#   OPENCV_SOURCE_DIR  OpenCV's source; default: the one of Debian's source package, fetched once
#   OPENCV_SUITE       of Debian, whose source package that is; default: the one of this system
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
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$build/python_loader:$source/modules/python/test" \
        OPENCV_SAMPLES_DATA_PATH="$source/samples/data" /usr/bin/python3 -c "$run_unittests" "test_usac*.py"
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
    "$folder/venv/bin/pip" install --no-index "$folder"/dist/usacv20-*.whl &&
    [ -z "$(find "$module" -name '*.egg-info' -o -path "$module/build" -o -path "$module/LICENSE")" ]  # nothing is left beside the sources
}

# The same tests, beside Debian's cv2 and as if there were none.
python_package_tests() # with | none
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 USAC_TEST_MODULE=usacv20 USAC_TEST_CV2="$1" \
        OPENCV_SAMPLES_DATA_PATH="$source/samples/data" "$folder/venv/bin/python3" -c "$run_unittests" "test_usac*.py"
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

# In a build of their own, on this OpenCV, with the tests as they were compiled above.
sanitized_tests()
{
    OPENCV_SOURCE_DIR="$source" OPENCV_BUILD_DIR="$build" USAC_TEST_OBJECTS="$build/usac_test_objects.txt" \
        USAC_BUILD_DIR="$work" sh "$module/misc/sanitize.sh" asan
}

# A program of GoogleTest, its tests shared by as many processes as there are processors.
in_shards() # program
{
    shards=$(nproc) shard=0 processes=
    while [ $shard -lt "$shards" ]; do
        GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard "$@" > "$work/shard.$shard.log" 2>&1 &
        processes="$processes $!" shard=$((shard + 1))
    done
    rc=0
    for process in $processes; do wait "$process" || rc=1; done
    cat "$work"/shard.*.log
    p=$(cat "$work"/shard.*.log | sed -n "s/$gtest_passed/\1/p" | awk '{ n += $1 } END { print n + 0 }')
    f=$(cat "$work"/shard.*.log | sed -n "s/$gtest_failed/\1/p" | awk '{ n += $1 } END { print n + 0 }')
    rm "$work"/shard.*.log
    echo "$p passed, $f failed"
    return $rc
}

# The build of the consumer checks with the C++ tests: the library is compiled once.
installed_tests()
{
    cmake --build "$built" --target opencv_test_usac &&
    cd "$built" && in_shards bin/opencv_test_usac
}

installed_package_tests() # with | none
{
    cd "$module/misc/python/test" &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$work/site" USAC_TEST_MODULE=usacv20 USAC_TEST_CV2="$1" \
        /usr/bin/python3 -c "$run_unittests" "test_usac*.py"
}

# The two runs of the package's tests at the same time; each has one busy process.
installed_python()
{
    rm -rf "$work/site" && mkdir "$work/site" &&
    cp -r "$module/misc/python/package/usacv20" "$work/site" && cp "$built"/_native.* "$work/site/usacv20" || return 1
    installed_package_tests none > "$work/python_package_alone.part" 2>&1 &
    alone=$!
    installed_package_tests with && rc=0 || rc=1
    wait $alone || rc=1
    return $rc
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

failed=0
run sources "$count_passed" "$count_failed" bash "$module/misc/check_sources.sh"
run cpp "$gtest_passed" "$gtest_failed" in_build bin/opencv_test_usac
run perf "$gtest_passed" "$gtest_failed" in_build bin/opencv_perf_usac --perf_min_samples=1 --perf_force_samples=1
run python "$count_passed" "$count_failed" python_tests
build_python_package
run python_package "$count_passed" "$count_failed" python_package_tests with
run python_package_alone "$count_passed" "$count_failed" python_package_tests none
run consumer "$count_passed" "$count_failed" sh "$module/misc/consumer/check.sh" "$work/consumer" "$build"
run benchmark "$count_passed" "$count_failed" benchmark_tests
run opencv "$count_passed" "$count_failed" opencv_tests
run sanitized "$count_passed" "$count_failed" sanitized_tests

[ "$failed" = 0 ]
