// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_INSTRUCTION_SET_HPP
#define OPENCV_USACV20_INSTRUCTION_SET_HPP

namespace cv {
namespace usacv20 {

//! Instruction sets for which some files are compiled, see usac_options.cmake.
enum InstructionSet { INSTRUCTIONS_BASELINE, INSTRUCTIONS_AVX2, INSTRUCTIONS_AVX512 };

//! The fastest set that compiler and processor support and OPENCV_CPU_DISABLE permits.
InstructionSet fastestInstructions();

}  // namespace usacv20
}  // namespace cv

#endif
