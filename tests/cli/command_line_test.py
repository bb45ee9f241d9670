"""What the command line refuses, and how it says so."""

import pathlib
import unittest

import scene
from command import CommandTest


class CommandLine(CommandTest):
    def setUp(self):
        super().setUp()
        self.file = self.path("a.pgm")
        scene.write_pgm(self.file, scene.one_marker())

    def detect_error(self, arguments, *parts):
        with self.subTest(arguments):
            self.expect_error(self.run_program("detect", *arguments), *parts)

    def test_version_and_help(self):
        self.assertRegex(self.run_program("--version").stdout, rb"^runmark \d+\.\d+\.\d+\n$")
        self.assertIn(b"detect", self.run_program("--help").stdout)
        self.assertIn(b"DICT_4X4_50", self.run_program("detect", "--help").stdout)

    def test_no_command(self):
        self.expect_error(self.run_program(), "no command")

    def test_unknown_command_and_option(self):
        self.expect_error(self.run_program("find"), "find")
        self.detect_error([self.file, "--fast"], "--fast")

    def test_no_input(self):
        self.detect_error([], "INPUT")

    def test_options_out_of_range(self):
        for arguments, parts in (
                (["--format", "xml"], ["--format", "xml"]),
                (["--pipeline", "fast"], ["--pipeline", "fast"]),
                (["--region", "1,2"], ["--region"]),
                (["--region", "a,b,c,d"], ["--region"]),
                (["--octaves", "x"], ["--octaves"]),
                (["--octaves", "-1"], ["octaves"]),
                (["--corrected-bits", "99"], ["--corrected-bits"]),
                (["--min-size", "100", "--max-size", "50"], ["marker size"]),
                (["--dict", "DICT_4X4_51"], ["DICT_4X4_51", "DICT_4X4_50"]),
                (["--dict", self.path("none.codes")], [self.path("none.codes")]),
                (["--dict", "DICT_4X4_50", "--pipeline", "paper"], ["DICT_4X4_50"])):
            self.detect_error([self.file, *arguments], *parts)

    def test_inputs_that_cannot_be_read(self):
        self.detect_error([self.path("none.png")], self.path("none.png"), "No such file")
        for name, data in (("empty.png", b""), ("text.png", b"hello"), ("text.mp4", b"hello"), ("text", b"hello"),
                           ("cut.pgm", b"P5 320 240 255\n" + bytes(100)),
                           ("head.jpg", b"\xff\xd8\xff\xe0\x00\x10JFIF")):
            pathlib.Path(self.path(name)).write_bytes(data)
            self.detect_error([self.path(name)], self.path(name))
        scene.write_png(self.path("cut.png"), scene.one_marker())
        whole = pathlib.Path(self.path("cut.png")).read_bytes()
        pathlib.Path(self.path("cut.png")).write_bytes(whole[:len(whole) // 2])
        self.detect_error([self.path("cut.png")], self.path("cut.png"))

    def test_a_named_input_that_is_missing_is_told_before_any_work(self):
        result = self.run_program("detect", self.file, self.path("none.png"))
        self.assertEqual(result.stdout, b"")
        self.expect_error(result, self.path("none.png"))

    def test_frame_larger_than_any_detector_takes(self):
        pathlib.Path(self.path("wide.pgm")).write_bytes(b"P5 70000 1 255\n" + bytes(70000))
        self.detect_error([self.path("wide.pgm")], self.path("wide.pgm"))


if __name__ == "__main__":
    unittest.main()
