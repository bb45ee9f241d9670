"""`runmark detect --jobs`: several threads print what one prints."""

import json
import os
import pathlib
import signal
import subprocess
import time
import unittest

import scene
from command import PROGRAM, CommandTest, needs_ffmpeg


class SameAsOne(CommandTest):
    def expect_same(self, *arguments, stdin=b""):
        """Output, errors and status with several jobs are those with one; returns them."""
        expected = self.run_program("detect", "--jobs", 1, *arguments, stdin=stdin)
        for jobs in (2, 3, 8):
            result = self.run_program("detect", "--jobs", jobs, *arguments, stdin=stdin)
            self.assertEqual((result.returncode, result.stdout, result.stderr),
                             (expected.returncode, expected.stdout, expected.stderr), f"{jobs} jobs")
        return expected

    def fill_folder(self, count):
        """Pictures of several sizes, so that some take much longer than others."""
        for i in range(count):
            width, height = ((320, 240), (900, 700), (200, 200))[i % 3]
            scene.write_png(self.path(f"{i:03}.png"), scene.one_marker(x=20 + i, width=width, height=height))

    def test_folder(self):
        self.fill_folder(24)
        for form in ("jsonl", "csv", "text"):
            with self.subTest(form):
                result = self.expect_same("-f", form, self.folder)
                self.assertEqual(result.returncode, 0)
                self.assertEqual(result.stdout.count(b"DICT_4X4_50"), 24)

    def test_folder_with_broken_files_and_a_stream(self):
        self.fill_folder(12)
        for name in ("003.png", "007.png"):
            pathlib.Path(self.path(name)).write_text("not a picture")
        stream = scene.y4m_bytes(scene.moving_marker(9))
        pathlib.Path(self.path("005a.y4m")).write_bytes(stream)
        pathlib.Path(self.path("006a.y4m")).write_bytes(stream[:-100])  # breaks off in the ninth frame
        result = self.expect_same("-f", "jsonl", self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertEqual(len(result.stdout.splitlines()), 10 + 9 + 8)
        self.assertEqual([name in line for name, line in
                          zip(("003.png", "006a.y4m", "007.png"), result.stderr.decode().splitlines())], [True] * 3)

    def test_strict(self):
        self.fill_folder(12)
        pathlib.Path(self.path("004.png")).write_text("not a picture")
        result = self.expect_same("-f", "jsonl", "--strict", self.folder)
        self.assertEqual(len(result.stdout.splitlines()), 4)
        self.expect_error(result, self.path("004.png"))

    def test_stream(self):
        result = self.expect_same("-f", "jsonl", "-", stdin=scene.y4m_bytes(scene.moving_marker(40)))
        self.assertEqual([json.loads(line)["frame"] for line in result.stdout.splitlines()], list(range(40)))

    def test_options_that_do_not_suit(self):
        self.fill_folder(3)
        self.expect_error(self.expect_same("--octaves", "9", self.folder), "octaves 9")

    @needs_ffmpeg
    def test_video(self):
        video = self.ffmpeg(scene.moving_marker(50), "v.mp4", "-pix_fmt", "yuv420p")
        result = self.expect_same("-f", "jsonl", video)
        self.assertEqual([json.loads(line)["frame"] for line in result.stdout.splitlines()], list(range(50)))

    @needs_ffmpeg
    def test_annotations(self):
        self.fill_folder(4)
        self.ffmpeg(scene.moving_marker(12), "v.mp4", "-pix_fmt", "yuv420p")
        inputs = sorted(os.listdir(self.folder))
        for jobs in (1, 4):
            result = self.run_program("detect", "-j", jobs, self.folder, "--annotate", self.path(f"out{jobs}"))
            self.assertEqual((result.returncode, result.stderr), (0, b""))
        self.assertEqual(sorted(os.listdir(self.path("out4"))), inputs)
        for name in inputs:
            one, four = (pathlib.Path(self.path(f"out{jobs}/{name}")).read_bytes() for jobs in (1, 4))
            self.assertEqual(one, four, name)


class Endings(CommandTest):
    def start(self, *arguments, **keywords):
        return subprocess.Popen([PROGRAM, "detect", "--jobs", "3", "-f", "jsonl", *arguments], stdin=subprocess.PIPE,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, **keywords)

    def test_number_of_jobs(self):
        for jobs in ("0", "-1", "two", "1025"):
            self.expect_error(self.run_program("detect", "--jobs", jobs, self.folder), "--jobs")

    def test_full_disk(self):
        path = self.path("a.y4m")
        pathlib.Path(path).write_bytes(scene.y4m_bytes(scene.moving_marker(30)))
        self.expect_error(self.run_program("detect", "--jobs", 3, path, "-o", "/dev/full"), "No space left on device")

    def test_lines_come_while_the_stream_goes_on(self):
        page = scene.one_marker()
        with self.start("-") as program:
            program.stdin.write(scene.y4m_header(page, "mono"))
            for index in range(5):
                program.stdin.write(scene.y4m_frame(page, "mono"))
                program.stdin.flush()
                self.assertEqual(json.loads(program.stdout.readline())["frame"], index)
            program.stdin.close()
            self.assertEqual(program.wait(timeout=60), 0)

    def test_reader_that_goes_away_while_the_stream_waits(self):
        page = scene.one_marker()
        with self.start("-") as program:
            program.stdin.write(scene.y4m_header(page, "mono") + scene.y4m_frame(page, "mono"))
            program.stdin.flush()
            program.stdout.readline()
            program.stdout.close()
            program.stdin.write(scene.y4m_frame(page, "mono"))
            program.stdin.flush()  # and no end of the stream: the program must wake by itself
            self.assertEqual(program.wait(timeout=60), 0)
            self.assertEqual(program.stderr.read(), b"")

    def test_interrupt_while_the_stream_waits(self):
        page = scene.one_marker()
        with self.start("-") as program:
            program.stdin.write(scene.y4m_header(page, "mono") + scene.y4m_frame(page, "mono") * 3)
            program.stdin.flush()
            lines = [program.stdout.readline() for _ in range(3)]
            program.send_signal(signal.SIGINT)
            self.assertEqual(program.wait(timeout=60), 130)
            self.assertEqual((program.stdout.read(), program.stderr.read()), (b"", b""))
        self.assertEqual([json.loads(line)["frame"] for line in lines], [0, 1, 2])

    def test_interrupt_in_the_midst_leaves_whole_lines(self):
        path = self.path("a.pgm")
        scene.write_pgm(path, scene.one_marker(width=1200, height=900))
        with self.start(*[path] * 5000, bufsize=0) as program:  # communicate() knows nothing of lines read ahead
            first = program.stdout.readline()
            time.sleep(0.05)
            program.send_signal(signal.SIGINT)
            out, err = program.communicate(timeout=60)
            self.assertEqual((program.returncode, err), (130, b""))
        lines = (first + out).splitlines(keepends=True)
        self.assertLess(len(lines), 5000)
        for line in lines:
            self.assertTrue(line.endswith(b"\n"))
            self.assertEqual(json.loads(line)["source"], path)


if __name__ == "__main__":
    unittest.main()
