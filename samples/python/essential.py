#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Estimates the essential matrix and the relative pose from two images of calibrated cameras, and
compares flags of OpenCV with a flag of this module. The two cameras and their true relative pose are
calibrated from OpenCV's chessboard images."""

import sys
from typing import Optional, Tuple

import cv2
import numpy as np

import tools
from tools import Array, Image, usacv20


class Stereo:
    """Two cameras and their relative pose, calibrated from pairs of chessboard images; a file lists
    the names of the images."""

    def __init__(self, list_name: str, board: Tuple[int, int]) -> None:
        storage = cv2.FileStorage(tools.find_file(list_name), cv2.FILE_STORAGE_READ)
        node = storage.getFirstTopLevelNode()
        files = [node.at(i).string() for i in range(node.size())]
        plane = np.zeros((board[0] * board[1], 3), np.float32)
        plane[:, :2] = np.mgrid[0:board[0], 0:board[1]].T.reshape(-1, 2)
        corners = []
        for pair in zip(files[::2], files[1::2]):
            images = [cv2.cvtColor(tools.read_image(name), cv2.COLOR_BGR2GRAY) for name in pair]
            found = [self._corners(image, board) for image in images]
            if all(c is not None for c in found):
                corners.append(found)
        if not corners:
            raise SystemExit("%s: no pair of images shows the whole chessboard" % list_name)
        size = images[0].shape[::-1]
        corners1, corners2 = zip(*corners)
        planes = [plane] * len(corners)
        K1, K2 = cv2.initCameraMatrix2D(planes, corners1, size), cv2.initCameraMatrix2D(planes, corners2, size)
        rms, self.K1, self.dist1, self.K2, self.dist2, self.R, self.t, _, _ = cv2.stereoCalibrate(
            planes, corners1, corners2, K1, None, K2, None, size, flags=cv2.CALIB_USE_INTRINSIC_GUESS)
        print("calibrated from %d pairs of chessboard images, reprojection error %.2f px" % (len(corners), rms))

    @staticmethod
    def _corners(image: Image, board: Tuple[int, int]) -> Optional[Array]:
        found, corners = cv2.findChessboardCorners(image, board)
        if not found:
            return None
        criteria = (cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, 30, 0.01)
        result: Array = cv2.cornerSubPix(image, corners, (11, 11), (-1, -1), criteria)
        return result


def rate(result: tools.Result, points1: Array, points2: Array, stereo: Stereo) -> None:
    """Computes the angle between the true and the estimated rotation, and the angle between the true
    and the estimated direction of translation. The error is the larger angle in degrees."""
    normalized1 = cv2.undistortPoints(points1, stereo.K1, stereo.dist1)
    normalized2 = cv2.undistortPoints(points2, stereo.K2, stereo.dist2)
    _, R, t, _ = cv2.recoverPose(result.model, normalized1, normalized2, np.eye(3), mask=result.mask.copy())
    cosines = ((np.trace(R.T @ stereo.R) - 1) / 2, (t.T @ stereo.t).item() / np.linalg.norm(stereo.t))
    rotation, translation = (np.degrees(np.arccos(np.clip(c, -1, 1))) for c in cosines)
    result.error = max(rotation, translation)
    result.errorText = "R %.2f, t %.2f deg" % (rotation, translation)


def draw(image1: Image, image2: Image, points1: Array, points2: Array, stereo: Stereo, result: tools.Result) -> Image:
    """Draws inliers and epipolar lines in undistorted images, where epipolar lines are straight."""
    straight1 = cv2.undistort(image1, stereo.K1, stereo.dist1)
    straight2 = cv2.undistort(image2, stereo.K2, stereo.dist2)
    points1 = cv2.undistortPoints(points1, stereo.K1, stereo.dist1, P=stereo.K1).reshape(-1, 2)
    points2 = cv2.undistortPoints(points2, stereo.K2, stereo.dist2, P=stereo.K2).reshape(-1, 2)
    F = np.linalg.inv(stereo.K2).T @ result.model @ np.linalg.inv(stereo.K1)
    return tools.draw_epipolar_lines(straight1, straight2, points1, points2, result.mask, F)


def main() -> int:
    parser = tools.arguments(__doc__, "left01.jpg", "right01.jpg", "essential_py.jpg", 1.0)
    parser.add_argument("--chessboards", default="stereo_calib.xml", help="list of pairs of chessboard images")
    parser.add_argument("--columns", type=int, default=9, help="number of inner corners in a row of the chessboard")
    parser.add_argument("--rows", type=int, default=6, help="number of inner corners in a column")
    args = parser.parse_args()
    image1, image2 = tools.read_image(args.image1), tools.read_image(args.image2)
    stereo = Stereo(args.chessboards, (args.columns, args.rows))
    points1, points2 = tools.match(image1, image2, args)

    results = []
    for name in ("RANSAC", "USAC_DEFAULT", "USACV20"):
        result = tools.measure(name, args.runs, lambda: usacv20.findEssentialMat(
            points1, points2, stereo.K1, stereo.dist1, stereo.K2, stereo.dist2, tools.flag_of(name), args.confidence,
            args.threshold))
        if result.model is not None:
            rate(result, points1, points2, stereo)
        results.append(result)

    # Repeats the estimation to get the report, which a call with a flag does not return. 1000 is
    # findEssentialMat's default maximum number of samples.
    ours = results[-1]
    _, _, report = usacv20.estimateEssential(points1, points2, stereo.K1, stereo.K2, stereo.dist1, stereo.dist2,
                                             tools.usacv20_params(args, 1000))
    ours.iterations = report.iterations
    tools.print_table(len(points1), results, args.runs)
    print("USACV20: " + report.describe())
    if ours.model is not None:
        picture = draw(image1, image2, points1, points2, stereo, ours)
        tools.write_picture(args.output, picture, ours, "; some of them with their epipolar lines")
    return tools.exit_code(ours, 10)  # limit of the error in degrees


if __name__ == "__main__":
    sys.exit(main())
