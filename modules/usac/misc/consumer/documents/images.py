# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.

"""Makes a folder of overlapping images, as the tutorial on collections needs it: images.py FOLDER.

The images show textured rectangles of different depths and slants, seen by cameras on an arc."""

import os
import sys

import cv2
import numpy as np

SIZE = (320, 240)
K = np.array([[300.0, 0, 160], [0, 300, 120], [0, 0, 1]])
# For each textured rectangle: a corner, the edge along the width of the texture, and the edge along its
# height. z points away from the camera. Far rectangles come first, so that nearer ones are drawn over
# them.
PLANES = [((-9, -7, 12), (18, 0, 0), (0, 14, 0)), ((-5, -3, 9), (4, 0, 1.5), (0, 5, 0)), ((1, -3.5, 9), (4, 0, -1.5), (0, 5, 0.8)),
          ((-3, 0.5, 7), (3, 0, -0.5), (0, 2, 0.5)), ((0.2, -2, 7), (2, 0, 0.6), (0, 3.5, 0))]


def texture(rng, width, height):
    """Returns an image with features everywhere: the sum of smooth noise of three scales."""
    image = np.zeros((height, width))
    for size in (6, 16, 48):
        noise = rng.uniform(-1, 1, (height // size + 2, width // size + 2))
        image += cv2.resize(noise, (width, height), interpolation=cv2.INTER_CUBIC)
    return cv2.normalize(image, None, 0, 255, cv2.NORM_MINMAX).astype(np.uint8)


def view(textures, degrees):
    """Returns the image of a camera on an arc around the point (0, 0, 9). At 0 degrees the camera is
    in the middle of the arc, at the origin."""
    angle = np.radians(degrees)
    R = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    t = np.array([0, 0, 9]) - R @ [0, 0, 9]
    image = np.full(SIZE[::-1], 128, np.uint8)
    for (corner, along, down), picture in zip(PLANES, textures):
        height, width = picture.shape
        plane = np.c_[np.divide(along, width), np.divide(down, height), corner]
        M = K @ (R @ plane + np.outer(t, [0, 0, 1]))
        warped = cv2.warpPerspective(picture, M, SIZE, flags=cv2.INTER_LINEAR)
        seen = cv2.warpPerspective(np.full_like(picture, 255), M, SIZE, flags=cv2.INTER_NEAREST)
        image[seen > 0] = warped[seen > 0]
    return image


def main(folder):
    os.makedirs(folder)
    rng = np.random.RandomState(1)
    textures = [texture(rng, int(50 * np.linalg.norm(along)), int(50 * np.linalg.norm(down))) for _, along, down in PLANES]
    for number, degrees in enumerate(np.linspace(-18, 18, 5)):
        cv2.imwrite(os.path.join(folder, "{}.png".format(number)), view(textures, degrees))


if __name__ == "__main__":
    main(sys.argv[1])
