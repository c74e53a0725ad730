# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The version of the package, which is that of the C++ library (cmake/usac_version.cmake)."""

__all__ = ["__version__"]

__version__ = "0.2.0"
