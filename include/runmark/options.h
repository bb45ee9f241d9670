#pragma once

#include <cstdint>

namespace runmark {

/// How the five cores are put together.
enum class Pipeline : std::uint8_t {
  paper,     ///< the seed as published: fixed threshold, Fig. 2 filter, corner state machine, 8x8 grid
  hardware,  ///< what the FPGA core computes beyond the paper, in integers only
  standard,  ///< the best software; `--pipeline default`
};

/// Part of the frame, in pixels. Width or height 0: the whole frame.
struct Region {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Which dark pixels touch: eight also counts those that meet at a corner only.
enum class Connectivity : std::uint8_t {
  standard,  ///< the pipeline's own: eight in the paper's, four in the others
  four,
  eight,
};

/// The cases of the paper's Fig. 2 as bits of Options::filter.
enum FilterCase : std::uint8_t {
  filter_none = 0,
  filter_hole_with_diagonals = 1,  ///< (a) a one-pixel hole with diagonal contacts
  filter_diagonal_object = 2,      ///< (b) object pixels that touch at a corner only
  filter_diagonal_hole = 4,        ///< (c) hole pixels that touch at a corner only
  filter_lone_object = 8,          ///< (d) an object pixel with no neighbour
  filter_lone_hole = 16,           ///< (e) a hole pixel with no neighbour
  filter_empty_column = 32,        ///< (f) an empty column one pixel wide
  filter_all = 63,
  filter_standard = 255,  ///< the pipeline's own: all in the paper's, none in the others
};

/// Tunables of a detector. The defaults suit most pictures: change what the comment gives a reason for.
struct Options {
  Pipeline pipeline = Pipeline::standard;

  /// The largest frame; memory is set aside for it when the detector is made, and never after.
  int max_width = 1920;
  int max_height = 1080;

  /// Look only inside this part of the frame.
  Region region{};

  /// Sizes of the black square to report, in pixels: the square root of its area in the image.
  /// Raise the lower one to save time and to be rid of far markers.
  double min_marker_size = 8;
  double max_marker_size = 65535;

  /// Also look for white-on-black markers.
  bool inverted = false;

  /// Corrected bits for every dictionary, or -1 for each dictionary's own safe number.
  int corrected_bits = -1;

  /// Markers whose margin (see Marker::margin) is less are not reported.
  float min_margin = 0.05F;

  /// Cases of the paper's Fig. 2 to mend before contours are followed. Fewer specks, less work; the
  /// contour core needs none of them mended.
  std::uint8_t filter = filter_standard;
  /// Four keeps markers apart that touch at a corner, eight keeps thin slanted borders whole.
  Connectivity connectivity = Connectivity::standard;

  /// Light-following threshold: the least difference of grey levels between black and white in a
  /// neighbourhood. It rises by itself with the noise of the rows already seen. Default pipeline: in the
  /// dark, where white is twice as light as black, two fifths of it are enough.
  int min_contrast = 20;

  /// Paper pipeline: grey levels below it are dark.
  int fixed_threshold = 128;
  /// Paper pipeline: levels at or above fixed_threshold are dark instead (as the paper prints it).
  bool above_is_dark = false;
  /// Paper pipeline: offset across the direction of travel that makes a corner, in pixels.
  int corner_offset = 5;

  /// How often the rows are halved to find large and blurred markers; 0 looks at full size only.
  int octaves = 2;

  /// Row streaming: copy the grey rows into the detector's own store, so that the caller's memory need
  /// not outlive push_rows. Costs max_width * max_height bytes.
  bool copy_rows = false;

  /// Also keep the squares that turned out to be no marker, see Detector::rejected: to find out why a marker
  /// is missed. Up to 1,024 a frame.
  bool keep_rejected = false;
};

}  // namespace runmark
