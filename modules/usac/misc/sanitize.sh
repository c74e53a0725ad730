#!/bin/sh
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Runs the module's tests with sanitizers and other tools. Installs what it needs on Debian (as root
# or with sudo). The last line is "<N> passed, <M> failed", and the exit code is nonzero if anything
# fails.
#
# usage: sanitize.sh [asan] [tsan] [assertions] [valgrind] [fuzz [seconds]] [python] [lint]
# [coverage]       default: all
#
#   asan        library and tests with AddressSanitizer (including leaks) and
#               UndefinedBehaviorSanitizer
#   tsan        the tests with more than one thread (tsan_tests) with ThreadSanitizer
#   assertions  the tests with the assertions of libstdc++ (_GLIBCXX_ASSERTIONS)
#   valgrind    memcheck of the tests named in valgrind_tests
#   fuzz        libFuzzer with generated points and parameters, and with the contracts
#               (test/contracts) as the oracle; default: 60 seconds
#   python      the tests of the Python package, whose extension module has AddressSanitizer and
#               UndefinedBehaviorSanitizer
#   lint        clang-tidy (modules/usac/.clang-tidy) and cppcheck of include/ and src/
#   coverage    lines and branches of src/ that the tests reach, and a list of lines that no test
#               reaches
#
# "The tests" are all except slow_tests and statistics (common.sh; coverage includes the latter) and
# those with the tag verylong.
#
# For each tool, the library is built with the unmodified OpenCV (libopencv-dev) and GoogleTest of the
# system.
#
#   USAC_BUILD_DIR     folder for all files that this script writes; default
#                      ${TMPDIR:-/tmp}/opencv_usac, kept for the next run

set -eu
. "$(dirname "$0")/common.sh"
tools=$work/sanitized-$(printf %s "$project" | cksum | cut -d ' ' -f 1)  # CMake ties a build to its sources
jobs=${JOBS:-$(nproc)}
export CCACHE_NOHASHDIR=1 CCACHE_BASEDIR="$tools"  # tests with the same flags for several tools are compiled once
# Only tests with several threads can have data races.
tsan_tests='*hread*:*arallel*:UsacContracts*:Usac_Fuzz.*'
# Only the tests of the input checks and a few others, because under valgrind a test is 20 to 50 times
# slower.
valgrind_tests='Usac_Input*:UsacInput*:UsacPoints*:Usac_Arguments*:Usac_Solvers.allF*:Usac_Fuzz.kept*:Usac_Fuzz.few_places:-*hundred_thousand*'

# Configures the build of a tool and builds a target. Assertions of OpenCV's and Eigen's headers are enabled (no NDEBUG).
build_with() # tool, target, compiler, flags of the library, more options for CMake
{
    tool=$1 target=$2 compiler=$3 flags="-O1 -g1 $4"
    shift 4
    cmake -S "$project" -B "$tools/$tool" -DBUILD_TESTS=ON -DBUILD_SAMPLES=OFF -DUSAC_COUNT_ALLOCATIONS=OFF -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS_RELEASE=-g1 -DUSAC_SOURCE_FLAGS="$(echo $flags | tr ' ' ';')" \
        -DCMAKE_EXE_LINKER_FLAGS="$flags" -DCMAKE_SHARED_LINKER_FLAGS="$flags" -DUSAC_PRECOMPILED_HEADERS=ON -DUSAC_UNITY_BUILD=ON "$@" > "$tools/$tool.cmake.log" &&
    cmake --build "$tools/$tool" -j "$jobs" --target "$target"
}

# Runs the tests in the build folder of a tool, where they can write files.
tests_of() # tool, command before the program or nothing, arguments of the tests
{
    folder=$tools/$1
    shift
    cd "$folder" && "$@"
}

# With its default options, LeakSanitizer sometimes crashes at the end of a program with threads
# ("Tracer caught signal 11"): https://github.com/google/sanitizers/issues/1322
leaks=intercept_tls_get_addr=0
sanitizers="-fno-omit-frame-pointer -fno-sanitize-recover=all -fsanitize=address,undefined,float-cast-overflow"

run_asan()
{
    build_with asan opencv_test_usac g++ "$sanitizers" -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1 $sanitizers" &&
    ASAN_OPTIONS="$leaks:detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1" \
        UBSAN_OPTIONS=print_stacktrace=1 tests_of asan in_shards bin/opencv_test_usac --gtest_filter="-$slow_tests:$statistics"
}

run_tsan()
{
    build_with tsan opencv_test_usac g++ -fsanitize=thread -DUSAC_THREADS_BACKEND=ON &&
    tests_of tsan in_shards bin/opencv_test_usac --gtest_filter="$tsan_tests"
}

run_assertions()
{
    build_with assertions opencv_test_usac g++ -D_GLIBCXX_ASSERTIONS &&
    tests_of assertions in_shards bin/opencv_test_usac --gtest_filter="-$slow_tests:$statistics"
}

run_valgrind()
{
    build_with assertions opencv_test_usac g++ -D_GLIBCXX_ASSERTIONS &&
    tests_of assertions in_shards valgrind --error-exitcode=1 --leak-check=full \
        --errors-for-leak-kinds=definite bin/opencv_test_usac --gtest_filter="$valgrind_tests"
}

# Runs the stored inputs once, then new ones. Inputs that reach new code are kept in `corpus` for
# the next run; inputs that fail are kept in `findings`. The timeout is long, because it is
# wall-clock time and the process might have to wait for a processor.
run_fuzz() # seconds
{
    mkdir -p "$tools/corpus" "$tools/findings"
    build_with fuzz usac_fuzz clang++ "-O2 $sanitizers,fuzzer-no-link" &&
    if "$tools/fuzz/bin/usac_fuzz" -max_total_time="$1" -len_control=0 -max_len=1024 -timeout=600 -print_final_stats=1 \
        -artifact_prefix="$tools/findings/" "$tools/corpus" "$project/test_data/fuzz" 2>&1
    then
        echo "1 passed, 0 failed"
    else
        echo "0 passed, 1 failed"
    fi
}

# Leak detection is off, because the interpreter itself leaks. The tests for leaks in
# test_usac_surroundings.py are skipped here, because they measure the memory of the process and
# AddressSanitizer keeps freed memory; run_tests.sh runs them.
run_python()
{
    site=$tools/python/site
    cmake -S "$module/misc/python/native" -B "$tools/python" -DPython_EXECUTABLE=/usr/bin/python3 -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_CXX_FLAGS_RELEASE="-O1 -g1 $sanitizers" > "$tools/python.cmake.log" &&
    cmake --build "$tools/python" -j "$jobs" || return 1
    rm -rf "$site"
    mkdir "$site"
    cp -r "$module/misc/python/package/usacv20" "$site"
    cp "$tools/python/out/"_native.* "$site/usacv20"
    cd "$module/misc/python/test" &&
    LD_PRELOAD="$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libubsan.so)" PYTHONMALLOC=malloc \
        ASAN_OPTIONS=detect_leaks=0:detect_stack_use_after_return=1:strict_string_checks=1 UBSAN_OPTIONS=print_stacktrace=1 \
        PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$site" USAC_TEST_MODULE=usacv20 \
        /usr/bin/python3 -c "$run_unittests" "test_usac*.py"
}

# Each source file counts as one check for clang-tidy and one for cppcheck.
run_lint()
{
    build_with lint help clang++ "-Wunused-member-function" -DUSAC_PRECOMPILED_HEADERS=OFF -DUSAC_UNITY_BUILD=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON > /dev/null
    cd "$module"
    good=0 bad=0
    check() { if "$@"; then good=$((good + 1)); else bad=$((bad + 1)); echo "FAILED $*"; fi; }
    for file in $(find src -name '*.cpp' | sort); do
        check clang-tidy --quiet -p "$tools/lint" "$file" 2> /dev/null
        check cppcheck --quiet --enable=warning,performance,portability --std=c++11 --inline-suppr --error-exitcode=1 \
            --suppressions-list="$module/misc/sanitize/cppcheck.txt" -Iinclude -Isrc "$file"
    done
    echo "$good passed, $bad failed"
}

# Code outside the module is not counted. Branches taken only for an exception are not counted either,
# because every call that can throw has one (every allocation, for example).
run_coverage()
{
    build_with coverage opencv_test_usac g++ "--coverage -O0 -fprofile-update=atomic -fprofile-exclude-files=/usr/.*" || return 1
    cd "$tools/coverage"
    find . -name '*.gcda' -delete
    in_shards bin/opencv_test_usac --gtest_filter="-$slow_tests" && rc=0 || rc=1
    mkdir -p html &&
    gcovr --root "$module" --filter "$module/src/" --exclude-throw-branches --exclude-unreachable-branches \
        --txt - --html-details html/index.html --print-summary CMakeFiles/opencv_usac.dir && return $rc
}

# Prints the packages that the modes need in addition to those of run_tests.sh.
needs() # modes
{
    case " $* " in *" fuzz "*) echo clang libclang-rt-dev ;; esac
    case " $* " in *" lint "*) echo clang clang-tidy cppcheck ;; esac
    case " $* " in *" valgrind "*) echo valgrind libc6-dbg ;; esac
    case " $* " in *" coverage "*) echo gcovr ;; esac
}

[ $# -gt 0 ] || set -- asan tsan assertions valgrind fuzz python lint coverage
for mode in "$@"; do
    case $mode in
    asan | tsan | assertions | valgrind | fuzz | python | lint | coverage | [0-9]*) ;;
    *)
        echo "usage: sanitize.sh [asan] [tsan] [assertions] [valgrind] [fuzz [seconds]] [python] [lint] [coverage]" >&2
        trap - EXIT
        exit 2
        ;;
    esac
done
install_packages libgtest-dev $(needs "$@")
mkdir -p "$tools"

failed=0
while [ $# -gt 0 ]; do
    mode=$1
    shift
    case $mode in
    asan | tsan | assertions | valgrind | lint | python | coverage)
        run "$mode" "$count_passed" "$count_failed" "run_$mode" ;;
    fuzz)
        seconds=60
        case ${1:-} in [0-9]*) seconds=$1; shift ;; esac
        run fuzz "$count_passed" "$count_failed" run_fuzz "$seconds" ;;
    *)
        echo "seconds belong to fuzz, not $mode"
        failed=$((failed + 1)) ;;
    esac
done

[ "$failed" = 0 ]
