#include "bench/speed/noise_sweep.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "bench/speed/median_time.h"
#include "runmark/detector.h"

namespace runmark::bench {
namespace {

std::vector<std::uint8_t> noise(int width, int height, double density, int granularity) {
  std::mt19937 random(17);
  std::bernoulli_distribution dark(density);
  std::vector<std::uint8_t> grey;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; y % granularity == 0 && x < width; x += granularity) {
      const std::uint8_t value = dark(random) ? 0 : 255;
      std::fill(row.begin() + x, row.begin() + std::min(x + granularity, width), value);
    }
    grey.insert(grey.end(), row.begin(), row.end());
  }
  return grey;
}

}  // namespace

double NoiseSweep::worst() const {
  return std::ranges::max_element(cells, {}, &NoiseCell::milliseconds)->milliseconds;
}

NoiseSweep sweep_noise(int width, int height, int rounds) {
  auto dictionary = builtin_dictionary("tag36h11");
  if (!dictionary) throw std::runtime_error(dictionary.error());
  auto detector = Detector::create({.max_width = width, .max_height = height}, {*std::move(dictionary)});
  if (!detector) throw std::runtime_error(detector.error());
  NoiseSweep result;
  result.memory = detector->memory();
  for (const int granularity : {1, 2, 4, 8, 16}) {
    for (int tenth = 0; tenth <= 10; ++tenth) {
      const std::vector<std::uint8_t> grey = noise(width, height, tenth / 10.0, granularity);
      const auto view = ImageView::grey(grey.data(), width, height, width);
      const double time = median_time(rounds, [&] { static_cast<void>(detector->detect(view)); });
      const FrameStats& stats = detector->stats();
      result.cells.push_back(
          {tenth / 10.0, granularity, time, stats.crack_runs, stats.records_peak, stats.dropped_chains});
    }
  }
  return result;
}

}  // namespace runmark::bench
