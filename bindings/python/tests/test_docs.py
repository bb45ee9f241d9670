"""The programs in docs/python.md and docs/opencv.md run as they stand there."""

import pathlib
import re

import numpy as np
import pytest

import runmark
from scenes import page

DOCS = pathlib.Path(__file__).resolve().parents[3] / "docs"
CAMERA = """image_width: 640
image_height: 480
distortion_model: plumb_bob
camera_matrix: {rows: 3, cols: 3, data: [600, 0, 319.5, 0, 600, 239.5, 0, 0, 1]}
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
"""


def blocks(name):
    return re.findall(r"^```python\n(.*?)^```$", (DOCS / name).read_text(), re.MULTILINE | re.DOTALL)


def test_the_python_page(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    pathlib.Path("camera.yaml").write_text(CAMERA)
    image = page([(7, 100, 100, 16), (12, 300, 200, 10)], size=(640, 480))
    names = {"image": image, "width": 640, "height": 480, "camera": [image[:200], image[200:]], "video": [image] * 4,
             "bits": np.random.default_rng(1).integers(0, 2, (5, 6, 6))}
    programs = blocks("python.md")
    assert len(programs) == 5
    for program in programs:
        exec(compile(program, "docs/python.md", "exec"), names)
    printed = capsys.readouterr().out
    assert "DICT_4X4_50 7" in printed and "known after row" in printed
    assert names["times"].shape == (2, 2)
    assert names["found"].ids.shape == (2,) and names["picture"].shape == (200, 200)


def test_the_opencv_page():
    pytest.importorskip("cv2")
    names = {"image": page([(7, 100, 100, 16)])}
    exec("import cv2, runmark, runmark.aruco\n"
         "dictionary, parameters = cv2.aruco.getPredefinedDictionary(0), None", names)
    programs = blocks("opencv.md")
    assert len(programs) == 2
    for program in programs:
        exec(compile(program, "docs/opencv.md", "exec"), names)
    assert names["aruco"] is runmark.aruco
    assert names["ids"].tolist() == [[7]] and names["corners"][0].shape == (1, 4, 2)
