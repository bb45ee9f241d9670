#include "pattern/marker_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dictionary/code_distance.h"
#include "pattern/unblur.h"

namespace runmark {
namespace {

constexpr int most_grid = 16;  // cells across the widest marker with its neighbours

int overhang_of(const Dictionary& dictionary) {
  int overhang = 0;
  for (const Cell cell : dictionary.cells) overhang = std::max({overhang, -cell.x, -cell.y});
  return overhang;
}

double distance(Point a, Point b) { return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)); }

// Points well away from a cell's neighbours, against noise.
constexpr std::array<std::array<double, 2>, 5> inner_points{
    {{0.5, 0.5}, {0.3, 0.3}, {0.7, 0.3}, {0.7, 0.7}, {0.3, 0.7}}};
constexpr std::size_t most_samples = 64 * inner_points.size();  // a code has at most 64 bits
static_assert(most_samples % CellPoints::group == 0);

/// The share of a cell's light that a Gaussian blur of that standard deviation, in cells, moves into the
/// next.
float spill(double blur) {
  constexpr double step = 0.15;
  constexpr std::array shares{0.0, 0.0004, 0.0478, 0.1328, 0.1961, 0.2297, 0.2415, 0.2405};
  const double place = std::min(blur / step, shares.size() - 1.001);
  const auto below = static_cast<std::size_t>(place);
  return static_cast<float>(shares[below] +
                            (place - static_cast<double>(below)) * (shares[below + 1] - shares[below]));
}

}  // namespace

MarkerReader::Layout::Layout(const Dictionary& dictionary)
    : width(dictionary.width),
      border(dictionary.border),
      cells(dictionary.cells),
      overhang(overhang_of(dictionary)),
      rings(dictionary.width) {
  for (const Cell cell : cells) {
    middles.add(cell.x + 0.5, cell.y + 0.5);
    for (const auto& [u, v] : inner_points) spread.add(cell.x + u, cell.y + v);
  }
  for (int y = 0; y < width; ++y) {
    for (int x = 0; x < width; ++x) square.add(x + 0.5, y + 0.5);
  }
}

bool MarkerReader::Layout::has(const Dictionary& dictionary) const {
  return width == dictionary.width && border == dictionary.border && cells == dictionary.cells;
}

MarkerReader::MarkerReader(const std::vector<Dictionary>& dictionaries, const ReaderLimits& limits)
    : limits_(limits) {
  for (const Dictionary& dictionary : dictionaries) {
    const int bits = limits.corrected_bits < 0 ? dictionary.corrected_bits : limits.corrected_bits;
    const auto same = std::find_if(layouts_.begin(), layouts_.end(),
                                   [&](const Layout& layout) { return layout.has(dictionary); });
    Layout& layout = same != layouts_.end() ? *same : layouts_.emplace_back(dictionary);
    const bool reversed = dictionary.border == Border::reversed;
    const std::uint64_t plain = reversed ? ~std::uint64_t{0} >> (64 - layout.cells.size()) : 0;
    layout.has_plain = layout.has_plain || std::find(dictionary.codes.begin(), dictionary.codes.end(),
                                                     plain) != dictionary.codes.end();
    layout.books.push_back({&dictionary, CodeLookup(dictionary, bits)});
    most_cells_ = std::max(most_cells_, dictionary.width);
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

bool MarkerReader::may_be_marker(const GreyFrame& frame, const Quad& quad) const {
  constexpr int one_in = 4;
  constexpr float least_light = 0.3F;  // of the lightest cell; seldom below 0.6 in markers of 8 px
  return std::any_of(layouts_.begin(), layouts_.end(), [&](const Layout& layout) {
    if (!fits(layout, quad)) return false;
    const Homography place(quad.corners, layout.width);
    const std::optional<LightModel> light = fit_light(frame, place, layout.rings, quad.light_inside, one_in);
    if (!light) return false;
    if (layout.has_plain) return true;
    std::array<float, most_samples> values;  // NOLINT(*-member-init): samples fill it
    sample_cells(frame, place, layout.middles, values.data());
    light->make_relative(layout.middles, values.data());
    return *std::max_element(values.data(), values.data() + layout.middles.size()) >= least_light;
  });
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
  // Small cells are read at their middle, larger ones at a few points.
  constexpr double small_cell = 5;  // pixels
  const double diagonal = distance(place(0, 0), place(layout.width, layout.width));
  const bool small = diagonal < 1.41 * small_cell * layout.width;
  const CellPoints& points = small ? layout.middles : layout.spread;
  const std::size_t of_each = small ? 1 : inner_points.size();
  std::array<float, most_samples> values;  // NOLINT(*-member-init): samples fill it
  sample_cells(frame, place, points, values.data());
  light.make_relative(points, values.data());

  // Values of the data cells among their neighbours: 0 like the ring inside the square, 1 like that outside.
  const int reach = layout.overhang + 1;
  std::array<float, most_grid * most_grid> grid{};
  const auto at = [&](int x, int y) -> float& {
    return grid[static_cast<std::size_t>((y + reach) * most_grid + x + reach)];
  };
  for (int y = -reach; y < layout.width + reach; ++y) {
    for (int x = -reach; x < layout.width + reach; ++x) {
      at(x, y) = x < 0 || y < 0 || x >= layout.width || y >= layout.width ? 1.0F : 0.0F;
    }
  }
  const float* sampled = values.data();
  for (const Cell cell : layout.cells) {
    float sum = 0;
    for (std::size_t k = 0; k < of_each; ++k) sum += *sampled++;
    at(cell.x, cell.y) = sum / static_cast<float>(of_each);
  }
  // Blur mixes each cell with its neighbours: what they took is given back.
  constexpr float sharpening = 0.3F;
  Reading reading;
  float sum = 0;
  for (const Cell cell : layout.cells) {
    const int x = cell.x;
    const int y = cell.y;
    const float value = at(x, y);
    const float neighbours = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1);
    const float sharp = value + sharpening * (4 * value - neighbours);
    reading.code = (reading.code << 1) | (sharp > 0.5F ? 1U : 0U);
    sum += std::min(std::fabs(sharp - 0.5F), 0.5F);
  }
  reading.margin = sum / static_cast<float>(layout.cells.size());
  return reading;
}

bool MarkerReader::look_up(const Reading& reading, const Quad& quad, const Layout& layout,
                           double most_accepted, Best& best) {
  const bool reversed = layout.border == Border::reversed;
  // The model's 1 is the ring outside: white round a black border, black round a reversed one.
  const std::size_t bits = layout.cells.size();
  const std::uint64_t code = reversed ? reading.code ^ (~std::uint64_t{0} >> (64 - bits)) : reading.code;
  bool found = false;
  for (const Book& book : layout.books) {
    const auto match = book.lookup.find(code);
    if (!match || accepted_share(bits, book.dictionary->codes.size(), match->hamming) > most_accepted)
      continue;
    found = true;
    const double chance = accepted_share(bits, 1, match->hamming);
    if (chance >= best.chance) continue;
    Marker marker;
    marker.dictionary = book.dictionary->name;
    marker.id = match->id;
    marker.hamming = match->hamming;
    marker.margin = reading.margin;
    marker.inverted = quad.light_inside != reversed;
    for (std::size_t i = 0; i < 4; ++i) {
      marker.corners[i] = quad.corners[(i + static_cast<std::size_t>(match->rotation)) % 4];
    }
    best = {marker, chance};
  }
  return found;
}

void MarkerReader::read_unblurred(const GreyFrame& frame, const Quad& quad, const Homography& place,
                                  const LightModel& light, const Layout& layout, Best& best) const {
  constexpr std::array blurs{0.45, 0.6, 0.75};   // standard deviation, of a cell
  constexpr double largest_cell = 6;             // pixels; blur of half a larger one is rare
  constexpr double most_accepted = 1 / 16384.0;  // of random readings: small codes would invent markers
  constexpr float least_margin = 0.25F;          // clear enough that no other cell would do
  const int width = layout.width;
  const double side = std::sqrt(area_of(quad.corners));
  if (layout.overhang > 0 || side > largest_cell * width) return;
  CellValues cells;
  cells.width = width;
  sample_cells(frame, place, layout.square, cells.values);
  light.make_relative(layout.square, cells.values);
  // A tilted marker's cells are shorter one way, and the same blur carries farther there.
  const Point left = place(0, width / 2.0);
  const Point right = place(width, width / 2.0);
  const Point top = place(width / 2.0, 0);
  const Point bottom = place(width / 2.0, width);
  const double across = distance(left, right) / side;
  const double down = distance(top, bottom) / side;
  for (const double blur : blurs) {
    const Unblurred clear = unblur(cells, layout.cells, spill(blur / across), spill(blur / down));
    const Reading reading{clear.code, clear.margin};
    if (reading.margin >= std::max(least_margin, limits_.min_margin) &&
        look_up(reading, quad, layout, most_accepted, best)) {
      return;
    }
  }
}

std::optional<Marker> MarkerReader::read(const GreyFrame& frame, const Quad& quad) const {
  Best best;
  for (const Layout& layout : layouts_) {
    if (!fits(layout, quad)) continue;
    const Homography place(quad.corners, layout.width);
    // Small codes are read into much that is no marker: their border must be the better.
    const int one_in = layout.cells.size() <= 16 ? 13 : 10;
    const std::optional<LightModel> light = fit_light(frame, place, layout.rings, quad.light_inside, one_in);
    if (!light) continue;
    const Reading reading = sample(frame, place, *light, layout);
    if (reading.margin >= limits_.min_margin && look_up(reading, quad, layout, 1, best)) continue;
    read_unblurred(frame, quad, place, *light, layout, best);
  }
  return best.marker;
}

}  // namespace runmark
