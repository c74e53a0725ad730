# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Tests of USACV20_AUTO and of other options with which the threshold is estimated from the data."""

import unittest

import numpy as np

from usac_common import FINDER, GENERAL, PLANE, bits, usac

LARGEST = 10.0  # pixels, upper limit of the estimated threshold; the noise of the scenes is 0.3 pixels


class EstimatedThresholdTest(unittest.TestCase):

    def test_flag_and_params_give_the_same(self):
        p = PLANE
        H, mask = FINDER.findHomography(p.points1, p.points2, usac.USACV20_AUTO, LARGEST)
        params = usac.Params.automatic(threshold=LARGEST, confidence=0.995, maxIterations=2000)
        other, mask2, report = usac.estimateHomography(p.points1, p.points2, params)
        self.assertEqual(bits((H, mask)), bits((other, mask2)))
        self.assertEqual(report.inliers, int(mask.sum()))

    def test_report_tells_what_was_found(self):
        g = GENERAL
        for params in (usac.Params.automatic(threshold=LARGEST), usac.Params(threshold=LARGEST, thresholdType="estimated"),
                       usac.Params.fast(threshold=LARGEST, thresholdType=usac.THRESHOLD_ESTIMATED)):
            F, mask, report = usac.estimateFundamental(g.points1, g.points2, params)
            self.assertGreater(report.sigma, 0)
            self.assertLess(report.threshold, LARGEST / 2)
            self.assertGreater(report.threshold, 1.5 * report.sigma)
            errors = usac.modelErrors("fundamental", F, g.points1, g.points2)
            np.testing.assert_array_equal(mask.ravel() != 0, np.asarray(errors).ravel() <= report.threshold)
            self.assertIn("sigma", report.asDict())

    def test_given_threshold_is_kept(self):
        g = GENERAL
        _, _, report = usac.estimateFundamental(g.points1, g.points2, usac.Params(threshold=LARGEST))
        self.assertEqual((report.threshold, report.sigma), (LARGEST, 0))
        self.assertIs(usac.Params().thresholdType, usac.ThresholdType.THRESHOLD_GIVEN)
        self.assertIs(usac.Params.automatic().thresholdType, usac.THRESHOLD_ESTIMATED)


if __name__ == "__main__":
    unittest.main()
