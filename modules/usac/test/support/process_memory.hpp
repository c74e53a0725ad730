// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.

#ifndef OPENCV_USACV20_TEST_PROCESS_MEMORY_HPP
#define OPENCV_USACV20_TEST_PROCESS_MEMORY_HPP

// Measures how much main memory this process uses.

namespace opencv_test {

//! False where resident memory cannot be read, and under AddressSanitizer or ThreadSanitizer, which
//! keep freed memory and use memory themselves.
bool memoryIsMeasurable();

//! Resident memory in bytes; 0 if it cannot be read. With glibc, free memory is first returned to
//! the system.
double residentBytes();

/** @brief The peak of resident memory in bytes since the object was constructed, minus the resident
memory at that time.

Where the system cannot reset the peak, only memory above the previous peak of the process is
counted, so that the result can be too small but never too large. */
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
