"""runmark.aruco answers like OpenCV's module."""

import subprocess
import sys

import numpy as np
import pytest

import runmark
from runmark import aruco
from scenes import MARKERS, page

cv2 = pytest.importorskip("cv2")
NAMES = sorted({getattr(cv2.aruco, name): name for name in dir(cv2.aruco) if name.startswith("DICT_")}.values())


def scene(dictionary):
    """Two markers drawn by OpenCV, and a black square that is none."""
    image = np.full((400, 600), 220, np.uint8)
    draw = getattr(cv2.aruco, "generateImageMarker", None) or cv2.aruco.drawMarker
    for number, x, y, side in ((7, 60, 50, 128), (12, 300, 150, 100)):
        image[y - 20:y + side + 20, x - 20:x + side + 20] = 255
        image[y:y + side, x:x + side] = draw(dictionary, number, side)
    image[300:360, 100:160] = 20
    return cv2.GaussianBlur(image, (3, 3), 0)


def opencv(image, dictionary, parameters=None):
    if hasattr(cv2.aruco, "ArucoDetector"):
        detector = cv2.aruco.ArucoDetector(dictionary, parameters or cv2.aruco.DetectorParameters())
        return detector.detectMarkers(image)
    return cv2.aruco.detectMarkers(image, dictionary, parameters=parameters or cv2.aruco.DetectorParameters_create())


def by_id(corners, ids):
    return dict(zip(ids.ravel().tolist(), corners))


@pytest.mark.parametrize("name", NAMES)
def test_the_same_answer_for_every_dictionary_of_opencv(name):
    dictionary = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, name))
    image = scene(dictionary)
    theirs = opencv(image, dictionary)
    for given in (dictionary, getattr(cv2.aruco, name)):
        for ours in (aruco.detectMarkers(image, given), aruco.ArucoDetector(given).detectMarkers(image)):
            assert [type(part) for part in ours] == [type(part) for part in theirs]
            assert (ours[1].shape, ours[1].dtype) == (theirs[1].shape, theirs[1].dtype)
            mine, other = by_id(*ours[:2]), by_id(*theirs[:2])
            assert mine.keys() == other.keys() == {7, 12}
            for number, corners in mine.items():
                assert (corners.shape, corners.dtype) == (other[number].shape, other[number].dtype)
                np.testing.assert_allclose(corners, other[number], atol=1.5)  # the same first corner
            square = min(ours[2], key=lambda c: np.abs(c.mean(axis=(0, 1)) - [129.5, 329.5]).max())
            np.testing.assert_allclose(square.mean(axis=(0, 1)), [129.5, 329.5], atol=1)
            assert square.shape == (1, 4, 2) and square.dtype == np.float32


def test_nothing_found():
    blank = np.full((100, 100), 255, np.uint8)
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    assert aruco.detectMarkers(blank, dictionary) == ((), None, ()) == tuple(opencv(blank, dictionary))


def test_both_call_styles_take_opencvs_arguments():
    image = page(MARKERS)
    colour = cv2.cvtColor(image, cv2.COLOR_GRAY2BGR)
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    parameters = getattr(cv2.aruco, "DetectorParameters_create", cv2.aruco.DetectorParameters)()
    for picture in (image, colour, cv2.UMat(image)):
        assert set(aruco.detectMarkers(picture, dictionary, parameters=parameters)[1].ravel()) == {7, 12}
        detector = aruco.ArucoDetector(dictionary, parameters, None)
        assert set(detector.detectMarkers(picture)[1].ravel()) == {7, 12}
    assert set(aruco.detectMarkers(image, dictionary, None, None, parameters, None)[1].ravel()) == {7, 12}


def test_parameters_that_are_followed():
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    parameters = getattr(cv2.aruco, "DetectorParameters_create", cv2.aruco.DetectorParameters)()
    detector = aruco.ArucoDetector(dictionary, parameters)
    inverted = 255 - page(MARKERS)
    assert detector.detectMarkers(inverted)[1] is None
    parameters.detectInvertedMarker = True
    detector.setDetectorParameters(parameters)
    assert len(detector.detectMarkers(inverted)[0]) == 2
    assert detector.getDetectorParameters() is parameters and detector.getDictionary() is dictionary

    known = runmark.Dictionary("DICT_6X6_250")
    damaged = known.draw(5, 10, 2)
    damaged[60:70, 60:70] = 255 - damaged[60:70, 60:70]
    damaged = np.pad(damaged, 20, constant_values=255)
    parameters = getattr(cv2.aruco, "DetectorParameters_create", cv2.aruco.DetectorParameters)()
    detector.setDictionary(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_6X6_250))
    detector.setDetectorParameters(parameters)
    assert detector.detectMarkers(damaged)[1].tolist() == [[5]]
    parameters.errorCorrectionRate = 0
    detector.setDetectorParameters(parameters)
    assert detector.detectMarkers(damaged)[1] is None


def test_a_dictionary_of_ones_own():
    bits = np.random.default_rng(2).integers(0, 2, (4, 5, 5)).astype(np.uint8)
    own = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_50)
    lists = getattr(cv2.aruco, "Dictionary_getByteListFromBits", None) or cv2.aruco.Dictionary.getByteListFromBits
    own = cv2.aruco.Dictionary_create(4, 5) if hasattr(cv2.aruco, "Dictionary_create") else own
    own.bytesList = np.concatenate([lists(each) for each in bits])
    image = np.full((200, 200), 255, np.uint8)
    draw = getattr(cv2.aruco, "generateImageMarker", None) or cv2.aruco.drawMarker
    image[50:150, 50:150] = draw(own, 2, 100)
    assert aruco.detectMarkers(image, own)[1].tolist() == [[2]]


def test_the_bits_corrected_are_those_of_runmark():
    for name in runmark.dictionary_names():
        known = runmark.Dictionary(name)
        assert aruco._safe_bits(known) == known.corrected_bits, name


def test_other_names_are_opencvs():
    assert aruco.DICT_4X4_50 == cv2.aruco.DICT_4X4_50
    assert aruco.drawDetectedMarkers is cv2.aruco.drawDetectedMarkers
    with pytest.raises(AttributeError):
        aruco.detectEverything


def test_unknown_dictionaries():
    with pytest.raises(ValueError, match="dictionary 99"):
        aruco.ArucoDetector(99)


def test_without_opencv():
    program = """
import sys
sys.modules["cv2"] = None  # as if it were not installed
import numpy as np
from runmark import Dictionary, aruco
image = np.pad(Dictionary("DICT_4X4_50").draw(7), 20, constant_values=255)
detector = aruco.ArucoDetector(aruco.getPredefinedDictionary(aruco.DICT_4X4_50), aruco.DetectorParameters())
assert detector.detectMarkers(image)[1].tolist() == [[7]]
dictionary = aruco.Dictionary_get(aruco.DICT_4X4_50)
assert aruco.detectMarkers(image, dictionary, parameters=aruco.DetectorParameters_create())[1].tolist() == [[7]]
try:
    aruco.drawDetectedMarkers
except AttributeError as error:
    assert "OpenCV" in str(error)
else:
    raise SystemExit("no error")
"""
    subprocess.run([sys.executable, "-c", program], check=True)
