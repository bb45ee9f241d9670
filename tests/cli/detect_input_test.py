"""`runmark detect` reads every kind of input it names."""

import os
import pathlib
import unittest

import scene
from command import CommandTest, needs_ffmpeg


class Images(CommandTest):
    def check(self, write, name, *arguments):
        page = scene.one_marker()
        write(self.path(name), page, *arguments)
        frames = self.detect(self.path(name))
        self.assertEqual(len(frames), 1)
        self.assertEqual({key: frames[0][key] for key in ("source", "frame", "width", "height")},
                         {"source": self.path(name), "frame": 0, "width": 320, "height": 240})
        self.expect_markers(frames[0], page)

    def test_pgm(self):
        self.check(scene.write_pgm, "a.pgm")

    def test_pgm_of_16_bits(self):
        self.check(scene.write_pgm16, "a.pgm")

    def test_ppm(self):
        self.check(scene.write_ppm, "a.ppm")

    def test_pbm_of_one_bit(self):
        self.check(scene.write_pbm, "a.pbm")

    def test_bmp(self):
        self.check(scene.write_bmp, "a.bmp")

    def test_png_of_every_kind(self):
        for kind in ("grey", "rgb", "grey16", "bit", "rgba", "grey_alpha"):
            with self.subTest(kind):
                self.check(scene.write_png, f"{kind}.png", kind)

    def test_name_without_extension(self):
        self.check(scene.write_png, "picture")

    def test_capital_extension(self):
        self.check(scene.write_png, "A.PNG")

    @needs_ffmpeg
    def test_jpeg_tiff_and_webp(self):
        page = scene.one_marker()
        for name, options in (("a.jpg", ("-q:v", "2")), ("a.tiff", ()), ("a.webp", ("-quality", "95"))):
            with self.subTest(name):
                path = self.ffmpeg([page], name, "-frames:v", "1", *options)
                self.expect_markers(self.detect(path)[0], page, tolerance=0.5)

    def test_images_of_growing_size(self):
        pages = [scene.one_marker(width=w, height=h) for w, h in ((220, 180), (640, 200), (210, 500))]
        for i, page in enumerate(pages):
            scene.write_pgm(self.path(f"{i}.pgm"), page)
        for frame, page in zip(self.detect(*(self.path(f"{i}.pgm") for i in range(3))), pages):
            self.expect_markers(frame, page)


class Folders(CommandTest):
    def test_sorted_not_recursive_and_only_pictures(self):
        (self.folder / "sub").mkdir()
        for name in ("c.png", "a.png", "b.png", "sub/d.png"):
            scene.write_png(self.path(name), scene.one_marker())
        (self.folder / "notes.txt").write_text("no picture")
        frames = self.detect(str(self.folder))
        self.assertEqual([frame["source"] for frame in frames], [self.path(n) for n in ("a.png", "b.png", "c.png")])

    def test_videos_in_a_folder(self):
        scene.write_png(self.path("a.png"), scene.one_marker())
        pathlib.Path(self.path("b.y4m")).write_bytes(scene.y4m_bytes(scene.moving_marker(3)))
        frames = self.detect(str(self.folder))
        self.assertEqual([(os.path.basename(f["source"]), f["frame"]) for f in frames],
                         [("a.png", 0), ("b.y4m", 0), ("b.y4m", 1), ("b.y4m", 2)])

    def test_one_bad_file_is_told_at_the_end(self):
        for name in ("a.png", "c.png"):
            scene.write_png(self.path(name), scene.one_marker())
        pathlib.Path(self.path("b.png")).write_text("not a picture")
        result = self.run_program("detect", "-f", "jsonl", self.folder)
        self.assertEqual(len(result.stdout.splitlines()), 2)
        self.expect_error(result, self.path("b.png"))

    def test_strict_stops_at_the_bad_file(self):
        for name in ("a.png", "c.png"):
            scene.write_png(self.path(name), scene.one_marker())
        pathlib.Path(self.path("b.png")).write_text("not a picture")
        result = self.run_program("detect", "-f", "jsonl", "--strict", self.folder)
        self.assertEqual(len(result.stdout.splitlines()), 1)
        self.expect_error(result, self.path("b.png"))

    def test_empty_folder(self):
        self.expect_error(self.run_program("detect", self.folder), str(self.folder), "no images")


class Streams(CommandTest):
    def test_y4m_of_every_chroma_format(self):
        pages = scene.moving_marker(3, width=321, height=241)
        for colour in ("", "420", "420jpeg", "420mpeg2", "420paldv", "411", "422", "444", "444alpha", "mono"):
            with self.subTest(colour):
                frames = self.detect("-", stdin=scene.y4m_bytes(pages, colour))
                self.assertEqual([(f["source"], f["frame"]) for f in frames], [("-", 0), ("-", 1), ("-", 2)])
                for frame, page in zip(frames, pages):
                    self.expect_markers(frame, page)

    def test_y4m_of_ten_bits_is_refused(self):
        result = self.run_program("detect", "-", stdin=scene.y4m_bytes([scene.one_marker()], "420p10"))
        self.expect_error(result, "standard input", "420p10")

    def test_y4m_that_breaks_off(self):
        data = scene.y4m_bytes(scene.moving_marker(3))
        result = self.run_program("detect", "-f", "jsonl", "-", stdin=data[:-100])
        self.assertEqual(len(result.stdout.splitlines()), 2)
        self.expect_error(result, "standard input", "frame 2")

    def test_y4m_without_size(self):
        self.expect_error(self.run_program("detect", "-", stdin=b"YUV4MPEG2 W0 H5\nFRAME\n"), "width")

    def test_y4m_header_without_end(self):
        self.expect_error(self.run_program("detect", "-", stdin=b"YUV4MPEG2 " + b"X" * 9000), "header")

    def test_y4m_without_frames(self):
        self.expect_error(self.run_program("detect", "-", stdin=scene.y4m_header(scene.one_marker(), "420")),
                          "no frames")

    @needs_ffmpeg
    def test_mjpeg(self):
        pages = scene.moving_marker(4)
        path = self.ffmpeg(pages, "a.mjpeg", "-q:v", "2")
        data = pathlib.Path(path).read_bytes()
        for frames in (self.detect("-", stdin=data), self.detect(path)):
            self.assertEqual([frame["frame"] for frame in frames], [0, 1, 2, 3])
            for frame, page in zip(frames, pages):
                self.expect_markers(frame, page, tolerance=0.5)

    @needs_ffmpeg
    def test_mjpeg_in_a_multipart_stream(self):
        data = pathlib.Path(self.ffmpeg(scene.moving_marker(3), "a.bin", "-f", "mpjpeg")).read_bytes()
        self.assertTrue(data.startswith(b"--"))
        self.assertEqual(len(self.detect("-", stdin=data)), 3)

    @needs_ffmpeg
    def test_thumbnail_inside_a_jpeg_is_no_picture(self):
        data = pathlib.Path(self.ffmpeg([scene.one_marker()], "a.jpg", "-frames:v", "1")).read_bytes()
        thumbnail = b"\xff\xd8\xff\xdb\x00\x02\xff\xd9"
        segment = b"\xff\xe1" + (len(thumbnail) + 2).to_bytes(2, "big") + thumbnail
        with_thumbnail = data[:2] + segment + data[2:]
        frames = self.detect("-", stdin=with_thumbnail + with_thumbnail)
        self.assertEqual([len(frame["markers"]) for frame in frames], [1, 1])

    @needs_ffmpeg
    def test_mjpeg_that_breaks_off(self):
        data = pathlib.Path(self.ffmpeg(scene.moving_marker(3), "a.mjpeg")).read_bytes()
        result = self.run_program("detect", "-f", "jsonl", "-", stdin=data[:-10])
        self.assertEqual(len(result.stdout.splitlines()), 2)
        self.expect_error(result, "standard input", "frame 2")

    def test_neither_y4m_nor_mjpeg(self):
        for data in (b"\x89PNG\r\n\x1a\n", b"x", b"\xff", bytes(100000)):
            with self.subTest(data[:8]):
                self.expect_error(self.run_program("detect", "-", stdin=data), "neither a Y4M nor an MJPEG")

    def test_empty(self):
        self.expect_error(self.run_program("detect", "-"), "standard input", "no data")

    def test_read_only_once(self):
        self.expect_error(self.run_program("detect", "-", "-"), "only once")


@needs_ffmpeg
class Videos(CommandTest):
    def test_containers(self):
        pages = scene.moving_marker(12)
        for name in ("a.mp4", "a.avi", "a.mkv", "a.webm", "a.mov"):
            with self.subTest(name):
                frames = self.detect(self.ffmpeg(pages, name, "-pix_fmt", "yuv420p"))
                self.assertEqual([frame["frame"] for frame in frames], list(range(12)))
                for frame, page in zip(frames, pages):
                    self.expect_markers(frame, page, tolerance=1)

    def test_video_that_breaks_off(self):
        path = self.ffmpeg(scene.moving_marker(60), "a.mp4", "-movflags", "faststart", "-g", "5", "-bf", "0")
        data = pathlib.Path(path).read_bytes()
        pathlib.Path(path).write_bytes(data[:len(data) * 2 // 3])
        result = self.run_program("detect", "-f", "jsonl", path)
        self.assertGreater(len(result.stdout.splitlines()), 5)
        self.expect_error(result, path, "breaks off after", "of 60 frames")

    def test_video_without_its_index(self):
        path = self.ffmpeg(scene.moving_marker(20), "a.mp4")
        data = pathlib.Path(path).read_bytes()
        pathlib.Path(path).write_bytes(data[:len(data) // 2])
        self.expect_error(self.run_program("detect", path), path, "video")


class Cameras(CommandTest):
    def test_camera_that_is_not_there(self):
        self.expect_error(self.run_program("detect", "camera:63"), "camera:63")
        self.expect_error(self.run_program("detect", "/dev/video63"), "/dev/video63")

    def test_camera_without_a_number(self):
        self.expect_error(self.run_program("detect", "camera:front"), "camera:front", "camera:0")


if __name__ == "__main__":
    unittest.main()
