"""The hardware as a command, beside `runmark detect` in both profiles; RUNMARK_RTL and RUNMARK_PROGRAM say where they are."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tests" / "cli"))
import scene  # noqa: E402

BIN = SOURCE / "build/release/bin"
HARDWARE = os.environ.get("RUNMARK_RTL", str(BIN / "runmark-rtl"))
SOFTWARE = os.environ.get("RUNMARK_PROGRAM", str(BIN / "runmark"))


def markers(width=320, height=240):
    return scene.Scene(width, height).add("DICT_6X6_1000", 7, 40, 20, 9).add("DICT_6X6_1000", 249, 200, 100, 11)


class Command(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="runmark-rtl-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def path(self, name):
        return str(self.folder / name)

    def run_hardware(self, *arguments):
        return subprocess.run([HARDWARE, *map(str, arguments)], capture_output=True, timeout=120)

    def frames(self, *arguments):
        result = self.run_hardware("--dict", "DICT_6X6_250", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return [json.loads(line) for line in result.stdout.splitlines()]

    def expect_error(self, result, *parts):
        text = result.stderr.decode()
        self.assertEqual((result.returncode, text.count("\n")), (2, 1), text)
        self.assertTrue(text.startswith("runmark-rtl: "), text)
        for part in parts:
            self.assertIn(part, text)

    def test_prints_what_the_detector_prints(self):
        """Grey and colour, one frame behind the other, and one for the larger core."""
        paths = [self.path(name) for name in ("a.pgm", "b.ppm", "c.pgm")]
        scene.write_pgm(paths[0], markers())
        scene.write_ppm(paths[1], markers(400, 300))
        scene.write_pgm(paths[2], markers(700, 250))
        frames = self.frames(*paths)
        detected = self.detected("--pipeline", "paper", "--dict", "DICT_6X6_250", *paths)
        for frame, plain, ends, records in zip(frames, detected, (640, 640, 3840), (1023, 1023, 4095), strict=True):
            hardware = frame.pop("hardware")
            self.assertEqual(frame, plain)
            self.assertEqual(sorted(marker["id"] for marker in frame["markers"]), [7, 249])
            pixels = frame["width"] * frame["height"]
            self.assertGreaterEqual(hardware["clocks"], pixels)
            self.assertLess(hardware["clocks_per_pixel"], 1.03)
            for clocks, lines in zip(hardware["latency_clocks"], hardware["latency_lines"], strict=True):
                # The filter runs a row late; then the chain is walked along and 64 pixels are read.
                self.assertTrue(1 <= lines < 25, hardware)
                self.assertAlmostEqual(lines, clocks / frame["width"], delta=0.001)
            self.assertEqual((hardware["ends"], hardware["records"]), (ends, records))
            self.assertTrue(0 < hardware["record_peak"] < 200 and 0 < hardware["end_peak"] <= 100, hardware)
            self.assertEqual([hardware[f"dropped_{why}"] for why in ("full", "queue")], [0, 0])
            self.assertFalse(hardware["rest_given_up"])

    def test_prints_what_the_detector_prints_in_the_hardware_profile(self):
        """Markers of 4x4 cells at any rotation, and one picture for the larger core."""
        paths = [self.path(name) for name in ("a.pgm", "b.ppm", "c.pgm")]
        for path, write, size in zip(paths, (scene.write_pgm, scene.write_ppm, scene.write_pgm),
                                     ((320, 240), (400, 300), (700, 250)), strict=True):
            write(path, scene.Scene(*size).add("DICT_4X4_1000", 7, 40, 20, 9).add("DICT_4X4_1000", 41, 200, 100, 11))
        arguments = ["--dict", "DICT_4X4_50", "--pipeline", "hardware"]
        frames = [json.loads(line) for line in self.run_hardware(*arguments, *paths).stdout.splitlines()]
        for frame, plain, records in zip(frames, self.detected(*arguments, *paths), (2047, 2047, 8191), strict=True):
            hardware = frame.pop("hardware")
            self.assertEqual(frame, plain)
            self.assertEqual(sorted(marker["id"] for marker in frame["markers"]), [7, 41])
            self.assertEqual(hardware["records"], records)
            # The threshold runs eight rows late.
            self.assertTrue(all(8 <= lines < 60 for lines in hardware["latency_lines"]), hardware)

    def detected(self, *arguments):
        result = subprocess.run([SOFTWARE, "detect", "-f", "jsonl", *arguments], capture_output=True, timeout=60, check=True)
        return [json.loads(line) for line in result.stdout.splitlines()]

    def test_prints_what_the_detector_prints_of_photos(self):
        photos = pathlib.Path(os.environ.get("RUNMARK_SHARED", SOURCE.parent / "shared")) / "real-images"
        if not photos.is_dir():
            self.skipTest(f"{photos} is not there: no photos are run")
        truth = json.loads((photos / "truth.json").read_text())
        small = [photo for photo in truth if photo["width"] <= 640 and photo["height"] <= 480]
        paths = [str(photos / "images" / photo["image"]) for photo in small[::max(1, len(small) // 6)]]
        for arguments in (["--dict", "tag36h11", "--threshold", "100", "--pipeline", "paper"],
                          ["--dict", "tag36h11", "--pipeline", "hardware"]):
            frames = [json.loads(line) for line in self.run_hardware(*arguments, *paths).stdout.splitlines()]
            for frame in frames:
                frame.pop("hardware")
            self.assertEqual(frames, self.detected(*arguments, *paths))

    def test_writes_waves(self):
        scene.write_pgm(self.path("a.pgm"), scene.Scene(64, 40))
        self.assertEqual(len(self.frames("--trace", self.path("a.fst"), self.path("a.pgm"))), 1)
        wave = (self.folder / "a.fst").read_bytes()
        # An FST file begins with its header block, of this length.
        self.assertEqual(wave[:9], b"\0" + (329).to_bytes(8, "big"))
        self.assertGreater(len(wave), 5000)

    def test_refuses_bad_input(self):
        scene.write_pgm(self.path("a.pgm"), markers())
        scene.write_pgm(self.path("b.pgm"), scene.Scene(2, 40))
        (self.folder / "c.png").write_bytes(b"no picture")
        good = self.path("a.pgm")
        self.expect_error(self.run_hardware(), "IMAGE")
        self.expect_error(self.run_hardware(self.path("missing.png")), "missing.png")
        self.expect_error(self.run_hardware(self.path("b.pgm")), "b.pgm: 2 x 40 pixels", "3 x 3 to 3840 x 2160")
        self.expect_error(self.run_hardware("--dict", "DICT_4X4_50", good), "DICT_4X4_50", "6x6")
        self.expect_error(self.run_hardware("--dict", "DICT_9X9", good), "DICT_9X9")
        self.expect_error(self.run_hardware("--pipeline", "default", good), "--pipeline")
        self.expect_error(self.run_hardware("--pipeline", "hardware", self.path("b.pgm")), "b.pgm", "16 x 3 to 3840 x 2160")
        self.expect_error(self.run_hardware("--pipeline", "hardware", "--dict", "tagCircle21h7", good), "4x4 to 8x8")
        self.expect_error(self.run_hardware("--threshold", 257, good), "--threshold")
        self.expect_error(self.run_hardware("--trace", self.path("no/w.fst"), good), "no/w.fst")
        self.expect_error(self.run_hardware("--trace", self.path("w.fst"), good, good), "--trace")
        # A broken picture among good ones is said, and the good ones are done.
        result = self.run_hardware("--dict", "DICT_6X6_250", self.path("c.png"), good)
        self.expect_error(result, "c.png")
        self.assertEqual(len(json.loads(result.stdout)["markers"]), 2)


if __name__ == "__main__":
    unittest.main()
