"""A program that mypy checks with --strict: the stubs say what the package does."""

from typing import List, Tuple

import numpy as np
from numpy.typing import NDArray

import runmark
from runmark import aruco


def largest(image: NDArray[np.uint8]) -> Tuple[int, float]:
    detector = runmark.Detector(dictionaries=["tag36h11"], inverted=True, region=(0, 0, 64, 64), corrected_bits=None)
    found: runmark.Detection = detector.detect(image, order="rgb")
    sides: NDArray[np.float64] = np.hypot(*np.moveaxis(found.corners[:, 1] - found.corners[:, 0], -1, 0))
    return int(found.ids[sides.argmax()]), float(sides.max())


def streamed(image: NDArray[np.uint8]) -> List[int]:
    height, width = image.shape[:2]
    ids: List[int] = []
    with runmark.Detector(runmark.Dictionary("DICT_4X4_50")).stream(width, height, copy=False) as stream:
        for y in range(0, height, 16):
            ids += [marker.id for marker in stream.push(image[y : y + 16])]
    return ids


def as_opencv(image: NDArray[np.uint8]) -> int:
    corners, ids, rejected = aruco.ArucoDetector(0).detectMarkers(image)
    return 0 if ids is None else len(corners) + len(rejected)


def drawn() -> NDArray[np.uint8]:
    picture: NDArray[np.uint8] = runmark.Dictionary("tag36h11").draw(3, pixels_per_cell=4)
    return picture


def placed(image: NDArray[np.uint8]) -> float:
    camera = runmark.Camera(600, 600, 320, 240, distortion=[-0.1, 0.02])
    found = runmark.Detector("tag36h11").detect(image)
    estimate: runmark.PoseEstimate = runmark.pose(found[0], 0.1, camera, image)
    view = runmark.Board.grid("tag36h11", 3, 2, marker=0.1, gap=0.02).view(found, image)
    other = estimate.other
    return float(view.pose(camera).best.translation[2]) + (other.error if other else 0.0)
