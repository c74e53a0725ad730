// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PROCESS_MEMORY_HPP
#define OPENCV_USACV20_TEST_PROCESS_MEMORY_HPP

// What of this process is in main memory.

namespace opencv_test {

//! False where there is no way to know, and under a sanitizer, which keeps memory that was freed
//! and has some of its own.
bool memoryIsMeasurable();

//! Bytes now, after what is free has been given back to the system.
double residentBytes();

/** @brief The most bytes since the object was made, beyond those at that time.

Where the system cannot start anew, the part that lies above the peak of the process so far; never
too much. */
class PeakMemory
{
public:
    PeakMemory();
    double bytes() const;

private:
    double before;
};

}  // namespace opencv_test

#endif
