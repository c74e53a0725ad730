# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""USACv20: robust estimation of homographies, affinities, similarities, fundamental and essential matrices, camera
poses, motions of space.

The same package is the module cv2.usacv20 of an OpenCV that was built with the module, and usacv20 beside any cv2, or none. With
`import usacv20`, or `from cv2 import usacv20`, there are three levels of use:

1. A flag: usacv20.USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_PROSAC, USACV20_MAGSAC, USACV20_PARALLEL.

       H, mask = usacv20.findHomography(points1, points2, usacv20.USACV20, 3.0)
       A, inliers = usacv20.estimateAffine2D(points1, points2, None, usacv20.USACV20, 3.0)
       found, rvec, tvec, inliers = usacv20.solvePnPRansac(objectPoints, imagePoints, K, None, flags=usacv20.USACV20)

   The functions of cv2 take the flags, too: always those of an OpenCV that was built with the module, which has them as
   cv2.USACV20 and so on, those of any other after usacv20.patch_cv2(). The flags are integers, from 0x4000 on; a program may
   keep them in a variable or a file.

2. All options, match scores among them, in the place of the flag.

       params = usacv20.Params(threshold=2.0, scores=[match.distance for match in matches])
       H, mask = usacv20.findHomography(points1, points2, params)

3. The same with a report of what the estimator learned.

       H, mask, report = usacv20.estimateHomography(points1, points2, params)

Many pairs at once, on all cores, are estimateHomographies and its kin; all pairs of a collection of images, from a COLMAP database
or files of matches, python3 -m usacv20.collection.

Where there is no model (too few or degenerate points, or random ones, see Params.significance) the model is None, the mask zero,
and report.stop says why; report.chance bounds the probability that random matches give as good a model. A flag does not tell
whether maxIters ended the search; with Params.fromMethod(USACV20) report.stop == STOP_MAX_ITERATIONS does.

Points are arrays of integers or floating-point numbers of any type and layout. Mistakes raise usacv20.error, which names the
argument; it is a subclass of cv2.error where there is a cv2. The interpreter's lock is released while an estimation runs: points
and Params must not be changed by another thread during the call; those of the package usacv20 may, as they have been read before.

The package has classes for research beside (not in cv2): Usac, whose components Sampler and Score can be written in Python.
"""

from typing import TYPE_CHECKING, Any, List

from ._backend import IN_TREE as _IN_TREE
from ._backend import native as _compiled
from ._batch import (estimateAbsolutePoses, estimateAffinities2D, estimateEssentials, estimateFundamentals, estimateHomographies,
                     estimateRigids3D, estimateSimilarities2D, estimateSimilarities3D)
from ._enumerations import (
    ABSOLUTE_POSE, AFFINITY, DEGENERACY_DEGENSAC, DEGENERACY_ORIENTATION, DEGENERACY_REPEATED, DegeneracyFlags, ESSENTIAL,
    FUNDAMENTAL, HOMOGRAPHY, LOCAL_OPTIMIZATION_FLO_RANSAC, LOCAL_OPTIMIZATION_GC_RANSAC, LOCAL_OPTIMIZATION_GRAPH_CUT,
    LOCAL_OPTIMIZATION_LO_RANSAC, LOCAL_OPTIMIZATION_NONE, LOCAL_OPTIMIZATION_SIGMA_CONSENSUS,
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS, LocalOptimizationType, NEIGHBORHOOD_GRID, NEIGHBORHOOD_KNN,
    NEIGHBORHOOD_RADIUS, NeighborhoodType, ORDERING_AUTO, ORDERING_DENSITY, ORDERING_INPUT_ORDER, ORDERING_NONE,
    OrderingType, POLISHING_LEAST_SQUARES, POLISHING_NONE, POLISHING_REWEIGHTED, POLISHING_ROBUST, PolishingType,
    ProblemType, QUALITY_INLIERS, QUALITY_LMEDS, QUALITY_MAGSAC, QUALITY_MAGSAC_PLUS_PLUS, QUALITY_MLESAC, QUALITY_MSAC,
    QualityType, RESIDUAL_STANDARD, RESIDUAL_SYMMETRIC, RIGID_3D, ResidualType, SAMPLER_IMPORTANCE, SAMPLER_NAPSAC,
    SAMPLER_PROSAC, SAMPLER_P_NAPSAC, SAMPLER_UNIFORM, SCORES_HIGHER_IS_BETTER, SCORES_LOWER_IS_BETTER, SIMILARITY,
    SIMILARITY_3D, STOP_CUSTOM, STOP_MAGSAC, STOP_MAX_ITERATIONS, STOP_NOT_RUN, STOP_NOT_SIGNIFICANT, STOP_NO_MODEL,
    STOP_ORDER, STOP_PROSAC, STOP_P_NAPSAC, STOP_SPRT, STOP_STANDARD, STOP_TOO_FEW_POINTS, SamplerType, ScoreOrder, StopReason,
    TERMINATION_EXACT, TERMINATION_MAGSAC, TERMINATION_ORDER, TERMINATION_PROSAC, TERMINATION_P_NAPSAC,
    TERMINATION_SPRT, TERMINATION_STANDARD, TerminationFlags, USACV20, USACV20_ACCURATE, USACV20_FAST, USACV20_MAGSAC, USACV20_PARALLEL, USACV20_PROSAC,
    UsacV20Method, VERIFICATION_NONE, VERIFICATION_SPRT, VERIFICATION_TDD, VerificationType)
from ._errors import errorClass as _errorClass
from ._essential import findEssentialMat
from ._estimate import (estimateAbsolutePose, estimateAffinity2D, estimateEssential, estimateFundamental, estimateHomography,
                        estimateRigid3D, estimateSimilarity2D, estimateSimilarity3D)
from ._find import estimateAffine2D, estimateAffinePartial2D, findFundamentalMat, findHomography
from ._lens import removeDistortion
from ._opencv import patch_cv2, unpatch_cv2
from ._params import Params, UsacParams
from ._pose import solvePnPRansac
from ._report import Report
from ._version import __version__

__all__ = [
    "ABSOLUTE_POSE", "AFFINITY", "DEGENERACY_DEGENSAC", "DEGENERACY_ORIENTATION", "DEGENERACY_REPEATED", "DegeneracyFlags",
    "ESSENTIAL", "FUNDAMENTAL", "HOMOGRAPHY", "LOCAL_OPTIMIZATION_FLO_RANSAC", "LOCAL_OPTIMIZATION_GC_RANSAC",
    "LOCAL_OPTIMIZATION_GRAPH_CUT", "LOCAL_OPTIMIZATION_LO_RANSAC", "LOCAL_OPTIMIZATION_NONE",
    "LOCAL_OPTIMIZATION_SIGMA_CONSENSUS", "LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS", "LocalOptimizationType",
    "NEIGHBORHOOD_GRID", "NEIGHBORHOOD_KNN", "NEIGHBORHOOD_RADIUS", "NeighborhoodType", "ORDERING_AUTO", "ORDERING_DENSITY",
    "ORDERING_INPUT_ORDER", "ORDERING_NONE", "OrderingType", "POLISHING_LEAST_SQUARES", "POLISHING_NONE",
    "POLISHING_REWEIGHTED", "POLISHING_ROBUST", "Params", "PolishingType", "ProblemType", "QUALITY_INLIERS",
    "QUALITY_LMEDS", "QUALITY_MAGSAC", "QUALITY_MAGSAC_PLUS_PLUS", "QUALITY_MLESAC", "QUALITY_MSAC", "QualityType",
    "RESIDUAL_STANDARD", "RESIDUAL_SYMMETRIC", "RIGID_3D", "Report", "ResidualType", "SAMPLER_IMPORTANCE", "SAMPLER_NAPSAC",
    "SAMPLER_PROSAC", "SAMPLER_P_NAPSAC", "SAMPLER_UNIFORM", "SCORES_HIGHER_IS_BETTER", "SCORES_LOWER_IS_BETTER",
    "SIMILARITY", "SIMILARITY_3D", "STOP_CUSTOM", "STOP_MAGSAC", "STOP_MAX_ITERATIONS", "STOP_NOT_RUN",
    "STOP_NOT_SIGNIFICANT", "STOP_NO_MODEL", "STOP_ORDER", "STOP_PROSAC", "STOP_P_NAPSAC", "STOP_SPRT", "STOP_STANDARD",
    "STOP_TOO_FEW_POINTS", "SamplerType", "ScoreOrder", "StopReason", "TERMINATION_EXACT", "TERMINATION_MAGSAC",
    "TERMINATION_ORDER", "TERMINATION_PROSAC", "TERMINATION_P_NAPSAC", "TERMINATION_SPRT", "TERMINATION_STANDARD", "TerminationFlags", "USACV20",
    "USACV20_ACCURATE", "USACV20_FAST", "USACV20_MAGSAC", "USACV20_PARALLEL", "USACV20_PROSAC", "UsacParams",
    "UsacV20Method", "VERIFICATION_NONE", "VERIFICATION_SPRT", "VERIFICATION_TDD", "VerificationType", "error",
    "estimateAbsolutePose", "estimateAbsolutePoses", "estimateAffine2D", "estimateAffinePartial2D", "estimateAffinities2D",
    "estimateAffinity2D", "estimateEssential", "estimateEssentials", "estimateFundamental", "estimateFundamentals",
    "estimateHomographies", "estimateHomography", "estimateRigid3D", "estimateRigids3D", "estimateSimilarities2D",
    "estimateSimilarities3D", "estimateSimilarity2D", "estimateSimilarity3D", "findEssentialMat", "findFundamentalMat",
    "findHomography", "isUsacV20Method", "patch_cv2", "removeDistortion", "solvePnPRansac", "unpatch_cv2"]

if TYPE_CHECKING:
    class error(Exception):
        """A mistake in the arguments, named in the message; a subclass of cv2.error where cv2 can be imported."""

        code: int
        err: str
        file: str
        func: str
        line: int
        msg: str


def isUsacV20Method(method: int) -> bool:
    """True for the values of UsacV20Method."""
    return bool(_compiled.isUsacV20Method(method))


def __getattr__(name: str) -> Any:
    if name == "error":  # made when it is needed first, as this may import cv2
        return _errorClass()
    raise AttributeError("module {!r} has no attribute {!r}".format(__name__, name))


def __dir__() -> List[str]:
    return sorted(set(globals()) | {"error"})


if not TYPE_CHECKING and _IN_TREE:
    import cv2 as _cv2

    from ._opencv import Patch as _Patch

    _patch = _Patch(_cv2, permanent=True)
else:
    from ._components import Components, Correspondences, Rng, Sampler, Score, Usac

    __all__ += ["Components", "Correspondences", "Rng", "Sampler", "Score", "Usac"]
