#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of reading image pairs from .corr, NPZ and HDF5 files. Wrong contents of one pair must give a
Fault (with the reason) in place of this pair. If nothing can be read, an error must be raised."""

import multiprocessing
import os
import pickle
import sys
import unittest
from unittest import mock

import numpy as np

from usac_collection_lists import K1, K2, Files, h5py, matchesOf, needsH5py
from usac_common import once, package

try:
    from usacv20.collection import _lists
except ImportError:  # cv2.usacv20 can be tested without the package; tests of the package are then skipped
    pass


@once
@package
class CorrTest(Files):

    def test_folder(self):
        for i, name in enumerate(("b", "sub/c", "a", "sub/deeper/d")):
            self.corr(name, i, known=i != 1)
        self.write("README.txt", "no pair")
        source = self.source(self.folder)
        self.assertEqual(list(source.keys()), ["a", "b", "sub/c", "sub/deeper/d"])
        self.assertEqual(len(source), 4)
        pairs = source.load(["sub/c", "a", "b"])
        for pair, seed in zip(pairs, (1, 2, 0)):
            self.check(pair, seed, known=seed != 1)
            self.assertFalse(pair.higherIsBetter)
            np.testing.assert_array_equal(pair.matches, np.column_stack([np.arange(12)] * 2))
        self.assertEqual([pair.key for pair in pairs], ["sub/c", "a", "b"])
        self.assertEqual((pairs[1].first.width, pairs[1].first.height, pairs[1].second.width), (640, 480, 650))
        with mock.patch.object(_lists, "BATCH", 2):
            self.assertEqual(list(source.keys()), ["a", "b", "sub/c", "sub/deeper/d"])
        self.assertEqual((pairs[0].first.width, pairs[0].first.height), (0, 0))

    def test_list(self):
        self.corr("pairs/x/one", 0)
        self.corr("pairs/x/two", 1)
        self.write("lists/x.F.list", "# of two pairs\npairs/x/two\n\npairs/x/one\npairs/x/three\n")
        source = self.source(self.path("lists/x.F.list"))
        keys = list(source.keys())
        self.assertEqual(keys, ["pairs/x/two", "pairs/x/one", "pairs/x/three"])
        two, one, three = source.load(keys)
        self.check(two, 1)
        self.check(one, 0)
        self.fault(three, "No such file")
        self.write("x.P.list", "pairs/x/two\n")
        self.mistake("no pairs of images", self.path("x.P.list"))
        self.write("pairs/x/here.list", "one\n")  # paths are relative to the folder of the list, unless this folder is called lists
        self.check(self.only(self.path("pairs/x/here.list")), 0)

    def test_names_that_occur_twice(self):
        names = ["pairs/{}".format(i) for i in range(40)]
        self.write("x.list", "\n".join(names + names[5:30:5] + names[20:] + ["pairs/last"] + names[:1]))
        source = self.source(self.path("x.list"))
        self.assertEqual(list(source.keys()), names + ["pairs/last"])
        self.assertEqual(list(source.keys()), names + ["pairs/last"])
        self.assertEqual(len(source), 41)

    def test_without_scores(self):
        self.corr("a", 3, scores=False)
        self.check(self.only(self.folder), 3, scores=False)
        lines = self.read("a.corr").decode().splitlines()
        self.write("a.corr", "\n".join([lines[0] + " 0.5"] + lines[1:]))
        np.testing.assert_array_equal(self.only(self.folder).scores, [0.5] + [1] * 11)

    def test_unknown_camera(self):
        self.corr("a", 3)
        self.write("a.json", '{"size1": [640, 480], "size2": [480, 640]}')
        pair = self.only(self.folder)
        for view, center in ((pair.first, [319.5, 239.5]), (pair.second, [239.5, 319.5])):
            self.assertFalse(view.focalKnown)
            self.assertEqual(view.matrix[:2, 2].tolist(), center)
            self.assertEqual((view.matrix[0, 0], view.matrix[1, 1]), (768, 768))

    def test_faults(self):
        good = "1 2 3 4 0.5\n"
        for corr, text, parts in (
                (good + "1 2 3\n", None, ["line 2", "x1 y1 x2 y2"]), (good + "1 2 x 4 1\n", None, ["line 2"]),
                (good + "1 2 3 4 5 6\n" + good[:8], None, ["line 2"]), (good + "nan 2 3 4 1\n", None, ["match 1", "not finite"]),
                (good + "1 inf 3 4 1\n", None, ["match 1"]), (b"\xff\xfe\x00", None, ["no text"]),
                (good, "{", ["line 1 of the .json"]), (good, "[]", ["an object"]),
                (good, '{"K1": [[1,0,0],[0,1,0],[0,0,1]]}', ["no K2"]), (good, '{"K1": [[1,0],[0,1]], "K2": null}', ["no K2"]),
                (good, '{"K1": 3, "K2": 3}', ["K1"]),
                (good, '{"size1": [1], "size2": [1, 2]}', ["size1", "width and height"]),
                (good, '{"size1": [1, "a"], "size2": [1, 2]}', ["size1"]), (good, b"\xff", ["no text"])):
            with self.subTest(corr=corr, json=text):
                self.write("one pair.corr", corr)
                if text is not None:
                    self.write("one pair.json", text)
                self.fault(self.only(self.folder), *parts)


@once
@package
class NpzTest(Files):

    def test_folder(self):
        for i in range(3):
            a, b, s = matchesOf(i)
            self.npz("p{}.npz".format(i), points1=a, points2=b, ratios=s, K1=K1, K2=K2, size1=[640, 480], size2=[640, 481])
        source = self.source(self.folder)
        self.assertEqual(list(source.keys()), ["p0", "p1", "p2"])
        for seed, pair in enumerate(source.load(list(source.keys()))):
            self.check(pair, seed)
            self.assertEqual((pair.higherIsBetter, pair.first.height, pair.second.height), (False, 480, 481))

    def test_one_file(self):
        arrays = {}
        for i, name in enumerate(("b", "a/c")):
            a, b, s = matchesOf(i)
            arrays.update({name + "/points1": a, name + "/points2": b, name + "/scores": s, name + "/K": K1})
        source = self.source(self.npz("all.npz", **arrays))
        self.assertEqual(list(source.keys()), ["a/c", "b"])
        pair = source.load(["b"])[0]
        np.testing.assert_array_equal(pair.second.matrix, K1)
        self.assertTrue(pair.higherIsBetter)
        a, b, _ = matchesOf(4)
        self.assertEqual(self.only(self.npz("single.npz", points1=a, points2=b)).key, "single")

    def test_names(self):
        a, b, s = matchesOf(1)
        for arrays, scores in (
                ({"mkpts0": a, "mkpts1": b, "mconf": s, "K0": K1, "K1": K2}, True),
                ({"keypoints0": a, "keypoints1": b, "K1": K1, "K2": K2, "confidence": s}, True),
                ({"points1": a, "points2": b, "K1": K1, "K2": K2, "scores": np.ones(12)}, False)):
            self.check(self.only(self.npz("a.npz", **arrays)), 1, scores=scores)

    def test_keypoints(self):
        a, b, s = matchesOf(1)
        order = np.random.RandomState(0).permutation(12)
        forward = np.full(14, -1)
        forward[2:] = np.argsort(order)  # match i belongs to keypoint 2 + i of image 1; keypoints 0 and 1 have no match
        forward[5] = -1
        rows = np.array([0, 1, 2] + list(range(4, 12)))
        first = np.vstack(([[1, 1], [2, 2]], a))
        expected = np.column_stack((2 + rows, forward[2 + rows]))
        weights = np.concatenate(([9, 9], s))
        for number, (name, matches, scores) in enumerate((
                ("matches0", forward, weights), ("matches", forward.astype(np.int16), weights), ("matches", expected, s[rows]))):
            arrays = {"keypoints0": first, "keypoints1": b[order], name: matches, "matching_scores0": scores, "K0": K1, "K1": K2}
            pair = self.only(self.npz("a.npz", **arrays))
            self.check(pair, 1, rows)
            np.testing.assert_array_equal(pair.matches, expected, str(number))
        renamed = {"keypoints1": first, "keypoints2": b[order], "matches": expected, "scores": s[rows], "K1": K1, "K2": K2}
        self.check(self.only(self.npz("a.npz", **renamed)), 1, rows)
        nothing = self.only(self.npz("a.npz", keypoints0=a, keypoints1=b, matches0=np.full(12, -1)))
        self.assertEqual(nothing.matches.shape, (0, 2))

    def test_faults(self):
        a, b, s = matchesOf(0)
        wrong = a.copy()
        wrong[7, 1] = np.nan
        both = {"keypoints0": a, "keypoints1": b}
        for arrays, parts in (
                ({"points1": a}, ["no points1, points2", "only points1"]), ({"x": a}, ["no points1, points2"]),
                ({"points1": a, "points2": b[:5]}, ["12 and 5 points"]), ({"points1": wrong, "points2": b}, ["points1: row 7"]),
                ({"points1": a, "points2": b, "scores": s[:3]}, ["scores: 3 numbers for 12"]),
                ({"points1": a, "points2": b, "scores": s * np.nan}, ["scores: row 0"]),
                ({"points1": a.T, "points2": b}, ["points1: N x 2"]), ({"points1": a, "points2": b, "K1": K1}, ["K1, but no K2"]),
                ({"points1": a, "points2": b, "K1": -K1, "K2": K2}, ["K1: no camera"]),
                ({"points1": a, "points2": b, "K": K1[:2]}, ["K: no camera"]),
                ({"points1": a.astype(str), "points2": np.full((12, 2), "x")}, ["points2: no array of numbers"]),
                (dict(both, matches0=np.full(12, 12)), ["keypoint 12 of keypoints1, which has 12"]),
                (dict(both, matches0=np.zeros(4, int)), ["matches0: 4 numbers for 12"]),
                (dict(both, matches0=np.zeros(12)), ["whole numbers"]), (dict(both, matches=np.zeros((3, 3), int)), ["3 x 3"]),
                (dict(both, matches=np.array([[0, -1]])), ["keypoint -1"]),
                ({"points1": np.array([[object()]], object), "points2": b}, ["damaged"])):
            with self.subTest(parts=parts):
                path = self.npz("f/pair 1.npz", **arrays)
                for where in (os.path.dirname(path), path):  # read from the folder, and as a single file
                    self.fault(self.only(where), *parts)

    def test_damaged(self):
        a, b, _ = matchesOf(0, 1000)
        self.npz("good.npz", points1=a, points2=b)
        whole = self.read("good.npz")
        changed = bytearray(whole)
        changed[2000] ^= 255
        for content in (whole[:-30], whole[:100], b"", b"text", bytes(changed)):
            self.write("bad.npz", content)
            good, bad = self.source(self.folder).load(["good", "bad"])
            self.assertEqual(len(good.matches), 1000)
            self.fault(bad, "damaged")
        self.mistake("damaged", self.write("alone.npz", whole[:-30]))
        np.save(self.path("array"), a)
        self.mistake("no NPZ", self.write("array.npz", self.read("array.npy")))


@once
@package
@needsH5py
class Hdf5Test(Files):

    def hloc(self, name="m.h5", separator="/", **more):
        a, b, s = matchesOf(2)
        self.h5("f.h5", **{"db/one.jpg/keypoints": a.astype(np.float32), "db/one.jpg/image_size": [640, 480],
                           "db/one.jpg/descriptors": np.zeros((4, 12)), "q_2.jpg/keypoints": b.astype(np.float32),
                           "q_2.jpg/image_size": [641, 481], "db/three.jpg/descriptors": np.zeros((2, 2))})
        matches = np.array([3, -1, 0, 11] + [-1] * 8, np.int16)
        arrays = {"db-one.jpg" + separator + "q_2.jpg/matches0": matches,
                  "db-one.jpg" + separator + "q_2.jpg/matching_scores0": s.astype(np.float16)}
        return self.h5(name, **dict(arrays, **more)), self.path("f.h5")

    def test_groups(self):
        arrays = {}
        for i, name in enumerate(("b", "a/d", "a/c")):
            a, b, s = matchesOf(i)
            arrays.update({name + "/points1": a, name + "/points2": b, name + "/scores": s, name + "/K1": K1, name + "/K2": K2})
        source = self.source(self.h5("all.h5", **arrays))
        self.assertEqual(list(source.keys()), ["a/c", "a/d", "b"])
        for pair, seed in zip(source.load(["b", "a/d", "a/c"]), range(3)):
            self.check(pair, seed)
        self.fault(source.load(["a"])[0], "no points1")
        self.fault(source.load(["z"])[0], "no such group")
        a, b, s = matchesOf(5)
        path = self.h5("g/one.hdf5", points1=a, points2=b, scores=s, K1=K1, K2=K2)
        for where in (path, os.path.dirname(path)):
            pair = self.only(where)
            self.assertEqual(pair.key, "one")
            self.check(pair, 5)

    def test_hloc(self):
        a, b, s = matchesOf(2)
        for separator in "/_":
            source = self.source(*self.hloc(separator=separator))
            (key,) = source.keys()
            self.assertEqual(key, "db-one.jpg" + separator + "q_2.jpg")
            self.assertEqual(source.images(key), ("db/one.jpg", "q_2.jpg"))
            (pair,) = source.load([key])
            self.assertEqual(pair.matches.tolist(), [[0, 3], [2, 0], [3, 11]])
            np.testing.assert_array_equal(pair.first.points, a.astype(np.float32)[[0, 2, 3]])
            np.testing.assert_array_equal(pair.second.points, b.astype(np.float32)[[3, 0, 11]])
            np.testing.assert_array_equal(pair.scores, s.astype(np.float16)[[0, 2, 3]])
            self.assertEqual((pair.first.name, pair.second.name, pair.higherIsBetter), ("db/one.jpg", "q_2.jpg", True))
            self.assertEqual((pair.second.width, pair.second.height, pair.second.focalKnown), (641, 481, False))
            source.close()

    def test_faults(self):
        """A dataset that is no array of numbers must make its own pair a Fault, but no other pair."""
        a, b, s = matchesOf(0)
        arrays = {"points1": a, "points2": b, "keypoints0": a, "keypoints1": b, "scores": s, "matches0": np.arange(12), "K": K1}
        wrong = (h5py.Empty("f4"), h5py.Empty("i4"), "text", b"12", np.array([b"a"] * 12), np.dtype("f4"), 3)
        for names in (("points1", "points2", "scores", "K"), ("keypoints0", "keypoints1", "matches0")):
            for name in names:
                groups = {"good/" + member: arrays[member] for member in names}
                for i, value in enumerate(wrong):
                    groups.update({"bad{}/{}".format(i, member): arrays[member] for member in names if member != name})
                    groups["bad{}/{}".format(i, name)] = value
                source = self.source(self.h5("all.h5", **groups))
                for loaded in source.load(["bad{}".format(i) for i in range(len(wrong))]):
                    with self.subTest(name=name, key=loaded.key):
                        self.fault(loaded, name)
                self.assertEqual(len(source.load(["good"])[0].matches), 12)
                source.close()

    def test_hloc_faults(self):
        nothing = {"db-one.jpg/zz.jpg/matches0": np.zeros(12, int), "db-three.jpg/q_2.jpg/matches0": np.zeros(12, int),
                   "q_2.jpg/db-one.jpg/other": np.zeros(12, int), "db-one.jpg/q_2.jpg/matches1": [0]}
        source = self.source(*self.hloc(**nothing))
        good, noImage, noKeypoints, noMatches = source.load(
            ["db-one.jpg/q_2.jpg", "db-one.jpg/zz.jpg", "db-three.jpg/q_2.jpg", "q_2.jpg/db-one.jpg"])
        self.assertEqual(len(good.matches), 3)
        self.fault(noImage, "does not have its two images")
        self.fault(noKeypoints, "has no keypoints")
        self.fault(noMatches, "no matches0")
        source.close()
        self.mistake("--keypoints", self.hloc()[0])
        self.mistake("no such file", self.hloc()[0], self.path("none.h5"))
        self.mistake("go with an HDF5 file", self.write("x.npz", "x"), self.path("f.h5"))

    def test_damaged(self):
        a, b, _ = matchesOf(0, 1000)
        self.h5("good.h5", points1=a, points2=b)
        whole = self.read("good.h5")
        for content in (whole[:-500], b"", b"text"):
            self.write("bad.h5", content)
            good, bad = self.source(self.folder).load(["good", "bad"])
            self.assertEqual(len(good.matches), 1000)
            self.fault(bad, "damaged")
            self.mistake("damaged", self.path("bad.h5"))


@once
@package
class SourceTest(Files):

    def test_mistakes(self):
        self.mistake("no such file", self.path("none"))
        self.mistake("no .corr, .npz", self.folder)
        self.mistake("is expected", self.write("a.txt", "x"))
        self.mistake("no pairs", self.write("a.F.list", "# none\n"))
        self.corr("a", 0)
        self.npz("b.npz", points1=np.zeros((1, 2)))
        self.mistake("both .corr and .npz", self.folder)

    def test_extensions_in_upper_case(self):
        for seed, name in enumerate(("a.npz", "b.NPZ", "sub/c.Npz")):
            self.npz("{}.npz".format(seed), **dict(zip(("points1", "points2", "scores"), matchesOf(seed)), K1=K1, K2=K2))
            os.renames(self.path("{}.npz".format(seed)), self.path(name))
        source = self.source(self.folder)
        self.assertEqual(list(source.keys()), ["a", "b", "sub/c"])
        for seed, pair in enumerate(source.load(["a", "b", "sub/c"])):
            self.check(pair, seed)
        self.fault(source.load(["d"])[0], "No such file")
        self.write("b.npz", self.read("a.npz"))
        if len(os.listdir(self.folder)) == 4:  # otherwise the file system regards both names as one
            self.mistake("several files b.npz", self.folder)

    def test_without_h5py(self):
        with mock.patch.dict(sys.modules, {"h5py": None}):
            self.mistake("h5py is needed .*python3-h5py", self.write("a.h5", "x"))

    def test_processes(self):
        self.corr("a", 4)
        source = self.source(self.folder)
        source.load(["a"])
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(os.path.dirname(self.folder))
        copy = pickle.loads(pickle.dumps(self.source(os.path.basename(self.folder))))
        os.chdir(before)
        self.check(copy.load(["a"])[0], 4)
        with multiprocessing.get_context("fork").Pool(1) as pool:
            self.assertEqual(pool.apply(copy.fingerprint), source.fingerprint())
        before = source.fingerprint()
        self.corr("a", 5)
        os.utime(self.path("a.corr"), (1, 1))
        self.assertNotEqual(source.fingerprint(), before)

    @needsH5py
    def test_fork(self):
        a, b, s = matchesOf(6)
        source = self.source(self.h5("a.h5", points1=a, points2=b, scores=s, K1=K1, K2=K2))
        with multiprocessing.get_context("fork").Pool(1) as pool:
            self.check(pool.apply(source.load, (["a"],))[0], 6)


if __name__ == "__main__":
    unittest.main()
