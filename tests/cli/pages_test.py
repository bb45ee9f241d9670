"""The commands shown in README.md and on the pages about them run as they stand there."""

import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import unittest

from command import PROGRAM, SOURCE, CommandTest
from display import DisplayTest, needs_display


PATH = f"{pathlib.Path(PROGRAM).parent}:{os.environ['PATH']}"
BOARD = "charuco:DICT_5X5_100:6x8:28:20"
CAMERA = """image_width: 640
image_height: 480
camera_matrix: {{rows: 3, cols: 3, data: [{focal}, 0, 319.5, 0, {focal}, 239.5, 0, 0, 1]}}
"""


def commands(page):
    blocks = re.findall(r"^```sh\n(.*?)^```$", (SOURCE / page).read_text(), re.MULTILINE | re.DOTALL)
    return [line.split("#")[0] for block in blocks for line in block.replace("\\\n", " ").splitlines()]


def run(line, folder):
    """What the command prints; it must succeed."""
    return subprocess.run(["bash", "-ec", line], cwd=folder, env={**os.environ, "PATH": PATH}, check=True,
                          capture_output=True, text=True, timeout=300).stdout


@needs_display
class Pages(DisplayTest):
    def run_page(self, page):
        lines = commands(page)
        self.assertTrue(lines)
        for line in lines:
            if line.startswith("runmark view"):
                self.start_view(*shlex.split(line)[2:], cwd=self.folder)
                self.press("q")
                self.expect_end(0)
            else:
                run(line, self.folder)

    def make_room(self):
        subprocess.run([PROGRAM, "render", "--set", "samples", "--scenes", "1", "--frames", "12", "-o", self.folder],
                       check=True, capture_output=True)

    def test_readme(self):
        self.run_page("README.md")
        lines = pathlib.Path(self.path("room.jsonl")).read_text().splitlines()
        self.assertEqual(len(lines), 30)
        self.assertIn('"row_times_us"', lines[-1])

    def test_detect(self):
        self.make_room()
        self.run_page("docs/detect.md")
        self.assertGreater(len(pathlib.Path(self.path("room.csv")).read_text().splitlines()), 30)

    def test_view(self):
        self.make_room()
        self.run_page("docs/view.md")


class PagesOfMeasuring(CommandTest):
    """Each page in a folder that holds what it says one has: a photo, its camera, photos of a board."""

    def run_page(self, page):
        lines = commands(page)
        self.assertTrue(lines)
        return [run(line, self.folder) for line in lines]

    def take_photo(self, board, first=0):
        run(f"runmark render --board {board} --scenes 1 --first {first} --format jpg --distortion 0 -o .", self.folder)
        truth, = json.loads((self.folder / "truth.json").read_text())
        (self.folder / truth["image"]).rename(self.path("photo.jpg"))
        (self.folder / "camera.yml").write_text(CAMERA.format(focal=truth["board"]["focal"]))
        return truth["board"]

    def expect_files(self, **beginnings):
        for name, beginning in beginnings.items():
            name = ".".join(name.rsplit("_", 1))
            self.assertTrue((self.folder / name).read_bytes().startswith(beginning), name)

    def test_pose(self):
        truth = self.take_photo("grid:tag36h11:1x1:60:1", first=2)
        frame = json.loads(self.run_page("docs/pose.md")[0])
        marker, = frame["markers"]
        # The grid's origin is the marker's corner.
        middle = [t + 30 * x + 30 * y for t, (x, y, _) in zip(truth["translation"], truth["rotation"])]
        self.assertLess(math.dist(marker["pose"]["translation"], middle), 0.005 * middle[2])
        self.assertEqual(len(marker["pose"]["covariance"]), 36)

    def test_boards(self):
        place = self.take_photo(BOARD)["translation"]
        frame = json.loads(self.run_page("docs/boards.md")[0])
        self.assertLess(math.dist(frame["board"]["pose"]["translation"], place), 0.01 * place[2])
        self.expect_files(board_pdf=b"%PDF")

    def test_printing(self):
        self.run_page("docs/printing.md")
        self.expect_files(sheet_pdf=b"%PDF", large_pdf=b"%PDF", board_pdf=b"%PDF", grid_svg=b"<?xml")

    def test_calibration(self):
        run(f"runmark render --board {BOARD} --scenes 12 -o photos", self.folder)
        truth = json.loads((self.folder / "photos/truth.json").read_text())
        printed, = self.run_page("docs/calibration.md")
        focal = float(re.search(r"fx +(\S+)", printed)[1])
        self.assertLess(abs(focal / truth[0]["board"]["focal"] - 1), 0.01)
        self.assertIn("distortion_model: plumb_bob", (self.folder / "camera_info.yaml").read_text())
        self.expect_files(camera_yml=b"%YAML", report_html=b"<!", coverage_png=b"\x89PNG")

    def test_tutorial(self):
        """Its commands, one after the other, end at the distance it promises."""
        lines = re.findall(r"^    \$ (.*)$", (SOURCE / "docs/tutorial.md").read_text(), re.MULTILINE)
        self.assertGreater(len(lines), 4)
        printed = [run(line, self.folder) for line in lines]
        measured = next(text for line, text in zip(lines, printed) if "--marker-size" in line)
        places = [[float(v) for v in place] for place in re.findall(r"at \((\S+), (\S+), (\S+)\) ", measured)]
        self.assertEqual(len(places), 2, measured)
        self.assertAlmostEqual(math.dist(*places), 200, delta=2)
        self.assertAlmostEqual(float(printed[-1].split()[0]), 200, delta=2)


if __name__ == "__main__":
    unittest.main()
