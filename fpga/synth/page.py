"""The figures of docs/hardware.md as tables."""
import latency

PAPER = {"threshold": (2394, 1959), "preprocess": (5141, 2354), "contour": (7930, 3358), "corner": (2074, 1161),
         "pattern": (115, 14), "total": (17654, 8846)}  # LUT, FF: the paper's Table 1
PAPER_MATCH = {1: 700, 4: 2800}  # clocks for one orientation, for four
SIZES = [(640, 480), (1280, 720), (1920, 1080), (3840, 2160)]


def rows(head, lines):
    out = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    out += ["| " + " | ".join(str(cell) for cell in line) + " |" for line in lines]
    return "\n".join(out)


def number(value):
    return f"{value:,}"


def nanoseconds(figure):
    return f"{figure['path_ps'] / 1000:.2f} ns"


def sizes(figures):
    lines = []
    for f in figures:
        lut, ff = (number(n) for n in PAPER[f["core"]]) if f["core"] in PAPER else ("-", "-")
        lines.append([f["core"], number(f["lut"]), number(f["ff"]), f["dsp"], number(f["ram_bits"]),
                      number(f["list_bits"]), number(f["line_bits"]), f["ramb18"], nanoseconds(f), lut, ff])
    return rows(["core", "LUT", "FF", "DSP", "RAM bits", "of these lists", "line store", "RAMB18", "slowest path",
                 "paper LUT", "paper FF"], lines)


def placed(figures):
    lines = []
    for f in figures:
        lines.append([f["core"], f["cells"], f["frame"], f["blocks"], f"{f['mhz']:.0f} MHz"] if "cells" in f else
                     [f["core"], "does not fit", "", "", ""])
    return rows(["core", "logic cells", "of these the frame's", "4 Kbit blocks", "clock after routing"], lines)


def rates():
    """A pixel a clock and the rows of flushing, beside the paper's equation 6 at its own load."""
    lines = []
    for width, height in SIZES:
        clocks = latency.ours(width * height, width)
        hardware = latency.ours(width * height, width, rows=latency.HARDWARE_ROWS)
        paper = latency.paper(width * height, 2970, 70)
        lines.append([f"{width}x{height}", number(clocks), f"{1e8 / clocks:.1f}", f"{1.5e8 / clocks:.1f}",
                      number(hardware), f"{1e8 / hardware:.1f}", f"{1.5e8 / hardware:.1f}", f"{1e8 / paper:.1f}"])
    return rows(["frame", "clocks, paper profile", "frames/s at 100 MHz", "at 150 MHz", "clocks, hardware profile",
                 "frames/s at 100 MHz", "at 150 MHz", "the paper's equation 6 at 100 MHz"], lines)


def targets(simulation):
    lines = []
    for profile, name, kind in (("paper", "vga ", "paper: rendered scenes, set `vga`"),
                                ("paper", "upright ", "paper: frames of upright markers"),
                                ("hardware", "vga ", "hardware: rendered scenes, set `vga`")):
        of = [s for s in simulation[profile]["scenes"] if s["name"].startswith(name)]
        thin = [s for s in of if s["events_per_100_pixels"] < 10]
        lines.append([
            kind, len(of), f"{sum(s['markers'] for s in of) - sum(s['missed'] for s in of)} of "
            f"{sum(s['markers'] for s in of)}",
            f"{sum(s['quads_of_hardware'] for s in of):.0f} of {sum(s['quads'] for s in of)}",
            f"{max(s['record_peak_unlimited'] for s in of)}",
            sum(s["dropped"] > 0 for s in of),
            f"{max(s['cycles_per_pixel'] for s in thin):.4f} ({len(thin)} scenes)",
            f"{max(s['cycles_per_pixel'] for s in of):.4f}"])
    return rows(["scenes", "number", "markers of those found without a limit", "candidates", "records in use at most, "
                 "no limit", "scenes in which a chain was dropped", "cycles a pixel at most, below 10 events in 100 "
                 "pixels", "in all"], lines)


def waits(simulation):
    lines = []
    for profile in ("paper", "hardware"):
        found = [s for s in simulation[profile]["scenes"] if s["latest_report"]]
        longest = max(found, key=lambda s: s["latest_report"])
        middle = sorted(s["latest_report"] for s in found)[len(found) // 2]
        lines.append([profile, len(found)] + [f"{number(clocks)} clocks, {clocks / longest['width']:.1f} lines, "
                                              f"{clocks / 100:.0f} us" for clocks in (middle, longest["latest_report"])])
    return rows(["profile", "frames with markers", "median frame", "worst frame"], lines)


def predicted(simulation):
    lines = []
    for profile, rows_behind in (("paper", latency.PAPER_ROWS), ("hardware", latency.HARDWARE_ROWS)):
        vga = sorted((s for s in simulation[profile]["scenes"] if s["name"].startswith("vga ")), key=lambda s: s["events"])
        for s in (vga[0], vga[len(vga) // 2], vga[-1], simulation[profile]["load"]):
            paper = latency.paper(s["pixels"], s["runs"], s["segments"])
            ours = latency.ours(s["pixels"], s["width"], s["contour_clocks"], rows_behind)
            lines.append([profile, s["name"], number(s["runs"]), number(s["segments"]), f"{paper / 1e5:.2f} ms",
                          f"{ours / 1e5:.3f} ms", f"{s['cycles'] / 1e5:.3f} ms"])
    return rows(["profile", "frame", "run lengths", "segments", "the paper's formula", "our formula", "measured"], lines)


def load(simulation, total):
    s = simulation["paper"]["load"]
    paper = latency.paper(s["pixels"], s["runs"], s["segments"])
    return rows(["", "paper", "here"], [
        ["run lengths, segments in the frame", "2,970, 70", f"{number(s['runs'])}, {s['segments']}"],
        ["of these in use at once", "all", f"{s['record_peak']} records, {s['end_peak']} ends"],
        ["list RAM", "62 Kbit", f"{total['list_bits'] / 1024:.1f} Kbit ({number(total['list_bits'])} bits)"],
        ["a frame at 100 MHz", f"18.5 ms (by the formula {paper / 1e5:.2f})", f"{s['cycles'] / 1e5:.2f} ms"]])


def matches(simulation):
    lines = [["one template, the paper", f"about {PAPER_MATCH[1]}; {number(PAPER_MATCH[4])} with rotations"]]
    lines += [[f"{m['codes']} code{'s' if m['codes'] > 1 else ''}, all rotations, here", number(m["clocks"])]
              for m in simulation["match"]]
    return rows(["a match", "clocks"], lines)


def growth(profile, grown, simulation):
    peaks = {(g["width"], g["height"]): g for g in simulation[profile]["growth"]}
    lines = []
    for g in grown:
        peak = peaks[tuple(g["size"])]
        lines.append(["{}x{}".format(*g["size"]), number(g["lut"]), number(g["ff"]), number(g["ram_bits"]),
                      number(g["list_bits"]), number(g["line_bits"]), nanoseconds(g), number(g["records"]),
                      f"{number(peak['record_peak'])} ({peak['scenes']} scenes)", number(peak["most_runs"])])
    return rows([f"{profile} profile", "LUT", "FF", "RAM bits", "lists", "line store", "slowest path", "records",
                 "records in use at most, rendered scenes, no limit", "crack runs at most"], lines)


def stripes(simulation):
    lines = []
    for profile, s in ((profile, s) for profile in ("paper", "hardware") for s in simulation[profile]["stripes"]):
        period = int(s["name"].split()[-1])
        lines.append([profile, f"N/{period // 2}" if period % 2 == 0 else f"2N/{period}", number(s["runs"]),
                      f"{s['cycles_per_pixel']:.3f}", number(s["record_peak_unlimited"]), s["record_peak"],
                      number(s["dropped"])])
    return rows(["profile", "links a row", "run lengths in the frame", "cycles a pixel", "records for all", "records there are",
                 "clocks in which a chain was given up"], lines)


def of_synthesis(figures, yosys):
    return {"figures": sizes(figures) + f"\n\nyosys {yosys}, `synth_xilinx -family xc7`, before placement.",
            "rates": rates()}


def of_the_rest(figures, places, grown, simulation):
    """`grown` has a list of figures for each profile."""
    total = next(f for f in figures if f["core"] == "total")
    return {"placed": placed(places), "targets": targets(simulation), "waits": waits(simulation),
            "predicted": predicted(simulation), "load": load(simulation, total), "matches": matches(simulation),
            "growth": "\n\n".join(growth(profile, grown[profile], simulation) for profile in ("paper", "hardware")), "stripes": stripes(simulation)}


def write(path, blocks):
    """Puts each block between its two marks."""
    with open(path) as file:
        text = file.read()
    for name, block in blocks.items():
        begin, end = f"<!-- {name} -->", f"<!-- end of {name} -->"
        if text.find(begin) < 0 or text.find(end) < text.find(begin):
            raise ValueError(f"{path}: no {begin} and {end}")
        text = text[:text.index(begin)] + f"{begin}\n\n{block}\n\n" + text[text.index(end):]
    with open(path, "w") as file:
        file.write(text)
