#include <gtest/gtest.h>

#include <bit>
#include <deque>
#include <vector>

#include "Vpattern.h"
#include "clocked.h"
#include "corner/quad.h"
#include "pattern/square_grid.h"
#include "render/draw_marker.h"
#include "runmark/dictionary.h"
#include "threshold/fixed_threshold.h"

namespace runmark::rtl {
namespace {

constexpr int width = 160;
constexpr int height = 120;

struct Frame {
  std::vector<std::uint8_t> grey = std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, 200);
  [[nodiscard]] std::uint8_t& at(int x, int y) { return grey[static_cast<std::size_t>(y * width + x)]; }
};

struct QuadIn {
  std::array<CrackPoint, 4> corners{};  // in the order of the chain
  int bottom = 0;
  bool hole = false;
};

struct Settings {
  FixedThreshold threshold{128, false};
  unsigned min_area = 128;  // in half pixels
  unsigned max_area = (1U << 21) - 1;
  int max_errors = 3;
};

struct Found {
  int id = -1, rotation = 0, errors = 0;
  bool hole = false;
  std::array<CrackPoint, 4> corners{};
  friend bool operator==(const Found&, const Found&) = default;
};

/// The definition, as PaperPipeline puts it together.
std::optional<Found> plain_match(Frame& frame, const QuadIn& quad, const Settings& settings,
                                 const std::vector<std::uint64_t>& codes) {
  std::array<CrackPoint, 4> c = quad.corners;
  if (quad.hole) std::swap(c[0], c[3]), std::swap(c[1], c[2]);
  Quad shape;
  for (std::size_t i = 0; i < 4; ++i) shape.corners[i] = {c[i].x - 0.5, c[i].y - 0.5};
  const double area = 2 * area_of(shape.corners);
  if (area < settings.min_area || area > settings.max_area || !is_convex_clockwise(shape.corners))
    return std::nullopt;
  std::array<std::array<int, 8>, 8> cell{};
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      const PixelPosition p = grid_sample(c[0], c[1], column, row);
      if (p.x < 0 || p.y < 0 || p.x >= width || p.y >= height) return std::nullopt;
      const bool dark = settings.threshold.dark(frame.at(p.x, std::min(p.y, quad.bottom + 1)));
      cell[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = dark != quad.hole ? 0 : 1;
    }
  }
  for (int rotation = 0; rotation < 4; ++rotation) {
    for (std::size_t id = 0; id < codes.size(); ++id) {
      int errors = 0;
      for (int row = 0; row < 8; ++row) {
        for (int column = 0; column < 8; ++column) {
          // Where this cell of the marker as drawn stands after `rotation` quarter turns clockwise.
          int x = column;
          int y = row;
          for (int r = 0; r < rotation; ++r) std::tie(x, y) = std::pair(7 - y, x);
          const bool inner = row > 0 && row < 7 && column > 0 && column < 7;
          const auto bit =
              inner ? static_cast<int>(codes[id] >> (35 - (6 * (row - 1) + column - 1)) & 1U) : 0;
          errors += cell[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] != bit;
        }
      }
      if (errors > settings.max_errors) continue;
      Found found{static_cast<int>(id), rotation, errors, quad.hole, {}};
      for (std::size_t i = 0; i < 4; ++i) found.corners[i] = c[(i + static_cast<std::size_t>(rotation)) % 4];
      return found;
    }
  }
  return std::nullopt;
}

class Bench {
 public:
  explicit Bench(const std::vector<std::uint64_t>& codes) {
    drive(core_->last_x, width - 1U);
    drive(core_->last_y, height - 1U);
    drive(core_->codes, codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
      core_->write = 1;
      drive(core_->write_at, i);
      core_->write_code = codes[i];
      core_.tick();
    }
    core_->write = 0;
  }

  std::optional<Found> run(Frame& frame, const QuadIn& quad, const Settings& settings, int percent,
                           std::uint64_t seed) {
    Willing moves(percent, seed);
    drive(core_->level, static_cast<unsigned>(settings.threshold.level));
    core_->above_is_dark = settings.threshold.above_is_dark;
    core_->filtered = 1;
    drive(core_->min_area, settings.min_area);
    drive(core_->max_area, settings.max_area);
    drive(core_->max_errors, static_cast<unsigned>(settings.max_errors));
    std::uint64_t xs = 0;
    std::uint64_t ys = 0;
    for (unsigned i = 0; i < 4; ++i) {
      xs |= static_cast<std::uint64_t>(quad.corners[i].x) << (10 * i);
      ys |= static_cast<std::uint64_t>(quad.corners[i].y) << (9 * i);
    }
    core_->quad_x = xs;
    core_->quad_y = ys;
    drive(core_->quad_bottom, static_cast<unsigned>(quad.bottom));
    core_->quad_hole = quad.hole;
    core_->quad_end = 0;
    core_->quad_valid = 1;
    std::deque<std::uint8_t> answers;
    std::optional<Found> found;
    bool taken = false;
    const std::uint64_t begin = core_.cycles();
    for (int clock = 0; clock < 200000; ++clock) {
      core_->read_ready = moves();
      core_->grey_valid = !answers.empty() && moves();
      if (core_->grey_valid) core_->grey = answers.front();
      core_->marker_ready = moves();
      core_.settle();
      if (taken && core_->quad_ready) break;
      taken = taken || core_->quad_ready;
      if (core_->grey_valid) answers.pop_front();
      if (core_->read_valid && core_->read_ready) {
        EXPECT_LT(core_->read_x, width);
        EXPECT_LE(core_->read_y, quad.bottom + 1);
        answers.push_back(frame.at(core_->read_x, core_->read_y));
      }
      if (core_->marker_valid && core_->marker_ready) {
        found.emplace();
        found->id = core_->marker_id;
        found->rotation = core_->marker_rotation;
        found->errors = core_->marker_errors;
        found->hole = core_->marker_hole != 0;
        for (unsigned i = 0; i < 4; ++i) {
          found->corners[i] = {static_cast<int>(core_->marker_x >> (10 * i) & 1023),
                               static_cast<int>(core_->marker_y >> (9 * i) & 511)};
        }
      }
      core_.tick();
      if (taken) core_->quad_valid = 0;
    }
    EXPECT_TRUE(answers.empty()) << "did not wait for all pixels";
    cycles = core_.cycles() - begin;
    return found;
  }
  std::uint64_t cycles = 0;

 private:
  Clocked<Vpattern> core_;
};

std::vector<std::uint64_t> codes_of(const char* name, std::size_t most) {
  auto dictionary = builtin_dictionary(name);
  if (!dictionary) return {};
  std::vector<std::uint64_t> codes = dictionary->codes;
  codes.resize(std::min(codes.size(), most));
  return codes;
}

TEST(RtlPattern, IsThePlainCore) {
  const auto dictionary = builtin_dictionary("DICT_6X6_250");
  ASSERT_TRUE(dictionary);
  const std::vector<std::uint64_t> codes = codes_of("DICT_6X6_250", 250);
  ASSERT_EQ(codes.size(), 250U);
  Bench bench(codes);
  std::mt19937_64 random(41);
  int matches = 0;
  std::array<int, 4> rotations{};
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    Frame frame;
    const MarkerDrawing drawing = draw_marker(*dictionary, random() % codes.size(), 1 + below(8), 0);
    const int side = drawing.side;
    const int x0 = 1 + below(width - side - 2);
    const int y0 = 1 + below(height - side - 2);
    const int turn = below(4);
    const bool inverted = below(4) == 0;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        int px = x;
        int py = y;
        for (int r = 0; r < turn; ++r) std::tie(px, py) = std::pair(side - 1 - py, px);
        const int level =
            drawing.grey[static_cast<std::size_t>(y * side + x)] != 0 ? 150 + below(100) : below(110);
        frame.at(x0 + px, y0 + py) = static_cast<std::uint8_t>(inverted ? 255 - level : level);
      }
    }
    for (int n = below(12); n > 0; --n)
      frame.at(below(width), below(height)) = static_cast<std::uint8_t>(below(256));
    QuadIn quad;
    quad.corners = {CrackPoint{x0, y0}, {x0 + side, y0}, {x0 + side, y0 + side}, {x0, y0 + side}};
    std::rotate(quad.corners.begin(), quad.corners.begin() + below(4), quad.corners.end());
    if (i % 3 == 0) {
      const auto moved = [&](int at, int most) { return std::clamp(at + below(9) - 4, 0, most - 1); };
      for (CrackPoint& c : quad.corners) c = {moved(c.x, width), moved(c.y, height)};
    }
    if (i % 50 == 0) {
      for (CrackPoint& c : quad.corners) c = {below(width), below(height)};
    }
    quad.hole = inverted;
    if (quad.hole) std::swap(quad.corners[0], quad.corners[3]), std::swap(quad.corners[1], quad.corners[2]);
    quad.bottom = std::min(y0 + side + below(3), height - 1);
    Settings settings;
    settings.max_errors = below(6);
    settings.threshold.above_is_dark = below(5) == 0;
    if (i % 7 == 0) settings.min_area = static_cast<unsigned>(below(6000));
    if (i % 11 == 0) settings.max_area = static_cast<unsigned>(below(6000));
    const auto plain = plain_match(frame, quad, settings, codes);
    const auto hardware = bench.run(frame, quad, settings, i % 2 == 0 ? 100 : 30, random());
    ASSERT_EQ(hardware.has_value(), plain.has_value()) << "quad " << i;
    if (!plain) {
      ++refused;
      continue;
    }
    ASSERT_TRUE(*hardware == *plain) << "quad " << i << ": id " << hardware->id << " for " << plain->id;
    ++matches;
    ++rotations[static_cast<std::size_t>(plain->rotation)];
  }
  EXPECT_GT(matches, 1000);
  EXPECT_GT(refused, 500);
  for (const int count : rotations) EXPECT_GT(count, 100);
}

TEST(RtlPattern, SearchesACodeAClock) {
  const std::vector<std::uint64_t> codes = codes_of("DICT_6X6_250", 250);
  Bench bench(codes);
  Frame frame;  // nothing in it: the search goes on to the end
  for (auto& level : frame.grey) level = 0;
  QuadIn quad{{CrackPoint{20, 20}, {60, 20}, {60, 60}, {20, 60}}, 60, false};
  Settings settings;
  settings.max_errors = 0;
  EXPECT_FALSE(bench.run(frame, quad, settings, 100, 1));
  RecordProperty("cycles", static_cast<int>(bench.cycles));
  EXPECT_LE(bench.cycles, 150U + 4 * (codes.size() + 6));
}

}  // namespace
}  // namespace runmark::rtl
