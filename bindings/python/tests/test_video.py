"""Markers confirmed over frames, and the rows at which they were seen."""

import numpy as np
import pytest

import runmark
from scenes import page


def test_confirmation():
    confirmation = runmark.Confirmation(3)

    def ids(*markers):
        found = runmark.Detector("DICT_4X4_50").detect(page(list(markers)))  # a new detector for each frame
        confirmed = confirmation.next(found)
        assert confirmed.size == found.size
        return sorted(confirmed.ids.tolist())
    assert ids((7, 40, 60, 10)) == []
    assert ids((7, 45, 60, 10), (12, 200, 100, 10)) == []
    assert ids((7, 50, 60, 10)) == [7]
    assert ids() == []
    assert ids((7, 55, 60, 10), (12, 200, 100, 10)) == [7]
    confirmation.restart()
    assert ids((7, 55, 60, 10)) == []
    with pytest.raises(ValueError, match="frames 0"):
        runmark.Confirmation(0)


def test_rows():
    found = runmark.Detector("DICT_4X4_50").detect(page([(7, 40, 60, 10)]))
    assert found.rows.shape == (1, 2)
    np.testing.assert_allclose(found.rows[0], [59.5, 119.5], atol=0.1)
    np.testing.assert_array_equal(found[0].rows, found.rows[0])
