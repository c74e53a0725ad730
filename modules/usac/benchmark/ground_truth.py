# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Readers of the ground truth that public data sets publish about their image pairs, one function
for each data set.

Each function takes a folder and returns a list of Truth. It raises DataError if a file is missing or
does not have the expected form. Image coordinates are not changed; (0, 0) is regarded as the center of
the first pixel, because then the annotated points of homogr agree best with matched features."""

import bisect
import glob
import itertools
import os

import numpy as np

from geometry import relative_pose

IMAGE_TYPES = (".png", ".jpg", ".jpeg", ".ppm", ".pgm", ".tif", ".tiff", ".bmp")
_STILL = 1e-3  # meters; a smaller translation between two frames of a video counts as no translation


class DataError(ValueError):
    """Raised if published data are missing or not in the expected form."""


class Camera:
    """A camera x ~ K (R X + t). If only the focal length is published, the principal point of K is the
    middle of the image. `distortion` has OpenCV's coefficients; None: there is no distortion."""

    def __init__(self, image, R, t, K=None, focal=None, distortion=None):
        self.image, self.R, self.t = image, np.asarray(R, float), np.asarray(t, float)
        self.K, self.focal, self.distortion = K, focal, distortion

    def matrix(self, size):
        if self.K is not None:
            return self.K
        return np.array([[self.focal, 0, (size[0] - 1) / 2], [0, self.focal, (size[1] - 1) / 2], [0, 0, 1]])

    @staticmethod
    def of_pose(image, R, center, **more):
        """Returns the camera at `center` whose axes are the columns of R, both in world coordinates."""
        R = np.asarray(R, float).T
        return Camera(image, R, -R @ np.asarray(center, float), **more)


class Truth:
    """The published ground truth of two images, which is one of these: annotated points (M x 4: x1 y1
    x2 y2), H, F, or two cameras. The members for the other three are None."""

    def __init__(self, name, image1, image2, problems, points=None, H=None, F=None, cameras=None):
        self.name, self.image1, self.image2, self.problems = name, image1, image2, problems
        self.points, self.H, self.F, self.cameras = points, H, F, cameras

    @staticmethod
    def of_cameras(name, camera1, camera2):
        return Truth(name, camera1.image, camera2.image, ["E", "F"], cameras=(camera1, camera2))


def homogr(folder):
    """homogr of Lebeda, Matas and Chum: planar scenes, each with about ten correspondences that were
    annotated by hand.

    <folder>/<name>A.<type>, <name>B.<type>: images 1 and 2
    <folder>/<name>_vpts.mat: MATLAB, structure `validation`, whose `pts` is 6 x M: homogeneous
    points of A above those of B"""
    return _annotated(folder, ["H"])


def kusvod2(folder):
    """kusvod2 of Lebeda, Matas and Chum: scenes that are not planar; the files have the form of
    those of homogr."""
    return _annotated(folder, ["F"])


def _annotated(folder, problems):
    truths = []
    for file in _files(folder, "*_vpts.mat"):
        name = os.path.basename(file)[:-len("_vpts.mat")]
        truths.append(Truth(name, _image(folder, name + "A"), _image(folder, name + "B"), problems,
                            points=_validation_points(file)))
    return truths


def _validation_points(file):
    try:
        from scipy.io import loadmat
    except ImportError:
        raise DataError(file + ": reading MATLAB files needs SciPy (Debian: python3-scipy)") from None
    try:
        points = np.asarray(loadmat(file, squeeze_me=True, struct_as_record=False)["validation"].pts, float)
    except (KeyError, AttributeError):
        raise DataError(file + ": no structure 'validation' with a member 'pts'") from None
    except (ValueError, NotImplementedError, TypeError) as error:
        raise DataError("%s: %s" % (file, error)) from None
    if points.ndim != 2 or len(points) != 6:
        raise DataError("%s: validation.pts: expected six rows, found %s" % (file, points.shape))
    return np.column_stack(((points[:2] / points[2]).T, (points[3:5] / points[5]).T))


def evd(folder):
    """EVD, Extreme View Dataset of Mishkin, Matas and Perdoch: planes from very different viewpoints.

    <folder>/1/<name>.<type>, <folder>/2/<name>.<type>: images 1 and 2
    <folder>/h/<name>.txt: homography, image 1 -> image 2, three rows"""
    truths = []
    for file in _files(os.path.join(folder, "h"), "*.txt"):
        name = os.path.basename(file)[:-len(".txt")]
        images = [_image(os.path.join(folder, part), name) for part in "12"]
        truths.append(Truth(name, images[0], images[1], ["H"], H=_numbers(file, (3, 3))))
    return truths


def strecha(folder):
    """The dense multi-view stereo scenes of Strecha et al.; all pairs of images of a scene.

    <scene>/<cameras>/<image>.camera: K (3 x 3), three zeros, R (3 x 3, columns: axes of the
    camera), center, width, height
    <scene>/<images>/<image>, e.g. urd/0000.png next to gt_dense_cameras/0000.png.camera; or both in
    <scene> itself

    <folder> is a scene or contains scenes at any depth."""
    scenes = {}
    for file in _find(folder, lambda name: name.endswith(".camera")):
        root, camera = _strecha_camera(file)
        scenes.setdefault(root, []).append(camera)
    if not scenes:
        raise DataError(folder + ": no *.camera")
    truths = []
    for root, views in sorted(scenes.items()):
        label = os.path.basename(os.path.abspath(root))
        truths += [Truth.of_cameras("%s_%s_%s" % (label, _stem(a.image), _stem(b.image)), a, b)
                   for a, b in itertools.combinations(views, 2)]
    return truths


def _strecha_camera(file):
    """Reads a file *.camera; returns the folder of its scene, and the camera."""
    values = _numbers(file, (26,))
    place, name = os.path.split(file[:-len(".camera")])
    parent = os.path.dirname(os.path.abspath(place))
    if os.path.isfile(os.path.join(place, name)):
        root, images = place, [os.path.join(place, name)]
    else:
        root, images = parent, glob.glob(os.path.join(glob.escape(parent), "*", glob.escape(name)))
    if len(images) != 1:
        raise DataError("%s: expected one image %s beside it, found %d" % (file, name, len(images)))
    return root, Camera.of_pose(images[0], values[12:21].reshape(3, 3), values[21:24], K=values[:9].reshape(3, 3))


def kitti(folder, step=1):
    """KITTI odometry of Geiger, Lenz and Urtasun: the left gray camera, frames i and i + step of each sequence with poses.

    <folder>/poses/<NN>.txt: one frame on each line, 3 x 4, camera -> world
    <folder>/sequences/<NN>/calib.txt: line `P0:`, 3 x 4; <folder>/sequences/<NN>/image_0/<six digits>.png

    A folder with pairs_with_gt.txt is read in the form in which FM-Bench publishes KITTI, see
    tanks_and_temples."""
    if _is_fm_bench(folder):
        return _fm_bench(folder)
    truths = []
    for file in _files(os.path.join(folder, "poses"), "*.txt"):
        sequence = os.path.basename(file)[:-len(".txt")]
        root = os.path.join(folder, "sequences", sequence)
        if not os.path.isdir(root):
            continue
        K = _kitti_matrix(os.path.join(root, "calib.txt"))
        frames = [Camera.of_pose(os.path.join(root, "image_0", "%06d.png" % i), pose[:, :3], pose[:, 3], K=K)
                  for i, pose in enumerate(_numbers(file, (-1, 3, 4)))]
        truths += _consecutive("k" + sequence, frames, ["%06d" % i for i in range(len(frames))], step)
    if not truths:
        raise DataError(folder + ": no sequence with poses")
    return truths


def _kitti_matrix(file):
    for number, words in _lines(file):
        if words[0] == "P0:":
            return _floats(file, number, words[1:], 12).reshape(3, 4)[:, :3]
    raise DataError(file + ": no line 'P0:'")


# fx, fy, cx, cy in pixels, and distortion coefficients of the color cameras (None: no distortion),
# from the page of the data set.
_TUM_CAMERAS = {
    "freiburg1": ((517.3, 516.5, 318.6, 255.3), (0.2624, -0.9531, -0.0054, 0.0026, 1.1633)),
    "freiburg2": ((520.9, 521.0, 325.1, 249.7), (0.2312, -0.7849, -0.0033, -0.0001, 0.9172)),
    "freiburg3": ((535.4, 539.2, 320.1, 247.6), None),
}
_TUM_TOLERANCE = 0.02  # largest time difference of an image and its pose in seconds, as in the tools of the data set


def tum(folder, step=1):
    """TUM RGB-D of Sturm et al.: color images i and i + step of each sequence, among those that
    have a pose.

    <folder>/<name with freiburg1, freiburg2 or freiburg3>/groundtruth.txt: lines `time tx ty tz qx qy qz qw`, camera ->
    world
    <folder>/<the same name>/rgb.txt: lines `time file`

    <folder> can also be the folder of a sequence. The name of this folder determines the camera.

    A folder with pairs_with_gt.txt is read in the form in which FM-Bench publishes TUM, see
    tanks_and_temples."""
    if _is_fm_bench(folder):
        return _fm_bench(folder)
    files = _find(folder, lambda name: name == "groundtruth.txt")
    if not files:
        raise DataError(folder + ": no groundtruth.txt")
    truths = []
    for file in files:
        root = os.path.dirname(os.path.abspath(file))
        name = os.path.basename(root)
        views = _tum_views(root, file)
        truths += _consecutive(name, views, [_stem(v.image) for v in views], step)
    return truths


def _tum_views(root, file):
    camera = [known for name, known in _TUM_CAMERAS.items() if name in os.path.basename(root)]
    if not camera:
        raise DataError(root + ": the name does not say which camera was used; it must contain freiburg1, freiburg2 or freiburg3")
    (fx, fy, cx, cy), distortion = camera[0]
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1.0]])
    poses = np.array(sorted(_floats(file, number, words, 8).tolist() for number, words in _lines(file)))
    if not len(poses):
        raise DataError(file + ": no poses")
    times = poses[:, 0].tolist()
    views = []
    index = os.path.join(root, "rgb.txt")
    for number, words in _lines(index):
        if len(words) != 2:
            raise DataError("%s:%d: expected 'time file'" % (index, number))
        time = _floats(index, number, words[:1], 1)[0]
        at = bisect.bisect(times, time)
        nearest = min((k for k in (at - 1, at) if 0 <= k < len(times)), key=lambda k: abs(times[k] - time))
        if abs(times[nearest] - time) <= _TUM_TOLERANCE:
            pose = poses[nearest]
            views.append(Camera.of_pose(os.path.join(root, words[1]), _quaternion(pose[4:]), pose[1:4], K=K,
                                        distortion=distortion))
    return views


def _quaternion(q):
    x, y, z, w = np.asarray(q) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


def tanks_and_temples(folder):
    """Tanks and Temples of Knapitsch et al. as FM-Bench of Bian et al. publishes it: F only.

    <folder>/pairs_with_gt.txt: one pair on each line, the numbers of both images, then F (x2' F x1 = 0) by rows
    <folder>/pairs_which_dataset.txt: the subset of each pair, one on each line
    <folder>/<subset>/Images/<eight digits>.jpg"""
    return _fm_bench(folder)


def cpc(folder):
    """Community Photo Collection of Wilson and Snavely as FM-Bench publishes it; the files have the form of those of tanks_and_temples."""
    return _fm_bench(folder)


def _is_fm_bench(folder):
    return os.path.isfile(os.path.join(folder, "pairs_with_gt.txt"))


def _fm_bench(folder):
    index, subsets_file = (os.path.join(folder, name) for name in ("pairs_with_gt.txt", "pairs_which_dataset.txt"))
    subsets = [(number, " ".join(words).strip("/")) for number, words in _lines(subsets_file)]
    rows = list(_lines(index))
    if len(rows) != len(subsets):
        raise DataError("%s has %d lines, %s %d" % (index, len(rows), subsets_file, len(subsets)))
    truths = []
    for (number, words), (_, subset) in zip(rows, subsets):
        if len(words) < 11:
            raise DataError("%s:%d: expected two image numbers and nine of F" % (index, number))
        values = _floats(index, number, words[:11], 11)
        numbers = [int(v) for v in values[:2]]
        images = [os.path.join(folder, subset, "Images", "%08d.jpg" % n) for n in numbers]
        name = "%s_%d_%d" % (subset.replace("/", "_"), numbers[0], numbers[1])
        truths.append(Truth(name, images[0], images[1], ["F"], F=values[2:].reshape(3, 3)))
    return truths


def one_dsfm(folder):
    """A scene of 1DSfM of Wilson and Snavely, e.g. Piccadilly: the pairs that have a two-view geometry, and whose cameras
    are both in the reference reconstruction.

    <folder>/gt_bundle.out: reconstruction, Bundler's format v0.3; a focal length of 0 means no camera
    <folder>/list.txt: the image of each camera, the first word of each line; relative to <folder> or to <folder>/images
    <folder>/EGs.txt: one two-view geometry on each line; the first two words are the numbers of the cameras"""
    scene = os.path.basename(os.path.abspath(folder))
    cameras = _bundler_cameras(folder)
    file = os.path.join(folder, "EGs.txt")
    truths = []
    for number, words in _lines(file):
        i, j = (int(v) for v in _floats(file, number, words[:2], 2))
        if not (0 <= i < len(cameras) and 0 <= j < len(cameras)):
            raise DataError("%s:%d: there are only %d cameras" % (file, number, len(cameras)))
        if cameras[i] is not None and cameras[j] is not None:
            truths.append(Truth.of_cameras("%s_%d_%d" % (scene, i, j), cameras[i], cameras[j]))
    return truths


def _bundler_cameras(folder):
    """Returns a list with the camera of each image, or None for an image without a camera. In Bundler's
    coordinates a camera looks along -z with y up. The returned cameras look along z with y down."""
    file, images_file = os.path.join(folder, "gt_bundle.out"), os.path.join(folder, "list.txt")
    images = [words[0] for _, words in _lines(images_file)]
    lines = _lines(file)
    number, words = next(lines, (1, ["0"]))
    count = int(_floats(file, number, words[:1], 1)[0])
    if count != len(images):
        raise DataError("%s has %d cameras, %s %d images" % (file, count, images_file, len(images)))
    flip = np.diag([1.0, -1.0, -1.0])
    cameras = []
    for image in images:
        rows = list(itertools.islice(lines, 5))
        if len(rows) < 5:
            raise DataError(file + ": ends within the cameras")
        values = np.array([_floats(file, n, row, 3) for n, row in rows])
        focal, k1, k2 = values[0]
        cameras.append(Camera(_listed_image(folder, image), flip @ values[1:4], flip @ values[4], focal=focal,
                              distortion=(k1, k2, 0, 0) if k1 or k2 else None) if focal > 0 else None)
    return cameras


def _listed_image(folder, image):
    places = [os.path.join(folder, image), os.path.join(folder, "images", os.path.basename(image))]
    return next((path for path in places if os.path.isfile(path)), places[0])


def _consecutive(label, views, names, step):
    """Returns the pairs of frames i and i + step. Pairs between which the camera did not move are left
    out, because they have no epipolar geometry."""
    truths = []
    for a, b, first, second in zip(views, views[step:], names, names[step:]):
        if np.linalg.norm(relative_pose(a, b)[1]) > _STILL:
            truths.append(Truth.of_cameras("%s_%s_%s" % (label, first, second), a, b))
    return truths


def _files(folder, pattern):
    files = sorted(glob.glob(os.path.join(glob.escape(folder), pattern)))
    if not files:
        raise DataError("%s: no %s" % (folder, pattern))
    return files


def _find(folder, wanted):
    return sorted(os.path.join(root, name) for root, _, names in os.walk(folder) for name in names if wanted(name))


def _stem(path):
    return os.path.splitext(os.path.basename(path))[0]


def _image(folder, stem):
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), glob.escape(stem) + ".*"))):
        if path.lower().endswith(IMAGE_TYPES):
            return path
    raise DataError("%s: no image %s.*" % (folder, stem))


def _lines(file):
    """Yields the number and the words of each line that is neither empty nor a comment. Blanks and
    commas separate the words."""
    try:
        with open(file) as text:
            for number, line in enumerate(text, 1):
                words = line.replace(",", " ").split()
                if words and not words[0].startswith("#"):
                    yield number, words
    except (OSError, UnicodeDecodeError) as error:
        raise DataError("%s: %s" % (file, getattr(error, "strerror", None) or error)) from None


def _floats(file, number, words, count):
    try:
        values = np.array([float(word) for word in words])
    except ValueError:
        values = np.empty(0)
    if len(values) != count or not np.isfinite(values).all():
        raise DataError("%s:%d: expected %d numbers" % (file, number, count))
    return values


def _numbers(file, shape):
    """Returns all numbers of a file in an array of this shape. If the first dimension is -1, it follows
    from the count of numbers."""
    values = [_floats(file, number, words, len(words)) for number, words in _lines(file)]
    values = np.concatenate(values) if values else np.empty(0)
    size = abs(int(np.prod(shape)))
    if not len(values) or (len(values) % size if shape[0] < 0 else len(values) != size):
        raise DataError("%s: expected %s numbers, found %d"
                        % (file, "a multiple of %d" % size if shape[0] < 0 else size, len(values)))
    return values.reshape(shape)
