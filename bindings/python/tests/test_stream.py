"""Rows as they come."""

import numpy as np
import pytest

import runmark
from scenes import MARKERS, page


@pytest.fixture(scope="module")
def detector():
    return runmark.Detector("DICT_4X4_50")


def test_markers_come_with_their_rows_and_are_those_of_the_whole_frame(detector):
    image, _ = runmark.render("vga", 5, dictionary="DICT_4X4_50")
    whole = detector.detect(image)
    assert len(whole) > 3
    for chunk in (1, 7, 480):
        fresh = []
        with detector.stream(640, 480) as stream:
            for y in range(0, 480, chunk):
                for marker in stream.push(image[y:y + chunk]):
                    assert marker.row < y + chunk
                    fresh.append(marker)
                assert len(stream.detection) == len(fresh)
        found = stream.detection
        assert found.size == (640, 480) and found.stats.pixels == whole.stats.pixels
        assert (found.ids == whole.ids).all() and (found.corners == whole.corners).all()
        assert [marker.id for marker in fresh] == whole.ids[:len(fresh)].tolist()


def test_the_callers_buffer_may_be_used_again(detector):
    image = page(MARKERS)
    buffer = np.empty((8, 320), np.uint8)
    with detector.stream(320, 240) as stream:
        for y in range(0, 240, 8):
            buffer[:] = image[y:y + 8]
            stream.push(buffer)
            buffer[:] = 0
    assert sorted(stream.detection.ids.tolist()) == [7, 12]


def test_without_a_copy_the_rows_are_kept(detector):
    image = page(MARKERS)
    with detector.stream(320, 240, copy=False) as stream:
        for y in range(0, 240, 8):
            stream.push(image[y:y + 8].copy())  # kept by the stream alone
    assert sorted(stream.detection.ids.tolist()) == [7, 12]


def test_colour_rows_and_a_second_frame(detector):
    image = np.stack([page(MARKERS)] * 3, axis=2)
    stream = detector.stream(320, 240, order="rgb")
    for _ in range(2):
        with stream:
            stream.push(image[:100])
            stream.push(image[100:])
        assert sorted(stream.detection.ids.tolist()) == [7, 12]


def test_whole_frames_meanwhile(detector):
    image = page(MARKERS)
    with detector.stream(320, 240) as stream:
        stream.push(image[:120])
        assert len(detector.detect(image)) == 2
        stream.push(image[120:])
    assert len(stream.detection) == 2


def test_missing_rows_are_an_error(detector):
    with pytest.raises(ValueError, match="ended after 100 of 240 rows"):
        with detector.stream(320, 240) as stream:
            stream.push(page(MARKERS)[:100])
    with detector.stream(320, 240) as stream:  # the next frame is as new
        stream.push(page(MARKERS))
    assert len(stream.detection) == 2


def test_the_callers_own_error_comes_through(detector):
    with pytest.raises(KeyError, match="mine"):
        with detector.stream(320, 240):
            raise KeyError("mine")


def test_wrong_use_is_refused(detector):
    image = page(MARKERS)
    stream = detector.stream(320, 240)
    with pytest.raises(ValueError, match="with statement"):
        stream.push(image)
    with pytest.raises(ValueError, match="1 to 65535"):
        detector.stream(0, 240)
    with stream:
        with pytest.raises(ValueError, match="open already"):
            with stream:
                pass
        with pytest.raises(ValueError, match="rows: 10 of 100 pixels, but 240 of 320 pixels are wanted"):
            stream.push(image[:10, :100])
        stream.push(image[:100])
        with pytest.raises(ValueError, match="one format"):
            stream.push(np.stack([image[100:]] * 3, axis=2))
        with pytest.raises(TypeError, match="rows: dtype float64"):
            stream.push(image[100:].astype(float))
        with pytest.raises(ValueError, match="but 140 of 320 pixels are wanted"):
            stream.push(image)
        stream.push(image[100:])
    assert len(stream.detection) == 2
