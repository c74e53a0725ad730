# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

# Types of the compiled part, whose source is in misc/python/native. Arrays have a type of numbers that cv::Mat has, too; lists are
# arrays of one dimension.

from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
import numpy.typing as npt

_Array = npt.NDArray[Any]
_Optional = Optional[npt.NDArray[Any]]
_Double = Optional[npt.NDArray[np.float64]]
_Found = Tuple[_Double, Optional[npt.NDArray[np.uint8]]]
_Pose = Tuple[bool, _Double, _Double, Optional[npt.NDArray[np.int32]]]
_Points = Tuple[npt.NDArray[np.float64], npt.NDArray[np.int32], Optional[npt.NDArray[np.float32]], float, int]

pybind11Version: Tuple[int, int]

class _Class(type): ...  # the metaclass (class of classes) that pybind11, which makes the extension module, gives to its classes

class Params(metaclass=_Class):
    threshold: float
    thresholdType: int
    confidence: float
    maxIterations: int
    maxTime: float
    seed: int
    threads: int
    sampler: int
    ordering: int
    scores: npt.NDArray[np.float32]
    sigmas: npt.NDArray[np.float32]
    initialModel: npt.NDArray[np.float64]
    initialCovariance: npt.NDArray[np.float64]
    scoreOrder: int
    neighborhood: int
    neighbors: int
    neighborRadius: float
    residual: int
    quality: int
    reach: float
    widestReach: float
    verification: int
    tddPoints: int
    localOptimization: int
    localIterations: int
    localSampleMultiple: int
    localSamples: int
    spatialWeight: float
    runnersUp: int
    orderedEvery: int
    termination: int
    relaxation: float
    persistence: int
    degeneracy: int
    polishing: int
    polishingSteps: int
    significance: float
    covariance: int
    def __init__(self) -> None: ...
    def check(self, count: int = ...) -> None: ...
    @staticmethod
    def fromMethod(method: int) -> Params: ...
    @staticmethod
    def usacV20() -> Params: ...
    @staticmethod
    def fast() -> Params: ...
    @staticmethod
    def accurate() -> Params: ...
    @staticmethod
    def sorted() -> Params: ...
    @staticmethod
    def trustedScores() -> Params: ...
    @staticmethod
    def parallel() -> Params: ...
    @staticmethod
    def automatic() -> Params: ...
    @staticmethod
    def ransac() -> Params: ...
    @staticmethod
    def msac() -> Params: ...
    @staticmethod
    def lmeds() -> Params: ...
    @staticmethod
    def mlesac() -> Params: ...
    @staticmethod
    def prosac() -> Params: ...
    @staticmethod
    def loRansac() -> Params: ...
    @staticmethod
    def floRansac() -> Params: ...
    @staticmethod
    def gcRansac() -> Params: ...
    @staticmethod
    def usac2013() -> Params: ...
    @staticmethod
    def paper() -> Params: ...
    @staticmethod
    def magsac() -> Params: ...
    @staticmethod
    def magsacPlusPlus() -> Params: ...

class Report(metaclass=_Class):
    stop: int
    iterations: int
    rejectedSamples: int
    degenerateSamples: int
    models: int
    rejectedModels: int
    refusedModels: int
    droppedModels: int
    localOptimizations: int
    localImprovements: int
    degenerate: bool
    inliers: int
    sample: Tuple[int, ...]
    inlierRatio: float
    independentInliers: int
    chance: float
    threshold: float
    sigma: float
    covariance: _Double
    priorChance: float
    wideThreshold: bool
    warning: str
    cost: float
    setupMs: float
    searchMs: float
    localMs: float
    polishMs: float
    def __init__(self) -> None: ...
    def describe(self) -> str: ...

solvePnPFlags: Dict[str, int]

class Rng(metaclass=_Class):
    """A generator of pseudo-random numbers, which a seed and a stream determine."""

    def __init__(self, seed: int = ..., stream: int = ...) -> None: ...
    def next(self) -> int: ...
    def uniform(self, n: int) -> int: ...
    def distinct(self, n: int, count: int) -> npt.NDArray[np.int32]: ...

class Usac(metaclass=_Class):
    def __init__(self, problem: int, points1: _Array, points2: _Array, params: Params, cameraMatrix1: _Optional,
                 cameraMatrix2: _Optional, distCoeffs1: _Optional, distCoeffs2: _Optional) -> None: ...
    def setSampler(self, sampler: Any) -> None: ...
    def setScore(self, score: Any) -> None: ...
    def setPoints(self, points1: _Array, points2: _Array) -> None: ...
    def renew(self, points1: _Optional, points2: _Optional, params: Params) -> None: ...
    def points(self) -> _Points: ...
    def run(self) -> Tuple[_Double, npt.NDArray[np.uint8], Report]: ...

class TwoViewRules(metaclass=_Class):
    minInliers: int
    inlierRatio: float
    ratios: List[float]
    planarRatio: float
    calibrationRatio: float
    def __init__(self) -> None: ...
    def samples(self, params: Params, sampleSize: int, matches: int) -> float: ...
    def reached(self, params: Params, sampleSize: int, matches: int) -> float: ...
    def check(self) -> None: ...

class Progress(metaclass=_Class):
    def __init__(self, function: Callable[[Report], bool]) -> None: ...
    def enter(self) -> None: ...
    def leave(self) -> None: ...

def isUsacV20Method(method: int) -> bool: ...
def lastWarning() -> str: ...
def removeDistortion(points: _Array, cameraMatrix: _Array, distCoeffs: _Optional) -> _Double: ...
def fitModel(problem: int, points1: _Array, points2: _Array, params: Params, weights: _Optional, chosen: _Optional,
             cameraMatrix1: _Optional, cameraMatrix2: _Optional, distCoeffs1: _Optional,
             distCoeffs2: _Optional) -> Tuple[_Double, Optional[npt.NDArray[np.uint8]], Report]: ...
def refineModel(problem: int, model: _Array, points1: _Array, points2: _Array, params: Params, chosen: _Optional,
                cameraMatrix1: _Optional, cameraMatrix2: _Optional, distCoeffs1: _Optional,
                distCoeffs2: _Optional) -> Tuple[_Double, Optional[npt.NDArray[np.uint8]], Report]: ...
def modelErrors(problem: int, model: _Array, points1: _Array, points2: _Array, params: Params, cameraMatrix1: _Optional,
                cameraMatrix2: _Optional, distCoeffs1: _Optional, distCoeffs2: _Optional) -> _Double: ...
def tangentOfModel(problem: int, model: _Array) -> _Double: ...
def covarianceOfModel(problem: int, model: _Array, covariance: _Array) -> _Double: ...
def covarianceOfPose(essential: _Array, covariance: _Array, R: _Array, t: _Array) -> _Double: ...
def pointCovariance(problem: int, model: _Array, covariance: _Array, points1: _Array, points2: _Optional,
                    cameraMatrix1: _Optional, cameraMatrix2: _Optional) -> _Double: ...
def estimateRelativePose(points1: _Array, points2: _Array, cameraMatrix1: _Array, distCoeffs1: _Optional,
                         cameraMatrix2: _Optional, distCoeffs2: _Optional, params: Params) -> Tuple[
                             _Double, _Double, Optional[npt.NDArray[np.uint8]], Report, _Double, int, int, _Double, _Double,
                             int]: ...
def estimate(problem: int, points1: _Array, points2: _Array, params: Params, cameraMatrix1: _Optional = ...,
             cameraMatrix2: _Optional = ..., distCoeffs1: _Optional = ...,
             distCoeffs2: _Optional = ...) -> Tuple[_Double, Optional[npt.NDArray[np.uint8]], Report]: ...
def estimateBatch(problem: int, points1: List[_Array], points2: List[_Array], params: List[Params],
                  cameraMatrices1: List[_Optional], cameraMatrices2: List[_Optional], distCoeffs1: List[_Optional],
                  distCoeffs2: List[_Optional],
                  threads: int) -> List[Tuple[_Double, Optional[npt.NDArray[np.uint8]], Report, str]]: ...
def estimateTwoViewGeometry(pair: Tuple[Any, ...], params: Params, rules: TwoViewRules) -> Tuple[Any, ...]: ...
def estimateTwoViewGeometries(pairs: List[Tuple[Any, ...]], params: Params, rules: TwoViewRules,
                              threads: int) -> List[Tuple[Any, ...]]: ...
def findHomography(srcPoints: _Array, dstPoints: _Array, method: int, threshold: float, maxIters: int,
                   confidence: float) -> _Found: ...
def findFundamentalMat(points1: _Array, points2: _Array, method: int, threshold: float, confidence: float,
                       maxIters: int) -> _Found: ...
def findEssentialMat(points1: _Array, points2: _Array, cameraMatrix: _Array, method: int, prob: float, threshold: float,
                     maxIters: int) -> _Found: ...
def findEssentialMatOfFocal(points1: _Array, points2: _Array, focal: float, pp: Tuple[float, float], method: int, prob: float,
                            threshold: float, maxIters: int) -> _Found: ...
def findEssentialMatOfCameras(points1: _Array, points2: _Array, cameraMatrix1: _Array, distCoeffs1: _Optional,
                              cameraMatrix2: _Array, distCoeffs2: _Optional, method: int, prob: float,
                              threshold: float) -> _Found: ...
def estimateAffine2D(points1: _Array, points2: _Array, method: int, threshold: float, maxIters: int, confidence: float,
                     refineIters: int) -> _Found: ...
def estimateAffinePartial2D(points1: _Array, points2: _Array, method: int, threshold: float, maxIters: int, confidence: float,
                            refineIters: int) -> _Found: ...
def solvePnPRansac(objectPoints: _Array, imagePoints: _Array, cameraMatrix: _Array, distCoeffs: _Optional, rvec: _Optional,
                   tvec: _Optional, useExtrinsicGuess: bool, iterationsCount: int, reprojectionError: float, confidence: float,
                   flags: int) -> _Pose: ...
def solvePnPRansacOfParams(objectPoints: _Array, imagePoints: _Array, cameraMatrix: _Array, distCoeffs: _Optional,
                           params: Params) -> _Pose: ...
