# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Cameras of a COLMAP database, and the removal of their distortion.

The two kinds of distortion of OpenCV are supported. For a perspective lens, (u, v) = (x / z, y / z)
is changed by polynomials in r^2 = u^2 + v^2 as in cv2.projectPoints; usacv20.removeDistortion
inverts them. For a fisheye lens, (u, v) is scaled so that its length r becomes
theta (1 + k1 theta^2 + k2 theta^4 + ...), as in cv2.fisheye; theta = atan(r) is the angle to the
optical axis. COLMAP's models with fewer coefficients are special cases with zeros; SIMPLE_FISHEYE
and FISHEYE have only zeros. COLMAP's other models have no counterpart in OpenCV; for these,
CollectionError is raised."""

from __future__ import annotations

import typing
from typing import TYPE_CHECKING, Any, Dict, Tuple

import numpy as np

from .._lens import removeDistortion
from ._pair import CollectionError

if TYPE_CHECKING:
    import numpy.typing as npt

    _Array = npt.NDArray[np.float64]

# COLMAP's number of a model: the name and the parameters of the model, as in COLMAP's documentation.
_MODELS: Dict[int, Tuple[str, str]] = {
    0: ("SIMPLE_PINHOLE", "f cx cy"),
    1: ("PINHOLE", "fx fy cx cy"),
    2: ("SIMPLE_RADIAL", "f cx cy k1"),
    3: ("RADIAL", "f cx cy k1 k2"),
    4: ("OPENCV", "fx fy cx cy k1 k2 p1 p2"),
    5: ("OPENCV_FISHEYE", "fx fy cx cy k1 k2 k3 k4"),
    6: ("FULL_OPENCV", "fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6"),
    8: ("SIMPLE_RADIAL_FISHEYE", "f cx cy k1"),
    9: ("RADIAL_FISHEYE", "f cx cy k1 k2"),
    14: ("SIMPLE_FISHEYE", "f cx cy"),
    15: ("FISHEYE", "fx fy cx cy"),
}
# COLMAP's models without a counterpart in OpenCV. Here and in _MODELS, numbers above 10 are those of
# COLMAP 4.2.1.
_REFUSED: Dict[int, str] = {7: "FOV", 10: "THIN_PRISM_FISHEYE", 11: "RAD_TAN_THIN_PRISM_FISHEYE", 12: "SIMPLE_DIVISION",
                            13: "DIVISION", 16: "EUCM", 17: "EQUIRECTANGULAR"}
_DISTORTIONS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6")
# Maximum number of steps of Newton's method. Each step doubles the number of correct digits; common
# lenses need 3 to 6 steps for full precision.
_STEPS = 30
# Newton's method has converged if the radius of the distorted point differs by less than this value
# from the given radius, in units of the focal length; 10^-6 pixels for a focal length of 10^4 pixels.
_TOLERANCE = 1e-10


class Camera(typing.NamedTuple):
    """A camera, one row of the table `cameras`."""

    id: int  # camera_id
    model: str  # COLMAP's name of the model
    width: int  # pixels
    height: int
    matrix: _Array  # 3 x 3 camera matrix
    distortion: Tuple[float, ...]  # k1 k2 p1 p2 k3 k4 k5 k6; for a fisheye lens, p1, p2, k5 and k6 are 0
    fisheye: bool
    focalKnown: bool  # column prior_focal_length: the focal length is known from EXIF data or from the user

    @classmethod
    def fromColmap(cls, id: int, model: int, width: int, height: int, params: bytes, priorFocalLength: int) -> Camera:
        """Creates a camera from the columns of a row of the table `cameras`. Raises CollectionError
        for a model without a counterpart in OpenCV, and for invalid parameters."""
        if model not in _MODELS:
            name = _REFUSED.get(model, "of number {}".format(model))
            raise CollectionError("camera {}: its model {} has a distortion that OpenCV does not know".format(id, name))
        name, parameters = _MODELS[model]
        names = parameters.split()
        blob = params or b""
        values = np.frombuffer(blob, np.float64) if len(blob) % 8 == 0 else np.empty(0)
        if len(values) != len(names):
            raise CollectionError("camera {}: {} has {} parameters, of 8 bytes each, not {} bytes".format(
                id, name, len(names), len(blob)))
        value = {"fx": 0.0, "fy": 0.0, **{key: 0.0 for key in _DISTORTIONS}, **dict(zip(names, map(float, values)))}
        if "f" in value:
            value["fx"] = value["fy"] = value["f"]
        if not np.all(np.isfinite(values)) or value["fx"] <= 0 or value["fy"] <= 0:
            raise CollectionError("camera {}: finite parameters and positive focal lengths are expected, not {}".format(
                id, ", ".join("{}={:g}".format(key, value[key]) for key in names)))
        matrix = np.array([[value["fx"], 0, value["cx"]], [0, value["fy"], value["cy"]], [0, 0, 1]])
        return cls(id, name, width, height, matrix, tuple(value[key] for key in _DISTORTIONS), name.endswith("FISHEYE"),
                   bool(priorFocalLength))

    @property
    def distorted(self) -> bool:
        return self.fisheye or any(self.distortion)

    def ideal(self, points: npt.NDArray[Any]) -> _Array:
        """Removes the distortion: returns the pixels at which the same camera without distortion
        would see the points.

        points -- N x 2, pixels of the original (distorted) image

        Returns N x 2; NaN for points that are not the image of any direction in front of the
        camera."""
        taken = np.asarray(points, np.float64)
        if not self.fisheye:
            return removeDistortion(taken, self.matrix, np.array(self.distortion))
        focal, center = self.matrix[[0, 1], [0, 1]], self.matrix[:2, 2]
        with np.errstate(all="ignore"):
            result: _Array = _withoutFisheye((taken - center) / focal, self.distortion) * focal + center
        return result


def _withoutFisheye(distorted: _Array, distortion: Tuple[float, ...]) -> _Array:
    """Returns the points without fisheye distortion, in units of the focal length, by Newton's
    method for the angle to the optical axis; NaN for points outside the field of view of the lens.
    """
    k1, k2, _, _, k3, k4, _, _ = distortion
    target = np.hypot(distorted[:, 0], distorted[:, 1])
    angle = target.copy()
    for _ in range(_STEPS):
        s = angle * angle
        error = angle * (1 + s * (k1 + s * (k2 + s * (k3 + s * k4)))) - target
        slope = 1 + s * (3 * k1 + s * (5 * k2 + s * (7 * k3 + s * 9 * k4)))
        angle -= error / slope
        if np.all(np.abs(error) < _TOLERANCE):
            break
    # If the polynomial decreases at the solution, the solution is beyond the maximum of the
    # polynomial, where the lens forms no image.
    angle[~((np.abs(error) < _TOLERANCE) & (slope > 0) & (angle >= 0) & (angle < np.pi / 2))] = np.nan
    scale = np.where(target > 0, np.tan(angle) / np.where(target > 0, target, 1), 1)
    result: _Array = distorted * scale[:, None]
    return result
