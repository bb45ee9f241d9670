"""Finds square fiducial markers (ArUco, AprilTag, your own) in one scan of the image.

    import runmark
    detector = runmark.Detector(dictionaries=["DICT_4X4_50"])
    for marker in detector.detect(image):
        print(marker.id, marker.corners)

runmark.aruco answers like OpenCV's aruco module.
"""

from ._core import (
    Board,
    BoardView,
    Camera,
    Confirmation,
    Detection,
    Detector,
    Dictionary,
    FrameStats,
    Marker,
    Pose,
    PoseEstimate,
    RowStream,
    __version__,
    dictionary_names,
    pose,
    render,
)

__all__ = [
    "Board",
    "BoardView",
    "Camera",
    "Confirmation",
    "Detection",
    "Detector",
    "Dictionary",
    "FrameStats",
    "Marker",
    "Pose",
    "PoseEstimate",
    "RowStream",
    "__version__",
    "dictionary_names",
    "pose",
    "render",
]
