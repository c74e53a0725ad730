# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Version of the module, for builds inside OpenCV and stand-alone builds.

set(USAC_VERSION 0.2.0)
