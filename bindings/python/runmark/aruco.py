"""runmark behind the names of OpenCV's aruco module, for programs written for it.

Either replace the import,

    from runmark import aruco           # instead of: from cv2 import aruco

or one call: `cv2.aruco.ArucoDetector(...)` (OpenCV 4.7 and later) or `cv2.aruco.detectMarkers(...)` (up to 4.6) by the
same name of this module. Both answer (corners, ids, rejected) as OpenCV does: a tuple of float32 (1, 4, 2) arrays, x, y
in pixels; an int32 (N, 1) array, or None when there is none; a tuple of float32 (1, 4, 2) arrays.

Dictionaries are OpenCV's objects, its numbers (DICT_4X4_50), or what runmark.Detector takes. A marker's first corner
is the one OpenCV 4 says, also with its AprilTag dictionaries, which it turns by 180 degrees.

Of the detector parameters two are followed: detectInvertedMarker, and errorCorrectionRate as an upper limit (runmark
never corrects more bits than is safe for the dictionary). The others tune OpenCV's own way of finding markers.
Corners are always refined. Every other name of the module is OpenCV's own, when it is installed.
"""

from __future__ import annotations

import functools
import math
import types
from typing import Any, NamedTuple, Optional, Tuple

import numpy as np

from . import _core

__all__ = ["ArucoDetector", "detectMarkers"]

Answer = Tuple[Tuple[np.ndarray, ...], Optional[np.ndarray], Tuple[np.ndarray, ...]]


class ArucoDetector:
    """Stands for cv2.aruco.ArucoDetector. Safe to use from several threads at once."""

    def __init__(self, dictionary: Any = 0, detectorParams: Any = None, refineParams: Any = None) -> None:
        """refineParams is for OpenCV's refineDetectedMarkers and not used here."""
        self._dictionary = dictionary
        self._parameters = detectorParams
        self._make()

    def _make(self) -> None:
        self._detector = _detector(_codes_of(self._dictionary), _settings_of(self._parameters))

    def detectMarkers(self, image: Any, corners: Any = None, ids: Any = None, rejectedImgPoints: Any = None) -> Answer:
        """The markers of a uint8 image, (H, W) or (H, W, 3) in BGR; see the module. The other arguments are
        OpenCV's places for its results and are not written to."""
        return _answer(self._detector, image)

    def getDictionary(self) -> Any:
        return self._dictionary

    def setDictionary(self, dictionary: Any) -> None:
        self._dictionary = dictionary
        self._make()

    def getDetectorParameters(self) -> Any:
        return self._parameters

    def setDetectorParameters(self, detectorParameters: Any) -> None:
        self._parameters = detectorParameters
        self._make()


def detectMarkers(image: Any, dictionary: Any, corners: Any = None, ids: Any = None, parameters: Any = None,
                  rejectedImgPoints: Any = None) -> Answer:
    """Stands for cv2.aruco.detectMarkers of OpenCV 4.6 and before. The detector is kept for the next call with the same
    dictionary and parameters."""
    return _answer(_detector(_codes_of(dictionary), _settings_of(parameters)), image)


def _answer(detector: _core.Detector, image: Any) -> Answer:
    found = detector.detect(image.get() if hasattr(image, "get") else image)  # a cv2.UMat has get
    corners = found.corners.astype(np.float32)
    rejected = found.rejected.astype(np.float32)
    ids = found.ids.reshape(-1, 1) if len(found) else None
    return tuple(c[np.newaxis] for c in corners), ids, tuple(r[np.newaxis] for r in rejected)


class _Codes(NamedTuple):
    """A dictionary that can be compared: its bits as OpenCV holds them, or what runmark knows it by."""

    source: Any
    side: int = 0
    most_corrected: int = 0


class _Settings(NamedTuple):
    inverted: bool
    correction_rate: float


def _settings_of(parameters: Any) -> _Settings:
    return _Settings(bool(getattr(parameters, "detectInvertedMarker", False)),
                     float(getattr(parameters, "errorCorrectionRate", 0.6)))


def _codes_of(dictionary: Any) -> _Codes:
    if hasattr(dictionary, "bytesList"):
        side, listed = int(dictionary.markerSize), np.ascontiguousarray(dictionary.bytesList, np.uint8)
        return _Codes(listed.tobytes(), side, int(dictionary.maxCorrectionBits))
    return _Codes(dictionary)


@functools.lru_cache(maxsize=16)
def _detector(codes: _Codes, settings: _Settings) -> _core.Detector:
    corrected = None
    if codes.side > 0:
        bits = _unpacked(codes.source, codes.side)
        turned = ((bits == np.rot90(bits, k, (1, 2))).all((1, 2)) for k in (1, 2))
        symmetric = np.logical_or(*turned).nonzero()[0].tolist()
        dictionary = _core.Dictionary.from_bits(bits, "OpenCV's dictionary", 0, symmetric)
        corrected = min(_safe_bits(dictionary), int(codes.most_corrected * settings.correction_rate))
    elif isinstance(codes.source, (int, np.integer)):
        dictionary = _predefined(int(codes.source))
    else:
        dictionary = codes.source
    return _core.Detector(dictionary, inverted=settings.inverted, corrected_bits=corrected, keep_rejected=True)


def _unpacked(packed: bytes, side: int) -> np.ndarray:
    """OpenCV's bytesList as uint8 (N, side, side)."""
    cells, size = side * side, (side * side + 7) // 8
    # The four rotations lie one after the other. Each is its cells, row by row, packed into bytes; the last byte is
    # filled from its low end.
    first = np.frombuffer(packed, np.uint8).reshape(-1, 4, size)[:, 0]
    bits = np.unpackbits(first, axis=1)
    start = 8 * (size - 1)
    return np.delete(bits, np.s_[start:start + 8 * size - cells], axis=1).reshape(-1, side, side)


def _safe_bits(dictionary: _core.Dictionary) -> int:
    """The rule of docs/dictionaries.md, "Corrected bits"."""
    codes, bits = len(dictionary), len(dictionary.cells)
    best = readings = 0
    for wrong in range(bits):
        readings += math.comb(bits, wrong)
        if 2 * wrong >= dictionary.distance or 4 * codes * readings * 4096 > 2**bits:
            break
        best = wrong
    return best


# OpenCV's numbers of its predefined dictionaries.
_NAMES = {
    **{4 * i + j: f"DICT_{s}X{s}_{n}" for i, s in enumerate((4, 5, 6, 7)) for j, n in enumerate((50, 100, 250, 1000))},
    16: "DICT_ARUCO_ORIGINAL",
    17: "DICT_APRILTAG_16h5",
    18: "DICT_APRILTAG_25h9",
    19: "DICT_APRILTAG_36h10",
    20: "DICT_APRILTAG_36h11",
    21: "DICT_ARUCO_MIP_36h12",
}


def _predefined(number: int) -> _core.Dictionary:
    if number not in _NAMES:
        raise ValueError(f"dictionary {number}: OpenCV has no predefined one of that number")
    official = _core.Dictionary(_NAMES[number])
    if "APRILTAG" not in official.name:
        return official
    side = official.width - 2
    shifts = np.arange(side * side, dtype=np.uint64)  # the last cell first: turned by 180 degrees
    turned = (official.codes[:, np.newaxis] >> shifts & np.uint64(1)).astype(np.uint8)
    return _core.Dictionary.from_bits(turned.reshape(-1, side, side), official.name, official.corrected_bits)


def __getattr__(name: str) -> Any:
    if not name.startswith("_"):
        try:
            import cv2
        except ImportError:
            return _without_opencv(name)
        return getattr(cv2.aruco, name)
    raise AttributeError(f"module 'runmark.aruco' has no attribute '{name}'")


def _without_opencv(name: str) -> Any:
    """What a program needs to say which markers it wants."""
    for number, known in _NAMES.items():
        if name == known:
            return number
    if name in ("getPredefinedDictionary", "Dictionary_get"):
        return lambda number: number
    if name in ("DetectorParameters", "DetectorParameters_create"):
        return lambda: types.SimpleNamespace(detectInvertedMarker=False, errorCorrectionRate=0.6)
    raise AttributeError(f"module 'runmark.aruco' has no attribute '{name}', and OpenCV, which might, is not installed")
