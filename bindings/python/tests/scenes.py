"""Scenes for the tests, drawn by runmark itself."""

import numpy as np

import runmark


def page(markers, dictionary="DICT_4X4_50", size=(320, 240), level=255):
    """A light page with upright markers: (id, x, y, pixels_per_cell), x and y of the marker's top-left pixel."""
    image = np.full((size[1], size[0]), level, np.uint8)
    known = runmark.Dictionary(dictionary)
    for number, x, y, cell in markers:
        drawn = known.draw(number, cell, 1)
        image[y - cell:y - cell + len(drawn), x - cell:x - cell + len(drawn)] = drawn
    return image


def corners(x, y, cell, width=6):
    """The corners of such a marker."""
    left, top, side = x - 0.5, y - 0.5, cell * width
    return np.array([[left, top], [left + side, top], [left + side, top + side], [left, top + side]])


MARKERS = [(7, 40, 60, 16), (12, 200, 100, 10)]
