"""Rendered scenes are those of the command line, with their truth."""

import numpy as np
import pytest

import runmark


def test_a_scene_and_its_truth():
    image, truth = runmark.render("vga", 2)
    assert image.shape == (480, 640) and image.dtype == np.uint8
    assert (truth["width"], truth["height"], truth["dictionary"]) == (640, 480, "tag36h11")
    found = {marker.id: marker for marker in runmark.Detector("tag36h11").detect(image)}
    large = [marker for marker in truth["markers"] if marker["size"] > 40 and marker["tilt"] < 45]
    assert large
    for marker in large:
        np.testing.assert_allclose(found[marker["id"]].corners, marker["corners"], atol=0.5)


def test_the_same_numbers_make_the_same_picture():
    first, _ = runmark.render("vga", 1, seed=5)
    again, _ = runmark.render("vga", 1, seed=5)
    other, _ = runmark.render("vga", 2, seed=5)
    assert (first == again).all() and (first != other).any()


def test_samples_and_changes():
    image, truth = runmark.render("inverted")
    assert image.shape == (720, 1280) and truth["inverted"]
    colour, _ = runmark.render("room", colour=True)
    assert colour.shape == (720, 1280, 3) and (colour[..., 0] != colour[..., 2]).any()
    _, truth = runmark.render("vga", dictionary="DICT_5X5_50", marker_size=(40, 60), tilt=0, blur=1.5, noise=3)
    assert truth["dictionary"] == "DICT_5X5_50" and truth["markers"]
    for marker in truth["markers"]:
        assert marker["tilt"] < 15 and marker["blur"] == 1.5 and marker["noise"] == 3


@pytest.mark.parametrize("arguments, error, says", [
    ({"set": "qvga"}, ValueError, "set 'qvga': there are vga, hd"),
    ({"index": -1}, ValueError, "index"),
    ({"tilt": 90}, ValueError, "tilt 90: must be a number or"),
    ({"blur": (3, 1)}, ValueError, "blur"),
    ({"dictionary": "none"}, ValueError, "none"),
    ({"fog": 3}, TypeError, "'fog'"),
])
def test_bad_arguments_are_named(arguments, error, says):
    with pytest.raises(error, match=says):
        runmark.render(**arguments)
