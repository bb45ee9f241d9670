"""Images in, markers out."""

import tracemalloc

import numpy as np
import pytest

import runmark
from scenes import MARKERS, corners, page


@pytest.fixture(scope="module")
def detector():
    return runmark.Detector(dictionaries=["DICT_4X4_50"])


@pytest.fixture(scope="module")
def image():
    return page(MARKERS)


def test_markers_as_objects(detector, image):
    found = detector.detect(image)
    assert len(found) == 2 and found.size == (320, 240)
    for marker, (number, x, y, cell) in zip(sorted(found, key=lambda m: m.id), MARKERS):
        assert (marker.dictionary, marker.id, marker.hamming, marker.inverted) == ("DICT_4X4_50", number, 0, False)
        assert marker.corners.shape == (4, 2) and marker.corners.dtype == np.float64
        np.testing.assert_allclose(marker.corners, corners(x, y, cell), atol=0.1)
        np.testing.assert_allclose(marker.centre, corners(x, y, cell).mean(axis=0), atol=0.1)
        assert 0.2 < marker.margin <= 0.5
        assert y + 6 * cell - 1 <= marker.row < 240
        assert repr(marker).startswith(f"<Marker DICT_4X4_50 {number} at [[")
    assert found[-1].id == found[1].id
    for index in (2, -3):
        with pytest.raises(IndexError, match="there are 2 markers"):
            found[index]


def test_markers_as_arrays(detector, image):
    found = detector.detect(image)
    expected = {"ids": (np.int32, (2,)), "corners": (np.float64, (2, 4, 2)), "hamming": (np.int32, (2,)),
                "margins": (np.float32, (2,)), "inverted": (np.bool_, (2,)), "rejected": (np.float64, (0, 4, 2))}
    for name, (dtype, shape) in expected.items():
        array = getattr(found, name)
        assert (array.dtype, array.shape) == (dtype, shape), name
    for i, marker in enumerate(found):
        assert (found.ids[i], found.hamming[i], found.inverted[i]) == (marker.id, marker.hamming, marker.inverted)
        assert (found.corners[i] == marker.corners).all() and found.margins[i] == np.float32(marker.margin)
    assert found.dictionaries == ["DICT_4X4_50"] * 2
    nothing = detector.detect(np.full((50, 60), 255, np.uint8))
    assert nothing.corners.shape == (0, 4, 2) and nothing.ids.shape == (0,) and list(nothing) == []


def test_results_outlive_the_detector(image):
    found = runmark.Detector("DICT_4X4_50").detect(image)
    marker = found[0]
    names = found.dictionaries
    del found
    assert marker.dictionary == names[0] == "DICT_4X4_50"


def test_every_layout_of_the_same_picture(detector):
    colour, _ = runmark.render("vga", 3, dictionary="DICT_4X4_50", colour=True)
    grey = colour[:, :, 1].copy()
    expected = detector.detect(grey).corners
    assert len(expected) > 5
    spread = np.zeros((2 * 480, 3 * 640), np.uint8)
    spread[::2, ::3] = grey
    layouts = {
        "one channel": grey[:, :, np.newaxis],
        "a channel of three": np.stack([grey] * 3, axis=2)[:, :, 1],
        "equal channels": np.stack([grey] * 3, axis=2),
        "four channels": np.stack([grey] * 3 + [grey * 0], axis=2),
        "every second row, every third column": spread[::2, ::3],
        "upside down": grey[::-1].copy()[::-1],
        "mirrored": grey[:, ::-1].copy()[:, ::-1],
        "turned half": grey[::-1, ::-1].copy()[::-1, ::-1],
        "transposed": grey.T.copy().T,
        "in Fortran order": np.asfortranarray(grey),
        "planes": np.stack([grey] * 3).transpose(1, 2, 0),
        "read-only": np.frombuffer(grey.tobytes(), np.uint8).reshape(grey.shape),
    }
    for name, layout in layouts.items():
        assert (detector.detect(layout).corners == expected).all(), name

    in_colour = detector.detect(colour).corners
    assert (detector.detect(colour[:, :, ::-1], order="rgb").corners == in_colour).all()
    assert (detector.detect(colour[:, :, ::-1].copy(), order="rgb").corners == in_colour).all()


def test_strided_views_are_not_copied():
    detector = runmark.Detector("DICT_4X4_50", octaves=0)
    picture = np.zeros((3000, 4000, 3), np.uint8)
    views = [picture, picture[:, :, 0], picture[::-1, ::-1], picture[::2, ::2], picture[:, :, ::-1],
             picture[:, :, 1].T]
    for view in views:
        detector.detect(view)  # makes the buffers of its size
        tracemalloc.start()
        detector.detect(view)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert peak < 100_000, (view.shape, view.strides, peak)


def test_only_broadcasts_are_copied(detector, image):
    row = image[120]
    found = detector.detect(np.broadcast_to(row, (100, 320)))
    assert len(found) == 0


def test_pixels_farther_apart_than_an_int_can_say(detector):
    far = np.zeros((1, 2**31 + 8), np.uint8)[:, ::2**31]  # never touched but for two pixels
    assert far.shape == (1, 2) and len(detector.detect(far)) == 0


@pytest.mark.parametrize("image, error, says", [
    (np.zeros((20, 20)), TypeError, "image: dtype float64, but it must be uint8"),
    (np.zeros((20, 20), np.int8), TypeError, "dtype int8"),
    (np.zeros((20, 20), bool), TypeError, "dtype bool"),
    (np.zeros(20, np.uint8), ValueError, r"shape \(20,\)"),
    (np.zeros((0, 20), np.uint8), ValueError, r"shape \(0, 20\)"),
    (np.zeros((20, 20, 2), np.uint8), ValueError, r"shape \(20, 20, 2\)"),
    (np.zeros((2, 20, 20, 3), np.uint8), ValueError, "shape"),
    (np.zeros((1, 65536), np.uint8), ValueError, "65535"),
    (None, TypeError, "image"),
    ("picture.png", TypeError, "image"),
])
def test_what_is_no_image_is_refused(detector, image, error, says):
    with pytest.raises(error, match=says):
        detector.detect(image)


def test_wrong_order_is_refused(detector, image):
    with pytest.raises(ValueError, match="order 'gbr': must be 'bgr' or 'rgb'"):
        detector.detect(image, order="gbr")


def test_pictures_of_any_size(detector):
    for size in ((1, 1), (7, 3), (65535, 1), (1, 3000), (2000, 1500)):
        found = detector.detect(np.full((size[1], size[0]), 200, np.uint8))
        assert len(found) == 0 and found.size == size
    large = page([(3, 210, 210, 200)], size=(1700, 1700))
    assert detector.detect(large).ids.tolist() == [3]
    assert detector.memory > 1_000_000


def test_options():
    image = page(MARKERS)

    def ids(**options):
        return sorted(runmark.Detector("DICT_4X4_50", **options).detect(image).ids.tolist())

    assert ids() == [7, 12]
    assert ids(min_marker_size=70) == [7]
    assert ids(max_marker_size=70) == [12]
    assert ids(region=(0, 0, 180, 240)) == [7]
    assert ids(corrected_bits=0, connectivity=8, filter="abcdef", octaves=0, min_contrast=30) == [7, 12]
    dark = 255 - image
    assert len(runmark.Detector("DICT_4X4_50").detect(dark)) == 0
    found = runmark.Detector("DICT_4X4_50", inverted=True).detect(dark)
    assert found.inverted.tolist() == [True, True]
    for pipeline in ("paper", "hardware"):
        picture = page([(3, 60, 60, 12)], "DICT_6X6_50")
        assert runmark.Detector("DICT_6X6_50", pipeline=pipeline).detect(picture).ids.tolist() == [3]


def test_rejected_squares(image):
    image = image.copy()
    image[20:60, 150:190] = 40
    assert len(runmark.Detector("DICT_4X4_50").detect(image).rejected) == 0
    rejected = runmark.Detector("DICT_4X4_50", keep_rejected=True).detect(image).rejected
    assert np.abs(rejected.mean(axis=1) - [169.5, 39.5]).max(axis=1).min() < 0.5


def test_several_dictionaries(image):
    own = runmark.Dictionary("DICT_4X4_100")
    detector = runmark.Detector(["tag36h11", own])
    assert detector.dictionaries == ["tag36h11", "DICT_4X4_100"]
    assert set(detector.detect(image).dictionaries) == {"DICT_4X4_100"}
    assert repr(detector) == "<Detector of tag36h11 DICT_4X4_100>"


@pytest.mark.parametrize("options, error, says", [
    ({"dictionaries": "tag36h12"}, ValueError, "did you mean tag36h10"),
    ({"dictionaries": []}, ValueError, "no dictionary"),
    ({"dictionaries": 3}, TypeError, "not int"),
    ({"dictionaries": ["tag36h11", None]}, TypeError, "not NoneType"),
    ({"dictionaries": "/no/such.codes"}, ValueError, "/no/such.codes"),
    ({"dictionaries": "tag36h11", "pipeline": "fast"}, ValueError, "pipeline 'fast'"),
    ({"dictionaries": "tag36h11", "octaves": 7}, ValueError, "octaves 7: must be 0 to 6"),
    ({"dictionaries": "tag36h11", "filter": "ax"}, ValueError, "filter 'ax'"),
    ({"dictionaries": "tag36h11", "connectivity": 6}, ValueError, "connectivity 6"),
    ({"dictionaries": "tag36h11", "region": (0, 0, -1, 4)}, ValueError, "region"),
    ({"dictionaries": "tag36h11", "min_marker_size": 1}, ValueError, "marker size"),
    ({"dictionaries": "tagStandard41h12", "pipeline": "paper"}, ValueError, "tagStandard41h12"),
    ({"dictionaries": "tag36h11", "speed": "fast"}, TypeError, "speed"),
])
def test_bad_options_are_named(options, error, says):
    with pytest.raises(error, match=says):
        runmark.Detector(**options)


def test_stats(detector, image):
    stats = detector.detect(image).stats
    assert stats.pixels >= image.size and stats.crack_runs > 50 and stats.quads >= 2
    assert stats.closed_chains > 2 and stats.records_peak > 2
    assert stats.dropped_chains == stats.dropped_markers == 0
