"""runmark calibrate: a camera from rendered views of a board, whose truth is known."""

import json
import pathlib
import re

from command import CommandTest, needs_ffmpeg
import subprocess

BOARD = "charuco:DICT_5X5_100:6x8:28:20"


class Calibrate(CommandTest):
    def render(self, *arguments, views=8):
        folder = self.path("views")
        result = self.run_program("render", "--board", BOARD, "--scenes", views, "-o", folder, *arguments)
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        truth = json.loads(pathlib.Path(folder, "truth.json").read_text())
        return folder, truth

    def calibrate(self, *arguments, board=BOARD):
        return self.run_program("calibrate", "--board", board, *arguments)

    def test_folder_gives_the_camera_and_all_files(self):
        folder, truth = self.render()
        files = [self.path(name) for name in ("camera.yml", "ros.yml", "report.html", "coverage.png")]
        result = self.calibrate(folder, "-o", files[0], "--ros", files[1], "--report", files[2], "--coverage", files[3])
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        text = result.stdout.decode()
        self.assertLess(float(re.search(r"error ([\d.]+) px", text)[1]), 0.05)
        for view in truth:
            self.assertIn(view["image"], text)
        for name in files[:2]:
            data = re.search(r"data: \[(.*?)\]", pathlib.Path(name).read_text())[1].split(",")
            focal = truth[0]["board"]["focal"]
            self.assertLess(abs(float(data[0]) - focal), 0.003 * focal)
            self.assertLess(abs(float(data[2]) - 319.5), 2)
        page = pathlib.Path(files[2]).read_text()
        self.assertEqual(page.count("<figure>"), 3)
        self.assertIn("board_0003.png", page)
        self.assertEqual(pathlib.Path(files[3]).read_bytes()[:4], b"\x89PNG")
        # The pose it then measures is the true one.
        result = self.run_program("detect", "-f", "jsonl", pathlib.Path(folder, "board_0002.png"), "--camera-info", files[1],
                                  "--board", BOARD)
        pose = json.loads(result.stdout)["board"]["pose"]
        for found, exact in zip(pose["translation"], truth[2]["board"]["translation"]):
            self.assertAlmostEqual(found, exact, delta=0.004 * truth[2]["board"]["translation"][2])

    @needs_ffmpeg
    def test_video_gives_views_that_differ(self):
        folder, _ = self.render(views=6)
        # Each view for half a second.
        video = self.path("views.avi")
        subprocess.run(["ffmpeg", "-v", "error", "-framerate", "2", "-i", f"{folder}/board_%04d.png", "-vf", "fps=10",
                        "-c:v", "mjpeg", "-q:v", "2", video], check=True)
        result = self.calibrate(video, "--max-views", 6)
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        frames = [int(number) for number in re.findall(r"avi frame (\d+)", result.stdout.decode())]
        self.assertEqual([frame // 5 for frame in frames], list(range(6)))

    def test_every_lens_model_gives_the_true_pose_of_another_view(self):
        folder, truth = self.render(views=10)
        views = [pathlib.Path(folder, view["image"]) for view in truth]
        for lens in ("plain", "rational", "fisheye"):
            camera = self.path(f"{lens}.yml")
            result = self.calibrate(*views[1:], "--lens", lens, "-o", camera)
            self.assertEqual((result.stderr, result.returncode), (b"", 0))
            result = self.run_program("detect", "-f", "jsonl", views[0], "--camera-info", camera, "--board", BOARD)
            self.assertEqual((result.stderr, result.returncode), (b"", 0))
            pose = json.loads(result.stdout)["board"]["pose"]
            exact = truth[0]["board"]["translation"]
            for a, b in zip(pose["translation"], exact):
                self.assertAlmostEqual(a, b, delta=0.002 * exact[2], msg=lens)

    def test_inverted_board(self):
        folder, _ = self.render("--inverted", views=5)
        result = self.calibrate(folder, "--inverted")
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        self.assertIn(b"5 views", result.stdout)

    def test_bad_view_is_named(self):
        folder, _ = self.render(views=8)
        # A view of a board of other proportions.
        other = self.run_program("render", "--board", "charuco:DICT_5X5_100:6x8:28:20.1", "--scenes", 1, "--seed", 9,
                                 "-o", self.path("other"))
        self.assertEqual(other.returncode, 0)
        result = self.calibrate(folder, self.path("other"))
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        # The other camera has another focal length.
        self.assertRegex(result.stdout.decode(), r"other/board_0000.png .*left out: disagrees with the others")

    def test_what_is_wrong(self):
        folder, _ = self.render(views=3)
        self.expect_error(self.calibrate(folder, board="charuco:DICT_5X5_100:8x6:28:20"), "6 x 8 squares")
        self.expect_error(self.calibrate(pathlib.Path(folder, "board_0000.png")), "in 1 of 1 frames", "at least 3")
        self.expect_error(self.calibrate(folder, board="x"), "a board is a .json file")
        self.run_program("render", "--board", BOARD, "--scenes", 1, "--set", "hd", "-o", self.path("hd"))
        self.expect_error(self.calibrate(folder, self.path("hd")), "1280 x 720", "640 x 480")
        self.expect_error(self.calibrate(folder, "-o", self.path("no/camera.yml")), "no/camera.yml")
        self.expect_error(self.calibrate(folder, "--coverage", self.path("x.txt")), "x.txt")
