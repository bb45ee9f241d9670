#!/usr/bin/env python3
"""How long a frame takes: the paper's formula (its equation 6) and ours.

  fpga/synth/latency.py --size 640x480 --runs 2970 --segments 70 [--clock 100] [--pattern 2800]

  paper: pixels * 6 + max((segments + run lengths) * 2, pattern)
  ours:  max(pixels + rows x width + 21, contour): what comes out runs rows behind, one in the paper profile (its
         filter), eight in the hardware profile (its tiles), and contour is what the events take
         (1 clock for a straight crack, 3 for a shift, 4 for a start, 6 for a closing run, 10 for another join)
"""
import argparse

PAPER_ROWS, HARDWARE_ROWS = 1, 8  # the last ones follow when the frame is in
PIPELINE = 21  # clocks from the last pixel of the flushed row to the end of the frame, nothing left to be done


def paper(pixels, runs, segments, pattern=2800):
    return pixels * 6 + max((segments + runs) * 2, pattern)


def ours(pixels, width, contour=0, rows=PAPER_ROWS):
    return max(pixels + rows * width + PIPELINE, contour)


def contour_at_most(runs, segments, straights):
    """Of a frame of which no more is known: every start has its join, and no join closes a chain."""
    return straights + 3 * (runs - 2 * segments) + (4 + 10) * segments


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--size", default="640x480", metavar="WIDTHxHEIGHT")
    parser.add_argument("--runs", type=int, default=2970, help="crack run lengths in the frame")
    parser.add_argument("--segments", type=int, default=70, help="starts of chains in the frame")
    parser.add_argument("--straights", type=int, default=0, help="straight cracks in the frame (ours only)")
    parser.add_argument("--pattern", type=int, default=2800, help="clocks of the paper's pattern core")
    parser.add_argument("--clock", type=float, default=100, help="MHz")
    args = parser.parse_args()
    try:
        width, height = (int(n) for n in args.size.split("x"))
    except ValueError:
        parser.error(f"--size {args.size}: not WIDTHxHEIGHT")
    if width < 1 or height < 1 or args.clock <= 0:
        parser.error("sizes and clock must be positive")
    pixels = width * height
    contour = contour_at_most(args.runs, args.segments, args.straights)
    for name, clocks in (("paper", paper(pixels, args.runs, args.segments, args.pattern)),
                         ("ours", ours(pixels, width, contour)),
                         ("ours, hardware profile", ours(pixels, width, contour, HARDWARE_ROWS))):
        print(f"{name}: {clocks} clocks, {clocks / args.clock / 1000:.2f} ms, "
              f"{args.clock * 1e6 / clocks:.1f} frames/s at {args.clock:g} MHz")


if __name__ == "__main__":
    main()
