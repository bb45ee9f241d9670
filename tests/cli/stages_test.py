"""`runmark stages` shows what the pipelines really do."""

import json
import os
import pathlib
import re
import shutil
import struct
import unittest

import scene
from command import CommandTest


def png_size(path):
    data = pathlib.Path(path).read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n") and data.endswith(b"IEND\xaeB`\x82")
    return struct.unpack(">II", data[16:24])


class Stages(CommandTest):
    def setUp(self):
        super().setUp()
        page = scene.Scene().add("tag36h11", 3, 40, 60, 12).add("tag36h11", 9, 200, 80, 8)
        self.image = self.path("a.png")
        scene.write_png(self.image, page)

    def stages(self, *arguments):
        """The captions of the pictures by their names."""
        shutil.rmtree(self.path("out"), ignore_errors=True)
        result = self.run_program("stages", self.image, "-o", self.path("out"), "--dict", "tag36h11", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        lines = [line.split(".png: ", 1) for line in result.stdout.decode().splitlines()]
        captions = {os.path.basename(path): caption for path, caption in lines}
        self.assertEqual(sorted(os.listdir(self.path("out"))), sorted(f"{name}.png" for name in captions))
        return captions

    def stats(self, *arguments):
        result = self.run_program("detect", self.image, "-f", "jsonl", "--stats", "--dict", "tag36h11", *arguments)
        return json.loads(result.stdout)["stats"]

    def test_counts_are_those_of_the_pipeline(self):
        for pipeline in ("default", "hardware", "paper"):
            with self.subTest(pipeline):
                captions = self.stages("--pipeline", pipeline)
                stats = self.stats("--pipeline", pipeline)
                runs = [int(re.search(r"(\d+) crack runs", caption)[1]) for caption in captions.values()
                        if "crack runs" in caption]
                self.assertEqual(len(runs), 3 if pipeline == "default" else 1)
                self.assertEqual(sum(runs), stats["crack_runs"])
                self.assertIn(f"{stats['closed_chains']} closed", captions["4-contours"])
                self.assertIn(f"{stats['quads']} quadrilaterals", captions["5-corners"])
                self.assertEqual(captions["7-markers"], "2 markers")

    def test_sizes(self):
        self.stages()
        for name, size in (("1-original", (320, 240)), ("2-threshold", (320, 240)), ("2-threshold-half-2", (160, 120)),
                           ("2-threshold-half-4", (80, 60)), ("4-contours", (320, 240)), ("7-markers", (320, 240))):
            self.assertEqual(png_size(self.path(f"out/{name}.png")), size)
        width, height = png_size(self.path("out/sheet.png"))
        self.assertGreater(width, 1000)
        self.assertGreater(height, 500)

    def test_region(self):
        captions = self.stages("--region", "20,40,150,180")
        self.assertEqual(captions["7-markers"], "1 marker")
        self.assertEqual(png_size(self.path("out/7-markers.png")), (150, 180))

    def test_pictures_without_markers(self):
        for value in (0, 128, 255):
            with self.subTest(value):
                scene.write_png(self.image, scene.Scene(width=64, height=48, white=value))
                self.assertEqual(self.stages()["7-markers"], "0 markers")
        scene.write_png(self.image, scene.Scene(width=1, height=1))
        self.stages("--octaves", "0")

    def test_what_is_refused(self):
        text = self.path("text.png")
        pathlib.Path(text).write_text("no picture")
        out = ["-o", self.path("out")]
        self.expect_error(self.run_program("stages", self.path("none.png"), *out), self.path("none.png"), "No such file")
        self.expect_error(self.run_program("stages", text, *out), text)
        self.expect_error(self.run_program("stages", self.image), "--output")
        self.expect_error(self.run_program("stages", self.image, "-o", text), text)
        self.expect_error(self.run_program("stages", self.image, *out, "--region", "500,0,10,10"), "--region")
        self.expect_error(self.run_program("stages", self.image, *out, "--pipeline", "paper", "--dict", "DICT_4X4_50"),
                          "DICT_4X4_50")

    def test_the_input_is_never_replaced(self):
        os.mkdir(self.path("out"))
        image = self.path("out/1-original.png")
        os.rename(self.image, image)
        before = pathlib.Path(image).read_bytes()
        self.expect_error(self.run_program("stages", image, "-o", self.path("out")), image)
        self.assertEqual(pathlib.Path(image).read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
