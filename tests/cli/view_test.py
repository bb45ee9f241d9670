"""`runmark view` on a virtual display, with real key presses."""

import os
import pathlib
import signal
import unittest

import scene
from command import CommandTest, needs_ffmpeg
from display import DisplayTest, needs_display

BAR = 26  # rows of the status line below the picture
STAGES = ["original", "threshold", "preprocess", "contours", "corners", "sample grid", "markers"]


def page(x):
    return scene.one_marker(x=x, width=640, height=480)


def colours_of(shot):
    """The colours of the picture, without the status line."""
    width, height, data = shot
    data = data[:3 * width * (height - BAR)]
    return {data[i:i + 3] for i in range(0, len(data), 3)}


def picture_of(shot):
    width, height, data = shot
    return data[:3 * width * (height - BAR)]


def is_green(colour):
    red, green, blue = colour
    return green > 180 and red < 140 and blue < 140


@needs_display
class View(DisplayTest):
    def test_stages_by_key(self):
        scene.write_png(self.path("desk.png"), page(100))
        self.view(self.path("desk.png"))
        self.assertEqual(self.title(), "runmark view: markers: desk.png")
        shots = {}
        for key, name in enumerate(STAGES, 1):
            self.press(str(key), f"view: {name}:")
            shots[name] = self.screenshot()
        self.press("q")
        self.expect_end(0)
        self.assertEqual(sorted(os.listdir(self.path("shots"))), [f"runmark-view-{i:03}.png" for i in range(1, 8)])

        self.assertEqual(shots["original"][:2], (640, 480 + BAR))
        self.assertEqual(picture_of(shots["original"]), page(100).rgb())
        for name in ("threshold", "preprocess"):
            self.assertEqual(colours_of(shots[name]), {b"\0\0\0", b"\xff\xff\xff"})
        self.assertTrue(any(is_green(colour) for colour in colours_of(shots["markers"])))
        self.assertFalse(any(is_green(colour) for colour in colours_of(shots["original"])))
        # A picture without specks is the same before and after preprocessing.
        self.assertEqual(len({picture_of(shot) for shot in shots.values()}), 6)
        width, _, data = shots["markers"]
        outline = data[3 * (60 * width + 150):][:3]  # in the middle of the upper side
        self.assertTrue(is_green(outline), outline)

    def test_the_screen_shows_it(self):
        scene.write_png(self.path("desk.png"), page(100))
        self.view(self.path("desk.png"))

        def shown():
            width, _, data = self.screen()
            return sum(is_green(data[i:i + 3]) for i in range(0, len(data), 3))
        self.wait_for("green outlines on the screen", lambda: shown() > 300)
        self.press("1", "original")
        self.wait_for("a screen without outlines", lambda: shown() == 0)
        self.press("Escape")
        self.expect_end(0)

    def test_a_folder_by_key(self):
        for i in range(3):
            scene.write_png(self.path(f"{i}.png"), page(100 + 100 * i))
        self.view(self.folder)
        self.press("1", "original: 0.png")
        for key, i in (("n", 1), ("n", 2), ("n", 2), ("b", 1), ("m", 2), ("b", 1), ("b", 0), ("b", 0)):
            self.press(key, f": {i}.png")
            self.assertEqual(picture_of(self.screenshot()), page(100 + 100 * i).rgb())
        self.press("q")
        self.expect_end(0)

    def test_axes_by_key(self):
        scene.write_png(self.path("desk.png"), page(100))
        camera = pathlib.Path(self.path("camera.yaml"))
        camera.write_text("image_width: 640\nimage_height: 480\ndistortion_model: plumb_bob\n"
                          "camera_matrix: {rows: 3, cols: 3, data: [600, 0, 319.5, 0, 600, 239.5, 0, 0, 1]}\n"
                          "distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}\n")
        self.view("--camera-info", camera, "--marker-size", "0.1", self.path("desk.png"))

        def reds_right_of_the_middle():
            width, _, data = self.screenshot()
            row = data[3 * width * 108:][:3 * width]  # through the middle of the marker, along its x axis
            return sum(row[3 * x] > 200 and row[3 * x + 1] < 120 for x in range(160, 190))
        with_axes = reds_right_of_the_middle()
        self.press("a")
        self.wait_for("a picture without axes", lambda: reds_right_of_the_middle() == 0)
        self.press("a")
        self.wait_for("the axes again", lambda: reds_right_of_the_middle() == with_axes)
        self.press("q")
        self.expect_end(0)
        self.assertGreater(with_axes, 20)

    def test_help_lies_over_the_picture(self):
        scene.write_png(self.path("desk.png"), page(100))
        self.view(self.path("desk.png"))
        before = self.screenshot()
        self.press("h")
        self.wait_for("the help", lambda: picture_of(self.screenshot()) != picture_of(before))
        self.press("h")
        self.wait_for("the picture again", lambda: picture_of(self.screenshot()) == picture_of(before))
        self.press("q")
        self.expect_end(0)

    def test_small_pictures_are_enlarged(self):
        scene.write_png(self.path("small.png"), scene.one_marker())
        self.view(self.path("small.png"))
        self.assertEqual(self.screenshot()[:2], (640, 480 + BAR))

    def test_screenshots_replace_nothing(self):
        scene.write_png(self.path("desk.png"), page(100))
        shots = pathlib.Path(self.path("shots"))
        shots.mkdir()
        (shots / "runmark-view-001.png").write_text("mine")
        self.view(self.path("desk.png"))
        self.screenshot()
        self.assertEqual((shots / "runmark-view-001.png").read_text(), "mine")
        self.assertTrue((shots / "runmark-view-002.png").exists())

    @needs_ffmpeg
    def test_a_video_runs_and_pauses(self):
        video = self.ffmpeg([scene.one_marker(x=20 + i, width=640, height=480) for i in range(300)], "a.avi",
                            "-c:v", "mjpeg", "-q:v", "2")
        self.view(video)
        self.press("1", "original")
        self.press("m")  # there is no other input to go to
        moving = set()

        def three_frames():
            moving.add(picture_of(self.screenshot()))
            return len(moving) >= 3
        self.wait_for("three frames", three_frames)
        self.press("space", "original, paused")
        still = picture_of(self.screenshot())
        self.assertEqual(picture_of(self.screenshot()), still)
        self.press("n")
        self.wait_for("the next frame", lambda: picture_of(self.screenshot()) != still)
        self.press("b")  # from the beginning
        self.press("space", "original: a.avi")
        self.press("q")
        self.expect_end(0)

    def test_a_stream_on_standard_input(self):
        data = scene.y4m_bytes(scene.moving_marker(3, width=640, height=480))
        path = pathlib.Path(self.path("stream"))
        path.write_bytes(data)
        with open(path, "rb") as stream:
            self.view("-", stdin=stream)
        self.press("1", "original: -")
        self.wait_for("the last frame",
                      lambda: picture_of(self.screenshot()) == scene.moving_marker(3, width=640, height=480)[2].rgb())
        self.press("b")  # what is gone cannot be read again
        self.press("q")
        self.expect_end(0)

    def test_a_broken_picture_is_told_and_left_out(self):
        scene.write_png(self.path("0.png"), page(100))
        pathlib.Path(self.path("1.png")).write_bytes(b"\x89PNG and no more")
        scene.write_png(self.path("2.png"), page(300))
        self.view(self.folder)
        self.press("n", ": 2.png")
        self.press("q")
        self.expect_end(2)
        self.assertIn("1.png: not an image", self.viewer.stderr.read())

    def test_control_c(self):
        scene.write_png(self.path("desk.png"), page(100))
        self.view(self.path("desk.png"))
        self.viewer.send_signal(signal.SIGINT)
        self.expect_end(130)

    def test_closing_the_window_ends_it(self):
        scene.write_png(self.path("desk.png"), page(100))
        self.view(self.path("desk.png"))
        self.close_window()
        self.expect_end(0)


class WithoutADisplay(CommandTest):
    def run_view(self, *arguments, **changes):
        environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
        return self.run_program("view", *arguments, env={**environment, **changes})

    def test_errors(self):
        scene.write_png(self.path("desk.png"), scene.one_marker())
        self.expect_error(self.run_view(self.path("desk.png")), "no display: DISPLAY is not set")
        self.expect_error(self.run_view(self.path("desk.png"), DISPLAY=":987"), "the display ':987' cannot be opened")
        self.expect_error(self.run_view(self.path("none.png")), "none.png: No such file")
        self.expect_error(self.run_view("camera:x"), "camera:x: a camera is named by its number")
        self.expect_error(self.run_view(), "INPUT is required; see runmark view --help")

    def test_help(self):
        result = self.run_view("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn(b"Usage: runmark view [OPTIONS] INPUT", result.stdout)
        self.assertIn(b"s screenshot", result.stdout)


if __name__ == "__main__":
    unittest.main()
