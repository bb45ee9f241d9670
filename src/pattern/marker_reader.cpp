#include "pattern/marker_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dictionary/code_distance.h"
#include "pattern/cell_reading.h"
#include "pattern/pattern_fit.h"
#include "pattern/unblur.h"

namespace runmark {
namespace {

// Of random readings, for codes that are to be trusted less than others.
constexpr double seldom = 1 / 16384.0;
constexpr double hardly_ever = 1 / 262144.0;

double distance(Point a, Point b) { return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)); }

}  // namespace

MarkerReader::MarkerReader(const std::vector<Dictionary>& dictionaries, const ReaderLimits& limits)
    : limits_(limits) {
  for (const Dictionary& dictionary : dictionaries) {
    const int bits = limits.corrected_bits < 0 ? dictionary.corrected_bits : limits.corrected_bits;
    const auto same = std::find_if(groups_.begin(), groups_.end(),
                                   [&](const Group& group) { return group.layout.is_of(dictionary); });
    Group& group = same != groups_.end() ? *same : groups_.emplace_back(Group{MarkerLayout(dictionary), {}});
    const bool reversed = group.layout.is_reversed();
    const std::uint64_t plain = reversed ? ~std::uint64_t{0} >> (64 - dictionary.cells.size()) : 0;
    const auto& codes = dictionary.codes;
    group.has_plain = group.has_plain || std::find(codes.begin(), codes.end(), plain) != codes.end();
    group.books.push_back({&dictionary, CodeLookup(dictionary, bits)});
    most_cells_ = std::max(most_cells_, dictionary.width);
    reads_dark_ = reads_dark_ || !reversed || limits.inverted;
    reads_light_ = reads_light_ || reversed || limits.inverted;
  }
}

std::size_t MarkerReader::memory() const {
  std::size_t bytes = sizeof(*this);
  for (const Group& group : groups_) {
    bytes += sizeof(group) + group.layout.memory();
    for (const Book& book : group.books) bytes += book.lookup.memory();
  }
  return bytes;
}

bool MarkerReader::may_be_marker(const GreyFrame& frame, const Quad& quad) const {
  constexpr int one_in = 4;
  constexpr float least_light = 0.3F;  // of the lightest cell; seldom below 0.6 in markers of 8 px
  return std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    const MarkerLayout& layout = group.layout;
    if (!fits(layout, quad)) return false;
    const Homography place(quad.corners, layout.width);
    const std::optional<LightModel> light = fit_light(frame, place, layout.rings, quad.light_inside, one_in);
    if (!light) return false;
    if (group.has_plain) return true;
    return lightest_cell(frame, place, *light, layout) >= least_light;
  });
}

int MarkerReader::lowest_row(const Quad& quad) const {
  double lowest = -1;
  for (const Group& group : groups_) {
    const MarkerLayout& layout = group.layout;
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

bool MarkerReader::look_up(const CellReading& reading, const Quad& quad, const Group& group,
                           double most_accepted, Best& best) {
  // Text is full of squares with tiny cells, and wrong bits make one of them a code.
  constexpr double tiny_cell = 1.5;  // pixels
  const MarkerLayout& layout = group.layout;
  const bool reversed = layout.is_reversed();
  const double width = tiny_cell * layout.width;
  const bool tiny = area_of(quad.corners) < width * width;
  // The model's 1 is the ring outside: white round a black border, black round a reversed one.
  const std::size_t bits = layout.cells.size();
  const std::uint64_t code = reversed ? reading.code ^ (~std::uint64_t{0} >> (64 - bits)) : reading.code;
  bool found = false;
  for (const Book& book : group.books) {
    const auto match = book.lookup.find(code);
    if (!match) continue;
    const double accepted = accepted_share(bits, book.dictionary->codes.size(), match->hamming);
    if (accepted > (tiny && match->hamming > 0 ? hardly_ever : most_accepted)) continue;
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
    best = {marker, chance, &layout, book.dictionary->codes[static_cast<std::size_t>(match->id)]};
  }
  return found;
}

void MarkerReader::read_unblurred(const GreyFrame& frame, const Quad& quad, const Homography& place,
                                  const LightModel& light, const Group& group, Best& best) const {
  const MarkerLayout& layout = group.layout;
  constexpr std::array blurs{0.45, 0.6, 0.75};  // standard deviation, of a cell
  constexpr double largest_cell = 6;            // pixels; blur of half a larger one is rare
  constexpr double least_blur = 0.35;           // cells, as the edges show it; sharper cells read as they are
  constexpr float least_margin = 0.25F;         // clear enough that no other cell would do
  const int width = layout.width;
  const double side = std::sqrt(area_of(quad.corners));
  if (layout.overhang > 0 || side > largest_cell * width || quad.blur * width < least_blur * side) return;
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
    const CellReading reading{clear.code, clear.margin};
    if (reading.margin >= std::max(least_margin, limits_.min_margin) &&
        look_up(reading, quad, group, seldom, best)) {
      return;
    }
  }
}

bool MarkerReader::confirm(const GreyFrame& frame, double blur, const Best& best, Marker& marker) {
  constexpr double largest_side = 100;  // pixels; the outer edges of larger ones tell enough
  constexpr double least_blur = 0.16;   // cells; sharper edges are where they were found
  constexpr double least_explained = 0.8;
  constexpr double most_doubtful = 36;    // pixels; the side of squares that text is full of
  constexpr std::size_t small_code = 16;  // bits, which much reads as that is no marker
  const MarkerLayout& layout = *best.layout;
  const double side = std::sqrt(area_of(marker.corners));
  const bool doubtful = layout.cells.size() <= small_code && side <= most_doubtful;
  const bool blurred = side <= largest_side && blur * layout.width >= least_blur * side;
  if (layout.picture.size() == 0 || !(doubtful || blurred)) return true;
  const Homography place(marker.corners, layout.width);
  const bool light_inside = marker.inverted != layout.is_reversed();
  const std::optional<LightModel> light = fit_light(frame, place, layout.rings, light_inside, 1);
  if (!light) return !doubtful;
  const PatternFit fit =
      fit_pattern(frame, layout.cells_of(best.code), layout.picture, *light, marker.corners);
  // Noise takes more of what small cells show.
  if (doubtful && fit.explained < std::min(0.5 + 0.1 * side / layout.width, least_explained)) return false;
  if (blurred && !fit.is_sharp && fit.explained >= least_explained) marker.corners = fit.corners;
  return true;
}

std::optional<Marker> MarkerReader::read(const GreyFrame& frame, const Quad& quad) const {
  return read(frame, quad, 1, true);
}

std::optional<Marker> MarkerReader::read_again(const GreyFrame& frame, const Quad& quad) const {
  return read(frame, quad, hardly_ever, false);
}

std::optional<Marker> MarkerReader::read(const GreyFrame& frame, const Quad& quad, double most_accepted,
                                         bool blurred) const {
  Best best;
  for (const Group& group : groups_) {
    const MarkerLayout& layout = group.layout;
    if (!fits(layout, quad)) continue;
    const Homography place(quad.corners, layout.width);
    // Small codes are read into much that is no marker: their border must be the better.
    const int one_in = layout.cells.size() <= 16 ? 13 : 10;
    const std::optional<LightModel> light = fit_light(frame, place, layout.rings, quad.light_inside, one_in);
    if (!light) continue;
    const CellReading reading = read_cells(frame, place, *light, layout);
    if (reading.margin >= limits_.min_margin && look_up(reading, quad, group, most_accepted, best)) continue;
    if (blurred) read_unblurred(frame, quad, place, *light, group, best);
  }
  if (best.marker && !confirm(frame, quad.blur, best, *best.marker)) return std::nullopt;
  return best.marker;
}

}  // namespace runmark
