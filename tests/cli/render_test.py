"""runmark render: files and truth it writes, markers that are found again, and what it refuses."""

import json
import math
import pathlib
import unittest

from command import CommandTest


class Render(CommandTest):
    def render(self, *arguments, folder="scenes"):
        result = self.run_program("render", "-o", self.path(folder), *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return json.loads(pathlib.Path(self.path(folder), "truth.json").read_text())

    def bytes_of(self, folder, name):
        return pathlib.Path(self.path(folder), name).read_bytes()

    def test_a_few_scenes_of_a_set(self):
        truth = self.render("--set", "vga", "--scenes", 3, "--format", "pgm")
        self.assertEqual([frame["image"] for frame in truth], ["vga_0000.pgm", "vga_0001.pgm", "vga_0002.pgm"])
        self.assertEqual([frame["scene"]["index"] for frame in truth], [0, 1, 2])
        self.assertTrue(self.bytes_of("scenes", "vga_0001.pgm").startswith(b"P5\n640 480\n255\n"))
        self.assertGreater(sum(len(frame["markers"]) for frame in truth), 6)
        # Scene 2 is the same wherever the work begins and however many do it.
        again = self.render("--set", "vga", "--scenes", 1, "--first", 2, "--jobs", 1, "--format", "pgm", folder="again")
        self.assertEqual(again[0], truth[2])
        self.assertEqual(self.bytes_of("again", "vga_0002.pgm"), self.bytes_of("scenes", "vga_0002.pgm"))
        other = self.render("--set", "vga", "--scenes", 1, "--first", 2, "--seed", 9, folder="other")
        self.assertNotEqual(other[0]["markers"], truth[2]["markers"])

    def test_detect_finds_what_was_rendered(self):
        easy = ["--marker-size", "50:90", "--tilt", "0:40", "--blur", "0.4", "--motion", 0, "--noise", 1, "--margin", 1.5,
                "--shadows", 0, "--lamps", 0, "--level", 1, "--distortion", 0, "--occluded", 0, "--cut", 0]
        for dictionary in ("DICT_4X4_50", "tag36h11", "tagStandard41h12"):
            truth = self.render("--scenes", 4, "--dict", dictionary, *easy, folder=dictionary)
            required = sum(len(frame["markers"]) for frame in truth)
            found = 0
            for frame in truth:
                [seen] = self.detect(self.path(f"{dictionary}/{frame['image']}"), dictionary=dictionary)
                for marker in frame["markers"]:
                    found += any(m["id"] == marker["id"] and max(
                        math.dist(a, b) for a, b in zip(m["corners"], marker["corners"])) < 1 for m in seen["markers"])
            self.assertGreater(required, 10)
            self.assertGreaterEqual(found, 0.9 * required, dictionary)

    def test_samples_in_colour_and_as_video(self):
        truth = self.render("--set", "samples", "--scenes", 2, "--colour", "--format", "jpg")
        self.assertEqual([(t["image"], t["dictionary"]) for t in truth],
                         [("room.jpg", "tag36h11"), ("board.jpg", "DICT_5X5_250")])
        frames = self.render("--set", "samples", "--scenes", 1, "--size", "320x240", "--frames", 3, folder="video")
        self.assertEqual([(t["image"], t["frame"]) for t in frames], [("room.avi", i) for i in range(3)])
        self.assertGreater(len(self.bytes_of("video", "room.avi")), 5000)

    def test_what_it_refuses(self):
        for arguments, parts in (
                (["--set", "huge"], ["--set huge", "fullhd"]),
                (["--tilt", "90"], ["--tilt 90", "85"]),
                (["--blur", "1:x"], ["--blur 1:x"]),
                (["--blur", "2:1"], ["--blur 2:1"]),
                (["--size", "big"], ["--size big"]),
                (["--wall", "sky"], ["--wall sky", "brick"]),
                (["--dict", "DICT_4X4_51"], ["DICT_4X4_51"]),
                (["--format", "avi"], ["--format avi", "--frames"]),
                (["--format", "png", "--frames", 2], ["--format png"]),
                (["--format", "pgm", "--colour"], ["--format pgm"]),
                (["--background", self.path("none")], [self.path("none")])):
            with self.subTest(arguments):
                self.expect_error(self.run_program("render", "-o", self.path("out"), *arguments), *parts)
        file = pathlib.Path(self.path("file"))
        file.write_text("not a folder")
        self.expect_error(self.run_program("render", "--scenes", 1, "-o", file / "in"), str(file))


if __name__ == "__main__":
    unittest.main()
