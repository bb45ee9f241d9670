"""Prints are turned to pixels and read back: every id, every size, in its place."""

import math
import pathlib
import re
import struct
import subprocess

from command import CommandTest

DPI = 300


class Print(CommandTest):
    def print(self, *arguments, name="print.pdf"):
        path = self.path(name)
        result = self.run_program("print", "-o", path, *arguments)
        self.assertEqual((result.stderr, result.returncode), (b"", 0))
        return path

    def pages(self, pdf):
        """The pages as pictures of DPI pixels an inch."""
        subprocess.run(["pdftoppm", "-r", str(DPI), "-gray", pdf, self.path("page")], check=True)
        return sorted(map(str, self.folder.glob("page*.pgm")))

    def read(self, picture, *arguments, dictionary):
        frame, = self.detect(picture, *arguments, dictionary=dictionary)
        return frame

    def expect_sizes(self, frame, size, dpi=DPI, tolerance=0.1):
        """Every side of every marker is so many millimetres long."""
        for marker in frame["markers"]:
            corners = marker["corners"]
            for i in range(4):
                length = math.dist(corners[i], corners[(i + 1) % 4]) / dpi * 25.4
                self.assertLess(abs(length - size), tolerance, marker["id"])

    def test_shortest_form(self):
        page, = self.pages(self.print("--dict", "tag36h11", "--ids", "0-11"))
        frame = self.read(page, dictionary="tag36h11")
        self.assertEqual(sorted(marker["id"] for marker in frame["markers"]), list(range(12)))
        self.expect_sizes(frame, 40)
        self.assertLessEqual(abs(frame["width"] - 210 / 25.4 * DPI), 1)
        self.assertLessEqual(abs(frame["height"] - 297 / 25.4 * DPI), 1)
        # Row by row from the top left one on.
        order = sorted(frame["markers"], key=lambda marker: (round(marker["corners"][0][1] / 50), marker["corners"][0][0]))
        self.assertEqual([marker["id"] for marker in order], list(range(12)))

    def test_every_kind_of_dictionary_and_many_pages(self):
        for dictionary, ids, size, paper in (("DICT_4X4_50", "0-49", 25, "A4"), ("DICT_7X7_1000", "990-999", 50.5, "Letter"),
                                             ("ARUCO_MIP_36h12", "3,1,2", 90, "A4"), ("tagStandard41h12", "0-5", 40, "A4"),
                                             ("tagCustom48h12", "7", 60, "A5"), ("tagCircle21h7", "0-3", 45, "A4-landscape"),
                                             ("DICT_ARUCO_ORIGINAL", "1023", 150, "230x240")):
            for old in self.folder.iterdir():
                old.unlink()
            pages = self.pages(self.print("-d", dictionary, "--ids", ids, "--size", size, "--paper", paper))
            found = []
            for page in pages:
                frame = self.read(page, dictionary=dictionary)
                self.expect_sizes(frame, size)
                found += [marker["id"] for marker in frame["markers"]]
            wanted = [i for part in ids.split(",") for i in range(int(part.split("-")[0]), int(part.split("-")[-1]) + 1)]
            self.assertEqual(sorted(found), sorted(wanted), dictionary)

    def test_codes_file_of_ones_own(self):
        codes = self.path("own.codes")
        source = pathlib.Path(__file__).resolve().parents[2] / "data/dictionaries/ARUCO_MIP_16h3.codes"
        pathlib.Path(codes).write_text(source.read_text())
        page, = self.pages(self.print("-d", codes, "--ids", "0,5", "--size", 30))
        frame = self.read(page, dictionary=codes)
        self.assertEqual(sorted(marker["id"] for marker in frame["markers"]), [0, 5])
        self.expect_sizes(frame, 30)

    def test_ruler_is_of_true_length(self):
        page, = self.pages(self.print("--dict", "tag36h11", "--ids", "0", "--no-labels", "--no-cut-marks"))
        data = pathlib.Path(page).read_bytes()
        header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
        width, height = int(header[1]), int(header[2])
        rows = [data[header.end() + y * width:header.end() + (y + 1) * width] for y in range(height)]
        # Its base line is the longest dark run of the page's foot.
        longest = 0
        for row in rows[int(0.9 * height):]:
            for run in re.findall(rb"[\x00-\xa0]+", row):
                longest = max(longest, len(run))
        self.assertLess(abs(longest / DPI * 25.4 - 150), 0.3)

    def test_white_margin_is_kept(self):
        page, = self.pages(self.print("--dict", "DICT_4X4_50", "--ids", "3", "--size", 60))
        frame = self.read(page, dictionary="DICT_4X4_50")
        (left, top), _, (right, bottom), _ = frame["markers"][0]["corners"]
        data = pathlib.Path(page).read_bytes()
        header = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", data)
        cell = (right - left) / 6
        for y in range(int(top - 0.95 * cell), int(bottom + 0.95 * cell)):
            row = header.end() + y * int(header[1])
            for a, b in ((left - 0.95 * cell, left - 2), (right + 2, right + 0.95 * cell)):
                self.assertEqual(set(data[row + int(a):row + int(b)]), {255})

    def test_png_and_svg_are_as_large(self):
        png = self.print("--dict", "tag36h11", "--ids", "0-3", "--size", 50, "--dpi", "200", name="print.png")
        frame = self.read(png, dictionary="tag36h11")
        self.expect_sizes(frame, 50, dpi=200)
        data = pathlib.Path(png).read_bytes()
        at = data.index(b"pHYs")
        self.assertEqual(struct.unpack(">IIB", data[at + 4:at + 13]), (7874, 7874, 1))
        svg = self.print("--dict", "tag36h11", "--ids", "0-3", "--size", 50, name="print.svg")
        self.assertRegex(pathlib.Path(svg).read_text(), r'width="210mm" height="297mm"')
        subprocess.run(["rsvg-convert", "-d", "200", "-p", "200", "-b", "white", "-o", self.path("svg.png"), svg], check=True)
        frame = self.read(self.path("svg.png"), dictionary="tag36h11")
        self.assertEqual(len(frame["markers"]), 4)
        self.expect_sizes(frame, 50, dpi=200)

    def test_several_pages_of_pictures_are_numbered(self):
        self.print("--dict", "tag36h11", "--ids", "0-5", "--size", 80, "--dpi", "50", name="many.png")
        self.assertEqual(sorted(path.name for path in self.folder.glob("many*")), [f"many-{i}.png" for i in (1, 2, 3)])

    def test_inverted(self):
        page, = self.pages(self.print("--dict", "DICT_5X5_100", "--ids", "0-3", "--inverted"))
        frame = self.read(page, "--inverted", dictionary="DICT_5X5_100")
        self.assertEqual(sorted((marker["id"], marker["inverted"]) for marker in frame["markers"]),
                         [(i, True) for i in range(4)])
        self.expect_sizes(frame, 40)

    def test_boards(self):
        for board, corners in (("charuco:DICT_5X5_100:6x8:28:20", 35), ("charuco:DICT_5X5_100:6x8:28:20:legacy", 35),
                               ("charuco:tag36h11:5x7:33:25:turned", 24), ("grid:tag36h11:4x5:35:8", 0)):
            for old in self.folder.iterdir():
                old.unlink()
            page, = self.pages(self.print("--board", board))
            frame = self.read(page, "--board", board, dictionary=board.split(":")[1])
            self.assertNotIn("advice", frame["board"], board)
            self.assertEqual(len(frame["board"]["corners"]), corners)
            marker = float(board.split(":")[4 if corners else 3])
            self.expect_sizes(frame, marker)
            if corners:
                columns, square = int(board.split(":")[2].split("x")[0]), float(board.split(":")[3])
                places = {corner["id"]: corner["place"] for corner in frame["board"]["corners"]}
                for i in range(columns - 2):
                    self.assertLess(abs(math.dist(places[i], places[i + 1]) / DPI * 25.4 - square), 0.05)

    def test_boards_in_metres(self):
        page, = self.pages(self.print("--board", "grid:tag36h11:2x2:0.05:0.01", "--unit", "m"))
        self.expect_sizes(self.read(page, dictionary="tag36h11"), 50)

    def test_what_is_wrong(self):
        def run(*arguments):
            return self.run_program("print", *arguments)
        out = self.path("x.pdf")
        self.expect_error(run("-o", out), "--dict and --ids, or --board")
        self.expect_error(run("-o", out, "-d", "tag36h11", "--ids", "600"), "tag36h11 has no marker 600", "0 to 586")
        self.expect_error(run("-o", out, "-d", "tag36h11", "--ids", "3-1"), "'3-1' is no list of ids")
        self.expect_error(run("-o", out, "-d", "tag36h11", "--ids", "0", "--size", "300"), "too large for paper of 210 mm")
        self.expect_error(run("-o", out, "-d", "tag36h11", "--ids", "0", "--size", "-1"), "not positive")
        self.expect_error(run("-o", out, "-d", "tag36h11", "--ids", "0", "--paper", "B7"), "'B7' is no paper")
        self.expect_error(run("-o", self.path("x.doc"), "-d", "tag36h11", "--ids", "0"), ".pdf, .svg or .png")
        self.expect_error(run("-o", self.path("no/x.pdf"), "-d", "tag36h11", "--ids", "0"), "no/x.pdf: cannot be written")
        self.expect_error(run("-o", out, "--board", "charuco:DICT_5X5_100:6x8:0.028:0.02"), "--unit")
        self.expect_error(run("-o", out, "--board", "charuco:DICT_5X5_100:6x8:60:40"), "too large for paper")
