"""What `runmark detect` makes of files that are damaged, mislabelled, unreadable or none at all."""

import json
import os
import pathlib
import random
import resource
import shutil
import signal
import struct
import subprocess
import threading
import unittest
import zlib

import scene
from command import FFMPEG, PROGRAM, CommandTest, needs_ffmpeg

CONVERT = shutil.which("convert")
needs_convert = unittest.skipUnless(CONVERT, "ImageMagick is not installed: pictures of rare kinds are not tested")


class PictureTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.page = scene.one_marker()
        self.original = self.path("original.pgm")
        scene.write_pgm(self.original, self.page)

    def convert(self, name, *options):
        """The page as ImageMagick writes it; `name` may begin with a format as in png:a.jpg."""
        form, colon, name = name.rpartition(":")
        subprocess.run([CONVERT, self.original, *options, form + colon + self.path(name)], check=True)
        return self.path(name)

    def write(self, name, data):
        pathlib.Path(self.path(name)).write_bytes(data)
        return self.path(name)

    def expect_the_marker(self, path, tolerance=0.5):
        frames = self.detect(path)
        self.assertEqual(len(frames), 1)
        self.expect_markers(frames[0], self.page, tolerance)

    def expect_refused(self, path, *parts):
        result = self.run_program("detect", "-f", "jsonl", path)
        self.assertEqual(result.stdout, b"")
        self.expect_error(result, path, *parts)


@needs_convert
class RareKinds(PictureTest):
    def test_are_read(self):
        light = "rgb(220,220,220)"
        kinds = {
            "cmyk.jpg": "-colorspace CMYK -quality 95", "cmyk.tif": "-colorspace CMYK", "lab.tif": "-colorspace Lab",
            "progressive.jpg": "-interlace Plane", "16.png": "-depth 16", "16.tif": "-depth 16 -endian MSB",
            "bit.png": "-monochrome", "bit.bmp": "-monochrome", "bit.pbm": "-monochrome",
            "fax.tif": "-monochrome -compress Group4", "lzw.tif": "-compress LZW", "jpeg.tif": "-compress JPEG",
            "tiles.tif": "-define tiff:tile-geometry=64x64", "PNG8:palette.png": "-type Palette",
            "BMP3:palette.bmp": "-type Palette", "alpha.png": f"-transparent {light}",
            "alpha.tif": f"-transparent {light}", "alpha.webp": f"-transparent {light}"}
        for name, options in kinds.items():
            with self.subTest(name):
                self.expect_the_marker(self.convert(name, *options.split()))

    def test_with_another_extension(self):
        for name in ("png:a.jpg", "jpg:b.png", "png:c.txt", "jpg:d", "png:e.mp4"):
            with self.subTest(name):
                self.expect_the_marker(self.convert(name))

    def test_that_are_not_supported_are_refused(self):
        self.expect_refused(self.convert("32.tif", "-depth", "32"))
        self.expect_refused(self.convert("cmyka.tif", "-colorspace", "CMYK", "-alpha", "on"))

    def test_cut_off_anywhere(self):
        kinds = {"a.png": "", "16.png": "-depth 16", "a.jpg": "", "b.jpg": "-interlace Plane", "a.bmp": "",
                 "a.webp": "", "cmyk.jpg": "-colorspace CMYK", "a.tif": "-compress LZW", "a.pgm": "", "a.pbm": "-monochrome"}
        for name, options in kinds.items():
            data = pathlib.Path(self.convert(name, *options.split())).read_bytes()
            for part in (0.01, 0.1, 0.5, 0.9):
                with self.subTest(name=name, part=part):
                    self.expect_refused(self.write("cut-" + name, data[:max(int(part * len(data)), 1)]))

    def test_damaged_anywhere(self):
        """PNG and WebP show all damage by themselves; of the other formats the headers do."""
        chance = random.Random(1)
        for name in ("a.png", "a.webp"):
            data = pathlib.Path(self.convert(name)).read_bytes()
            for _ in range(8):
                damaged = bytearray(data)
                start = len(data) // 4
                for at in range(start, len(data) - 16):
                    if chance.random() < 0.2:
                        damaged[at] ^= 1 + chance.randrange(255)
                with self.subTest(name):
                    self.expect_refused(self.write("damaged-" + name, damaged))
        for name in ("a.jpg", "a.tif", "a.bmp", "a.pgm"):
            data = pathlib.Path(self.convert(name)).read_bytes()
            with self.subTest(name):
                self.expect_refused(self.write("damaged-" + name, bytes(min(len(data) // 2, 40)) + data[40:]))

    def test_a_header_that_promises_more_than_comes(self):
        """Memory is for what has come: a few kilobytes that state gigabytes are refused before they are decoded."""
        jpeg = bytearray(pathlib.Path(self.convert("a.jpg")).read_bytes())
        size = jpeg.index(b"\xff\xc0") + 5
        jpeg[size:size + 4] = struct.pack(">HH", 28001, 26386)
        png = bytearray(pathlib.Path(self.convert("a.png")).read_bytes())
        png[16:24] = struct.pack(">II", 30000, 30000)
        png[29:33] = struct.pack(">I", zlib.crc32(png[12:29]))
        for name, data in (("huge.jpg", jpeg), ("huge.mjpeg", jpeg), ("huge.png", png)):
            with self.subTest(name):
                self.expect_refused(self.write(name, data), "more pixels than its data can hold")

    def test_one_among_many_is_told_at_the_end(self):
        folder = self.folder / "many"
        folder.mkdir()
        for i in range(12):
            shutil.copy(self.convert("a.png"), folder / f"{i:02}.png")
        broken = folder / "05.png"
        broken.write_bytes(broken.read_bytes()[:200])
        result = self.run_program("detect", "-f", "jsonl", folder)
        sources = [os.path.basename(json.loads(line)["source"]) for line in result.stdout.splitlines()]
        self.assertEqual(sources, [f"{i:02}.png" for i in range(12) if i != 5])
        self.expect_error(result, str(broken))
        strict = self.run_program("detect", "-f", "jsonl", "--strict", folder)
        self.assertEqual(len(strict.stdout.splitlines()), 5)
        self.expect_error(strict, str(broken))


class OddFiles(PictureTest):
    def test_without_permission(self):
        path = self.write("secret.png", b"")
        os.chmod(path, 0)
        # Root reads everything unless it gives that power up.
        drop = ["setpriv", "--bounding-set", "-dac_override,-dac_read_search"] if os.geteuid() == 0 else []
        result = subprocess.run([*drop, PROGRAM, "detect", path], capture_output=True, timeout=60)
        self.expect_error(result, path, "Permission denied")
        folder = self.folder / "locked"
        folder.mkdir()
        scene.write_png(folder / "a.png", self.page)
        os.chmod(folder / "a.png", 0)
        scene.write_png(folder / "b.png", self.page)
        result = subprocess.run([*drop, PROGRAM, "detect", folder], capture_output=True, timeout=60)
        self.assertIn(b"b.png", result.stdout)
        self.expect_error(result, str(folder / "a.png"), "Permission denied")

    def test_that_are_empty(self):
        for name in ("a.png", "a.jpg", "a.pgm", "a.mp4", "a.y4m", "a.mjpeg", "a", "a.codes"):
            with self.subTest(name):
                self.expect_refused(self.write(name, b""))

    def test_that_hold_something_else(self):
        for name in ("a.png", "a.jpg", "a.mp4", "a.y4m", "a"):
            for data in (b"hello\n", bytes(5000), random.Random(2).randbytes(5000),
                         pathlib.Path(PROGRAM).read_bytes()[:9000]):
                with self.subTest(name=name, data=data[:8]):
                    self.expect_refused(self.write(name, data))

    def test_that_are_no_files(self):
        os.mkdir(self.path("folder.png"))
        self.expect_error(self.run_program("detect", self.path("folder.png")), "folder.png", "no images")
        scene.write_png(self.path("folder.png/a.png"), self.page)
        os.mkdir(self.path("folder.png/b.png"))
        os.mkfifo(self.path("folder.png/c.png"))  # would keep it waiting for ever
        self.assertEqual(len(self.detect(self.path("folder.png"))), 1)
        self.expect_error(self.run_program("detect", "/dev/zero"), "/dev/zero", "neither")
        self.expect_error(self.run_program("detect", "/dev/null"), "/dev/null", "no data")

    def test_dangling_link(self):
        os.symlink(self.path("gone.png"), self.path("link.png"))
        self.expect_error(self.run_program("detect", self.path("link.png")), "link.png", "No such file")
        self.expect_error(self.run_program("detect", "-f", "jsonl", self.folder), "link.png", "No such file")

    def test_named_pipe_is_a_stream(self):
        os.mkfifo(self.path("pipe"))
        writer = threading.Thread(target=lambda: pathlib.Path(self.path("pipe")).write_bytes(
            scene.y4m_bytes(scene.moving_marker(3))))
        writer.start()
        self.assertEqual([frame["frame"] for frame in self.detect(self.path("pipe"))], [0, 1, 2])
        writer.join()

    @unittest.skipIf(b"__asan_init" in pathlib.Path(PROGRAM).read_bytes(), "AddressSanitizer takes all addresses for itself")
    def test_that_promise_too_much(self):
        """A header may claim any size: nothing is set aside for it before the data come."""
        limit = 600 << 20

        def run(*arguments, **keywords):
            return subprocess.run([PROGRAM, "detect", "-j", "1", *arguments], capture_output=True, timeout=120,
                                  preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)), **keywords)

        header = b"YUV4MPEG2 W65535 H65535 F30:1 C444alpha\nFRAME\n"
        self.expect_error(run("-", input=header + bytes(100000)), "ends within frame 0")
        self.expect_error(run(self.write("a.pgm", b"P5 65535 65535 255\n" + bytes(1000))), "a.pgm")
        # A whole picture that is too large for the memory does not keep the next one from being read.
        rows = [bytes(20000)] * 20000
        self.write("huge.png", scene.png_bytes(20000, 20000, 8, 2, [row * 3 for row in rows[:1]] * 20000))
        result = run("-f", "jsonl", self.path("huge.png"), self.original)
        self.assertEqual([json.loads(line)["source"] for line in result.stdout.splitlines()], [self.original])
        self.expect_error(result, "huge.png")


@needs_ffmpeg
class Videos(CommandTest):
    def expect_an_end(self, result, path):
        """Whole lines of the frames that could be decoded, in order; then silence or one line."""
        frames = [json.loads(line) for line in result.stdout.splitlines()]
        self.assertEqual([frame["frame"] for frame in frames], list(range(len(frames))))
        if result.returncode == 0:
            self.assertEqual(result.stderr, b"")
        else:
            self.expect_error(result, path)
        return len(frames)

    def test_cut_off_anywhere(self):
        pages = scene.moving_marker(60)
        for name, options in (("a.mp4", ("-movflags", "faststart")), ("a.avi", ("-c:v", "mpeg4")), ("a.mkv", ()),
                              ("a.webm", ()), ("a.mjpeg", ()), ("a.y4m", ())):
            data = pathlib.Path(self.ffmpeg(pages, name, *options)).read_bytes()
            for part in (0.001, 0.05, 0.3, 0.7):
                with self.subTest(name=name, part=part):
                    pathlib.Path(self.path("cut-" + name)).write_bytes(data[:max(int(part * len(data)), 1)])
                    result = self.run_program("detect", "-f", "jsonl", self.path("cut-" + name))
                    self.assertLess(self.expect_an_end(result, self.path("cut-" + name)), 60)
                    if name in ("a.mp4", "a.avi", "a.y4m"):  # those state how much there should be
                        self.assertEqual(result.returncode, 2)

    def test_damaged_anywhere(self):
        chance = random.Random(3)
        for name in ("a.mp4", "a.avi", "a.mkv", "a.mjpeg"):
            data = pathlib.Path(self.ffmpeg(scene.moving_marker(40), name)).read_bytes()
            for _ in range(6):
                damaged = bytearray(data)
                for _ in range(40):
                    damaged[chance.randrange(len(data))] ^= 1 + chance.randrange(255)
                with self.subTest(name):
                    pathlib.Path(self.path("damaged-" + name)).write_bytes(damaged)
                    result = self.run_program("detect", "-f", "jsonl", self.path("damaged-" + name))
                    self.expect_an_end(result, self.path("damaged-" + name))

    def test_a_pipe_whose_ffmpeg_is_killed(self):
        """The frames that came whole are there, and the one that was cut off is told."""
        pages = scene.moving_marker(30, width=1280, height=720)
        source = self.ffmpeg(pages, "a.mkv", "-c:v", "ffv1")
        for form in ("yuv4mpegpipe -pix_fmt yuv444p", "mjpeg -q:v 1 -vf noise=alls=60:allf=t"):
            for jobs in ("1", "3"):
                with self.subTest(form=form, jobs=jobs):
                    result = self.run_with_killed_ffmpeg(source, form.split(), jobs)
                    frames = [json.loads(line)["frame"] for line in result.stdout.splitlines()]
                    self.assertEqual(frames, list(range(len(frames))))
                    self.expect_error(result, "standard input", f"frame {len(frames)}")

    def run_with_killed_ffmpeg(self, source, form, jobs):
        ffmpeg = subprocess.Popen([FFMPEG, "-v", "error", "-stream_loop", "-1", "-i", source, "-f", *form, "-"],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        with subprocess.Popen([PROGRAM, "detect", "-f", "jsonl", "-j", jobs, "-"], stdin=ffmpeg.stdout,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              bufsize=0) as program:  # communicate() knows nothing of lines read ahead
            ffmpeg.stdout.close()
            lines = [program.stdout.readline() for _ in range(5)]
            # While nobody reads, ffmpeg stands in the middle of a frame, which is larger than any pipe.
            program.send_signal(signal.SIGSTOP)
            self.wait_until_blocked(ffmpeg.pid)
            ffmpeg.kill()
            ffmpeg.wait()
            program.send_signal(signal.SIGCONT)
            out, err = program.communicate(timeout=60)
            return subprocess.CompletedProcess([], program.returncode, b"".join(lines) + out, err)

    @staticmethod
    def wait_until_blocked(process):
        """Until it sleeps in a write to a full pipe."""
        for _ in range(600):
            if "pipe_write" in pathlib.Path(f"/proc/{process}/wchan").read_text():
                return
            threading.Event().wait(0.1)
        raise AssertionError("ffmpeg does not wait for its reader")


if __name__ == "__main__":
    unittest.main()
