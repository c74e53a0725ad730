#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Writes files of image pairs (.corr, NPZ, HDF5) and checks what is read from them; for tests of the
command `pairs`."""

import json
import os
import shutil
import tempfile
import unittest

import numpy as np

try:
    from usacv20.collection._lists import ListSource
    from usacv20.collection._pair import CollectionError, Fault
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass
try:
    import h5py
except ImportError:
    h5py = None

K1, K2 = np.array([[500., 0, 320], [0, 510, 240], [0, 0, 1]]), np.array([[600., 0, 330], [0, 600, 250], [0, 0, 1]])
needsH5py = unittest.skipIf(h5py is None, "there is no h5py")


def matchesOf(seed, count=12):
    rng = np.random.RandomState(seed)
    return rng.uniform(0, 600, (count, 2)), rng.uniform(0, 600, (count, 2)), rng.uniform(0.2, 0.8, count)


class Files(unittest.TestCase):

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return path

    def write(self, name, content):
        with open(self.path(name), "wb") as out:
            out.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def corr(self, name, seed, known=True, scores=True):
        a, b, s = matchesOf(seed)
        rows = np.column_stack((a, b, s) if scores else (a, b))
        self.write(name + ".corr", "\n".join(" ".join(map(repr, row)) for row in rows.tolist()) + "\n")
        if known:
            self.write(name + ".json", json.dumps({"size1": [640, 480], "size2": [650, 490], "K1": K1.tolist(), "K2": K2.tolist(),
                                                   "H": None, "gt_points": []}))

    def npz(self, name, **arrays):
        np.savez(self.path(name), **arrays)
        return self.path(name)

    def h5(self, name, **arrays):
        """Writes an HDF5 file. arrays -- the names are paths in the file: NAME or GROUP/NAME"""
        with h5py.File(self.path(name), "w") as out:
            for key, array in arrays.items():
                out[key] = array
        return self.path(name)

    def only(self, path, *more):
        """Opens a source, which must have exactly one item, and returns this item (a Pair or a Fault)."""
        source = self.source(path, *more)
        self.assertEqual(len(source), 1)
        (loaded,) = source.load(list(source.keys()))
        source.close()
        return loaded

    def source(self, path, *more):
        source = ListSource(path, *more)
        self.addCleanup(source.close)
        return source

    def check(self, pair, seed, rows=slice(None), known=True, scores=True):
        """Asserts that the pair has the given rows of matchesOf(seed), and the camera matrices K1 and
        K2 if `known` is true."""
        self.assertNotIsInstance(pair, Fault, pair)
        a, b, s = matchesOf(seed)
        for view, points in ((pair.first, a), (pair.second, b)):
            np.testing.assert_array_equal(view.points, points[rows])
            np.testing.assert_array_equal(view.taken, points[rows])
            self.assertEqual((view.points.dtype, view.focalKnown), (np.float64, known))
        if known:
            np.testing.assert_array_equal(pair.first.matrix, K1)
            np.testing.assert_array_equal(pair.second.matrix, K2)
        self.assertEqual((pair.matches.shape, pair.matches.dtype), (pair.first.points.shape, np.uint32))
        if scores:
            np.testing.assert_array_equal(pair.scores, s[rows])
        else:
            self.assertIsNone(pair.scores)

    def fault(self, loaded, *parts):
        self.assertIsInstance(loaded, Fault)
        for part in (str(loaded.key),) + parts:
            self.assertIn(part, loaded.reason)
        self.assertNotIn("\n", loaded.reason)

    def mistake(self, expected, *args):
        with self.assertRaisesRegex(CollectionError, expected) as caught:
            ListSource(*args)
        self.assertNotIn("\n", str(caught.exception))
