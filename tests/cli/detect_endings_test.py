"""How `runmark detect` ends before its inputs do: full disks, readers that go away, signals."""

import json
import os
import pathlib
import resource
import signal
import subprocess
import time
import unittest

import scene
from command import PROGRAM, CommandTest, needs_ffmpeg


class EndingTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.file = self.path("a.pgm")
        scene.write_pgm(self.file, scene.one_marker())

    def expect_whole_lines(self, data):
        """JSON lines of frames in order; returns how many."""
        self.assertTrue(data == b"" or data.endswith(b"\n"), data[-80:])
        lines = [json.loads(line) for line in data.splitlines()]
        for index, line in enumerate(lines):
            self.assertIn(line["frame"], (0, index))
        return len(lines)

    def expect_playable(self, video, frames):
        """As any player would: every frame that was written can be decoded."""
        self.assertEqual([frame["frame"] for frame in self.detect(video)], list(range(frames)))


class FullDisks(EndingTest):
    def limited(self, limit, *arguments, **keywords):
        """Runs the program where no file may grow beyond `limit` bytes."""
        def limit_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        return subprocess.run([PROGRAM, "detect", "-f", "jsonl", *map(str, arguments)], stderr=subprocess.PIPE,
                              timeout=120, preexec_fn=limit_files, **keywords)

    def test_no_space_left(self):
        for arguments in ((), ("-o", "/dev/full")):
            with self.subTest(arguments), open("/dev/full", "wb") as full:
                result = subprocess.run([PROGRAM, "detect", self.file, *arguments], stdout=full, stderr=subprocess.PIPE,
                                        timeout=60)
                self.expect_error(result, "No space left on device")

    def test_no_space_left_for_an_annotation(self):
        os.symlink("/dev/full", self.path("full.png"))
        self.expect_error(self.run_program("detect", self.file, "--annotate", self.path("full.png")), "full.png",
                          "No space left on device")

    def test_file_size_limit_leaves_whole_lines(self):
        for jobs in (1, 3):
            for out, options in (("file", ("-o", self.path("file"))), ("stdout", ())):
                with self.subTest(jobs=jobs, out=out), open(self.path("stdout"), "wb") as stdout:
                    result = self.limited(3000, *[self.file] * 60, "-j", jobs, *options, stdout=stdout)
                    self.expect_error(result, "File too large")
                    data = pathlib.Path(self.path(out)).read_bytes()
                    self.assertGreater(self.expect_whole_lines(data), 3)
                    self.assertGreater(len(data), 2000)

    def test_file_size_limit_behind_other_output(self):
        """What stood in the file before is kept."""
        path = pathlib.Path(self.path("out"))
        path.write_bytes(b"before\n")
        with open(path, "ab") as stdout:
            self.expect_error(self.limited(1500, *[self.file] * 60, stdout=stdout), "File too large")
        data = path.read_bytes()
        self.assertTrue(data.startswith(b"before\n"))
        self.assertGreater(self.expect_whole_lines(data[7:]), 3)

    def test_file_size_limit_for_pictures(self):
        result = self.limited(1000, self.file, "--annotate", self.path("out.png"), stdout=subprocess.DEVNULL)
        self.expect_error(result, "out.png", "File too large")

    @needs_ffmpeg
    def test_file_size_limit_for_a_video(self):
        video = self.ffmpeg(scene.moving_marker(60, width=640, height=480), "v.mkv", "-c:v", "ffv1")
        for name in ("out.mp4", "out.avi"):
            with self.subTest(name):
                self.assertEqual(self.run_program("detect", video, "--annotate", self.path(name)).returncode, 0)
                half = os.path.getsize(self.path(name)) // 2
                result = self.limited(half, video, "--annotate", self.path(name), stdout=subprocess.DEVNULL)
                self.expect_error(result, name, "not all frames could be written")

    def test_output_that_is_an_input(self):
        before = pathlib.Path(self.file).read_bytes()
        self.expect_error(self.run_program("detect", self.file, "-o", self.file), self.file, "would replace an input")
        self.assertEqual(pathlib.Path(self.file).read_bytes(), before)

    def test_closed_standard_output(self):
        result = subprocess.run(["sh", "-c", 'exec "$0" detect "$1" >&-', PROGRAM, self.file], stderr=subprocess.PIPE,
                                timeout=60)
        self.expect_error(result, "standard output", "Bad file descriptor")


class Readers(EndingTest):
    def test_reader_that_goes_away(self):
        with subprocess.Popen([PROGRAM, "detect", "-f", "jsonl", *[self.file] * 200], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as program:
            self.assertTrue(program.stdout.readline().startswith(b"{"))
            program.stdout.close()
            self.assertEqual(program.stderr.read(), b"")
            self.assertEqual(program.wait(timeout=60), 0)

    def test_lines_come_while_the_stream_goes_on(self):
        with subprocess.Popen([PROGRAM, "detect", "-f", "jsonl", "-"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE) as program:
            page = scene.one_marker()
            program.stdin.write(scene.y4m_header(page, "mono"))
            for index in range(3):
                program.stdin.write(scene.y4m_frame(page, "mono"))
                program.stdin.flush()
                self.assertEqual(json.loads(program.stdout.readline())["frame"], index)
            program.stdin.close()
            self.assertEqual(program.wait(timeout=60), 0)

    def test_head(self):
        for jobs in ("1", "3"):
            with self.subTest(jobs=jobs):
                command = '"$0" detect -f jsonl -j "$1" $(yes "$2" | head -n 400) | head -n 1; echo "${PIPESTATUS[0]}"'
                result = subprocess.run(["bash", "-c", command, PROGRAM, jobs, self.file], capture_output=True,
                                        timeout=120)
                first, status = result.stdout.splitlines()
                self.assertEqual((json.loads(first)["source"], status, result.stderr), (self.file, b"0", b""))

    @needs_ffmpeg
    def test_annotated_video_is_whole_when_the_reader_goes_away(self):
        video = self.ffmpeg(scene.moving_marker(200, width=640, height=480), "v.mp4", "-pix_fmt", "yuv420p")
        with subprocess.Popen([PROGRAM, "detect", "-f", "jsonl", video, "--annotate", self.path("out.mp4")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            for _ in range(10):
                program.stdout.readline()
            program.stdout.close()
            self.assertEqual((program.wait(timeout=60), program.stderr.read()), (0, b""))
        frames = len(self.detect(self.path("out.mp4")))
        self.assertTrue(10 <= frames < 200, frames)


class Signals(EndingTest):
    def start(self, *arguments, **keywords):
        return subprocess.Popen([PROGRAM, "detect", "-f", "jsonl", *arguments], stderr=subprocess.PIPE, **keywords)

    def test_while_a_stream_waits(self):
        page = scene.one_marker()
        annotated = self.path("out.avi")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for jobs in ("1", "3"):
                with self.subTest(number=number, jobs=jobs), \
                        self.start("-j", jobs, "-", "--annotate", annotated, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE) as program:
                    program.stdin.write(scene.y4m_header(page, "mono") + scene.y4m_frame(page, "mono") * 3)
                    program.stdin.flush()
                    lines = [program.stdout.readline() for _ in range(3)]
                    time.sleep(0.2)  # now it waits for the fourth frame
                    program.send_signal(number)
                    self.assertEqual(program.wait(timeout=60), 130)
                    self.assertEqual((program.stdout.read(), program.stderr.read()), (b"", b""))
                    self.assertEqual([json.loads(line)["frame"] for line in lines], [0, 1, 2])
                    self.expect_playable(annotated, 3)

    @needs_ffmpeg
    def test_in_the_middle_of_a_video(self):
        video = self.ffmpeg(scene.moving_marker(250, width=640, height=480), "v.mp4", "-pix_fmt", "yuv420p")
        for jobs, name in (("1", "one.mp4"), ("3", "three.mp4"), ("3", "three.avi")):
            with self.subTest(name):
                out = pathlib.Path(self.path(name + ".jsonl"))
                with self.start("-j", jobs, video, "--annotate", self.path(name), "-o", str(out)) as program:
                    while not out.exists() or out.read_bytes().count(b"\n") < 20:
                        time.sleep(0.005)
                    program.send_signal(signal.SIGINT)
                    self.assertEqual((program.wait(timeout=60), program.stderr.read()), (130, b""))
                frames = self.expect_whole_lines(out.read_bytes())
                self.assertTrue(20 <= frames < 250, frames)
                self.expect_playable(self.path(name), frames)

    def test_twice_ends_at_once(self):
        page = scene.one_marker()
        with self.start("-", stdin=subprocess.PIPE, stdout=subprocess.PIPE) as program:
            program.stdin.write(scene.y4m_header(page, "mono") + scene.y4m_frame(page, "mono"))
            program.stdin.flush()
            program.stdout.readline()
            program.send_signal(signal.SIGSTOP)  # so that it cannot end between the two
            program.send_signal(signal.SIGINT)
            program.send_signal(signal.SIGCONT)
            program.send_signal(signal.SIGINT)
            self.assertIn(program.wait(timeout=60), (130, -signal.SIGINT))


if __name__ == "__main__":
    unittest.main()
