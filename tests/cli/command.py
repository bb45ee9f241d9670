"""Runs the built program; RUNMARK_PROGRAM says where it is."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import scene

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("RUNMARK_PROGRAM", str(SOURCE / "build/release/bin/runmark"))
FFMPEG = shutil.which("ffmpeg")
needs_ffmpeg = unittest.skipUnless(FFMPEG, "ffmpeg is not installed: no videos are made or tested")


class CommandTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="runmark-test-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def run_program(self, *arguments, stdin=b"", **keywords):
        return subprocess.run([PROGRAM, *map(str, arguments)], input=stdin, capture_output=True, timeout=120,
                              **keywords)

    def detect(self, *arguments, stdin=b"", dictionary="DICT_4X4_50"):
        """The frames as `detect -f jsonl` prints them; the command must succeed in silence."""
        result = self.run_program("detect", "-f", "jsonl", "--dict", dictionary, *arguments, stdin=stdin)
        self.assertEqual(result.stderr, b"")
        self.assertEqual(result.returncode, 0)
        return [json.loads(line) for line in result.stdout.splitlines()]

    def expect_error(self, result, *parts, status=2):
        """One line on stderr that begins with the program's name and holds each of the parts."""
        text = result.stderr.decode()
        self.assertEqual(result.returncode, status, text)
        self.assertEqual(text.count("\n"), 1, text)
        self.assertTrue(text.startswith("runmark: ") and text.endswith("\n"), text)
        for part in parts:
            self.assertIn(part, text)

    def expect_markers(self, frame, scene, tolerance=0.25):
        """The frame holds exactly the scene's markers, corners in their order."""
        found = sorted((marker["id"], marker["corners"]) for marker in frame["markers"])
        wanted = sorted((number, corners) for number, corners in scene.markers)
        self.assertEqual([number for number, _ in found], [number for number, _ in wanted])
        for (_, corners), (_, truth) in zip(found, wanted):
            for (x, y), (true_x, true_y) in zip(corners, truth):
                self.assertLess(max(abs(x - true_x), abs(y - true_y)), tolerance)

    def ffmpeg(self, scenes, name, *options):
        """Encodes the scenes with ffmpeg."""
        path = self.path(name)
        subprocess.run([FFMPEG, "-v", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-", *options, path],
                       input=scene.y4m_bytes(scenes), check=True)
        return path
