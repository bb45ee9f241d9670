"""What `runmark detect` does for videos: ids confirmed over frames, and times of a rolling shutter."""

import csv
import io
import subprocess
import unittest

import scene
from command import FFMPEG, CommandTest, needs_ffmpeg


def flashing(frames, *, every):
    """A marker that moves, and in one frame of `every` another one."""
    scenes = []
    for i in range(frames):
        page = scene.Scene().add("DICT_4X4_1000", 7, 40 + 3 * i, 60, 10)
        if i % every == 2:
            page.add("DICT_4X4_1000", 12, 20 + 60 * (i % 4), 160, 10)
        scenes.append(page)
    return scenes


class Confirmed(CommandTest):
    def ids(self, frames):
        return [sorted(marker["id"] for marker in frame["markers"]) for frame in frames]

    def video(self, scenes, name="a.y4m"):
        path = self.path(name)
        with open(path, "wb") as file:
            file.write(scene.y4m_bytes(scenes))
        return path

    def test_a_marker_is_printed_from_the_nth_frame_on(self):
        scenes = flashing(10, every=4)
        video = self.video(scenes)
        self.assertEqual(self.ids(self.detect(video)), [[7], [7], [7, 12], [7], [7], [7], [7, 12], [7], [7], [7]])
        frames = self.detect("--confirm", 3, video)
        self.assertEqual(self.ids(frames), [[], []] + [[7]] * 8)
        for frame, page in list(zip(frames, scenes))[2:]:
            self.assertLess(abs(frame["markers"][0]["corners"][0][0] - page.markers[0][1][0][0]), 0.25)

    def test_each_video_begins_anew(self):
        short, long = self.video(flashing(3, every=9), "a.y4m"), self.video(flashing(4, every=9), "b.y4m")
        self.assertEqual(self.ids(self.detect("--confirm", 3, short, long)), [[], [], [7], [], [], [7], [7]])

    def test_pictures_are_frames_of_one_video(self):
        for i, page in enumerate(flashing(4, every=9)):
            scene.write_pgm(self.path(f"{i}.pgm"), page)
        self.assertEqual(self.ids(self.detect("--confirm", 2, self.folder)), [[], [7], [7], [7]])

    def test_the_same_for_any_number_of_threads(self):
        video = self.video(flashing(40, every=5))
        one = self.detect("--confirm", 4, "--jobs", 1, video)
        self.assertEqual(one, self.detect("--confirm", 4, "--jobs", 3, video))
        self.assertEqual(self.ids(one), [[]] * 3 + [[7]] * 37)

    @needs_ffmpeg
    def test_only_confirmed_markers_are_drawn(self):
        video = self.video([scene.one_marker() for _ in range(4)])
        for confirm, drawn in ((5, False), (2, True)):
            out = self.path(f"{confirm}.avi")
            self.detect("--confirm", confirm, "--annotate", out, video)
            self.assertEqual(self.last_frame_has_green(out), drawn)

    def last_frame_has_green(self, video):
        data = subprocess.run([FFMPEG, "-v", "error", "-i", video, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                              check=True, capture_output=True).stdout
        last = data[-320 * 240 * 3:]
        return any(last[i + 1] > 180 and last[i] < 140 and last[i + 2] < 140 for i in range(0, len(last), 3))

    def test_wrong_use(self):
        video = self.video(flashing(2, every=9))
        self.expect_error(self.run_program("detect", "--confirm", 0, video), "--confirm")
        self.expect_error(self.run_program("detect", "--confirm", 2, "--resume", self.path("o.jsonl"), video),
                          "--confirm", "--resume")


class RowTimes(CommandTest):
    def setUp(self):
        super().setUp()
        self.file = self.path("a.pgm")
        scene.write_pgm(self.file, scene.one_marker())  # rows 60 to 155

    def test_json(self):
        marker = self.detect("--row-time", 15, self.file)[0]["markers"][0]
        self.assertEqual(list(marker)[-2:], ["rows", "row_times_us"])
        (first, last), times = marker["rows"], marker["row_times_us"]
        self.assertLess(max(abs(first - 59.5), abs(last - 155.5)), 0.1)
        self.assertEqual((first, last), (min(y for _, y in marker["corners"]), max(y for _, y in marker["corners"])))
        self.assertLess(max(abs(times[0] - 15 * first), abs(times[1] - 15 * last)), 0.01)
        self.assertNotIn("rows", self.detect(self.file)[0]["markers"][0])

    def test_csv_and_text(self):
        def output(*arguments):
            return self.run_program("detect", "--dict", "DICT_4X4_50", "--row-time", "0.5", *arguments,
                                    self.file).stdout.decode()
        row = next(csv.DictReader(io.StringIO(output("-f", "csv"))))
        self.assertLess(abs(float(row["first_row"]) - 59.5), 0.1)
        self.assertLess(abs(float(row["last_us"]) - 77.75), 0.1)
        self.assertRegex(output(), r"rows 59\.\d+ to 155\.\d+: 29\.\d+ to 77\.\d+ us after the first row")

    def test_wrong_use(self):
        for time in ("0", "-3", "fast"):
            self.expect_error(self.run_program("detect", "--row-time", time, self.file), "--row-time")


if __name__ == "__main__":
    unittest.main()
