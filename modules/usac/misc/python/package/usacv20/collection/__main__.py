# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Runs the collection tool: python3 -m usacv20.collection"""

import sys


def _run() -> int:
    try:
        from ._command import main
        return main()
    except KeyboardInterrupt:  # interrupted before any work started
        return 130


if __name__ == "__main__":
    sys.exit(_run())
