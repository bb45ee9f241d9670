"""Finds the markers of one picture, in Python: detect.py PICTURE"""

# README.md shows the lines between the marks; a test compares them.
# [readme]
import cv2
import runmark

detector = runmark.Detector(dictionaries=["tag36h11"])


def print_markers(path):
    found = detector.detect(cv2.imread(path))
    for marker in found:
        x, y = marker.corners[0]
        print(f"{marker.dictionary} {marker.id}: top-left corner {x:g}, {y:g}")
    return found.corners  # float64 (N, 4, 2)
# [readme]


if __name__ == "__main__":
    import sys

    if len(sys.argv) != 2:
        sys.exit("usage: detect.py PICTURE")
    print_markers(sys.argv[1])
