#pragma once

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "cores.h"
#include "marker_scene.h"
#include "noise_image.h"
#include "pipeline/contour_scan.h"

namespace runmark::hls_form {

/// Everything a chain is, by value: the places of its records from head to tail.
using Chain = std::vector<std::pair<int, int>>;

inline Settings settings_of(const PixelImage& image) {
  Settings settings;
  settings.width = image.width();
  settings.height = image.height();
  settings.holes = true;
  return settings;
}

inline void send(const PixelImage& image, BitStream& dark) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) dark.write(image.dark(x, y) ? 1 : 0);
  }
}

/// The plain cores on the same image, with the same number of records.
template <class Sink>
void plain_chains(const PixelImage& image, const Settings& settings, Sink&& sink) {
  ChainLimits limits;
  limits.max_turns = settings.max_turns;
  limits.max_records = 1U << 20;
  limits.min_height = static_cast<std::uint16_t>(settings.min_height);
  limits.holes = settings.holes;
  const auto connectivity = settings.eight ? Connectivity::eight : Connectivity::four;
  ContourScan scan(image.width(), {{settings.cases, connectivity}, limits, max_records});
  scan.begin_frame(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    BitWord* row = scan.next_row();
    std::fill_n(row, bit_words(image.width()), BitWord{0});
    for (int x = 0; x < image.width(); ++x) {
      if (image.dark(x, y)) set_bit(row, x, true);
    }
    scan.advance(sink);
  }
}

inline Chain chain_of(const ClosedChain& closed) {
  Chain chain;
  closed.runs([&](int, int to, int line) { chain.emplace_back(to, line); });
  return chain;
}

/// Small noise with every setting at random.
inline std::pair<PixelImage, Settings> random_frame(int number, std::mt19937_64& random) {
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const int most = number % 10 == 0 ? 60 : 16;
  const PixelImage image =
      noise_image(1 + below(most), 1 + below(most), 20 + below(61), 1 + below(4), random());
  Settings settings = settings_of(image);
  settings.cases = static_cast<std::uint8_t>(number % 3 == 0 ? 63 : 1 + below(63));
  settings.eight = below(2) != 0;
  settings.holes = below(4) != 0;
  settings.max_turns = static_cast<unsigned>(below(3) == 0 ? below(8) : 30);
  settings.min_height = static_cast<unsigned>(below(3) == 0 ? below(5) : 0);
  return {image, settings};
}

}  // namespace runmark::hls_form
