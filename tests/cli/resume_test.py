"""`runmark detect --resume`: a run that was stopped goes on, with no frame lost or doubled."""

import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import time
import unittest

import scene
from command import PROGRAM, CommandTest, needs_ffmpeg

KILLS = int(os.environ.get("RUNMARK_KILLS", "100"))


class ResumeTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.inputs = self.folder / "inputs"
        self.inputs.mkdir()
        self.out = self.folder / "out.jsonl"

    def put_images(self, count):
        for i in range(count):
            scene.write_png(self.inputs / f"{i:03}.png", scene.one_marker(x=20 + i, width=400, height=300))

    def put_stream(self, name, frames):
        (self.inputs / name).write_bytes(scene.y4m_bytes(scene.moving_marker(frames)))

    def whole_run(self, *arguments, status=0):
        result = self.run_program("detect", "-f", "jsonl", *arguments, self.inputs)
        self.assertEqual(result.returncode, status, result.stderr)
        return result.stdout.splitlines(keepends=True)

    def resume(self, *arguments):
        return self.run_program("detect", "--resume", self.out, *arguments, self.inputs)

    def expect_done(self, result):
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, b"", b""))


class Killed(ResumeTest):
    @needs_ffmpeg
    def test_at_random_moments(self):
        """Folders with images and videos; the program is killed again and again until a run gets through."""
        self.put_images(25)
        self.put_stream("007a.y4m", 20)
        self.ffmpeg(scene.moving_marker(30), "inputs/011a.mp4", "-pix_fmt", "yuv420p")
        expected = self.whole_run()
        self.assertEqual(len(expected), 25 + 20 + 30)
        chance = random.Random(5)
        window = 0.5  # seconds within which it is killed: follows how fast this machine is just now
        kills = cut = rounds = 0
        while kills < KILLS:
            rounds += 1
            self.out.unlink(missing_ok=True)
            while self.killed(["-j", str(chance.choice((1, 2, 5)))], chance.uniform(0, window)):
                kills += 1
                window *= 1.1
                # A sudden loss of power can leave less than what was written, to the byte.
                if chance.random() < 0.2 and self.out.exists() and self.out.stat().st_size > 0:
                    size = self.out.stat().st_size
                    os.truncate(self.out, size - chance.randrange(1, min(size, 5000) + 1))
                    cut += 1
            window *= 0.5
            self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)
        self.assertGreaterEqual(kills, KILLS)
        print(f"{kills} kills in {rounds} runs, {cut} files cut off; all ended with the same {len(expected)} lines")

    def killed(self, arguments, after):
        """Whether a run had to be killed after so many seconds; else it was done."""
        with subprocess.Popen([PROGRAM, "detect", "--resume", self.out, *arguments, self.inputs],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as program:
            try:
                program.wait(timeout=after)
            except subprocess.TimeoutExpired:
                program.kill()
                return True
            self.assertEqual((program.returncode, program.stdout.read(), program.stderr.read()), (0, b"", b""))
            return False

    def test_with_a_file_that_is_broken(self):
        """It is told by the run that gets to the end, too."""
        self.put_images(6)
        (self.inputs / "002.png").write_text("not a picture")
        self.put_stream("003a.y4m", 9)
        stream = self.inputs / "003a.y4m"
        stream.write_bytes(stream.read_bytes()[:-100])  # breaks off in the ninth frame
        expected = self.whole_run(status=2)
        self.assertEqual(len(expected), 5 + 8)
        for lines in range(len(expected) + 1):
            for rest in (b"", b'{"source":"' + os.fsencode(self.inputs)):
                with self.subTest(lines=lines, rest=rest):
                    self.out.write_bytes(b"".join(expected[:lines]) + rest)
                    result = self.resume()
                    self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)
                    self.assertEqual(result.returncode, 2)
                    told = result.stderr.decode().splitlines()
                    self.assertEqual([name in line for name, line in zip(("002.png", "003a.y4m"), told)], [True, True])


class Resumed(ResumeTest):
    def test_nothing_is_done_twice(self):
        self.put_images(4)
        expected = self.whole_run()
        self.expect_done(self.resume())
        self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)
        before = self.out.stat().st_mtime_ns
        self.expect_done(self.resume())
        self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)
        self.assertEqual(self.out.stat().st_mtime_ns, before)

    def test_an_input_that_could_be_read_only_later(self):
        """Its lines come at the end, and a run that is stopped there loses nothing either."""
        self.put_images(3)
        self.put_stream("000a.y4m", 5)
        good = (self.inputs / "000a.y4m").read_bytes()
        (self.inputs / "000a.y4m").write_bytes(b"broken")
        self.assertEqual(self.resume().returncode, 2)
        first = self.out.read_bytes().splitlines(keepends=True)
        self.assertEqual(len(first), 3)
        (self.inputs / "000a.y4m").write_bytes(good)
        self.expect_done(self.resume())
        expected = self.out.read_bytes().splitlines(keepends=True)
        self.assertEqual(sorted(expected), sorted(self.whole_run()))
        for lines in range(3, len(expected)):
            self.out.write_bytes(b"".join(expected[:lines]))
            self.expect_done(self.resume())
            self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)

    def test_an_input_named_twice(self):
        self.put_images(2)
        twice = [self.inputs / "000.png", self.inputs / "001.png", self.inputs / "000.png", self.inputs / "000.png"]
        expected = self.run_program("detect", "-f", "jsonl", *twice).stdout.splitlines(keepends=True)
        for lines in range(5):
            self.out.write_bytes(b"".join(expected[:lines]))
            self.expect_done(self.run_program("detect", "--resume", self.out, *twice))
            self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)

    def test_a_name_that_is_not_utf8(self):
        self.put_images(2)
        os.rename(os.fsencode(self.inputs / "000.png"), os.fsencode(self.inputs) + b"/\xff\xfe.png")
        expected = self.whole_run()
        self.out.write_bytes(expected[0])
        self.expect_done(self.resume())
        self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)

    def test_standard_input_that_comes_again(self):
        stream = scene.y4m_bytes(scene.moving_marker(12))
        expected = self.run_program("detect", "-f", "jsonl", "-", stdin=stream).stdout
        self.out.write_bytes(b"".join(expected.splitlines(keepends=True)[:7]))
        self.expect_done(self.run_program("detect", "--resume", self.out, "-", stdin=stream))
        self.assertEqual(self.out.read_bytes(), expected)
        self.expect_error(self.run_program("detect", "--resume", self.out, "-", stdin=stream[:len(stream) // 2]),
                          "ends within frame")

    @needs_ffmpeg
    def test_ctrl_c_and_on(self):
        video = self.ffmpeg(scene.moving_marker(150, width=640, height=480), "inputs/v.mp4", "-pix_fmt", "yuv420p")
        expected = self.whole_run()
        with subprocess.Popen([PROGRAM, "detect", "--resume", self.out, video], stderr=subprocess.PIPE) as program:
            while not self.out.exists() or self.out.read_bytes().count(b"\n") < 5:
                time.sleep(0.01)
            program.send_signal(signal.SIGINT)
            self.assertEqual((program.wait(timeout=60), program.stderr.read()), (130, b""))
        self.assertLess(self.out.read_bytes().count(b"\n"), 150)
        self.expect_done(self.resume())
        self.assertEqual(self.out.read_bytes().splitlines(keepends=True), expected)

    def test_annotated_pictures(self):
        self.put_images(5)
        pictures = self.folder / "pictures"
        self.expect_done(self.resume("--annotate", self.folder / "whole"))
        expected = self.out.read_bytes().splitlines(keepends=True)
        for lines in range(5):
            shutil.rmtree(pictures, ignore_errors=True)
            self.out.write_bytes(b"".join(expected[:lines]))
            self.expect_done(self.resume("--annotate", pictures))
            self.assertEqual(sorted(os.listdir(pictures)), [f"{i:03}.png" for i in range(lines, 5)])
            for name in os.listdir(pictures):
                self.assertEqual((pictures / name).read_bytes(), (self.folder / "whole" / name).read_bytes())


class Refused(ResumeTest):
    def setUp(self):
        super().setUp()
        self.put_images(2)
        self.lines = self.whole_run()

    def expect_refused(self, data, *parts):
        self.out.write_bytes(data)
        self.expect_error(self.resume(), str(self.out), *parts)
        self.assertEqual(self.out.read_bytes(), data)

    def test_a_file_of_another_command(self):
        self.expect_refused(b"hello\n", "line 1")
        self.expect_refused(self.lines[0] + b"[1]\n", "line 2")
        self.expect_refused(self.lines[0] + b'{"source":"other.png","frame":0}\n', "line 2", "other.png")
        self.expect_refused(self.lines[0] * 2, "line 2", "frame 0")
        self.expect_refused(self.lines[0].replace(b'"frame":0', b'"frame":3'), "line 1", "frame 3")

    def test_options_that_do_not_go_with_it(self):
        self.expect_error(self.resume("-f", "csv"), "--resume", "jsonl")
        self.expect_error(self.resume("-o", self.path("other")), "--resume", "--output")
        self.expect_error(self.run_program("detect", "--resume", self.out, "camera:0"), "camera:0")
        self.put_stream("a.y4m", 2)
        self.expect_error(self.resume("--annotate", self.path("folder")), "--resume", "video")

    def test_what_is_no_file(self):
        for path in ("/dev/null", "/dev/full", str(self.folder)):
            result = self.run_program("detect", "--resume", path, self.inputs)
            self.expect_error(result, path, "not a file")

    def test_a_line_without_an_end(self):
        """What is no output of ours is refused without reading all of it into memory."""
        with open(self.out, "wb") as file:
            file.truncate(1 << 32)
        self.expect_error(self.resume(), str(self.out), "line 1", "longer")

    def test_a_file_another_run_writes_into(self):
        page = scene.one_marker()
        with subprocess.Popen([PROGRAM, "detect", "--resume", self.out, "-"], stdin=subprocess.PIPE) as first:
            first.stdin.write(scene.y4m_header(page, "mono") + scene.y4m_frame(page, "mono"))
            first.stdin.flush()
            while not self.out.exists() or not self.out.read_bytes():
                time.sleep(0.01)
            self.expect_error(self.run_program("detect", "--resume", self.out, "-", stdin=b""), "another run")
            first.stdin.close()
            self.assertEqual(first.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
