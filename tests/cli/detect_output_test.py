"""What `runmark detect` prints and draws."""

import csv
import io
import json
import os
import pathlib
import unittest

import scene
from command import CommandTest, needs_ffmpeg


def two_markers():
    return scene.Scene().add("DICT_4X4_1000", 7, 40, 60, 16).add("DICT_4X4_1000", 12, 200, 100, 10)


class Formats(CommandTest):
    def setUp(self):
        super().setUp()
        self.page = two_markers()
        self.file = self.path('a "b", c.pgm')
        scene.write_pgm(self.file, self.page)

    def output(self, *arguments):
        result = self.run_program("detect", "--dict", "DICT_4X4_50", *arguments, self.file)
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return result.stdout.decode()

    def test_jsonl(self):
        lines = self.output("--format", "jsonl").splitlines()
        self.assertEqual(len(lines), 1)
        frame = json.loads(lines[0])
        self.assertEqual(list(frame), ["source", "frame", "width", "height", "markers"])
        for marker in frame["markers"]:
            self.assertEqual(list(marker), ["dictionary", "id", "corners", "hamming", "margin", "inverted"])
            self.assertEqual((marker["dictionary"], marker["hamming"], marker["inverted"]), ("DICT_4X4_50", 0, False))
            self.assertTrue(0.05 <= marker["margin"] <= 0.5)
            for value in sum(marker["corners"], []):
                self.assertEqual(value, round(value, 3))
        self.expect_markers(frame, self.page)

    def test_csv(self):
        rows = list(csv.DictReader(io.StringIO(self.output("-f", "csv"))))
        self.assertEqual([row["source"] for row in rows], [self.file, self.file])
        self.assertEqual(sorted(int(row["id"]) for row in rows), [7, 12])
        markers = [{"id": int(row["id"]), "corners": [[float(row[f"x{i}"]), float(row[f"y{i}"])] for i in range(4)]}
                   for row in rows]
        self.expect_markers({"markers": markers}, self.page)

    def test_text(self):
        lines = self.output().splitlines()
        self.assertIn("320 x 240: 2 markers", lines[0])
        self.assertEqual(sorted(line.split()[:2] for line in lines[1:]), [["DICT_4X4_50", "12"], ["DICT_4X4_50", "7"]])

    def test_stats(self):
        frame = json.loads(self.output("-f", "jsonl", "--stats"))
        self.assertGreaterEqual(frame["stats"]["pixels"], 320 * 240)
        self.assertGreater(frame["stats"]["crack_runs"], 0)
        self.assertGreater(frame["ms"], 0)
        self.assertIn("crack runs", self.output("--stats"))
        self.expect_error(self.run_program("detect", "-f", "csv", "--stats", self.file), "--stats")

    def test_output_file(self):
        expected = self.output("-f", "jsonl")
        self.assertEqual(self.output("-f", "jsonl", "-o", self.path("out.jsonl")), "")
        self.assertEqual(pathlib.Path(self.path("out.jsonl")).read_text(), expected)

    def test_default_dictionaries(self):
        result = self.run_program("detect", "-f", "jsonl", self.file)
        self.expect_markers(json.loads(result.stdout), self.page)

    def test_dictionary_of_ones_own(self):
        path = self.path("mine.codes")
        text = (scene.SOURCE / "data" / "dictionaries" / "DICT_4X4_1000.codes").read_text()
        pathlib.Path(path).write_text(text)
        frame = self.detect(self.file, dictionary=path)[0]
        self.assertEqual({marker["dictionary"] for marker in frame["markers"]}, {"mine"})

    def test_region(self):
        frame = json.loads(self.output("-f", "jsonl", "--region", "0,0,180,240"))
        self.assertEqual([marker["id"] for marker in frame["markers"]], [7])

    def test_sizes(self):
        frame = json.loads(self.output("-f", "jsonl", "--min-size", "70"))
        self.assertEqual([marker["id"] for marker in frame["markers"]], [7])
        frame = json.loads(self.output("-f", "jsonl", "--max-size", "70"))
        self.assertEqual([marker["id"] for marker in frame["markers"]], [12])

    def test_pipelines(self):
        page = scene.Scene().add("tag36h11", 3, 40, 60, 12)
        scene.write_pgm(self.file, page)
        for pipeline in ("default", "paper"):
            with self.subTest(pipeline):
                frame = self.detect(self.file, "--pipeline", pipeline, dictionary="tag36h11")[0]
                self.expect_markers(frame, page, tolerance=1.5)

    def test_inverted(self):
        scene.write_pgm(self.file, scene.one_marker(white=40, black=230))
        self.assertEqual(json.loads(self.output("-f", "jsonl"))["markers"], [])
        markers = json.loads(self.output("-f", "jsonl", "--inverted"))["markers"]
        self.assertEqual([(marker["id"], marker["inverted"]) for marker in markers], [(7, True)])


class Annotations(CommandTest):
    def annotated(self, *arguments):
        result = self.run_program("detect", "--dict", "DICT_4X4_50", *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, b""))

    def setUp(self):
        super().setUp()
        self.file = self.path("a.pgm")
        scene.write_pgm(self.file, two_markers())

    def test_image(self):
        self.annotated(self.file, "--annotate", self.path("out.ppm"))
        data = pathlib.Path(self.path("out.ppm")).read_bytes()
        header = b"P6\n320 240\n255\n"
        self.assertTrue(data.startswith(header))
        x, y = 40, 60  # the first corner, marked in red
        blue_green_red = data[len(header) + 3 * (y * 320 + x):][:3]
        self.assertGreater(blue_green_red[0], 200)
        self.assertLess(blue_green_red[2], 120)

    def test_folder_keeps_files_of_one_stem_apart(self):
        scene.write_png(self.path("a.png"), two_markers())
        self.annotated(self.file, self.path("a.png"), "--annotate", self.path("out"))
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["a-2.png", "a.png"])

    def test_an_input_is_never_replaced(self):
        before = pathlib.Path(self.file).read_bytes()
        self.expect_error(self.run_program("detect", self.file, "--annotate", self.file), self.file)
        self.assertEqual(pathlib.Path(self.file).read_bytes(), before)

    def test_one_image_cannot_take_several_inputs(self):
        scene.write_png(self.path("b.png"), two_markers())
        self.expect_error(self.run_program("detect", self.file, self.path("b.png"), "--annotate",
                                           self.path("out.png")), self.path("out.png"))

    def test_format_that_cannot_be_written(self):
        result = self.run_program("detect", self.file, "--annotate", self.path("no/such/folder/out.png"))
        self.expect_error(result, self.path("no/such/folder/out.png"), "No such file")

    @needs_ffmpeg
    def test_video(self):
        video = self.ffmpeg(scene.moving_marker(10, width=321, height=241), "v.mkv", "-c:v", "ffv1")
        for name in ("out.mp4", "out.avi", "folder"):
            with self.subTest(name):
                self.annotated(video, "--annotate", self.path(name))
                path = self.path("folder/v.mp4" if name == "folder" else name)
                self.assertEqual(len(self.detect(path)), 10)


if __name__ == "__main__":
    unittest.main()
