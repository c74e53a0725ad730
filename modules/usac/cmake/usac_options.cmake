# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# How the module is compiled, the same inside OpenCV and stand-alone.

option(USAC_WERROR "Warnings of the module's own targets are errors" OFF)
set(USAC_SOURCE_FLAGS "" CACHE STRING "Compiler options of the module's own source files, after those of the build type")

include(CheckCXXSourceCompiles)

# Sets `result` if the compiler targets x86-64 and accepts the flags of an instruction set.
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
  # No contraction, no reordering: the same bits with every instruction set. The pragma "omp simd" without OpenMP. Square
  # roots that need not set errno are vector code.
  set(USAC_ARITHMETIC_FLAGS -fno-fast-math -fno-math-errno -ffp-contract=off -fopenmp-simd)
  set(USAC_AVX2_FLAGS -mavx2)
  set(USAC_AVX512_FLAGS -mavx512f -mavx512bw -mavx512dq -mavx512vl)
endif()

if(NOT CV_DISABLE_OPTIMIZATION)
  string(REPLACE ";" " " _flags "${USAC_AVX2_FLAGS}")
  usac_check_instruction_set(USAC_COMPILES_AVX2 __AVX2__ "(void)_mm256_setzero_si256()" "${_flags}")
  string(REPLACE ";" " " _flags "${USAC_AVX512_FLAGS}")
  usac_check_instruction_set(USAC_COMPILES_AVX512 __AVX512F__ "(void)_mm512_setzero_ps()" "${_flags}")
endif()

# Which instruction sets the module's *_avx2.cpp and *_avx512.cpp are compiled for.
set(USAC_DEFINITIONS "")
foreach(_set AVX2 AVX512)
  if(USAC_COMPILES_${_set})
    list(APPEND USAC_DEFINITIONS USACV20_HAVE_${_set})
  endif()
endforeach()

# Options of the module's source files; properties of files, because in opencv_world they have no target of their own.
function(usac_source_options)
  foreach(source ${ARGN})
    set(options ${USAC_SOURCE_FLAGS} ${USAC_ARITHMETIC_FLAGS})
    if(source MATCHES "_avx2\\.cpp$" AND USAC_COMPILES_AVX2)
      list(APPEND options ${USAC_AVX2_FLAGS})
    elseif(source MATCHES "_avx512\\.cpp$" AND USAC_COMPILES_AVX512)
      list(APPEND options ${USAC_AVX512_FLAGS})
    endif()
    if(source MATCHES "\\.cpp$")
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_OPTIONS ${options})
      set_property(SOURCE "${source}" APPEND PROPERTY COMPILE_DEFINITIONS ${USAC_DEFINITIONS})
      set_property(SOURCE "${source}" APPEND PROPERTY INCLUDE_DIRECTORIES "${USAC_MODULE_DIR}/src")
    endif()
  endforeach()
endfunction()

# Warnings of a target of the module as errors.
function(usac_target_options target)
  if(USAC_WERROR)
    if(MSVC)
      target_compile_options(${target} PRIVATE /WX)
    else()
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
endfunction()

get_filename_component(USAC_MODULE_DIR "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
get_filename_component(USAC_PROJECT_DIR "${USAC_MODULE_DIR}/../.." ABSOLUTE)
