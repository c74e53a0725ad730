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
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from .._arguments import INT_MAX
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
# lenses need 3 to 6 steps for full precision, points close to a maximum of the polynomial up to 25.
_STEPS = 60
# Newton's method has converged if the radius of the distorted point differs by less than this value
# from the given radius, in units of the focal length; 10^-6 pixels for a focal length of 10^4 pixels.
_TOLERANCE = 1e-10


def blobOf(value: Any) -> Optional[bytes]:
    """Returns a value of a database as bytes; None if it is neither a blob nor NULL, for which there are no bytes."""
    return b"" if value is None else value if isinstance(value, bytes) else None


def sizeOf(blob: Optional[bytes]) -> str:
    """Returns a text for messages on the result of blobOf."""
    return "a value that is no blob" if blob is None else "{} bytes".format(len(blob))


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
            raise CollectionError("camera {}: its model {} has a distortion that OpenCV does not support".format(id, name))
        name, parameters = _MODELS[model]
        names = parameters.split()
        blob = blobOf(params)
        if blob is None or len(blob) != 8 * len(names):
            raise CollectionError("camera {}: {} has {} parameters, of 8 bytes each, not {}".format(
                id, name, len(names), sizeOf(blob)))
        if not all(isinstance(side, int) and 0 <= side <= INT_MAX for side in (width, height)):
            raise CollectionError("camera {}: width and height are numbers of pixels, not {!r} and {!r}".format(id, width, height))
        values = np.frombuffer(blob, np.float64)
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
        camera, because they are outside of the field of view of the lens."""
        taken = np.asarray(points, np.float64)
        if not self.fisheye:
            return removeDistortion(taken, self.matrix, np.array(self.distortion))
        focal, center = self.matrix[[0, 1], [0, 1]], self.matrix[:2, 2]
        with np.errstate(all="ignore"):
            result: _Array = _withoutFisheye((taken - center) / focal, self.distortion) * focal + center
        return result


def _withoutFisheye(distorted: _Array, distortion: Tuple[float, ...]) -> _Array:
    """Returns the points without fisheye distortion, in units of the focal length; NaN for points
    outside the field of view of the lens."""
    coefficients = [distortion[i] for i in (0, 1, 4, 5)]  # k1 to k4
    limit = _fieldOfView(coefficients)
    radius = np.hypot(distorted[:, 0], distorted[:, 1])
    inside = radius < _polynomials(np.array(limit), coefficients)[0]
    angle = np.full(len(radius), np.nan)
    angle[inside] = _angles(radius[inside], coefficients, limit)
    scale = np.where(radius > 0, np.tan(angle) / np.where(radius > 0, radius, 1), 1)
    result: _Array = distorted * scale[:, None]
    return result


def _polynomials(angle: _Array, coefficients: typing.Sequence[float]) -> Tuple[_Array, _Array]:
    """Returns the radius of the distorted point, a polynomial in the angle, and its derivative."""
    k1, k2, k3, k4 = coefficients
    s = angle * angle
    radius: _Array = angle * (1.0 + s * (k1 + s * (k2 + s * (k3 + s * k4))))
    slope: _Array = 1.0 + s * (3 * k1 + s * (5 * k2 + s * (7 * k3 + s * 9 * k4)))
    return radius, slope


def _fieldOfView(coefficients: typing.Sequence[float]) -> float:
    """Returns the angle up to which the lens forms an image: the smallest angle at which the
    derivative of the polynomial is 0, at most pi / 2."""
    k1, k2, k3, k4 = coefficients
    # The unknown is 1 / angle^2, not angle^2, so that the leading coefficient is 1.
    roots = np.roots(np.nan_to_num([1, 3 * k1, 5 * k2, 7 * k3, 9 * k4]))
    found = roots.real[(roots.imag == 0) & (roots.real > (2 / np.pi)**2)]
    return float(found.max()**-0.5) if len(found) else np.pi / 2


def _angles(radius: _Array, coefficients: typing.Sequence[float], limit: float) -> _Array:
    """Returns the angles at which the polynomial has the given values, by Newton's method. The
    polynomial increases up to `limit`, and its value there is larger than each radius. So the
    solution is always known to be in an interval, which is halved in place of a step that would leave
    the interval, or after a step that has not halved the error."""
    low, high = np.zeros_like(radius), np.full_like(radius, limit)
    angle, before = np.minimum(radius, limit), np.full_like(radius, np.inf)
    for _ in range(_STEPS):
        value, slope = _polynomials(angle, coefficients)
        error = value - radius
        low, high = np.where(error < 0, angle, low), np.where(error < 0, high, angle)
        size, step = np.abs(error), angle - error / slope
        good = (step >= low) & (step <= high) & (size <= before / 2)
        found = size < _TOLERANCE
        # The last step of a point is limited, because the derivative is close to 0 at the edge of the field of view.
        angle = np.where(found, angle - error / np.maximum(slope, 1e-3), np.where(good, step, (low + high) / 2))
        before = size
        if np.all(found):
            return angle
    angle[~found] = np.nan
    return angle
