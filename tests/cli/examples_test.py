"""The examples that need more than one picture: pose, board, video to CSV."""

import json
import pathlib
import re
import subprocess

import scene
from command import PROGRAM, CommandTest, needs_ffmpeg

BOARD = "charuco:DICT_5X5_100:6x8:28:20"
CAMERA = """image_width: 640
image_height: 480
camera_matrix: {{rows: 3, cols: 3, data: [{focal}, 0, 319.5, 0, {focal}, 239.5, 0, 0, 1]}}
"""


class Examples(CommandTest):
    def example(self, name, *arguments):
        program = pathlib.Path(PROGRAM).parent / f"example_{name}"
        result = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=60)
        self.assertEqual((result.stderr, result.returncode), ("", 0))
        return result.stdout

    def render(self, *arguments):
        result = self.run_program("render", "--scenes", 1, "--format", "pgm", "--distortion", 0, "-o", self.path("r"), *arguments)
        self.assertEqual(result.returncode, 0)
        truth, = json.loads(pathlib.Path(self.path("r"), "truth.json").read_text())
        camera = self.path("camera.yml")
        pathlib.Path(camera).write_text(CAMERA.format(focal=truth["board"]["focal"]))
        return pathlib.Path(self.path("r"), truth["image"]), camera, truth["board"]["translation"]

    def test_board(self):
        picture, camera, place = self.render("--board", BOARD)
        text = self.example("board", picture, camera, BOARD)
        self.assertRegex(text, r"\d+ markers, \d+ chessboard corners\n")
        found = [float(v) for v in re.search(r"is at (\S+) (\S+) (\S+),", text).groups()]
        for a, b in zip(found, place):
            self.assertAlmostEqual(a, b, delta=0.002 * place[2])

    def test_pose(self):
        picture, camera, place = self.render("--board", "grid:tag36h11:1x1:100:1")
        text = self.example("pose", picture, camera, 100)
        match = re.search(r"tag36h11 0: at \S+ \S+ (\S+), distance \+- (\S+), ambiguity", text)
        # The grid's origin is the marker's corner, so the middle is up to 71 away from it.
        self.assertAlmostEqual(float(match[1]), place[2], delta=71)
        self.assertTrue(0 < float(match[2]) < 5)

    @needs_ffmpeg
    def test_video_to_csv(self):
        video = self.ffmpeg([scene.one_marker(x=100 + 4 * i) for i in range(5)], "video.avi", "-c:v", "mjpeg", "-q:v", "2")
        lines = self.example("video_to_csv", video, "DICT_4X4_50").splitlines()
        self.assertEqual(lines[0].split(",")[:4], ["frame", "dictionary", "id", "x0"])
        rows = [line.split(",") for line in lines[1:]]
        self.assertEqual([row[:3] for row in rows], [[str(i), "DICT_4X4_50", "7"] for i in range(5)])
        self.assertAlmostEqual(float(rows[4][3]) - float(rows[0][3]), 16, delta=0.3)
