# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""python3 -m usacv20.collection"""

import sys

if __name__ == "__main__":
    try:
        from ._command import main
        sys.exit(main())
    except KeyboardInterrupt:  # before anything was begun
        sys.exit(130)
