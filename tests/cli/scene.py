"""Scenes with known markers, and the files the tests put them into; the standard library only."""

import os
import pathlib
import struct
import zlib

SOURCE = pathlib.Path(__file__).resolve().parents[2]


def codes(dictionary):
    """The cells of each code of a dictionary whose codes are square, as rows of 0 and 1."""
    lines = (SOURCE / "data" / "dictionaries" / f"{dictionary}.codes").read_text().splitlines()
    lines = [line for line in lines if line and not line.startswith("#")]
    side = int(lines[0].split()[0])
    digits = -(-side * side // 4)
    numbers = [int(line, 16) for line in lines[1:] if len(line) == digits and set(line) <= set("0123456789abcdef")]
    bits = [f"{number:0{side * side}b}" for number in numbers]
    return [[[int(bit) for bit in row[y * side:(y + 1) * side]] for y in range(side)] for row in bits]


class Scene:
    """A light grey page with upright markers at whole pixels; rows of 8-bit grey."""

    def __init__(self, width=320, height=240, white=220, black=30):
        self.width, self.height, self.white, self.black = width, height, white, black
        self.rows = [bytearray([white] * width) for _ in range(height)]
        self.markers = []  # (id, the four corners)

    def add(self, dictionary, number, x, y, cell):
        """Puts a marker with its top-left pixel at (x, y); each cell is `cell` pixels wide."""
        code = codes(dictionary)[number]
        side = len(code) + 2
        for row in range(side):
            for column in range(side):
                inside = 0 < row < side - 1 and 0 < column < side - 1
                bit = code[row - 1][column - 1] if inside else 0
                for line in self.rows[y + row * cell:y + (row + 1) * cell]:
                    line[x + column * cell:x + (column + 1) * cell] = \
                        bytes([self.white if bit else self.black] * cell)
        left, top, right, bottom = x - 0.5, y - 0.5, x + side * cell - 0.5, y + side * cell - 0.5
        self.markers.append((number, [[left, top], [right, top], [right, bottom], [left, bottom]]))
        return self

    def grey(self):
        return b"".join(bytes(row) for row in self.rows)

    def rgb(self):
        return bytes(value for grey in self.grey() for value in (grey, grey, grey))


def one_marker(x=100, y=60, **keywords):
    """DICT_4X4_50, id 7, 96 pixels wide."""
    return Scene(**keywords).add("DICT_4X4_1000", 7, x, y, 16)


def write_pgm(path, scene):
    pathlib.Path(path).write_bytes(b"P5 %d %d 255\n" % (scene.width, scene.height) + scene.grey())


def write_pgm16(path, scene):
    samples = b"".join(struct.pack(">H", value * 257) for value in scene.grey())
    pathlib.Path(path).write_bytes(b"P5 %d %d 65535\n" % (scene.width, scene.height) + samples)


def write_ppm(path, scene):
    pathlib.Path(path).write_bytes(b"P6 %d %d 255\n" % (scene.width, scene.height) + scene.rgb())


def write_pbm(path, scene):
    """One bit a pixel, 1 is black."""
    pathlib.Path(path).write_bytes(b"P4 %d %d\n" % (scene.width, scene.height) + packed_bits(scene, dark=1))


def packed_bits(scene, dark):
    data = bytearray()
    for row in scene.rows:
        for x in range(0, scene.width, 8):
            byte = 0
            for bit, value in enumerate(row[x:x + 8]):
                byte |= (dark if value < 128 else 1 - dark) << (7 - bit)
            data.append(byte)
    return bytes(data)


def write_bmp(path, scene):
    padding = bytes(-scene.width * 3 % 4)
    rows = b"".join(bytes(v for grey in row for v in (grey, grey, grey)) + padding for row in reversed(scene.rows))
    header = struct.pack("<2sIHHI", b"BM", 54 + len(rows), 0, 0, 54)
    header += struct.pack("<IiiHHIIiiII", 40, scene.width, scene.height, 1, 24, 0, len(rows), 2835, 2835, 0, 0)
    pathlib.Path(path).write_bytes(header + rows)


def png_bytes(width, height, depth, colour, rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def write_png(path, scene, kind="grey"):
    """kind: grey, rgb, grey16, bit (one bit a pixel), rgba or grey_alpha (what is light is transparent
    black), palette-free all of them."""
    def alpha(value):
        return 255 if value < 128 else 0
    rows = {
        "grey": (8, 0, lambda row: bytes(row)),
        "rgb": (8, 2, lambda row: bytes(v for g in row for v in (g, g, g))),
        "grey16": (16, 0, lambda row: b"".join(struct.pack(">H", g * 257) for g in row)),
        "rgba": (8, 6, lambda row: bytes(v for g in row for v in (0, 0, 0, alpha(g)))),
        "grey_alpha": (8, 4, lambda row: bytes(v for g in row for v in (0, alpha(g)))),
    }
    if kind == "bit":
        bits, stride = packed_bits(scene, dark=0), (scene.width + 7) // 8
        lines = [bits[y * stride:(y + 1) * stride] for y in range(scene.height)]
        data = png_bytes(scene.width, scene.height, 1, 0, lines)
    else:
        depth, colour, convert = rows[kind]
        data = png_bytes(scene.width, scene.height, depth, colour, [convert(row) for row in scene.rows])
    pathlib.Path(path).write_bytes(data)


def y4m_header(scene, colour):
    space = f" C{colour}" if colour else ""
    return f"YUV4MPEG2 W{scene.width} H{scene.height} F30:1 Ip A1:1{space}\n".encode()


def y4m_frame(scene, colour):
    width, height = scene.width, scene.height
    half, quarter, tall = (width + 1) // 2, (width + 3) // 4, (height + 1) // 2
    chroma = {"mono": 0, "444": 2 * width * height, "444alpha": 3 * width * height, "422": 2 * half * height,
              "411": 2 * quarter * height}.get(colour, 2 * half * tall)
    return b"FRAME\n" + scene.grey() + bytes([128]) * chroma


def y4m_bytes(scenes, colour="420jpeg"):
    return y4m_header(scenes[0], colour) + b"".join(y4m_frame(scene, colour) for scene in scenes)


def moving_marker(frames, **keywords):
    """The marker goes two pixels to the right from frame to frame."""
    return [one_marker(x=40 + 2 * i, **keywords) for i in range(frames)]
