# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# The module's version, the same inside OpenCV and stand-alone.

set(USAC_VERSION 0.2.0)
