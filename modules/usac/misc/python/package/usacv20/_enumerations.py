# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The enumerations of the module. Each enumerator is also a constant of the package, such as usacv20.QUALITY_MSAC."""

# Written by misc/python/make_names.py. Edit that script or the headers instead of this file.

import enum
from typing import Dict

__all__ = [
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
    "VERIFICATION_NONE", "VERIFICATION_SPRT", "VERIFICATION_TDD"]


class UsacV20Method(enum.IntEnum):
    """Presets of the module, passed as the method flag of cv2.findHomography, cv2.findFundamentalMat, cv2.findEssentialMat,
    cv2.estimateAffine2D and cv2.estimateAffinePartial2D, or as the argument flags of cv2.solvePnPRansac."""

    USACV20 = 0x4000  # the configuration of the paper, with robust polishing; Params.usacV20()
    USACV20_FAST = 0x4001  # early termination and a short local optimization; Params.fast()
    USACV20_ACCURATE = 0x4002  # late termination and a long local optimization; Params.accurate()
    USACV20_PROSAC = 0x4003  # for points that the caller has sorted, best first; Params.sorted()
    USACV20_MAGSAC = 0x4004  # MAGSAC++: score and fits marginalized over the noise scale; Params.magsacPlusPlus()
    USACV20_PARALLEL = 0x4005  # USACV20 with cv2.getNumThreads() threads and the same result; Params.parallel()
    USACV20_AUTO = 0x4006  # the threshold is estimated from the data; the given value is its upper bound; Params.automatic()


class ProblemType(enum.IntEnum):
    """The model that is estimated."""

    HOMOGRAPHY = 0  # 3x3 homography from 4 or more correspondences
    FUNDAMENTAL = 1  # 3x3 fundamental matrix from 7 or more correspondences
    ESSENTIAL = 2  # 3x3 essential matrix from 5 or more correspondences of calibrated cameras
    AFFINITY = 3  # 2x3 affine map from 3 or more correspondences
    SIMILARITY = 4  # 2x3 rotation, uniform scale and translation from 2 or more correspondences
    ABSOLUTE_POSE = 5  # 3x4 pose of a calibrated camera from 3 or more 3-D points
    RIGID_3D = 6  # 3x4 rotation and translation from 3 or more pairs of 3-D points
    SIMILARITY_3D = 7  # like RIGID_3D, with a uniform scale
    TRANSLATION_2D = 8  # 2x3 translation from 1 or more correspondences


class ThresholdType(enum.IntEnum):
    """What Params.threshold means."""

    THRESHOLD_GIVEN = 0  # the inlier threshold
    # threshold is the largest plausible inlier threshold, for example three to ten times the usual one
    THRESHOLD_ESTIMATED = 1


class SamplerType(enum.IntEnum):
    """How minimal samples are drawn."""

    SAMPLER_UNIFORM = 0  # all points are equally likely
    SAMPLER_PROSAC = 1  # from a growing set of the best points
    SAMPLER_P_NAPSAC = 2  # P-NAPSAC: a point of PROSAC's set and others from its growing neighborhood
    SAMPLER_NAPSAC = 3  # a random point and some of its neighbors
    SAMPLER_IMPORTANCE = 4  # each point with probability proportional to Params.scores, for example inlier probabilities


class NeighborhoodType(enum.IntEnum):
    """Which points are neighbors in the joint space of both arrays, such as (x1, y1, x2, y2)."""

    NEIGHBORHOOD_GRID = 0  # points in the same cell of a grid with layers of finer and coarser cells
    NEIGHBORHOOD_KNN = 1  # the Params.neighbors nearest points, through cv2.flann
    NEIGHBORHOOD_RADIUS = 2  # the points within Params.neighborRadius pixels, through cv2.flann


class ResidualType(enum.IntEnum):
    """The error of a point, which is minimized and compared with the threshold."""

    # H, affine maps: transfer error in image 2. F, E: Sampson distance. Absolute pose: reprojection error in the original
    # (distorted) image. 3-D motions: distance between a mapped point and its counterpart
    RESIDUAL_STANDARD = 0
    # H, affine maps: root of the sum of the squared transfer errors in both images. F, E: root of the sum of the squared
    # distances to both epipolar lines. Absolute pose, 3-D motions: raises usacv20.error
    RESIDUAL_SYMMETRIC = 1


class OrderingType(enum.IntEnum):
    """Where the order of the points ("best first") comes from."""

    ORDERING_AUTO = 0  # Params.scores if given, else the local density
    ORDERING_DENSITY = 1  # local density of the points in the joint space, densest first
    # the caller has sorted the points, best first; if Params.scores are given, they determine the order instead
    ORDERING_INPUT_ORDER = 2
    ORDERING_NONE = 3  # a fixed pseudo-random order


class ScoreOrder(enum.IntEnum):
    """Whether low or high Params.scores are good."""

    SCORES_LOWER_IS_BETTER = 0  # descriptor distances, distance ratios
    SCORES_HIGHER_IS_BETTER = 1  # similarities, probabilities


class QualityType(enum.IntEnum):
    """How a model is scored."""

    QUALITY_INLIERS = 0  # number of inliers
    QUALITY_MSAC = 1  # sum of truncated squared errors
    QUALITY_MLESAC = 2  # likelihood under a mixture of Gaussian inliers and uniform outliers
    QUALITY_LMEDS = 3  # median of the squared errors; the threshold of the mask is estimated
    QUALITY_MAGSAC = 4  # likelihood marginalized over the noise scale
    QUALITY_MAGSAC_PLUS_PLUS = 5  # the robust loss whose weights are marginalized over the noise scale


class VerificationType(enum.IntEnum):
    """How bad models are rejected early."""

    VERIFICATION_NONE = 0  # no test; scoring ends early only when the cost becomes too high
    VERIFICATION_SPRT = 1  # Wald's sequential probability ratio test
    VERIFICATION_TDD = 2  # Params.tddPoints random points must be inliers


class LocalOptimizationType(enum.IntEnum):
    """How each model that is better than all before is improved."""

    LOCAL_OPTIMIZATION_NONE = 0  # nothing
    # least squares with a shrinking threshold; then, if the model clearly beats the best model so far, graph cut and inner
    # RANSAC
    LOCAL_OPTIMIZATION_GRAPH_CUT = 1
    LOCAL_OPTIMIZATION_LO_RANSAC = 2  # inner RANSAC and least squares with a shrinking threshold
    LOCAL_OPTIMIZATION_FLO_RANSAC = 3  # like LO-RANSAC, with fits of bounded size
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = 4  # fits marginalized over the noise scale
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = 5  # re-weighted fits with marginalized weights
    LOCAL_OPTIMIZATION_GC_RANSAC = 6  # graph cut and inner RANSAC alternately, as long as the model improves; see Params.paper


class TerminationFlags(enum.IntFlag):
    """Termination criteria, a set of bits; the first that fires ends the search."""

    TERMINATION_STANDARD = 1  # with probability confidence there is no better model
    TERMINATION_SPRT = 2  # the standard criterion, allowing for good models that SPRT rejects
    TERMINATION_P_NAPSAC = 4  # with probability confidence there is no significantly better model, see Params.relaxation
    TERMINATION_PROSAC = 8  # PROSAC's maximality and non-randomness on a set of best points
    TERMINATION_MAGSAC = 16  # the standard criterion marginalized over the noise scale
    # modifies the other criteria: with I inliers among N points, a sample of m points, drawn without replacement, is
    # all-inlier with probability C(I, m) / C(N, m) instead of (I / N)^m
    TERMINATION_EXACT = 32
    # PROSAC's criterion, if inliers of the best model come early in a known order and samples drawn from its outliers yield no
    # better model; takes effect only with PROSAC or P-NAPSAC, local optimization, orderedEvery above 1 and runnersUp above 0
    TERMINATION_ORDER = 64


class DegeneracyFlags(enum.IntFlag):
    """Checks for degenerate configurations, a set of bits."""

    DEGENERACY_ORIENTATION = 1  # H: orientation of the sample; F, E: oriented epipolar constraint
    # F of a sample on a plane: plane and parallax. E with TERMINATION_EXACT: twice as many samples if most inliers are on a
    # plane. Pose: the second pose of a plane
    DEGENERACY_DEGENSAC = 2
    # rejects samples in which two matches have the same point in an array (nearly the same, if there are many such matches);
    # many matches to one point, or many copies of one match, count as a single inlier
    DEGENERACY_REPEATED = 4


class PolishingType(enum.IntEnum):
    """How the best model is refined at the end (Algorithm 1, last line)."""

    POLISHING_NONE = 0  # nothing
    # least squares of the geometric error over all inliers, repeated while this improves the model
    POLISHING_LEAST_SQUARES = 1
    POLISHING_REWEIGHTED = 2  # iteratively re-weighted least squares with the weights of MAGSAC++
    # least squares with a robust loss adapted to the noise of the inliers; few inliers: from several initial models
    POLISHING_ROBUST = 3


class StopReason(enum.IntEnum):
    """Why an estimation ended."""

    STOP_NOT_RUN = 0  # no estimation has been run
    STOP_TOO_FEW_POINTS = 1  # fewer different, finite correspondences than a minimal sample: no model
    STOP_NO_MODEL = 2  # no sample yielded a model with enough inliers (degenerate data)
    STOP_MAX_ITERATIONS = 3  # Params.maxIterations was reached
    STOP_STANDARD = 4  # TERMINATION_STANDARD fired, or practically all possible samples have been drawn
    STOP_SPRT = 5  # TERMINATION_SPRT fired
    STOP_P_NAPSAC = 6  # TERMINATION_P_NAPSAC fired
    STOP_CUSTOM = 7  # a Termination component of the caller fired
    STOP_PROSAC = 8  # TERMINATION_PROSAC fired
    STOP_MAGSAC = 9  # TERMINATION_MAGSAC fired
    # no model is returned: the best one has no more inliers than random matches can yield, see Params.significance
    STOP_NOT_SIGNIFICANT = 10
    STOP_ORDER = 11  # TERMINATION_ORDER fired
    STOP_TIME = 12  # Params.maxTime was reached: the model, if any, is the best so far
    STOP_CANCELLED = 13  # the function of a ProgressScope returned false: the model, if any, is the best so far
    STOP_NO_SEARCH = 14  # result of Usac.fit or Usac.refine, which do not search


class TwoViewConfiguration(enum.IntEnum):
    """The relation between two images, with the names and numbers of COLMAP's table two_view_geometries."""

    TWO_VIEW_UNDEFINED = 0  # unknown: the estimation was canceled, or it raised an exception (batches)
    TWO_VIEW_DEGENERATE = 1  # no model is good enough, see TwoViewGeometry.reason
    TWO_VIEW_CALIBRATED = 2  # essential matrix and relative pose
    TWO_VIEW_UNCALIBRATED = 3  # fundamental matrix: the focal lengths are unknown or wrong
    TWO_VIEW_PLANAR = 4  # plane seen by calibrated cameras with a baseline
    TWO_VIEW_PANORAMIC = 5  # pure rotation of a calibrated camera
    TWO_VIEW_PLANAR_OR_PANORAMIC = 6  # plane or pure rotation; the focal lengths are unknown or wrong
    TWO_VIEW_WATERMARK = 7  # most inliers are at the borders of both images, with a common shift


USACV20 = UsacV20Method.USACV20
USACV20_FAST = UsacV20Method.USACV20_FAST
USACV20_ACCURATE = UsacV20Method.USACV20_ACCURATE
USACV20_PROSAC = UsacV20Method.USACV20_PROSAC
USACV20_MAGSAC = UsacV20Method.USACV20_MAGSAC
USACV20_PARALLEL = UsacV20Method.USACV20_PARALLEL
USACV20_AUTO = UsacV20Method.USACV20_AUTO
HOMOGRAPHY = ProblemType.HOMOGRAPHY
FUNDAMENTAL = ProblemType.FUNDAMENTAL
ESSENTIAL = ProblemType.ESSENTIAL
AFFINITY = ProblemType.AFFINITY
SIMILARITY = ProblemType.SIMILARITY
ABSOLUTE_POSE = ProblemType.ABSOLUTE_POSE
RIGID_3D = ProblemType.RIGID_3D
SIMILARITY_3D = ProblemType.SIMILARITY_3D
TRANSLATION_2D = ProblemType.TRANSLATION_2D
THRESHOLD_GIVEN = ThresholdType.THRESHOLD_GIVEN
THRESHOLD_ESTIMATED = ThresholdType.THRESHOLD_ESTIMATED
SAMPLER_UNIFORM = SamplerType.SAMPLER_UNIFORM
SAMPLER_PROSAC = SamplerType.SAMPLER_PROSAC
SAMPLER_P_NAPSAC = SamplerType.SAMPLER_P_NAPSAC
SAMPLER_NAPSAC = SamplerType.SAMPLER_NAPSAC
SAMPLER_IMPORTANCE = SamplerType.SAMPLER_IMPORTANCE
NEIGHBORHOOD_GRID = NeighborhoodType.NEIGHBORHOOD_GRID
NEIGHBORHOOD_KNN = NeighborhoodType.NEIGHBORHOOD_KNN
NEIGHBORHOOD_RADIUS = NeighborhoodType.NEIGHBORHOOD_RADIUS
RESIDUAL_STANDARD = ResidualType.RESIDUAL_STANDARD
RESIDUAL_SYMMETRIC = ResidualType.RESIDUAL_SYMMETRIC
ORDERING_AUTO = OrderingType.ORDERING_AUTO
ORDERING_DENSITY = OrderingType.ORDERING_DENSITY
ORDERING_INPUT_ORDER = OrderingType.ORDERING_INPUT_ORDER
ORDERING_NONE = OrderingType.ORDERING_NONE
SCORES_LOWER_IS_BETTER = ScoreOrder.SCORES_LOWER_IS_BETTER
SCORES_HIGHER_IS_BETTER = ScoreOrder.SCORES_HIGHER_IS_BETTER
QUALITY_INLIERS = QualityType.QUALITY_INLIERS
QUALITY_MSAC = QualityType.QUALITY_MSAC
QUALITY_MLESAC = QualityType.QUALITY_MLESAC
QUALITY_LMEDS = QualityType.QUALITY_LMEDS
QUALITY_MAGSAC = QualityType.QUALITY_MAGSAC
QUALITY_MAGSAC_PLUS_PLUS = QualityType.QUALITY_MAGSAC_PLUS_PLUS
VERIFICATION_NONE = VerificationType.VERIFICATION_NONE
VERIFICATION_SPRT = VerificationType.VERIFICATION_SPRT
VERIFICATION_TDD = VerificationType.VERIFICATION_TDD
LOCAL_OPTIMIZATION_NONE = LocalOptimizationType.LOCAL_OPTIMIZATION_NONE
LOCAL_OPTIMIZATION_GRAPH_CUT = LocalOptimizationType.LOCAL_OPTIMIZATION_GRAPH_CUT
LOCAL_OPTIMIZATION_LO_RANSAC = LocalOptimizationType.LOCAL_OPTIMIZATION_LO_RANSAC
LOCAL_OPTIMIZATION_FLO_RANSAC = LocalOptimizationType.LOCAL_OPTIMIZATION_FLO_RANSAC
LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = LocalOptimizationType.LOCAL_OPTIMIZATION_SIGMA_CONSENSUS
LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = LocalOptimizationType.LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS
LOCAL_OPTIMIZATION_GC_RANSAC = LocalOptimizationType.LOCAL_OPTIMIZATION_GC_RANSAC
TERMINATION_STANDARD = TerminationFlags.TERMINATION_STANDARD
TERMINATION_SPRT = TerminationFlags.TERMINATION_SPRT
TERMINATION_P_NAPSAC = TerminationFlags.TERMINATION_P_NAPSAC
TERMINATION_PROSAC = TerminationFlags.TERMINATION_PROSAC
TERMINATION_MAGSAC = TerminationFlags.TERMINATION_MAGSAC
TERMINATION_EXACT = TerminationFlags.TERMINATION_EXACT
TERMINATION_ORDER = TerminationFlags.TERMINATION_ORDER
DEGENERACY_ORIENTATION = DegeneracyFlags.DEGENERACY_ORIENTATION
DEGENERACY_DEGENSAC = DegeneracyFlags.DEGENERACY_DEGENSAC
DEGENERACY_REPEATED = DegeneracyFlags.DEGENERACY_REPEATED
POLISHING_NONE = PolishingType.POLISHING_NONE
POLISHING_LEAST_SQUARES = PolishingType.POLISHING_LEAST_SQUARES
POLISHING_REWEIGHTED = PolishingType.POLISHING_REWEIGHTED
POLISHING_ROBUST = PolishingType.POLISHING_ROBUST
STOP_NOT_RUN = StopReason.STOP_NOT_RUN
STOP_TOO_FEW_POINTS = StopReason.STOP_TOO_FEW_POINTS
STOP_NO_MODEL = StopReason.STOP_NO_MODEL
STOP_MAX_ITERATIONS = StopReason.STOP_MAX_ITERATIONS
STOP_STANDARD = StopReason.STOP_STANDARD
STOP_SPRT = StopReason.STOP_SPRT
STOP_P_NAPSAC = StopReason.STOP_P_NAPSAC
STOP_CUSTOM = StopReason.STOP_CUSTOM
STOP_PROSAC = StopReason.STOP_PROSAC
STOP_MAGSAC = StopReason.STOP_MAGSAC
STOP_NOT_SIGNIFICANT = StopReason.STOP_NOT_SIGNIFICANT
STOP_ORDER = StopReason.STOP_ORDER
STOP_TIME = StopReason.STOP_TIME
STOP_CANCELLED = StopReason.STOP_CANCELLED
STOP_NO_SEARCH = StopReason.STOP_NO_SEARCH
TWO_VIEW_UNDEFINED = TwoViewConfiguration.TWO_VIEW_UNDEFINED
TWO_VIEW_DEGENERATE = TwoViewConfiguration.TWO_VIEW_DEGENERATE
TWO_VIEW_CALIBRATED = TwoViewConfiguration.TWO_VIEW_CALIBRATED
TWO_VIEW_UNCALIBRATED = TwoViewConfiguration.TWO_VIEW_UNCALIBRATED
TWO_VIEW_PLANAR = TwoViewConfiguration.TWO_VIEW_PLANAR
TWO_VIEW_PANORAMIC = TwoViewConfiguration.TWO_VIEW_PANORAMIC
TWO_VIEW_PLANAR_OR_PANORAMIC = TwoViewConfiguration.TWO_VIEW_PLANAR_OR_PANORAMIC
TWO_VIEW_WATERMARK = TwoViewConfiguration.TWO_VIEW_WATERMARK

#: The kind of the arguments of each problem: the column ARGUMENTS of src/problems/registry.inl.hpp.
ARGUMENTS: Dict[int, str] = {
    ProblemType.HOMOGRAPHY: "IMAGES",
    ProblemType.FUNDAMENTAL: "IMAGES",
    ProblemType.ESSENTIAL: "CAMERAS",
    ProblemType.AFFINITY: "IMAGES",
    ProblemType.SIMILARITY: "IMAGES",
    ProblemType.ABSOLUTE_POSE: "POSE",
    ProblemType.RIGID_3D: "SPACES",
    ProblemType.SIMILARITY_3D: "SPACES",
    ProblemType.TRANSLATION_2D: "IMAGES",
}
