# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Synthetic pairs of images with known noise, for tests and measurements of --threshold auto."""

import numpy as np

from usac_camera import rotation

from usacv20.collection._pair import Pair, View

NONE = "none"  # the kind of a pair without overlap
KINDS = ("general", "general", "general", "general", "planar", "rotation")


class NoisyPair(object):
    """A pair with its ground truth.

    A quarter of the wrong matches join a small square in image 1 to one in image 2. If the images
    overlap, another quarter are copies of right matches whose points in image 2 are all shifted by
    the same offset (repeated structure). The others are random.

    sigma -- standard deviation of the noise in pixels
    heavy -- above 0: the noise of each keypoint is multiplied by a random log-normal factor; `heavy`
    is the standard deviation of the logarithm of this factor"""

    def __init__(self, seed, kind="general", size=(1600, 1200), sigma=1.0, wrong=0.5, known=True, matches=None,
                 heavy=0.0):
        self.kind, self.rng = kind, np.random.RandomState(seed)
        self.size, self.sigma, self.heavy = np.array(size, float), sigma, heavy
        focal = 1.2 * max(size)
        self.K = np.array([[focal, 0, size[0] / 2.0], [0, focal, size[1] / 2.0], [0, 0, 1]])
        self.R = rotation(self.rng.normal(0, 0.12, 3))
        move = self.rng.normal(0, 1, 3) * [1, 0.5, 0.5]
        self.t = 0 * move if kind == "rotation" else move * self.rng.uniform(0.3, 1.2) / np.linalg.norm(move)
        count = matches or int(np.exp(self.rng.uniform(np.log(100), np.log(1500))))
        a, b = self._right(0 if kind == NONE else int(round(count * (1 - wrong))))
        c, d = self._wrong(count - len(a), a, b)
        order = self.rng.permutation(count)
        points = [np.vstack([self._noisy(x), y])[order] for x, y in ((a, c), (b, d))]
        self.right = order < len(a)
        names = ["{}{}.jpg".format(side, seed) for side in "ab"]
        first, second = (View(name, x, x, self.K, known, *size) for name, x in zip(names, points))
        self.pair = Pair(seed, first, second, np.tile(np.arange(count, dtype=np.uint32)[:, None], 2), None, False)

    def _right(self, count):
        a, b = np.empty((0, 2)), np.empty((0, 2))
        while len(a) < count:
            x = self.rng.uniform(0, self.size, (4 * count, 2))
            depth = self.rng.uniform(4, 12, len(x))
            X = np.hstack([x, np.ones((len(x), 1))]).dot(np.linalg.inv(self.K).T)
            if self.kind == "planar":
                depth = 7 / (1 + X.dot([0.3, 0.2, 0]))
            X = (X * depth[:, None]).dot(self.R.T) + self.t
            y = X.dot(self.K.T)
            y = y[:, :2] / y[:, 2:]
            seen = (X[:, 2] > 0.5) & (y > 0).all(axis=1) & (y < self.size).all(axis=1)
            a, b = np.vstack([a, x[seen]]), np.vstack([b, y[seen]])
        return a[:count], b[:count]

    def _wrong(self, count, a, b):
        u, v = self.rng.uniform(0, self.size, (count, 2)), self.rng.uniform(0, self.size, (count, 2))
        quarter, side = count // 4, self.size.max() / 20
        for points in (u, v):
            points[:quarter] = self.rng.uniform(0, self.size - side) + self.rng.uniform(0, side, (quarter, 2))
        if len(a):
            of = self.rng.randint(len(a), size=quarter)
            u[quarter:2 * quarter] = self._noisy(a[of])
            v[quarter:2 * quarter] = self._noisy(b[of]) + self.rng.normal(0, 0.05, 2) * self.size[0]
        return u, v

    def _noisy(self, x):
        noise = self.rng.normal(0, self.sigma, x.shape)
        if self.heavy:
            noise *= np.exp(self.rng.normal(0, self.heavy, (len(x), 1)))
        return x + noise


def noisyPairs(seed, pairs, none=0.2, **options):
    """Returns random pairs of all kinds, with 30 to 70 % wrong matches unless `options` has `wrong`.
    With probability `none`, a pair has no overlap and only wrong matches."""
    rng = np.random.RandomState(seed)
    result = []
    for i in range(pairs):
        kind = NONE if rng.rand() < none else KINDS[rng.randint(len(KINDS))]
        given = dict(dict(wrong=rng.uniform(0.3, 0.7)), **options)
        result.append(NoisyPair(1000 * seed + i, kind, **given))
    return result
