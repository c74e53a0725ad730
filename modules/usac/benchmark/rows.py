# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Reads the CSV files that the programs of the benchmark write."""

import csv


def read_rows(file, columns, option, take):
    """Calls take(row) for each row of a CSV file. Raises ValueError with file and line if a column
    is missing or `take` raises TypeError or ValueError. `option` names the program that writes such
    files, and its option, for the error messages."""
    with open(file, newline="") as lines:
        rows = csv.DictReader(lines)
        missing = [name for name in columns if name not in (rows.fieldnames or ())]
        if missing:
            raise ValueError("%s:1: no column %s; expected the file of %s" % (file, ", ".join(missing), option))
        for row in rows:
            try:
                take(row)
            except (TypeError, ValueError):
                raise ValueError("%s:%d: not a line of %s" % (file, rows.line_num, option)) from None
