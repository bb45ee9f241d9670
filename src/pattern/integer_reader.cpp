#include "pattern/integer_reader.h"

#include <algorithm>
#include <cstdlib>

#include "pattern/projective_grid.h"

namespace runmark {
namespace {

/// The same dictionary with its cells row by row.
Dictionary row_major(const Dictionary& dictionary) {
  Dictionary sorted = dictionary;
  const int side = dictionary.width - 2;
  const std::size_t bits = dictionary.cells.size();
  for (std::size_t i = 0; i < bits; ++i) {
    sorted.cells[i] = {static_cast<std::int8_t>(1 + static_cast<int>(i) % side),
                       static_cast<std::int8_t>(1 + static_cast<int>(i) / side)};
  }
  for (std::uint64_t& code : sorted.codes) {
    std::uint64_t in_order = 0;
    for (std::size_t i = 0; i < bits; ++i) {
      const Cell cell = dictionary.cells[i];
      const auto place = static_cast<std::size_t>((cell.y - 1) * side + cell.x - 1);
      in_order |= (code >> (bits - 1 - i) & 1U) << (bits - 1 - place);
    }
    code = in_order;
  }
  return sorted;
}

class CellSampler {
 public:
  CellSampler(const GreyFrame& frame, int last_row, const ProjectiveGrid& grid, bool light_inside)
      : frame_(frame), last_row_(last_row), grid_(grid), light_inside_(light_inside) {}

  /// In sixteenths; false beyond the horizon.
  [[nodiscard]] bool sample(int column, int row, FineGrey& grey) const {
    const auto p = grid_.middle(column, row);
    if (!p) return false;
    grey = grey_between(frame_, last_row_, *p);
    if (light_inside_) grey = 16 * 255 - grey;
    return true;
  }

 private:
  const GreyFrame& frame_;
  int last_row_;
  const ProjectiveGrid& grid_;
  bool light_inside_;
};

}  // namespace

FineGrey grey_between(const GreyFrame& frame, int last_row, SubpixelPoint p) {
  const std::int32_t x = std::clamp(p.x, 0, (frame.width - 1) << subpixel_bits);
  const std::int32_t y = std::clamp(p.y, 0, last_row << subpixel_bits);
  const int x0 = x >> subpixel_bits;
  const int y0 = y >> subpixel_bits;
  const int x1 = std::min(x0 + 1, frame.width - 1);
  const int y1 = std::min(y0 + 1, last_row);
  const int across = x & 15;
  const int down = y & 15;
  const int upper = 16 * frame.at(x0, y0) + across * (frame.at(x1, y0) - frame.at(x0, y0));
  const int lower = 16 * frame.at(x0, y1) + across * (frame.at(x1, y1) - frame.at(x0, y1));
  return (16 * upper + down * (lower - upper)) >> 4;
}

std::optional<CellBits> read_cells(const GreyFrame& frame, int last_row, const IntegerQuad& quad, int width) {
  constexpr FineGrey least_contrast = 8 * 16;
  const auto grid = ProjectiveGrid::make(quad.corners, width);
  if (!grid) return std::nullopt;
  const CellSampler sampler(frame, last_row, *grid, quad.light_inside);
  std::array<FineGrey, 100> cells{};
  const auto at = [&](int column, int row) -> FineGrey& {
    return cells[static_cast<std::size_t>(row * width + column)];
  };

  IntegerLight light(width);
  const int last = width - 1;
  for (int i = 0; i < width; ++i) {
    for (const auto& [column, row] : {std::array{i, -1}, {i, width}, {-1, i}, {width, i}}) {
      FineGrey grey = 0;
      if (!sampler.sample(column, row, grey)) return std::nullopt;
      light.add(column, row, grey);
    }
  }
  const auto for_border = [&](auto&& visit) {
    for (int i = 0; i < last; ++i) {
      if (!visit(i, 0) || !visit(last, i) || !visit(last - i, last) || !visit(0, last - i)) return false;
    }
    return true;
  };
  const bool placed = for_border([&](int column, int row) {
    if (!sampler.sample(column, row, at(column, row))) return false;
    light.add(column, row, at(column, row));
    return true;
  });
  if (!placed) return std::nullopt;
  light.finish();
  if (light.contrast() < least_contrast) return std::nullopt;
  int white = 0;
  for_border([&](int column, int row) {
    FineGrey& cell = at(column, row);
    cell = light.above(column, row, cell);
    white += cell >= 0 ? 1 : 0;
    return true;
  });
  if (white > 3 * width / 8) return std::nullopt;

  for (int row = 1; row < last; ++row) {
    for (int column = 1; column < last; ++column) {
      FineGrey grey = 0;
      if (!sampler.sample(column, row, grey)) return std::nullopt;
      at(column, row) = light.above(column, row, grey);
    }
  }
  // Blur mixes each cell with its neighbours: half of what they took is given back.
  CellBits bits;
  for (int row = 1; row < last; ++row) {
    for (int column = 1; column < last; ++column) {
      const FineGrey neighbours =
          at(column - 1, row) + at(column + 1, row) + at(column, row - 1) + at(column, row + 1);
      const FineGrey sharp = 6 * at(column, row) - neighbours;
      bits.code = (bits.code << 1) | (sharp > 0 ? 1U : 0U);
      bits.clearance += std::min(sharp < 0 ? ~sharp : sharp, light.contrast());
    }
  }
  bits.scale = 2 * light.contrast() * (width - 2) * (width - 2);
  return bits;
}

IntegerReader::IntegerReader(const std::vector<Dictionary>& dictionaries, const IntegerReaderLimits& limits)
    : limits_(limits) {
  for (const Dictionary& dictionary : dictionaries) {
    const int bits = limits.corrected_bits < 0 ? dictionary.corrected_bits : limits.corrected_bits;
    books_[static_cast<std::size_t>(dictionary.width)].push_back(
        {&dictionary, CodeLookup(row_major(dictionary), bits)});
  }
}

bool IntegerReader::can_read(const Dictionary& dictionary) {
  const int side = dictionary.width - 2;
  const auto within = [&](Cell cell) {
    return cell.x >= 1 && cell.y >= 1 && cell.x <= side && cell.y <= side;
  };
  return dictionary.border == Border::black && dictionary.width >= least_width &&
         dictionary.width <= most_width && dictionary.cells.size() == static_cast<std::size_t>(side * side) &&
         std::all_of(dictionary.cells.begin(), dictionary.cells.end(), within);
}

std::optional<IntegerReading> IntegerReader::read(const GreyFrame& frame, int last_row,
                                                  const IntegerQuad& quad) const {
  std::optional<IntegerReading> best;
  for (int width = least_width; width <= most_width; ++width) {
    const std::vector<Book>& books = books_[static_cast<std::size_t>(width)];
    if (books.empty()) continue;
    const auto bits = read_cells(frame, last_row, quad, width);
    if (!bits) continue;
    if (std::int64_t{256} * bits->clearance < std::int64_t{limits_.min_margin} * bits->scale) continue;
    for (const Book& book : books) {
      const auto match = book.lookup.find(bits->code);
      if (!match || (best && match->hamming >= best->match.hamming)) continue;
      best = IntegerReading{book.dictionary, *match, bits->clearance, bits->scale};
    }
  }
  return best;
}

std::size_t IntegerReader::memory() const {
  std::size_t bytes = sizeof(*this);
  for (const auto& books : books_) {
    for (const Book& book : books) bytes += book.lookup.memory();
  }
  return bytes;
}

}  // namespace runmark
