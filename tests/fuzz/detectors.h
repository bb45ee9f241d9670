#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include "expect.h"
#include "runmark/detector.h"

namespace runmark::fuzz {

/// Dictionaries of every kind of border and of several sizes; one of a few codes is quicker to make ready.
inline std::vector<Dictionary> dictionaries(FuzzedDataProvider& input, Pipeline pipeline) {
  static const std::array<std::vector<Dictionary>, 4> sets = [] {
    const auto load = [](const char* name, std::size_t codes) {
      Dictionary dictionary = *builtin_dictionary(name);
      if (dictionary.codes.size() > codes) dictionary.codes.resize(codes);
      return dictionary;
    };
    return std::array<std::vector<Dictionary>, 4>{{{load("DICT_6X6_50", 50)},
                                                   {load("DICT_4X4_50", 50), load("tag16h5", 30)},
                                                   {load("tagStandard41h12", 20)},
                                                   {load("tagCircle21h7", 38), load("DICT_7X7_50", 50)}}};
  }();
  const auto chosen = input.ConsumeIntegralInRange<std::size_t>(0, sets.size() - 1);
  if (pipeline == Pipeline::paper) return sets[0];
  return sets[pipeline == Pipeline::hardware ? chosen % 2 : chosen];
}

/// Options a detector takes, for frames of up to that size.
inline Options options(FuzzedDataProvider& input, int max_width, int max_height) {
  Options options;
  options.pipeline =
      input.PickValueInArray({Pipeline::standard, Pipeline::paper, Pipeline::hardware, Pipeline::standard});
  options.max_width = max_width;
  options.max_height = max_height;
  options.octaves = input.ConsumeIntegralInRange(0, 6);
  options.inverted = input.ConsumeBool();
  options.copy_rows = input.ConsumeBool();
  options.connectivity =
      input.PickValueInArray({Connectivity::standard, Connectivity::four, Connectivity::eight});
  const auto filter = input.ConsumeIntegral<std::uint8_t>();
  options.filter = filter > filter_all ? std::uint8_t{filter_standard} : filter;
  options.min_contrast = input.ConsumeIntegralInRange(1, 255);
  options.fixed_threshold = input.ConsumeIntegralInRange(0, 256);
  options.above_is_dark = input.ConsumeBool();
  options.corner_offset = input.ConsumeIntegralInRange(1, 255);
  options.min_marker_size = input.ConsumeIntegralInRange(0, 9) > 0
                                ? input.ConsumeIntegralInRange(4, 40)
                                : input.PickValueInArray({65535.0, 140000.0, 1e12, 1e300});
  options.max_marker_size =
      std::max(options.min_marker_size, input.PickValueInArray({1e300, 65535.0, 100.0, 8.0}));
  options.corrected_bits = input.ConsumeIntegralInRange(-1, 16);
  options.keep_rejected = input.ConsumeBool();
  options.min_margin = input.ConsumeBool() ? 0.0F : 0.05F;
  if (input.ConsumeBool()) {
    const auto side = [&] { return int{input.ConsumeIntegral<std::uint8_t>()}; };
    options.region = {side(), side(), side() + 1, side() + 1};
  }
  return options;
}

inline Detector detector(const Options& options, std::vector<Dictionary> dictionaries) {
  auto made = Detector::create(options, std::move(dictionaries));
  expect(static_cast<bool>(made), "these options are all within their ranges");
  return *std::move(made);
}

inline bool same(const Marker& a, const Marker& b) {
  bool equal = a.dictionary == b.dictionary && a.id == b.id && a.hamming == b.hamming &&
               a.inverted == b.inverted && a.row == b.row && a.margin == b.margin;
  for (std::size_t i = 0; i < 4; ++i) {
    equal = equal && a.corners[i].x == b.corners[i].x && a.corners[i].y == b.corners[i].y;
  }
  return equal;
}

inline void expect_same(std::span<const Marker> found, std::span<const Marker> wanted, const char* what) {
  expect(std::ranges::equal(found, wanted, same), what);
}

/// What holds for every frame, whatever is on it.
inline void expect_sound(const Detector& detector, std::span<const Marker> markers, int width, int height) {
  const FrameStats& stats = detector.stats();
  const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  // Every halving has a quarter of the pixels.
  expect(3 * stats.pixels <= 4 * pixels, "the work is bounded by the frame's size");
  expect(stats.crack_runs <= stats.pixels + 7ULL * static_cast<std::uint64_t>(height),
         "no row has more crack runs than pixels and one");
  expect(2 * stats.closed_chains <= stats.crack_runs, "a contour has two crack runs at least");
  expect(stats.quads <= stats.closed_chains, "a quadrilateral is a contour");
  for (const Marker& marker : markers) {
    expect(marker.id >= 0, "an id");
    expect(marker.margin >= 0 && marker.margin <= 0.5F, "a margin");
    expect(marker.hamming >= 0 && marker.hamming <= 16, "corrected bits");
    expect(marker.row >= 0 && marker.row < height, "a row of the frame");
    for (const Point& corner : marker.corners) {
      expect(corner.x > -width && corner.x < 2 * width && corner.y > -height && corner.y < 2 * height,
             "corners near the frame");
    }
  }
}

}  // namespace runmark::fuzz
