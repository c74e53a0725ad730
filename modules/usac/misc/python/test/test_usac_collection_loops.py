#!/usr/bin/env python
# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of the loop check: a pair is refused if its rotation contradicts the rotation along a path
of other pairs (links) that have at least twice as many inliers."""

import os
import shutil
import sys
import tempfile
import unittest

import numpy as np

from usac_camera import rotation as rotationOf
from usac_collection_database import DatabaseCase, change, dump, pairId, rows, smallDatabase
from usac_common import IN_TREE, once, package

if not IN_TREE:
    from usacv20.collection import verify
    from usacv20.collection._database_sink import DatabaseSink
    from usacv20.collection._loops import LONGEST, Edge, contradicted
    from usacv20.collection._pair import CollectionError, Configuration, TwoView
    from usacv20.collection._poses import quaternion

PROGRAMS = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "benchmark", "collection"))
RESULTS = ("two_view_geometries", "usacv20_pairs")


class Ring(object):
    """`count` images with known true rotations, in about equal steps around a vertical axis."""

    def __init__(self, count, seed=0):
        rng = np.random.RandomState(seed)
        self.rng = rng
        self.rotations = [rotationOf([0, 2 * np.pi * i / count, 0]).dot(rotationOf(rng.normal(0, 0.1, 3))) for i in range(count)]

    def edge(self, first, second, inliers, degrees=0.0, link=True, noise=0.5):
        """Returns an accepted pair whose rotation is wrong by `degrees`, plus random noise of about
        `noise` degrees."""
        wrong = rotationOf(np.radians(degrees) * np.array([0, 0.6, 0.8])).dot(rotationOf(np.radians(self.rng.normal(0, noise, 3))))
        R = wrong.dot(self.rotations[second]).dot(self.rotations[first].T)
        return Edge((first, second), first, second, inliers, quaternion(R)[None], link)


def chain(ring, inliers=100):
    return [ring.edge(i, i + 1, inliers) for i in range(len(ring.rotations) - 1)]


@once
@package
class LoopsTest(unittest.TestCase):

    def test_what_is_asked_of_links(self):
        """A path contradicts a pair only if each link of the path has a single rotation (link=True) and
        at least twice as many inliers as the pair, and if the path has at most LONGEST links."""
        ring = Ring(12)
        wrong = ring.edge(0, 4, 51, 90)
        self.assertEqual(contradicted(chain(ring) + [wrong]), {})
        found = contradicted(chain(ring, 102) + [wrong])
        self.assertEqual((list(found), contradicted([])), ([(0, 4)], {}))
        self.assertLess(abs(found[0, 4] - 90), 5)
        self.assertEqual(contradicted([edge._replace(link=False) for edge in chain(ring, 102)] + [wrong]), {})
        cut = chain(ring, 102)
        del cut[2]
        self.assertEqual(contradicted(cut + [wrong]), {})
        ring = Ring(2 * LONGEST)
        for distance, count in ((LONGEST, 1), (LONGEST + 1, 0)):
            self.assertEqual(len(contradicted(chain(ring) + [ring.edge(3, 3 + distance, 20, 90)])), count)

    def test_wrong_links_are_none(self):
        """Pair (0, 2) is contradicted by pairs with more inliers. Therefore it must not be a link of a
        path that contradicts other pairs."""
        ring = Ring(8)
        links = [ring.edge(0, 1, 1000), ring.edge(1, 2, 1000), ring.edge(4, 3, 1000)]
        wrong = ring.edge(0, 2, 400, 90)
        right = ring.edge(0, 3, 300), ring.edge(2, 4, 90)
        self.assertEqual(list(contradicted(links + [wrong, *right])), [(0, 2)])
        # Without the link (0, 1), no path contradicts (0, 2). So this wrong pair is itself a link, and
        # the right pair (1, 4) is refused.
        self.assertEqual(list(contradicted(links[1:] + [wrong, right[0], ring.edge(1, 4, 90)])), [(1, 4)])

    def test_one_of_two_rotations(self):
        ring = Ring(8)
        plane = ring.edge(0, 4, 30, 90)
        self.assertEqual(list(contradicted(chain(ring) + [plane])), [(0, 4)])
        both = np.concatenate([plane.rotations, -ring.edge(0, 4, 30).rotations])  # q and -q are the same rotation
        self.assertEqual(contradicted(chain(ring) + [plane._replace(rotations=both)]), {})


@once
@package
class LoopsOfDatabaseTest(DatabaseCase):

    def setUp(self):
        super().setUp()
        smallDatabase(self.path)

    def result(self, first, second, inliers, R, configuration=2):
        none = inliers == 0
        return TwoView(pairId(first, second), Configuration(configuration), np.zeros((inliers, 2), np.uint32), None if none else np.eye(3),
                       None, None, None, None, "none" if none else "", 60, 10, 1e-9, 0.1, None if none else quaternion(R)[None])

    def test_table(self):
        sink = DatabaseSink(self.path, {})
        self.assertEqual(sink.edges(), [])
        turn = rotationOf([0, 1, 0])
        sink.commit(self.hashed(self.result(1, 2, 50, turn), self.result(1, 3, 20, turn, 3), self.result(2, 3, 0, turn),
                                self.result(2, 4, 30, turn, 7)._replace(rotations=None)))
        edges = sink.edges()
        self.assertEqual([(edge.first, edge.second, edge.inliers, edge.link) for edge in edges], [(1, 2, 50, True), (1, 3, 20, False)])
        np.testing.assert_array_equal(edges[0].rotations, quaternion(turn)[None])
        self.assertEqual(sink.refuse({pairId(1, 3): "so"}), 1)
        sink.close()
        key = pairId(1, 3)
        self.assertEqual(rows(self.path, "SELECT rows, data, config, F FROM two_view_geometries WHERE pair_id = ?", key),
                         [(0, None, 1, None)])
        self.assertEqual(rows(self.path, "SELECT configuration, reason, inliers, rotations FROM usacv20_pairs WHERE pair_id = ?", key),
                         [(1, "loop: so", 0, None)])
        sink = DatabaseSink(self.path, {}, resume=True)
        self.addCleanup(sink.close)
        self.assertEqual([sink.done(pairId(*pair)) for pair in ((1, 2), (1, 3), (2, 3))], [True, False, True])
        self.assertEqual(len(sink.edges()), 1)

    def test_table_of_another_version(self):
        sink = DatabaseSink(self.path, {})
        sink.close()
        change(self.path, "ALTER TABLE usacv20_pairs DROP COLUMN rotations")
        change(self.path, "ALTER TABLE usacv20_pairs DROP COLUMN matches_hash")
        change(self.path, "UPDATE usacv20_runs SET version = 2")
        with self.assertRaisesRegex(CollectionError, "another version of this tool: verify without --resume"):
            DatabaseSink(self.path, {}, resume=True)
        sink = DatabaseSink(self.path, {}, keep=True)
        sink.commit(self.hashed(self.result(1, 2, 50, np.eye(3))))
        self.assertEqual(len(sink.edges()), 1)
        sink.close()
        sink = DatabaseSink(self.path, {}, resume=True)
        self.addCleanup(sink.close)
        self.assertTrue(sink.done(pairId(1, 2)))


@once
@package
@unittest.skipUnless(os.path.exists(PROGRAMS), "the programs of the benchmark are not here")
class CourtTest(unittest.TestCase):
    """Tests with a synthetic courtyard whose opposite sides have the same windows. Without the loop
    check, some pairs of images without overlap are therefore accepted."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp()
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        sys.path.insert(0, PROGRAMS)
        cls.addClassCleanup(sys.path.remove, PROGRAMS)
        from streets import Options, Street
        cls.street = Street(Options("court", 16, seed=1))

    def verified(self, name, **options):
        """Verifies the database `name`; returns the number of accepted pairs with overlap (at least 30
        common points) and the number of accepted pairs without a common point."""
        path = os.path.join(self.folder, name)
        if not os.path.exists(path):
            self.street.write(path)
        self.summary = verify(path, threshold=0.9, threads=1, **options)
        kept = [key for key, in rows(path, "SELECT pair_id FROM two_view_geometries WHERE rows > 0")]
        return [sum(condition(self.street.common[key]) for key in kept) for condition in (lambda n: n >= 30, lambda n: n == 0)]

    def test_pairs_without_overlap(self):
        right, wrong = self.verified("all.db", loops=False)
        self.assertGreater(wrong, 5)
        self.assertEqual(self.summary.contradicted, 0)
        before = self.summary.verified
        self.assertEqual(self.verified("all.db"), [right, 0])
        self.assertEqual(self.summary.contradicted, wrong)
        self.assertEqual(self.summary.verified, before - wrong)
        self.assertIn("{} pairs are refused because pairs with more inliers".format(wrong), self.summary.line())

    def test_some_pairs_first(self):
        """First the pairs of ten images are verified, then the remaining pairs. The second run must
        also use the results of the first run: the table must equal that of a single run."""
        self.verified("one.db")
        names = os.path.join(self.folder, "pairs.txt")
        with open(names, "w") as file:
            for i in range(1, 11):
                file.writelines("{:03}.png {:03}.png\n".format(i, j) for j in range(i + 1, 11))
        self.verified("two.db", pairs=names)
        self.verified("two.db", resume=True)
        self.assertGreater(self.summary.skipped, 20)
        one, two = (dump(os.path.join(self.folder, name), RESULTS[0]) for name in ("one.db", "two.db"))
        self.assertEqual(one, two)

    def test_refused_pairs_again(self):
        """A run of only the pairs that the loop check has refused must refuse them again, because the other
        pairs of the table contradict them."""
        self.verified("again.db")
        wrong, before = self.summary.contradicted, dump(os.path.join(self.folder, "again.db"), RESULTS[0])
        names = os.path.join(self.folder, "refused.txt")
        with open(names, "w") as file:
            file.writelines("{:03}.png {:03}.png\n".format(key // 2147483647, key % 2147483647) for key, in rows(
                os.path.join(self.folder, "again.db"), "SELECT pair_id FROM usacv20_pairs WHERE reason LIKE 'loop: %'"))
        self.verified("again.db", pairs=names)
        self.assertEqual((self.summary.pairs, self.summary.contradicted, self.summary.verified), (wrong, wrong, 0))
        self.assertEqual(dump(os.path.join(self.folder, "again.db"), RESULTS[0]), before)

    def test_pairs_that_are_not_selected(self):
        """First the pairs without a common point are verified, then the others, which contradict them. The
        rows of the first pairs must not change until a run includes these pairs."""
        self.verified("whole.db")
        names = os.path.join(self.folder, "parts.txt")
        for overlap in (False, True):
            with open(names, "w") as file:
                file.writelines("{:03}.png {:03}.png\n".format(key // 2147483647, key % 2147483647)
                                for key, common in self.street.common.items() if (common > 0) == overlap)
            _, wrong = self.verified("parts.db", pairs=names, resume=overlap)
            self.assertGreater(wrong, 5)
            self.assertEqual(self.summary.contradicted, 0)
        self.assertEqual(self.verified("parts.db", resume=True)[1], 0)
        self.assertEqual(self.summary.contradicted, wrong)
        one, parts = (dump(os.path.join(self.folder, name), RESULTS[0]) for name in ("whole.db", "parts.db"))
        self.assertEqual(one, parts)


if __name__ == "__main__":
    unittest.main()
