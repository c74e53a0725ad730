#!/usr/bin/env python3
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes the correspondence sets of this directory from OpenCV's sample images. README.md says what each number is.

    python3 make.py <directory with graf1.png, left01.jpg, ...> [<output directory>]
"""

import os
import sys

import cv2 as cv
import numpy as np

BOARD = (9, 6)
SQUARE = 0.025  # metres; only the scale of the translation depends on it
FRAMES = ["%02d" % i for i in (1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 12, 13, 14)]
RATIO = 0.9     # of the ratio test: high, so that outliers remain
MOST = 600      # correspondences of a set


def gray(directory, name):
    image = cv.imread(os.path.join(directory, name), cv.IMREAD_GRAYSCALE)
    if image is None:
        sys.exit("%s is missing in %s" % (name, directory))
    return image


def match(image1, image2, features=4000):
    """SIFT, nearest neighbor, ratio test. Rows x1 y1 x2 y2 score, the score being the ratio: lower is better."""
    sift = cv.SIFT_create(features)
    keys1, descriptors1 = sift.detectAndCompute(image1, None)
    keys2, descriptors2 = sift.detectAndCompute(image2, None)
    rows = []
    for best, second in cv.BFMatcher(cv.NORM_L2).knnMatch(descriptors1, descriptors2, 2):
        if best.distance < RATIO * second.distance:
            p, q = keys1[best.queryIdx].pt, keys2[best.trainIdx].pt
            rows.append([p[0], p[1], q[0], q[1], best.distance / second.distance])
    rows = np.unique(np.array(rows), axis=0)  # a key point with two orientations can match twice
    order = np.random.RandomState(1).permutation(len(rows))[:MOST]
    return rows[order]


def corners(image):
    found, points = cv.findChessboardCorners(image, BOARD)
    if not found:
        sys.exit("no chessboard found")
    criteria = (cv.TERM_CRITERIA_EPS + cv.TERM_CRITERIA_COUNT, 100, 1e-4)
    return cv.cornerSubPix(image, points, (5, 5), (-1, -1), criteria).reshape(-1, 2)


class Rig(object):
    """The stereo rig of left*.jpg and right*.jpg, calibrated from the chessboards of all pairs."""

    def __init__(self, directory):
        left = [corners(gray(directory, "left%s.jpg" % f)) for f in FRAMES]
        right = [corners(gray(directory, "right%s.jpg" % f)) for f in FRAMES]
        board = np.zeros((BOARD[0] * BOARD[1], 3), np.float32)
        board[:, :2] = np.mgrid[:BOARD[0], :BOARD[1]].T.reshape(-1, 2) * SQUARE
        boards = [board] * len(FRAMES)
        size = (640, 480)
        flags = cv.CALIB_FIX_K3
        _, K1, d1, _, _ = cv.calibrateCamera(boards, left, size, None, None, flags=flags)
        _, K2, d2, _, _ = cv.calibrateCamera(boards, right, size, None, None, flags=flags)
        flags |= cv.CALIB_USE_INTRINSIC_GUESS
        self.rms, self.K1, self.d1, self.K2, self.d2, R, t, _, _ = cv.stereoCalibrate(
            boards, left, right, K1, d1, K2, d2, size, flags=flags,
            criteria=(cv.TERM_CRITERIA_EPS + cv.TERM_CRITERIA_COUNT, 300, 1e-9))
        t = t.ravel() / np.linalg.norm(t)
        cross = np.array([[0, -t[2], t[1]], [t[2], 0, -t[0]], [-t[1], t[0], 0]])
        self.E = unit(cross.dot(R))
        self.F = unit(np.linalg.inv(self.K2).T.dot(self.E).dot(np.linalg.inv(self.K1)))
        self.check = np.hstack([np.vstack(left), np.vstack(right)])[::5]

    def undistorted(self, rows):
        a = cv.undistortPoints(rows[:, None, 0:2].astype(np.float64), self.K1, self.d1, P=self.K1)
        b = cv.undistortPoints(rows[:, None, 2:4].astype(np.float64), self.K2, self.d2, P=self.K2)
        return np.hstack([a.reshape(-1, 2), b.reshape(-1, 2), rows[:, 4:]])


def unit(matrix):
    return matrix / np.linalg.norm(matrix)


def epipolar_errors(F, rows):
    a = np.hstack([rows[:, 0:2], np.ones((len(rows), 1))])
    b = np.hstack([rows[:, 2:4], np.ones((len(rows), 1))])
    lines, back = a.dot(F.T), b.dot(F)
    size = np.sqrt((lines[:, :2] ** 2).sum(1) + (back[:, :2] ** 2).sum(1))
    return np.abs((b * lines).sum(1)) / size


def transfer_errors(H, rows):
    a = np.hstack([rows[:, 0:2], np.ones((len(rows), 1))]).dot(H.T)
    return np.linalg.norm(a[:, :2] / a[:, 2:] - rows[:, 2:4], axis=1)


def save(directory, name, problem, model, rows, check, errors, cameras=None):
    """Writes the correspondences and their truth; prints how many are right."""
    with open(os.path.join(directory, name + ".txt"), "w") as out:
        for row in rows:
            out.write("%.3f %.3f %.3f %.3f %.4f\n" % tuple(row))
    fs = cv.FileStorage(os.path.join(directory, name + ".yml"), cv.FILE_STORAGE_WRITE)
    fs.write("problem", problem)
    fs.write("model", model)
    for key, value in (cameras or {}).items():
        fs.write(key, value)
    fs.write("check", np.round(check, 3).astype(np.float32))
    fs.release()
    print("%-14s %s %4d correspondences, %4d within 2 px of the truth; %4d check points, median error %.3f px" % (
        name, problem, len(rows), (errors(rows) < 2).sum(), len(check), np.median(errors(check))))


def make_graf(images, out):
    """Homography: a wall seen from two sides, with the published homography."""
    fs = cv.FileStorage(os.path.join(images, "H1to3p.xml"), cv.FILE_STORAGE_READ)
    H = fs.getNode("H13").mat()
    grid = np.mgrid[40:800:80, 40:640:80].T.reshape(-1, 1, 2).astype(np.float64)
    mapped = cv.perspectiveTransform(grid, H).reshape(-1, 2)
    inside = (mapped > 0).all(1) & (mapped < [800, 640]).all(1)
    check = np.hstack([grid.reshape(-1, 2), mapped])[inside]
    rows = match(gray(images, "graf1.png"), gray(images, "graf3.png"))
    save(out, "graf", "H", H, rows, check, lambda r: transfer_errors(H, r))


def make_aloe(images, out):
    """Fundamental matrix: a rectified pair, with check points from its disparity map."""
    F = unit(np.array([[0, 0, 0], [0, 0, -1.], [0, 1, 0]]))
    disparity = gray(images, "aloeGT.png")
    check = [[x, y, x - float(disparity[y, x]), y] for y in range(30, 1110, 70) for x in range(230, 1282, 70)
             if disparity[y, x] > 0]
    rows = match(gray(images, "aloeL.jpg"), gray(images, "aloeR.jpg"))
    save(out, "aloe", "F", F, rows, np.array(check), lambda r: epipolar_errors(F, r))


def make_stereo(images, out):
    """Fundamental and essential matrix: an office behind a chessboard, with the calibration from the chessboards."""
    rig = Rig(images)
    print("stereo calibration: %.3f px" % rig.rms)
    cameras = {"K1": rig.K1, "d1": rig.d1, "K2": rig.K2, "d2": rig.d2}
    for frame in ("01", "12"):
        rows = match(gray(images, "left%s.jpg" % frame), gray(images, "right%s.jpg" % frame))
        errors = lambda r: epipolar_errors(rig.F, rig.undistorted(r))
        save(out, "office%s_E" % frame, "E", rig.E, rows, rig.check, errors, cameras)
        save(out, "office%s_F" % frame, "F", rig.F, rig.undistorted(rows), rig.undistorted(rig.check),
             lambda r: epipolar_errors(rig.F, r))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    out = sys.argv[2] if len(sys.argv) == 3 else os.path.dirname(os.path.abspath(__file__))
    make_graf(sys.argv[1], out)
    make_aloe(sys.argv[1], out)
    make_stereo(sys.argv[1], out)


if __name__ == "__main__":
    main()
