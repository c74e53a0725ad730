# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""USACv20: robust estimation of homographies, affinities, similarities, fundamental and essential
matrices, camera poses, and motions between sets of 3-D points.

The package is cv2.usacv20 in an OpenCV that was built with the module, and usacv20 if it was
installed by itself. The latter works with any cv2 and without cv2. The package offers:

1. Flags: USACV20, USACV20_FAST, USACV20_ACCURATE, USACV20_AUTO, USACV20_PROSAC, USACV20_MAGSAC,
   USACV20_PARALLEL, and the flags of OpenCV. With USACV20_AUTO, the given threshold is only an upper
   limit; the estimated threshold is report.threshold.

    H, mask = usacv20.findHomography(points1, points2, usacv20.USACV20, 3.0)

The flags are integers. The functions of cv2 accept the flags, too: always in an OpenCV built with
the module (cv2.USACV20), in any other cv2 after usacv20.patch_cv2(). In any other cv2 without
patch_cv2(), findFundamentalMat and findEssentialMat run LMEDS for these flags, without an error
message.

2. All options (Params) in place of the flag.
3. A report on the run: its statistics, and the uncertainty of the model.

    params = usacv20.Params(threshold=2.0, scores=[match.distance for match in matches])
    H, mask = usacv20.findHomography(points1, points2, params)
    H, mask, report = usacv20.estimateHomography(points1, points2, params)

estimateHomographies and similar functions process many pairs of images in one call; python3 -m
usacv20.collection processes all pairs of a collection of images. draw_matches makes a picture of
the matches. For research, the class Usac runs a search whose sampler and score can be replaced with
Python code (Sampler, Score). These three classes are not in cv2.usacv20. Other components can be
replaced in C++ only.

fitModel (like OpenCV's method 0), refineModel and modelErrors fit, refine and evaluate a model
without a search. estimateRelativePose finds the motion of a calibrated camera between two views;
its inliers are in front of both cameras. A run can be ended after Params.maxTime milliseconds, by
the function of usacv20.progress, or by Ctrl-C (in cv2.usacv20 only within usacv20.progress).

If there is no model, the model is None, all entries of the mask are 0, and report.stop gives the
reason. report.chance is an upper bound of the probability that random matches give an equally good
model. An invalid argument raises usacv20.error, whose message names the argument; this exception is
a subclass of cv2.error if cv2 can be imported. A call that is valid but probably has a wrong camera
matrix or unit of the threshold gives a usacv20.UsacWarning; report.warning has its text. The global interpreter lock is released during an
estimation; with cv2.usacv20, other threads must not change the points or the Params during this
time.

See also help(usacv20.Params), help(usacv20.Report), and help on enumerations, such as
help(usacv20.QualityType)."""

from . import _start as _start  # first
import importlib as _importlib
from typing import TYPE_CHECKING, Any, List

from ._backend import IN_TREE as _IN_TREE
from ._backend import native as _compiled
from ._covariance import covarianceOfModel, covarianceOfPose, pointCovariance, tangentOfModel
from ._draw import draw_matches
from ._enumerations import *  # noqa: F403
from ._errors import UsacWarning
from ._errors import errorClass as _errorClass
from ._essential import findEssentialMat
from ._estimate import estimateModel
from ._find import estimateAffine2D, estimateAffinePartial2D, findFundamentalMat, findHomography
from ._given import fitModel, modelErrors, refineModel
from ._lens import removeDistortion
from ._opencv import patch_cv2, unpatch_cv2
from ._params import Params
from ._pose import solvePnPRansac
from ._problems import *  # noqa: F403
from ._progress import progress
from ._relative_pose import RelativePose, estimateRelativePose
from ._report import Report
from ._two_view import TwoViewGeometry, TwoViewPair, TwoViewRules, estimateTwoViewGeometries, estimateTwoViewGeometry
# These names are exported, but are not in __all__, so that help() does not show them. Type checkers
# treat a name as exported if it is imported in the form `NAME as NAME`.
from ._enumerations import (
    DegeneracyFlags as DegeneracyFlags, LocalOptimizationType as LocalOptimizationType,
    NeighborhoodType as NeighborhoodType, OrderingType as OrderingType, PolishingType as PolishingType,
    ProblemType as ProblemType, QualityType as QualityType, ResidualType as ResidualType, SamplerType as SamplerType,
    ScoreOrder as ScoreOrder, StopReason as StopReason, TerminationFlags as TerminationFlags,
    ThresholdType as ThresholdType, TwoViewConfiguration as TwoViewConfiguration,
    UsacV20Method as UsacV20Method, VerificationType as VerificationType)
from ._params import UsacParams as UsacParams
from ._version import __version__

__all__ = [
    "Params", "RelativePose", "Report", "TwoViewGeometry", "TwoViewPair", "TwoViewRules", "UsacWarning",
    "covarianceOfModel", "covarianceOfPose", "draw_matches", "estimateAffine2D", "estimateAffinePartial2D", "estimateModel", "estimateRelativePose",
    "estimateTwoViewGeometries", "estimateTwoViewGeometry", "findEssentialMat", "findFundamentalMat", "findHomography",
    "fitModel", "isUsacV20Method", "modelErrors", "patch_cv2", "pointCovariance", "progress", "refineModel",
    "removeDistortion", "solvePnPRansac", "tangentOfModel", "unpatch_cv2"]
# What follows is written by misc/python/make_names.py.
__all__ += [
    "ABSOLUTE_POSE", "AFFINITY", "DEGENERACY_DEGENSAC", "DEGENERACY_ORIENTATION", "DEGENERACY_REPEATED", "ESSENTIAL",
    "FUNDAMENTAL", "HOMOGRAPHY", "LOCAL_OPTIMIZATION_FLO_RANSAC", "LOCAL_OPTIMIZATION_GC_RANSAC",
    "LOCAL_OPTIMIZATION_GRAPH_CUT", "LOCAL_OPTIMIZATION_LO_RANSAC", "LOCAL_OPTIMIZATION_NONE",
    "LOCAL_OPTIMIZATION_SIGMA_CONSENSUS", "LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS", "NEIGHBORHOOD_GRID",
    "NEIGHBORHOOD_KNN", "NEIGHBORHOOD_RADIUS", "ORDERING_AUTO", "ORDERING_DENSITY", "ORDERING_INPUT_ORDER", "ORDERING_NONE",
    "POLISHING_LEAST_SQUARES", "POLISHING_NONE", "POLISHING_REWEIGHTED", "POLISHING_ROBUST", "QUALITY_INLIERS",
    "QUALITY_LMEDS", "QUALITY_MAGSAC", "QUALITY_MAGSAC_PLUS_PLUS", "QUALITY_MLESAC", "QUALITY_MSAC", "RESIDUAL_STANDARD",
    "RESIDUAL_SYMMETRIC", "RIGID_3D", "SAMPLER_IMPORTANCE", "SAMPLER_NAPSAC", "SAMPLER_PROSAC", "SAMPLER_P_NAPSAC",
    "SAMPLER_UNIFORM", "SCORES_HIGHER_IS_BETTER", "SCORES_LOWER_IS_BETTER", "SIMILARITY", "SIMILARITY_3D", "STOP_CANCELLED",
    "STOP_CUSTOM", "STOP_MAGSAC", "STOP_MAX_ITERATIONS", "STOP_NOT_RUN", "STOP_NOT_SIGNIFICANT", "STOP_NO_MODEL",
    "STOP_NO_SEARCH", "STOP_ORDER", "STOP_PROSAC", "STOP_P_NAPSAC", "STOP_SPRT", "STOP_STANDARD", "STOP_TIME",
    "STOP_TOO_FEW_POINTS", "TERMINATION_EXACT", "TERMINATION_MAGSAC", "TERMINATION_ORDER", "TERMINATION_PROSAC",
    "TERMINATION_P_NAPSAC", "TERMINATION_SPRT", "TERMINATION_STANDARD", "THRESHOLD_ESTIMATED", "THRESHOLD_GIVEN",
    "TRANSLATION_2D", "TWO_VIEW_CALIBRATED", "TWO_VIEW_DEGENERATE", "TWO_VIEW_PANORAMIC", "TWO_VIEW_PLANAR",
    "TWO_VIEW_PLANAR_OR_PANORAMIC", "TWO_VIEW_UNCALIBRATED", "TWO_VIEW_UNDEFINED", "TWO_VIEW_WATERMARK", "USACV20",
    "USACV20_ACCURATE", "USACV20_AUTO", "USACV20_FAST", "USACV20_MAGSAC", "USACV20_PARALLEL", "USACV20_PROSAC",
    "VERIFICATION_NONE", "VERIFICATION_SPRT", "VERIFICATION_TDD", "estimateAbsolutePose", "estimateAbsolutePoses",
    "estimateAffinities2D", "estimateAffinity2D", "estimateEssential", "estimateEssentials", "estimateFundamental",
    "estimateFundamentals", "estimateHomographies", "estimateHomography", "estimateRigid3D", "estimateRigids3D",
    "estimateSimilarities2D", "estimateSimilarities3D", "estimateSimilarity2D", "estimateSimilarity3D",
    "estimateTranslation2D", "estimateTranslations2D"]
# End of the names written by misc/python/make_names.py.

if TYPE_CHECKING:
    class error(Exception):
        """Raised for an invalid argument, which the message names. It is a subclass of cv2.error if
        cv2 can be imported."""

        code: int
        err: str
        file: str
        func: str
        line: int
        msg: str


def isUsacV20Method(method: int) -> bool:
    """Returns True if the number is a value of UsacV20Method."""
    return bool(_compiled.isUsacV20Method(method))


def __getattr__(name: str) -> Any:
    if name == "error":  # the class is created at its first use, because creating it imports cv2 if possible
        return _errorClass()
    if name == "collection":  # allows usacv20.collection.verify(path) after `import usacv20` alone
        return _importlib.import_module(__name__ + ".collection")
    raise AttributeError("module {!r} has no attribute {!r}".format(__name__, name))


def __dir__() -> List[str]:
    return sorted(set(globals()) | {"error"})


if not TYPE_CHECKING and _IN_TREE:
    import cv2 as _cv2

    from ._opencv import Patch as _Patch

    _patch = _Patch(_cv2, permanent=True)
else:
    from ._components import (Components as Components, Correspondences as Correspondences, Rng as Rng, Sampler as Sampler,
                              Score as Score, Usac as Usac)
