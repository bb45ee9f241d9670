#include "threshold/fixed_threshold.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>

#include "Vthreshold.h"
#include "clocked.h"
#include "threshold/grey.h"

namespace runmark::rtl {
namespace {

struct Pixel {
  std::uint8_t grey;
  bool dark, sof, eol;
  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// Random pixels through the core, every output compared.
void compare(bool rgb, int level, bool above_is_dark, int percent_in, int percent_out, int pixels) {
  Clocked<Vthreshold> core;
  std::mt19937_64 random(static_cast<std::uint64_t>(level) * 8 + static_cast<std::uint64_t>(percent_in));
  Willing sends(percent_in, 1);
  Willing takes(percent_out, 2);
  const FixedThreshold threshold{level, above_is_dark};
  drive(core->level, static_cast<unsigned>(level));
  core->above_is_dark = above_is_dark;
  core->rgb = rgb;
  std::deque<Pixel> expected;
  bool offered = false;
  Pixel next{};
  int sent = 0;
  int taken = 0;
  while (taken < pixels) {
    ASSERT_LT(core.cycles(), static_cast<std::uint64_t>(pixels) * 40) << "the core stands still";
    if (!offered && sent < pixels && sends()) {
      offered = true;
      const auto bits = static_cast<std::uint32_t>(random() & 0xFFFFFF);
      core->in_data = bits;
      const std::array<std::uint8_t, 3> bytes{static_cast<std::uint8_t>(bits),
                                              static_cast<std::uint8_t>(bits >> 8),
                                              static_cast<std::uint8_t>(bits >> 16)};
      const std::uint8_t grey = grey_of(bytes.data(), rgb ? PixelFormat::rgb : PixelFormat::grey);
      next = {grey, threshold.dark(grey), random() % 7 == 0, random() % 5 == 0};
      core->in_sof = next.sof;
      core->in_eol = next.eol;
    }
    core->in_valid = offered;
    core->out_ready = takes();
    core.settle();
    if (core->in_valid && core->in_ready) {
      expected.push_back(next);
      offered = false;
      ++sent;
    }
    if (core->out_valid && core->out_ready) {
      ASSERT_FALSE(expected.empty());
      const Pixel got{core->out_grey, core->out_dark != 0, core->out_sof != 0, core->out_eol != 0};
      ASSERT_EQ(got, expected.front()) << "pixel " << taken;
      expected.pop_front();
      ++taken;
    }
    core.tick();
  }
}

TEST(RtlThreshold, IsThePlainCore) {
  for (const int level : {0, 1, 77, 128, 255, 256}) {
    for (const bool rgb : {false, true}) {
      compare(rgb, level, false, 100, 100, 4000);
      compare(rgb, level, true, 60, 70, 4000);
    }
  }
}

TEST(RtlThreshold, TakesAPixelAClock) {
  Clocked<Vthreshold> core;
  core->in_valid = 1;
  core->out_ready = 1;
  for (int i = 0; i < 100; ++i) {
    core.settle();
    ASSERT_TRUE(core->in_ready);
    if (i >= 3) {
      ASSERT_TRUE(core->out_valid);
    }
    core.tick();
  }
}

}  // namespace
}  // namespace runmark::rtl
