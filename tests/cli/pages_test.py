"""The commands shown in README.md and on the pages about them run as they stand there."""

import os
import pathlib
import re
import shlex
import subprocess
import unittest

from command import PROGRAM, SOURCE
from display import DisplayTest, needs_display


def commands(page):
    blocks = re.findall(r"^```sh\n(.*?)^```$", (SOURCE / page).read_text(), re.MULTILINE | re.DOTALL)
    return [line.split("#")[0] for block in blocks for line in block.splitlines()]


@needs_display
class Pages(DisplayTest):
    def run_page(self, page):
        lines = commands(page)
        self.assertTrue(lines)
        path = f"{pathlib.Path(PROGRAM).parent}:{os.environ['PATH']}"
        for line in lines:
            if line.startswith("runmark view"):
                self.start_view(*shlex.split(line)[2:], cwd=self.folder)
                self.press("q")
                self.expect_end(0)
            else:
                subprocess.run(["bash", "-ec", line], cwd=self.folder, env={**os.environ, "PATH": path}, check=True,
                               capture_output=True, timeout=300)

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


if __name__ == "__main__":
    unittest.main()
