#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "Vpattern.h"
#include "clocked.h"
#include "pattern_cases.h"

namespace runmark::rtl {
namespace {

using pattern::Found;
using pattern::Frame;
using pattern::height;
using pattern::QuadIn;
using pattern::Settings;
using pattern::width;

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
    pattern::Case it = pattern::random_case(i, *dictionary, codes.size(), random);
    const auto plain = pattern::plain_match(it.frame, it.quad, it.settings, codes);
    const auto hardware = bench.run(it.frame, it.quad, it.settings, i % 2 == 0 ? 100 : 30, random());
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
