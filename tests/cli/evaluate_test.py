"""runmark evaluate: the same score from the images and from a file of detections, and what it refuses."""

import csv
import io
import json
import pathlib
import unittest

from command import CommandTest


class Evaluate(CommandTest):
    def setUp(self):
        super().setUp()
        self.scenes = pathlib.Path(self.path("scenes"))
        self.run_ok("render", "--set", "vga", "--scenes", "3", "-o", self.scenes)
        self.truth = self.scenes / "truth.json"

    def run_ok(self, *arguments):
        result = self.run_program(*map(str, arguments))
        self.assertEqual((result.returncode, result.stderr), (0, b""))
        return result.stdout.decode()

    def test_images_and_detections_give_the_same_score(self):
        own = json.loads(self.run_ok("evaluate", self.truth, "--format", "json"))
        self.assertEqual(own["images"], 3)
        self.assertGreater(own["total"]["found"], 0)
        self.assertLess(own["total"]["corner_rms"], 1)
        self.assertEqual(own["total"]["rotated"], 0)
        seen = pathlib.Path(self.path("seen.jsonl"))
        seen.write_text(self.run_ok("detect", "-d", "tag36h11", "-f", "jsonl", self.scenes))
        read = json.loads(self.run_ok("evaluate", self.truth, "--detections", seen, "--format", "json"))
        for name in ("truth", "found", "false_alarms", "bad_corners", "extra", "duplicates"):
            self.assertEqual(own["total"][name], read["total"][name], name)
        missed = [m for m in own["mistakes"] if m["kind"] == "missed"]
        self.assertEqual(own["total"]["truth"] - own["total"]["found"] - own["total"]["bad_corners"], len(missed))

    def test_buckets_add_up(self):
        rows = list(csv.DictReader(io.StringIO(self.run_ok("evaluate", self.truth, "--format", "csv"))))
        total = next(row for row in rows if row["group"] == "total")
        for group in ("size", "tilt", "blur", "motion", "noise", "contrast", "dictionary"):
            for column in ("truth", "found"):
                parts = sum(int(row[column]) for row in rows if row["group"] == group)
                self.assertEqual(parts, int(total[column]), (group, column))

    def test_paper_pipeline_finds_less(self):
        found = [json.loads(self.run_ok("evaluate", self.truth, "--format", "json", "--pipeline", name))["total"]["found"]
                 for name in ("paper", "default")]
        self.assertLess(found[0], found[1])

    def test_what_is_wrong(self):
        self.expect_error(self.run_program("evaluate", "/nowhere.json"), "/nowhere.json: cannot be read")
        bad = pathlib.Path(self.path("bad.jsonl"))
        bad.write_text('{"image": "a"}\n')
        self.expect_error(self.run_program("evaluate", self.truth, "--detections", "/dev/zero"), "/dev/zero:1: longer")
        self.expect_error(self.run_program("evaluate", self.truth, "--detections", bad), 'bad.jsonl:1: no "markers"')
        bad.write_text('{"image": "a", "markers": []}\n')
        self.expect_error(self.run_program("evaluate", self.truth, "--detections", bad),
                          "none of its images is in the truth")
        next(self.scenes.glob("*.png")).unlink()
        self.expect_error(self.run_program("evaluate", self.truth), ".png")


if __name__ == "__main__":
    unittest.main()
