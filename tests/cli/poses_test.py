"""Poses on the command line: cameras, sizes and boards."""

import csv
import io
import json
import math
import os
import pathlib
import re
import unittest

import scene
from command import CommandTest

CAMERA = """%YAML:1.0
---
image_width: 320
image_height: 240
camera_matrix: !!opencv-matrix
   rows: 3
   cols: 3
   dt: d
   data: [ 400., 0., 159.5, 0., 400., 119.5, 0., 0., 1. ]
distortion_coefficients: !!opencv-matrix
   rows: 1
   cols: 5
   dt: d
   data: [ 0., 0., 0., 0., 0. ]
"""


class Poses(CommandTest):
    def setUp(self):
        super().setUp()
        self.camera = self.path("camera.yml")
        pathlib.Path(self.camera).write_text(CAMERA)
        # Two markers that face the camera: 96 and 60 pixels wide.
        self.page = scene.Scene().add("DICT_4X4_1000", 7, 40, 60, 16).add("DICT_4X4_1000", 12, 200, 100, 10)
        self.file = self.path("page.pgm")
        scene.write_pgm(self.file, self.page)

    def test_pose_of_markers_with_sizes_by_id(self):
        frame, = self.detect(self.file, "--camera-info", self.camera, "--marker-size", "0.12", "--marker-size", "12=0.06")
        poses = {marker["id"]: marker["pose"] for marker in frame["markers"]}
        for number, size, pixels, middle in ((7, 0.12, 96, (87.5, 107.5)), (12, 0.06, 60, (229.5, 129.5))):
            x, y, z = poses[number]["translation"]
            distance = 400 * size / pixels
            self.assertAlmostEqual(z, distance, delta=0.003 * distance)
            self.assertAlmostEqual(x, (middle[0] - 159.5) / 400 * distance, delta=0.002 * distance)
            self.assertAlmostEqual(y, (middle[1] - 119.5) / 400 * distance, delta=0.002 * distance)
            self.assertLess(math.hypot(*poses[number]["rotation_vector"]), 0.15)
            self.assertEqual(len(poses[number]["covariance"]), 36)
            self.assertLess(poses[number]["error"], 0.1)
            self.assertTrue(0 <= poses[number]["ambiguity"] <= 1)

    def test_marker_without_a_size_has_no_pose(self):
        frame, = self.detect(self.file, "--camera-info", self.camera, "--marker-size", "DICT_4X4_50:12=0.06")
        self.assertEqual({marker["id"]: "pose" in marker for marker in frame["markers"]}, {7: False, 12: True})

    def test_csv_has_columns_for_poses(self):
        result = self.run_program("detect", "-d", "DICT_4X4_50", "-f", "csv", self.file, "--camera-info", self.camera,
                                  "--marker-size", "12=0.06")
        self.assertEqual(result.stderr, b"")
        rows = {row["id"]: row for row in csv.DictReader(io.StringIO(result.stdout.decode()))}
        self.assertAlmostEqual(float(rows["12"]["tz"]), 0.4, delta=0.002)
        self.assertEqual(rows["7"]["tz"], "")

    def test_text_and_annotated_picture(self):
        picture = self.path("out.png")
        result = self.run_program("detect", "-d", "DICT_4X4_50", self.file, "--camera-info", self.camera,
                                  "--marker-size", "0.1", "--annotate", picture)
        self.assertEqual((result.stderr, result.stdout.count(b"    at (")), (b"", 2))
        self.assertGreater(pathlib.Path(picture).stat().st_size, 1000)

    def test_pose_of_a_board(self):
        # A grid of two markers, 16 pixels a cell: 96 wide, 32 apart.
        page = scene.Scene().add("DICT_4X4_1000", 0, 40, 60, 16).add("DICT_4X4_1000", 1, 168, 60, 16)
        scene.write_pgm(self.file, page)
        result = self.run_program("detect", "-f", "jsonl", self.file, "--camera-info", self.camera,
                                  "--board", "grid:DICT_4X4_50:2x1:0.06:0.02")
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        board = json.loads(result.stdout)["board"]
        self.assertEqual(board["markers"], 2)
        x, y, z = board["pose"]["translation"]
        self.assertAlmostEqual(z, 400 * 0.06 / 96, delta=0.001)
        self.assertAlmostEqual(x, (39.5 - 159.5) / 400 * z, delta=0.001)
        self.assertAlmostEqual(y, (59.5 - 119.5) / 400 * z, delta=0.001)

    def test_board_without_a_camera_gives_its_corners(self):
        board = self.charuco(legacy=False)
        self.assertEqual(len(board["corners"]), 4)
        self.assertNotIn("pose", board)
        # The square's corners lie at whole pixels.
        self.assertEqual([[round(v, 1) for v in corner["place"]] for corner in board["corners"]],
                         [[89.5, 69.5], [139.5, 69.5], [89.5, 119.5], [139.5, 119.5]])

    def charuco(self, legacy):
        """Draws a board of 3 x 3 squares (or 3 x 4 of the old layout) and reads it as one of 3 x 3 (3 x 4)."""
        rows = 4 if legacy else 3
        page = scene.Scene()
        number = 0
        for row in range(rows):
            for column in range(3):
                x, y = 40 + 50 * column, 20 + 50 * row
                if (row + column) % 2 == (1 if legacy else 0):
                    for line in page.rows[y:y + 50]:
                        line[x:x + 50] = bytes([page.black] * 50)
                else:
                    page.add("DICT_4X4_1000", number, x + 10, y + 10, 5)
                    number += 1
        scene.write_pgm(self.file, page)
        result = self.run_program("detect", "-f", "jsonl", self.file, "--board", f"charuco:DICT_4X4_50:3x{rows}:50:30")
        if legacy:
            self.expect_error(result, self.file, "the layout of OpenCV before 4.6")
        else:
            self.assertEqual((result.stderr, result.returncode), (b"", 0))
        return json.loads(result.stdout)["board"]

    def test_says_when_the_picture_fits_the_other_layout(self):
        self.assertIn("before 4.6", self.charuco(legacy=True)["advice"])

    def test_what_is_wrong(self):
        run = lambda *arguments: self.run_program("detect", self.file, *arguments)
        self.expect_error(run("--marker-size", "0.1"), "--marker-size needs --camera-info")
        self.expect_error(run("--camera-info", self.camera), "--camera-info needs --marker-size or --board")
        self.expect_error(run("--camera-info", self.camera, "--marker-size", "big"), "'big' is not a marker size")
        self.expect_error(run("--camera-info", self.path("none.yml"), "--marker-size", "1"), "none.yml: cannot be read")
        pathlib.Path(self.camera).write_text("image_width: 1\n")
        self.expect_error(run("--camera-info", self.camera, "--marker-size", "1"), "camera.yml: there is no camera_matrix")
        pathlib.Path(self.camera).write_text(CAMERA.replace("320", "640"))
        self.expect_error(run("--camera-info", self.camera, "--marker-size", "1"), "page.pgm", "320 x 240", "640 x 240")
        self.expect_error(run("--board", "hexagons"), "a board is a .json file")
        self.expect_error(run("--board", "grid:DICT_4X4_50:2x1:1:1", "-f", "csv"), "--board has no place in csv")


REAL = pathlib.Path(os.environ.get("RUNMARK_SHARED", scene.SOURCE.parent / "shared")) / "real-images"


@unittest.skipUnless(REAL.is_dir(), f"{REAL} is not there: no real photo is measured")
class RealPoses(CommandTest):
    def test_are_where_the_aruco_library_has_them(self):
        """A photo of the ArUco library's own tests, with its camera and the poses it expects."""
        frame, = self.detect(REAL / "images/aruco__image-test_1.png", "--camera-info", REAL / "calib/uco_single_intrinsics.yml",
                             "--marker-size", "1", dictionary="DICT_ARUCO_ORIGINAL")
        expected = dict(re.findall(r"id: (\d+)\s+Tvec: \[([^]]*)\]", (REAL / "calib/uco_single_expected.yml").read_text()))
        self.assertEqual(sorted(marker["id"] for marker in frame["markers"]), sorted(map(int, expected)))
        for marker in frame["markers"]:
            place = [float(value) for value in expected[str(marker["id"])].split(",")]
            self.assertLess(math.dist(marker["pose"]["translation"], place), 0.02 * math.hypot(*place))
            # All lie on one table: their frames are turned alike.
            turn = marker["pose"]["rotation_vector"]
            self.assertLess(math.dist(turn, frame["markers"][0]["pose"]["rotation_vector"]), 0.25)
