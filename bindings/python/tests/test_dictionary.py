"""Dictionaries as data, and the markers drawn from them."""

import pathlib

import numpy as np
import pytest

import runmark

DATA = pathlib.Path(__file__).resolve().parents[3] / "data" / "dictionaries"


def test_built_in_dictionaries():
    names = runmark.dictionary_names()
    assert names == sorted(names) and {"tag36h11", "DICT_4X4_50", "ARUCO_MIP_36h12"} <= set(names)
    known = runmark.Dictionary("DICT_4X4_50")
    assert (known.name, len(known), known.width, known.border, known.distance, known.corrected_bits) == \
        ("DICT_4X4_50", 50, 6, "black", 4, 0)
    assert known.codes.dtype == np.uint64 and known.codes[0] == 0xB532
    assert known.cells.shape == (16, 2) and known.cells[0].tolist() == [1, 1]
    assert runmark.Dictionary("tagStandard41h12").border == "reversed"
    assert repr(known) == "<Dictionary DICT_4X4_50: 50 markers>"


def test_a_file_and_its_text():
    path = DATA / "DICT_5X5_1000.codes"
    by_path, by_text = runmark.Dictionary(path), runmark.Dictionary.from_codes(path.read_text(), "mine")
    assert by_path.name == "DICT_5X5_1000" and by_text.name == "mine"
    assert (by_path.codes == by_text.codes).all()
    with pytest.raises(ValueError, match="mine, line 2"):
        runmark.Dictionary.from_codes("4 0\nxyz\n", "mine")


def test_bits_of_ones_own():
    bits = np.random.default_rng(1).integers(0, 2, (5, 6, 6))
    own = runmark.Dictionary.from_bits(bits, "own", corrected_bits=1)
    assert (len(own), own.width, own.corrected_bits) == (5, 8, 1)
    picture = np.pad(own.draw(3, 10, 2), 20, constant_values=255)
    assert runmark.Detector(own).detect(picture).ids.tolist() == [3]
    with pytest.raises(ValueError, match=r"shape \(5, 6\)"):
        runmark.Dictionary.from_bits(bits[:, :, 0], "own")
    with pytest.raises(ValueError, match="looks the same turned"):
        runmark.Dictionary.from_bits(np.zeros((1, 4, 4)), "own")
    assert len(runmark.Dictionary.from_bits(np.zeros((1, 4, 4)), "own", symmetric=[0])) == 1


def test_every_dictionary_can_be_drawn_and_read():
    for name in runmark.dictionary_names():
        known = runmark.Dictionary(name)
        drawn = known.draw(len(known) - 1, pixels_per_cell=8, margin_cells=2)
        assert drawn.dtype == np.uint8 and set(np.unique(drawn)) == {0, 255}
        picture = np.pad(drawn, 30, constant_values=255)
        found = runmark.Detector(known).detect(picture)
        assert found.ids.tolist() == [len(known) - 1] and found.dictionaries == [name], name


def test_what_cannot_be_drawn():
    known = runmark.Dictionary("DICT_4X4_50")
    with pytest.raises(IndexError, match="id 50: DICT_4X4_50 has 0 to 49"):
        known.draw(50)
    with pytest.raises(ValueError, match="pixels_per_cell"):
        known.draw(0, pixels_per_cell=0)
