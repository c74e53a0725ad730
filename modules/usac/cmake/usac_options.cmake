# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Compiler options of the module, for builds inside OpenCV and stand-alone builds.

option(USAC_WERROR "Warnings of the module's own targets are errors" OFF)
set(USAC_SOURCE_FLAGS "" CACHE STRING "Compiler options of the module's own source files, after those of the build type")

# Precompiled headers and unity builds shorten a build from scratch and do not change results. They are off by default with an old
# CMake and with a compiler launcher such as ccache, which serves rebuilds best from single files and needs
# CCACHE_SLOPPINESS=pch_defines,time_macros for precompiled headers.
set(_precompile ON)
set(_unite ON)
if(CMAKE_VERSION VERSION_LESS 3.16 OR CMAKE_CXX_COMPILER_LAUNCHER)
  set(_precompile OFF)
endif()
if(CMAKE_VERSION VERSION_LESS 3.18 OR CMAKE_CXX_COMPILER_LAUNCHER)
  set(_unite OFF)
endif()
option(USAC_PRECOMPILED_HEADERS "Parse the headers once per target; no effect in a build inside OpenCV" ${_precompile})
option(USAC_UNITY_BUILD "Compile the files of a folder together, so that templates are instantiated once; needs CMake 3.18" ${_unite})

include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)

get_filename_component(USAC_MODULE_DIR "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
get_filename_component(USAC_PROJECT_DIR "${USAC_MODULE_DIR}/../.." ABSOLUTE)

# File names in exceptions begin with modules/usac/ or, for samples, samples/, without the folder of the project.
check_cxx_compiler_flag(-fmacro-prefix-map=a=b USAC_COMPILER_MAPS_PATHS)
set(USAC_PATH_FLAGS "")
if(USAC_COMPILER_MAPS_PATHS)
  set(USAC_PATH_FLAGS "-fmacro-prefix-map=${USAC_PROJECT_DIR}/=")
endif()

# Sets the variable that `result` names to true if the compiler targets x86-64 and accepts the flags of an instruction set.
function(usac_check_instruction_set result macro intrinsic flags)
  set(CMAKE_REQUIRED_FLAGS "${flags}")
  set(CMAKE_REQUIRED_QUIET ON)
  check_cxx_source_compiles("
    #if !(defined __x86_64__ || defined _M_X64) || !defined ${macro}
    #error wrong target
    #endif
    #include <immintrin.h>
    int main() { ${intrinsic}; return 0; }" ${result})
endfunction()

if(MSVC)
  set(USAC_ARITHMETIC_FLAGS /fp:precise)
  set(USAC_AVX2_FLAGS /arch:AVX2)
  set(USAC_AVX512_FLAGS /arch:AVX512)
else()
  # Without fused multiply-add and reordering, results have the same bits with every instruction set. -fopenmp-simd enables the pragma "omp
  # simd" without OpenMP. -fno-math-errno allows vectorized square roots, -fno-trapping-math vectorized choices between two numbers;
  # neither changes a result.
  set(USAC_ARITHMETIC_FLAGS -fno-fast-math -fno-math-errno -fno-trapping-math -ffp-contract=off -fopenmp-simd)
  set(USAC_AVX2_FLAGS -mavx2)
  set(USAC_AVX512_FLAGS -mavx512f -mavx512bw -mavx512dq -mavx512vl)
endif()

if(NOT CV_DISABLE_OPTIMIZATION)
  string(REPLACE ";" " " _flags "${USAC_AVX2_FLAGS}")
  usac_check_instruction_set(USAC_COMPILES_AVX2 __AVX2__ "(void)_mm256_setzero_si256()" "${_flags}")
  string(REPLACE ";" " " _flags "${USAC_AVX512_FLAGS}")
  usac_check_instruction_set(USAC_COMPILES_AVX512 __AVX512F__ "(void)_mm512_setzero_ps()" "${_flags}")
endif()

# Macros for the instruction sets for which the module's *_avx2.cpp and *_avx512.cpp are compiled.
set(USAC_DEFINITIONS "")
foreach(_set AVX2 AVX512)
  if(USAC_COMPILES_${_set})
    list(APPEND USAC_DEFINITIONS USACV20_HAVE_${_set})
  endif()
endforeach()

# Sets the options of the module's source files as properties of the files, for opencv_world, in which the module has no target of
# its own. Without opencv_world, usac_library_options() sets them as properties of the target.
function(usac_source_options)
  foreach(source ${ARGN})
    if(source MATCHES "\\.cpp$")
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_OPTIONS ${USAC_SOURCE_FLAGS} ${USAC_ARITHMETIC_FLAGS} ${USAC_PATH_FLAGS})
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_DEFINITIONS ${USAC_DEFINITIONS})
      set_property(SOURCE "${source}" APPEND PROPERTY INCLUDE_DIRECTORIES "${USAC_MODULE_DIR}/src")
    endif()
  endforeach()
  usac_instruction_sets(${ARGN})
endfunction()

# Sets the compiler options of the files that are compiled for an instruction set.
function(usac_instruction_sets)
  foreach(source ${ARGN})
    if(source MATCHES "_avx2\\.cpp$" AND USAC_COMPILES_AVX2)
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_OPTIONS ${USAC_AVX2_FLAGS})
    elseif(source MATCHES "_avx512\\.cpp$" AND USAC_COMPILES_AVX512)
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_OPTIONS ${USAC_AVX512_FLAGS})
    endif()
  endforeach()
endfunction()

# Sets the options of a target with all of the library's sources.
function(usac_library_options target)
  target_compile_options(${target} PRIVATE ${USAC_SOURCE_FLAGS} ${USAC_ARITHMETIC_FLAGS} ${USAC_PATH_FLAGS})
  target_compile_definitions(${target} PRIVATE ${USAC_DEFINITIONS})
  target_include_directories(${target} PRIVATE "${USAC_MODULE_DIR}/src")
  get_target_property(sources ${target} SOURCES)
  usac_instruction_sets(${sources})
  usac_unite(${target})
endfunction()

# Sets `property` for the files that are compiled for an instruction set. These files neither use the precompiled headers, which the
# compiler rejects with other options, nor are they compiled together with other files.
function(usac_alone target property)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(source MATCHES "_avx(2|512)\\.cpp$")
      set_property(SOURCE "${source}" PROPERTY ${property} ON)
    endif()
  endforeach()
endfunction()

# Precompiles headers of a target.
function(usac_precompile target)
  if(USAC_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    usac_alone(${target} SKIP_PRECOMPILE_HEADERS)
  endif()
endfunction()

# Precompiles headers of a target with all of the library's sources.
function(usac_precompile_library target)
  usac_precompile(${target} "${USAC_MODULE_DIR}/src/precomp.hpp" <Eigen/Cholesky> <Eigen/Geometry> <Eigen/SVD>)
endfunction()

# Compiles all files of a folder of a target as one file, so that all names in a folder must differ, even in unnamed namespaces.
function(usac_unite target)
  if(NOT USAC_UNITY_BUILD)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(source MATCHES "\\.cpp$")
      get_filename_component(folder "${source}" DIRECTORY)
      string(REGEX REPLACE ".*/usac/" "" folder "${folder}")
      string(MAKE_C_IDENTIFIER "${folder}" group)
      set_property(SOURCE "${source}" PROPERTY UNITY_GROUP ${group})
    endif()
  endforeach()
  usac_alone(${target} SKIP_UNITY_BUILD_INCLUSION)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# With USAC_WERROR, makes warnings in a target of the module errors.
function(usac_target_options target)
  if(USAC_WERROR)
    if(MSVC)
      target_compile_options(${target} PRIVATE /WX)
    else()
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()
