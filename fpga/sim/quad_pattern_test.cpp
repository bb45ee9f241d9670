#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <vector>

#include "Vquad_pattern.h"
#include "clocked.h"
#include "pattern/homography.h"
#include "pattern/integer_reader.h"
#include "render/draw_marker.h"
#include "signed_port.h"

namespace runmark::rtl {
namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr unsigned coordinate_bits = 16;

struct Frame {
  std::vector<std::uint8_t> grey = std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height, 200);
  [[nodiscard]] std::uint8_t& at(int x, int y) { return grey[static_cast<std::size_t>(y * width + x)]; }
};

struct QuadIn {
  IntegerQuad quad;
  int bottom = 0;
};

struct Found {
  int id = -1, rotation = 0, errors = 0;
  int clearance = 0, scale = 0;
  std::array<SubpixelPoint, 4> corners{};
  friend bool operator==(const Found&, const Found&) = default;
};

/// The definition, as HardwarePipeline puts it together.
std::optional<Found> plain_reading(Frame& frame, const QuadIn& in, const IntegerReader& reader) {
  std::vector<const std::uint8_t*> rows;
  for (int y = 0; y < height; ++y) rows.push_back(&frame.at(0, y));
  const auto reading = reader.read({rows.data(), width, height, 1, PixelFormat::grey},
                                   std::min(in.bottom + 4, height - 1), in.quad);
  if (!reading) return std::nullopt;
  Found found{reading->match.id,  reading->match.rotation, reading->match.hamming,
              reading->clearance, reading->scale,          {}};
  for (std::size_t i = 0; i < 4; ++i) {
    found.corners[i] = in.quad.corners[(i + static_cast<std::size_t>(found.rotation)) % 4];
  }
  return found;
}

class Bench {
 public:
  explicit Bench(const Dictionary& dictionary, int max_errors, int min_margin) {
    drive(core_->last_x, width - 1U);
    drive(core_->last_y, height - 1U);
    drive(core_->width, static_cast<unsigned>(dictionary.width));
    drive(core_->max_errors, static_cast<unsigned>(max_errors));
    drive(core_->min_margin, static_cast<unsigned>(min_margin));
    drive(core_->codes, dictionary.codes.size());
    for (std::size_t i = 0; i < dictionary.codes.size(); ++i) {
      core_->write = 1;
      drive(core_->write_at, i);
      core_->write_code = dictionary.codes[i];
      core_.tick();
    }
    core_->write = 0;
  }

  std::optional<Found> run(Frame& frame, const QuadIn& in, int percent, std::uint64_t seed) {
    Willing moves(percent, seed);
    for (unsigned i = 0; i < 4; ++i) {
      set_part(core_->quad_x, i, coordinate_bits, in.quad.corners[i].x);
      set_part(core_->quad_y, i, coordinate_bits, in.quad.corners[i].y);
    }
    drive(core_->quad_bottom, static_cast<unsigned>(in.bottom));
    core_->quad_hole = in.quad.light_inside;
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
        EXPECT_LE(core_->read_y, std::min(in.bottom + 4, height - 1));
        answers.push_back(frame.at(core_->read_x, core_->read_y));
      }
      if (core_->marker_valid && core_->marker_ready) {
        found.emplace();
        found->id = core_->marker_id;
        found->rotation = core_->marker_rotation;
        found->errors = core_->marker_errors;
        found->clearance = static_cast<int>(core_->marker_clearance);
        found->scale = static_cast<int>(core_->marker_scale);
        EXPECT_EQ(core_->marker_hole != 0, in.quad.light_inside);
        for (unsigned i = 0; i < 4; ++i) {
          found->corners[i] = {signed_part(core_->marker_x, i, coordinate_bits),
                               signed_part(core_->marker_y, i, coordinate_bits)};
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
  Clocked<Vquad_pattern> core_;
};

int below(std::mt19937_64& random, int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

/// A marker somewhere in the frame, seen from anywhere, in uneven light and noise.
QuadIn draw(Frame& frame, const Dictionary& dictionary, bool inverted, std::mt19937_64& random) {
  const MarkerDrawing drawing = draw_marker(dictionary, random() % dictionary.codes.size(), 1, 1);
  const double size = 10 + below(random, 60);
  const double turn = below(random, 6283) / 1000.0;
  std::array<Point, 4> corners;
  const Point middle{40.0 + below(random, 80), 35.0 + below(random, 50)};
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = turn + 1.5708 * static_cast<double>(i) + below(random, 300) / 1000.0;
    const double radius = size * (0.55 + below(random, 300) / 1000.0);
    corners[i] = {middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)};
  }
  const int slope_x = below(random, 3) - 1;
  const int slope_y = below(random, 3) - 1;
  const int white = 140 + below(random, 60);
  const int black = 20 + below(random, 80);
  const int noise = 1 + below(random, 12);
  const Homography to_image(corners, drawing.square);
  // Every cell is drawn by many points: denser than the pixels.
  const int dense = static_cast<int>(size) * 4;
  for (auto& g : frame.grey) g = static_cast<std::uint8_t>(inverted ? black : white);
  for (int v = 0; v < dense; ++v) {
    for (int u = 0; u < dense; ++u) {
      const double cu = (u + 0.5) / dense * drawing.side;
      const double cv = (v + 0.5) / dense * drawing.side;
      const Point p = to_image(cu - drawing.origin, cv - drawing.origin);
      const int x = static_cast<int>(std::lround(p.x));
      const int y = static_cast<int>(std::lround(p.y));
      if (x < 0 || y < 0 || x >= width || y >= height) continue;
      const bool light =
          drawing
              .grey[static_cast<std::size_t>(static_cast<int>(cv) * drawing.side + static_cast<int>(cu))] !=
          0;
      frame.at(x, y) = static_cast<std::uint8_t>(light != inverted ? white : black);
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int level =
          frame.at(x, y) + slope_x * (x - 80) / 3 + slope_y * (y - 60) / 3 + below(random, noise);
      frame.at(x, y) = static_cast<std::uint8_t>(std::clamp(level, 0, 255));
    }
  }
  QuadIn in;
  in.quad.light_inside = inverted;
  double lowest = 0;
  const std::size_t first = random() % 4;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point p = corners[(i + first) % 4];
    in.quad.corners[i] = {static_cast<int>(std::lround(p.x * 16)) + below(random, 9) - 4,
                          static_cast<int>(std::lround(p.y * 16)) + below(random, 9) - 4};
    lowest = std::max(lowest, p.y);
  }
  in.bottom = std::clamp(static_cast<int>(lowest) - below(random, 3), 0, height - 1);
  return in;
}

void compare(const char* name, int corrected_bits, int min_margin, int quads, std::mt19937_64& random) {
  auto dictionary = builtin_dictionary(name);
  ASSERT_TRUE(dictionary);
  const int max_errors = std::min(corrected_bits, (dictionary->distance - 1) / 2);
  const std::vector<Dictionary> all{*dictionary};
  const IntegerReader reader(all, {corrected_bits, min_margin});
  Bench bench(*dictionary, max_errors, min_margin);
  int matches = 0;
  std::array<int, 4> rotations{};
  for (int i = 0; i < quads; ++i) {
    Frame frame;
    QuadIn in = draw(frame, *dictionary, random() % 4 == 0, random);
    if (i % 10 == 9) {  // corners that have nothing to do with the picture, some outside of it
      for (SubpixelPoint& c : in.quad.corners) c = {below(random, 6000) - 1500, below(random, 5000) - 1500};
    }
    if (i % 10 == 8) {  // convex, with one side far away
      in.quad.corners = {SubpixelPoint{0, 0}, {1600, 700 + below(random, 90)}, {1600, 840}, {0, 1600}};
    }
    const auto plain = plain_reading(frame, in, reader);
    ASSERT_EQ(bench.run(frame, in, i % 2 == 0 ? 100 : 40, random()), plain) << name << ", quad " << i;
    if (!plain) continue;
    ++matches;
    ++rotations[static_cast<std::size_t>(plain->rotation)];
  }
  EXPECT_GT(matches, quads / 4) << name;
  EXPECT_LT(matches, quads) << name;
  for (const int count : rotations) EXPECT_GT(count, 0) << name;
}

TEST(RtlQuadPattern, IsThePlainCore) {
  std::mt19937_64 random(91);
  compare("DICT_6X6_250", 5, 13, 1500, random);
  compare("DICT_4X4_50", 1, 13, 600, random);
  compare("DICT_5X5_100", 2, 40, 600, random);
  compare("DICT_7X7_100", 4, 0, 600, random);
  compare("tag36h11", 0, 13, 400, random);
}

TEST(RtlQuadPattern, PlacesWhileItReads) {
  auto dictionary = builtin_dictionary("DICT_6X6_250");
  ASSERT_TRUE(dictionary);
  Bench bench(*dictionary, 5, 13);
  std::mt19937_64 random(92);
  Frame frame;
  const QuadIn in = draw(frame, *dictionary, false, random);
  ASSERT_TRUE(bench.run(frame, in, 100, 1));
  // 96 samples of 21 clocks, the cells twice, and at most four searches.
  EXPECT_LE(bench.cycles, 96U * 23 + 64 * 4 + 36 * 8 + 4 * (36 + 250 + 8) + 60);
  RecordProperty("cycles", static_cast<int>(bench.cycles));
}

}  // namespace
}  // namespace runmark::rtl
