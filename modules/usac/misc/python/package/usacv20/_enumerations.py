# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""The enumerations of the module; each enumerator is also a constant of the package, usacv20.QUALITY_MSAC, say."""

import enum


class UsacV20Method(enum.IntEnum):
    """Presets, selected by a flag in the place of cv2.RANSAC."""

    USACV20 = 0x4000  # the default: Params.usacV20()
    USACV20_FAST = 0x4001  # early stop, short local optimization: Params.fast()
    USACV20_ACCURATE = 0x4002  # late stop, long local optimization: Params.accurate()
    USACV20_PROSAC = 0x4003  # the points are sorted, best first: Params.sorted()
    USACV20_MAGSAC = 0x4004  # marginalized over the noise: Params.magsacPlusPlus()
    USACV20_PARALLEL = 0x4005  # the default with all threads: Params.parallel()
    USACV20_AUTO = 0x4006  # the threshold is estimated, the given one is the largest plausible: Params.automatic()


class ProblemType(enum.IntEnum):
    """The model that is estimated."""

    HOMOGRAPHY = 0  # 3x3, from 4 or more correspondences
    FUNDAMENTAL = 1  # 3x3, from 7 or more
    ESSENTIAL = 2  # 3x3, from 5 or more of calibrated cameras
    AFFINITY = 3  # 2x3, from 3 or more
    SIMILARITY = 4  # 2x3, from 2 or more
    ABSOLUTE_POSE = 5  # 3x4, from 3 or more points of space and their images
    RIGID_3D = 6  # 3x4, from 3 or more pairs of points of space
    SIMILARITY_3D = 7  # the same with a uniform scale


class ThresholdType(enum.IntEnum):
    """What Params.threshold means."""

    THRESHOLD_GIVEN = 0  # the inlier threshold
    THRESHOLD_ESTIMATED = 1  # the largest plausible one; from the noise of the inliers follow Report.threshold and Report.sigma


class SamplerType(enum.IntEnum):
    """How minimal samples are drawn."""

    SAMPLER_UNIFORM = 0  # all points are equally likely
    SAMPLER_PROSAC = 1  # the best points first, then ever more of them
    SAMPLER_P_NAPSAC = 2  # the best point first and its neighbors, ever wider
    SAMPLER_NAPSAC = 3  # any point and its neighbors
    SAMPLER_IMPORTANCE = 4  # points as often as Params.scores, probabilities of being right, say


class NeighborhoodType(enum.IntEnum):
    """Which points are neighbors in the joint space (x1, y1, x2, y2)."""

    NEIGHBORHOOD_GRID = 0  # the same cell of a grid
    NEIGHBORHOOD_KNN = 1  # the Params.neighbors nearest points
    NEIGHBORHOOD_RADIUS = 2  # the points within Params.neighborRadius pixels


class ResidualType(enum.IntEnum):
    """Which error of a point is minimized and compared with the threshold."""

    RESIDUAL_STANDARD = 0  # transfer error in image 2 (H, maps, space), Sampson distance (F, E), reprojection error (pose)
    RESIDUAL_SYMMETRIC = 1  # H, maps: transfer errors in both images; F, E: distances to both epipolar lines


class OrderingType(enum.IntEnum):
    """Where the order of the points ("best first") comes from."""

    ORDERING_AUTO = 0  # Params.scores where given, else the local density
    ORDERING_DENSITY = 1  # densest places first
    ORDERING_INPUT_ORDER = 2  # the caller has sorted the points, best first; Params.scores, where given, are the order
    ORDERING_NONE = 3  # a fixed pseudo-random order


class ScoreOrder(enum.IntEnum):
    """Which end of Params.scores is the good one."""

    SCORES_LOWER_IS_BETTER = 0  # descriptor distances, ratios of distances
    SCORES_HIGHER_IS_BETTER = 1  # similarities, probabilities


class QualityType(enum.IntEnum):
    """How a model is rated."""

    QUALITY_INLIERS = 0  # number of inliers
    QUALITY_MSAC = 1  # sum of truncated squared errors
    QUALITY_MLESAC = 2  # likelihood of Gaussian inliers and uniform outliers
    QUALITY_LMEDS = 3  # median of the squared errors; finds the threshold itself
    QUALITY_MAGSAC = 4  # likelihood marginalized over the scale of the noise
    QUALITY_MAGSAC_PLUS_PLUS = 5  # robust loss of the marginalized weights


class VerificationType(enum.IntEnum):
    """How bad models are dropped early."""

    VERIFICATION_NONE = 0  # every model sees all points
    VERIFICATION_SPRT = 1  # Wald's sequential probability ratio test
    VERIFICATION_TDD = 2  # the first Params.tddPoints points must be inliers


class LocalOptimizationType(enum.IntEnum):
    """What improves each so-far-the-best model."""

    LOCAL_OPTIMIZATION_NONE = 0  # nothing
    LOCAL_OPTIMIZATION_GRAPH_CUT = 1  # LO-RANSAC's first steps; where they gain, graph cut and inner RANSAC
    LOCAL_OPTIMIZATION_LO_RANSAC = 2  # inner RANSAC, least squares with a shrinking threshold
    LOCAL_OPTIMIZATION_FLO_RANSAC = 3  # the same on a bounded number of inliers
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS = 4  # fits marginalized over the scale of the noise
    LOCAL_OPTIMIZATION_SIGMA_CONSENSUS_PLUS_PLUS = 5  # re-weighted fits with marginalized weights
    LOCAL_OPTIMIZATION_GC_RANSAC = 6  # graph cut and inner RANSAC in turn, while the model becomes better


class TerminationFlags(enum.IntFlag):
    """What ends the search, a set of bits; the first that fires wins."""

    TERMINATION_STANDARD = 1  # no better model with probability Params.confidence
    TERMINATION_SPRT = 2  # the same, with the errors of SPRT accounted for
    TERMINATION_P_NAPSAC = 4  # no significantly better model, see Params.relaxation
    TERMINATION_PROSAC = 8  # maximality and non-randomness in the best subset of the points
    TERMINATION_MAGSAC = 16  # the standard criterion marginalized over the noise
    TERMINATION_EXACT = 32  # modifies the others: samples without repetition
    TERMINATION_ORDER = 64  # PROSAC's criterion, where the best model confirms the order of the points


class DegeneracyFlags(enum.IntFlag):
    """Degenerate configurations that are looked for, a set of bits; all bits: all checks that the problem has."""

    DEGENERACY_ORIENTATION = 1  # orientation of the sample, oriented epipolar constraint
    DEGENERACY_DEGENSAC = 2  # F: samples dominated by a plane; E: inliers on a plane
    DEGENERACY_REPEATED = 4  # matches that share a point


class PolishingType(enum.IntEnum):
    """What is done to the best model at the end (Algorithm 1, last line)."""

    POLISHING_NONE = 0  # nothing
    POLISHING_LEAST_SQUARES = 1  # least squares over all inliers, until they settle
    POLISHING_REWEIGHTED = 2  # re-weighted least squares with the weights of MAGSAC++
    POLISHING_ROBUST = 3  # least squares with a robust loss that fits the noise


class StopReason(enum.IntEnum):
    """Why an estimation ended."""

    STOP_NOT_RUN = 0  # nothing has been run
    STOP_TOO_FEW_POINTS = 1  # fewer finite correspondences than a minimal sample: no model
    STOP_NO_MODEL = 2  # no sample gave a model with more inliers than a sample: no model
    STOP_MAX_ITERATIONS = 3  # Params.maxIterations reached
    STOP_STANDARD = 4  # TERMINATION_STANDARD fired
    STOP_SPRT = 5  # TERMINATION_SPRT fired
    STOP_P_NAPSAC = 6  # TERMINATION_P_NAPSAC fired
    STOP_CUSTOM = 7  # a criterion of the caller's fired
    STOP_PROSAC = 8  # TERMINATION_PROSAC fired
    STOP_MAGSAC = 9  # TERMINATION_MAGSAC fired
    STOP_NOT_SIGNIFICANT = 10  # no more support than random points give, see Params.significance: no model
    STOP_ORDER = 11  # TERMINATION_ORDER fired
    STOP_TIME = 12  # Params.maxTime is over: the model is the best one by then, or there is none yet
    STOP_CANCELLED = 13  # the function of usacv20.progress returned False; the same
    STOP_NO_SEARCH = 14  # of fitModel and refineModel: nothing was searched


class TwoViewConfiguration(enum.IntEnum):
    """What two images are to each other, with COLMAP's numbers."""

    TWO_VIEW_UNDEFINED = 0  # nothing is known: the arguments are wrong, or the estimation was cancelled
    TWO_VIEW_DEGENERATE = 1  # no model is good enough
    TWO_VIEW_CALIBRATED = 2  # an essential matrix, and a pose
    TWO_VIEW_UNCALIBRATED = 3  # a fundamental matrix: the focal lengths are not known, or are wrong
    TWO_VIEW_PLANAR = 4  # a plane, seen by calibrated cameras that have moved
    TWO_VIEW_PANORAMIC = 5  # a calibrated camera that has only turned
    TWO_VIEW_PLANAR_OR_PANORAMIC = 6  # one of these two, of cameras whose focal lengths are not known
    TWO_VIEW_WATERMARK = 7  # matches in the border of both images that stay where they are


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
