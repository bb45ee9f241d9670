#include "pattern/marker_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace runmark {
namespace {

int overhang_of(const Dictionary& dictionary) {
  int overhang = 0;
  for (const Cell cell : dictionary.cells) overhang = std::max({overhang, -cell.x, -cell.y});
  return overhang;
}

}  // namespace

MarkerReader::MarkerReader(const std::vector<Dictionary>& dictionaries, const ReaderLimits& limits)
    : limits_(limits) {
  for (const Dictionary& dictionary : dictionaries) {
    const int bits = limits.corrected_bits < 0 ? dictionary.corrected_bits : limits.corrected_bits;
    const auto same = std::find_if(layouts_.begin(), layouts_.end(), [&](const Layout& layout) {
      return layout.width == dictionary.width && layout.border == dictionary.border &&
             layout.cells == dictionary.cells;
    });
    Layout& layout =
        same != layouts_.end()
            ? *same
            : layouts_.emplace_back(
                  Layout{dictionary.width, dictionary.border, dictionary.cells, overhang_of(dictionary), {}});
    layout.books.push_back({&dictionary, CodeLookup(dictionary, bits)});
    most_cells_ = std::max(most_cells_, dictionary.width);
    const bool reversed = dictionary.border == Border::reversed;
    reads_dark_ = reads_dark_ || !reversed || limits.inverted;
    reads_light_ = reads_light_ || reversed || limits.inverted;
  }
}

std::size_t MarkerReader::memory() const {
  std::size_t bytes = sizeof(*this);
  for (const Layout& layout : layouts_) {
    for (const Book& book : layout.books) bytes += book.lookup.memory();
  }
  return bytes;
}

int MarkerReader::lowest_row(const Quad& quad) const {
  double lowest = -1;
  for (const Layout& layout : layouts_) {
    if (layout.overhang == 0 || !fits(layout, quad)) continue;
    const Homography place(quad.corners, layout.width);
    const double low = -layout.overhang;
    const double high = layout.width + layout.overhang;
    for (const Point p : {place(low, low), place(high, low), place(high, high), place(low, high)}) {
      lowest = std::max(lowest, p.y);
    }
  }
  return static_cast<int>(std::min(std::ceil(lowest), 65535.0));
}

MarkerReader::Reading MarkerReader::sample(const GreyFrame& frame, const Homography& place,
                                           const LightModel& light, const Layout& layout) {
  // A few points of each cell against noise, well away from its neighbours.
  static constexpr std::array<std::array<double, 2>, 5> inner{
      {{0.5, 0.5}, {0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}};
  Reading reading;
  double sum = 0;
  for (const Cell cell : layout.cells) {
    double value = 0;
    for (const auto& [u, v] : inner) {
      const double cu = cell.x + u;
      const double cv = cell.y + v;
      const Point p = place(cu, cv);
      const double grey = static_cast<double>(frame.sample(static_cast<float>(p.x), static_cast<float>(p.y)));
      const double inside = light.inside.at(cu, cv);
      value += (grey - inside) / (light.outside.at(cu, cv) - inside);
    }
    value /= static_cast<double>(inner.size());
    reading.code = (reading.code << 1) | (value > 0.5 ? 1U : 0U);
    sum += std::min(std::fabs(value - 0.5), 0.5);
  }
  reading.margin = static_cast<float>(sum / static_cast<double>(layout.cells.size()));
  return reading;
}

std::optional<Marker> MarkerReader::read(const GreyFrame& frame, const Quad& quad) const {
  std::optional<Marker> best;
  for (const Layout& layout : layouts_) {
    if (!fits(layout, quad)) continue;
    const bool reversed = layout.border == Border::reversed;
    const Homography place(quad.corners, layout.width);
    const std::optional<LightModel> light = fit_light(frame, place, layout.width, quad.light_inside);
    if (!light) continue;
    Reading reading = sample(frame, place, *light, layout);
    if (reading.margin < limits_.min_margin) continue;
    // The model's 1 is the ring outside: white round a black border, black round a reversed one.
    if (reversed) {
      const int bits = static_cast<int>(layout.cells.size());
      const std::uint64_t all = bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
      reading.code ^= all;
    }
    for (const Book& book : layout.books) {
      const auto match = book.lookup.find(reading.code);
      if (!match || (best && match->hamming >= best->hamming)) continue;
      Marker marker;
      marker.dictionary = book.dictionary->name;
      marker.id = match->id;
      marker.hamming = match->hamming;
      marker.margin = reading.margin;
      marker.inverted = quad.light_inside != reversed;
      for (std::size_t i = 0; i < 4; ++i) {
        marker.corners[i] = quad.corners[(i + static_cast<std::size_t>(match->rotation)) % 4];
      }
      best = marker;
    }
  }
  return best;
}

}  // namespace runmark
