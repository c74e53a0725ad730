# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Provides the functions of the extension module (_native.pyi) by calling those of a cv2 that was
built with the module."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable, Dict, List, Tuple

from ._intree_progress import Progress, Runs

_PAIR = ("points1", "points2", "cameraMatrix1", "cameraMatrix2", "distCoeffs1", "distCoeffs2", "imageSize1", "imageSize2", "taken1",
         "taken2", "scores", "sigmas")
_GEOMETRY = ("configuration", "mask", "inliers", "F", "E", "H", "R", "t", "rotations", "report", "iterations", "milliseconds", "reason",
             "error")


class Native:
    """The functions of _native.pyi, based on cv2._native.usacv20. OpenCV's bindings release the
    global interpreter lock during each call."""

    def __init__(self, cv2: Any) -> None:
        native = getattr(cv2._native, "usacv20", None)
        if native is None:
            raise ImportError("cv2 was built without the module usac")
        self._cv2 = cv2
        self._native = native
        self._functions = Runs(native)
        self.Progress = Progress
        self._constants = {name: value for name, value in vars(cv2._native).items() if name.startswith("USACV20")}
        self.Params = native.Params
        self.Report = native.Report
        self.TwoViewRules = native.TwoViewRules
        self.isUsacV20Method = native.isUsacV20Method
        self.removeDistortion = native.removeDistortion
        self.lastWarning = self._functions.lastWarning

    def estimate(self, problem: int, points1: Any, points2: Any, params: Any, cameraMatrix1: Any = None,
                 cameraMatrix2: Any = None, distCoeffs1: Any = None, distCoeffs2: Any = None) -> Tuple[Any, Any, Any]:
        model, mask, report = self._functions.estimateModel(problem, points1, points2, params, cameraMatrix1=cameraMatrix1,
                                                            cameraMatrix2=cameraMatrix2, distCoeffs1=distCoeffs1,
                                                            distCoeffs2=distCoeffs2)
        return model, mask, report

    def estimateBatch(self, problem: int, points1: List[Any], points2: List[Any], params: List[Any], cameraMatrices1: List[Any],
                      cameraMatrices2: List[Any], distCoeffs1: List[Any], distCoeffs2: List[Any],
                      threads: int) -> List[Tuple[Any, Any, Any, str]]:
        """Calls estimateBatch of C++. OpenCV's generator of bindings does not support lists of
        objects, so the tasks are added, and the results fetched, one by one."""
        count = len(points1)
        each = [entries * count if len(entries) == 1 else entries or [None] * count
                for entries in (params, cameraMatrices1, cameraMatrices2, distCoeffs1, distCoeffs2)]
        batch = self._native.Batch()
        for i in range(count):
            batch.add(problem, points1[i], points2[i], *(entries[i] for entries in each))
        self._functions.watched(lambda control: self._functions.entered(control, lambda: batch.run(threads)))
        return [(batch.model(i), batch.mask(i), batch.report(i), batch.error(i)) for i in range(count)]

    def _each(self, one: Callable[[int, Any], Any], count: int, threads: int) -> List[Any]:
        """Returns the results of `count` calls of `one`. The number of calls that run at once is
        `threads`, but at most the number of OpenCV's threads; `threads` 0 means this maximum. `one`
        gets the index of the call, and the RunControl that can stop the call, or None if nothing can
        stop it."""
        most = self._cv2.getNumThreads()
        workers = min(threads or most, most, count)

        def all(control: Any) -> List[Any]:
            if workers < 2:
                return [one(i, control) for i in range(count)]
            with ThreadPoolExecutor(workers) as pool:
                return list(pool.map(one, range(count), [control] * count))

        result: List[Any] = self._functions.watched(all)
        return result

    def _geometry(self, given: Tuple[Any, ...], params: Any, rules: Any) -> Tuple[Any, ...]:
        pair = self._native.TwoViewPair()
        for name, value in zip(_PAIR, given):
            if value is not None:
                setattr(pair, name, value)
        found = self._native.estimateTwoViewGeometry(pair, params, rules)
        return tuple(getattr(found, name) for name in _GEOMETRY)

    def estimateTwoViewGeometry(self, pair: Tuple[Any, ...], params: Any, rules: Any) -> Any:
        return self._functions.watched(
            lambda control: self._functions.entered(control, lambda: self._geometry(pair, params, rules)))

    def estimateTwoViewGeometries(self, pairs: List[Tuple[Any, ...]], params: Any, rules: Any,
                                  threads: int) -> List[Tuple[Any, ...]]:
        rules.check(params)

        def failed(report: Any, reason: str, error: str) -> Tuple[Any, ...]:
            return 0, None, 0, None, None, None, None, None, None, report, 0, 0.0, reason, error

        def one(i: int, control: Any) -> Tuple[Any, ...]:
            if control is not None and control.cancelled():
                return failed(self._functions.notBegun()[2], "canceled", "")
            try:
                found: Tuple[Any, ...] = self._functions.entered(control, lambda: self._geometry(pairs[i], params, rules))
                return found
            except self._cv2.error as mistake:
                return failed(self.Report(), "", str(getattr(mistake, "err", "") or mistake))

        return self._each(one, len(pairs), threads)

    def fitModel(self, problem: int, points1: Any, points2: Any, params: Any, weights: Any, chosen: Any, cameraMatrix1: Any,
                 cameraMatrix2: Any, distCoeffs1: Any, distCoeffs2: Any) -> Any:
        return self._functions.fitModel(problem, points1, points2, params, weights=weights, chosen=chosen,
                                        cameraMatrix1=cameraMatrix1, cameraMatrix2=cameraMatrix2, distCoeffs1=distCoeffs1,
                                        distCoeffs2=distCoeffs2)

    def refineModel(self, problem: int, model: Any, points1: Any, points2: Any, params: Any, chosen: Any, cameraMatrix1: Any,
                    cameraMatrix2: Any, distCoeffs1: Any, distCoeffs2: Any) -> Any:
        return self._functions.refineModel(problem, model, points1, points2, params, chosen=chosen, cameraMatrix1=cameraMatrix1,
                                           cameraMatrix2=cameraMatrix2, distCoeffs1=distCoeffs1, distCoeffs2=distCoeffs2)

    def modelErrors(self, problem: int, model: Any, points1: Any, points2: Any, params: Any, *cameras: Any) -> Any:
        return self._functions.modelErrors(problem, model, points1, points2, params, *cameras)

    def tangentOfModel(self, problem: int, model: Any) -> Any:
        return self._native.tangentOfModel(problem, model)

    def covarianceOfModel(self, problem: int, model: Any, covariance: Any) -> Any:
        return self._native.covarianceOfModel(problem, model, covariance)

    def covarianceOfPose(self, essential: Any, covariance: Any, R: Any, t: Any) -> Any:
        return self._native.covarianceOfPose(essential, covariance, R, t)

    def pointCovariance(self, problem: int, model: Any, covariance: Any, points1: Any, points2: Any, cameraMatrix1: Any,
                        cameraMatrix2: Any) -> Any:
        return self._native.pointCovariance(problem, model, covariance, points1, points2, cameraMatrix1, cameraMatrix2)

    def estimateRelativePose(self, *arguments: Any) -> Any:
        found, R, t, mask, pose = self._functions.estimateRelativePose(*arguments)
        return (R, t, mask, pose.report, pose.essential, pose.behind, pose.onPlane, pose.otherR, pose.otherT,
                pose.otherInliers) if found else (None, None, mask, pose.report, None, 0, 0, None, None, 0)

    def findHomography(self, srcPoints: Any, dstPoints: Any, method: int, threshold: float, maxIters: int,
                       confidence: float) -> Any:
        return self._functions.findHomography(srcPoints, dstPoints, method, threshold, None, maxIters, confidence)

    def findFundamentalMat(self, points1: Any, points2: Any, method: int, threshold: float, confidence: float,
                           maxIters: int) -> Any:
        return self._functions.findFundamentalMat(points1, points2, method, threshold, confidence, maxIters)

    def findEssentialMat(self, points1: Any, points2: Any, cameraMatrix: Any, method: int, prob: float, threshold: float,
                         maxIters: int) -> Any:
        return self._functions.findEssentialMat(points1, points2, cameraMatrix, method, prob, threshold, maxIters)

    def findEssentialMatOfFocal(self, points1: Any, points2: Any, focal: float, pp: Tuple[float, float], method: int,
                                prob: float, threshold: float, maxIters: int) -> Any:
        return self._functions.findEssentialMat(points1, points2, focal, pp, method, prob, threshold, maxIters)

    def findEssentialMatOfCameras(self, points1: Any, points2: Any, cameraMatrix1: Any, distCoeffs1: Any, cameraMatrix2: Any,
                                  distCoeffs2: Any, method: int, prob: float, threshold: float) -> Any:
        return self._functions.findEssentialMat(points1, points2, cameraMatrix1, distCoeffs1, cameraMatrix2, distCoeffs2,
                                                method, prob, threshold)

    def estimateAffine2D(self, points1: Any, points2: Any, method: int, threshold: float, maxIters: int, confidence: float,
                         refineIters: int) -> Any:
        return self._functions.estimateAffine2D(points1, points2, None, method, threshold, maxIters, confidence, refineIters)

    def estimateAffinePartial2D(self, points1: Any, points2: Any, method: int, threshold: float, maxIters: int,
                                confidence: float, refineIters: int) -> Any:
        return self._functions.estimateAffinePartial2D(points1, points2, None, method, threshold, maxIters, confidence,
                                                       refineIters)

    def solvePnPRansac(self, objectPoints: Any, imagePoints: Any, cameraMatrix: Any, distCoeffs: Any, rvec: Any, tvec: Any,
                       useExtrinsicGuess: bool, iterationsCount: int, reprojectionError: float, confidence: float,
                       flags: int) -> Any:
        return self._functions.solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec,
                                              useExtrinsicGuess, iterationsCount, reprojectionError, confidence, None, flags)

    def solvePnPRansacOfParams(self, objectPoints: Any, imagePoints: Any, cameraMatrix: Any, distCoeffs: Any,
                               params: Any) -> Any:
        found, _, rvec, tvec, inliers = self._functions.solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs,
                                                                       params=params)
        return found, rvec, tvec, inliers

    def enumerators(self) -> Dict[str, int]:
        """Returns the names and values of all enumerators."""
        result = {name: value for name, value in vars(self._native).items() if name.isupper() and isinstance(value, int)}
        result.update(self._constants)
        return result
