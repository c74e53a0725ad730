# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Rotations in the form that COLMAP databases use: unit quaternions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]


def quaternion(R: _Array) -> _Array:
    """Returns the quaternion (w, x, y, z) with w >= 0 of a rotation matrix. The outer product of
    the quaternion with itself (times 4) is computed from R, and its column with the largest
    diagonal element is normalized. NumPy is not used, because its calls take ten times as long for
    so few numbers."""
    rows: Any = R.tolist()
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rows
    columns = ((1 + xx + yy + zz, zy - yz, xz - zx, yx - xy), (zy - yz, 1 + xx - yy - zz, xy + yx, xz + zx),
               (xz - zx, xy + yx, 1 - xx + yy - zz, yz + zy), (yx - xy, xz + zx, yz + zy, 1 - xx - yy + zz))
    sizes = [columns[k][k] for k in range(4)]
    w, x, y, z = columns[sizes.index(max(sizes))]
    norm = math.copysign(math.sqrt(w * w + x * x + y * y + z * z), w)
    return np.array([w / norm + 0.0, x / norm, y / norm, z / norm])
