#include <gtest/gtest.h>

#include <string>

#include "Vcontour_scan.h"
#include "Vcontour_scan_small.h"
#include "noise_image.h"
#include "pixel_limit.h"
#include "scan_bench.h"

namespace runmark::rtl {
namespace {

constexpr std::size_t small_records = 14;
constexpr std::size_t vga_records = 1023;

std::string difference(const FrameChains& hardware, const FrameChains& plain) {
  if (!hardware.ended) return "the hardware stands still";
  const LinkerCounts& a = hardware.counts;
  const LinkerCounts& b = plain.counts;
  const auto differ = [](const char* what, std::uint64_t one, std::uint64_t other) {
    return std::string(what) + ' ' + std::to_string(one) + ", plain " + std::to_string(other);
  };
  if (a.runs != b.runs) return differ("runs", a.runs, b.runs);
  if (a.closed != b.closed) return differ("closed", a.closed, b.closed);
  if (a.handed_on != b.handed_on) return differ("handed on", a.handed_on, b.handed_on);
  if (a.dropped_full != b.dropped_full) return differ("dropped full", a.dropped_full, b.dropped_full);
  if (a.dropped_rule != b.dropped_rule) return differ("dropped by rule", a.dropped_rule, b.dropped_rule);
  if (hardware.dropped_queue != 0) return "dropped for want of queue";
  if (hardware.record_peak != plain.record_peak) {
    return differ("record peak", hardware.record_peak, plain.record_peak);
  }
  if (hardware.chains != plain.chains) return "other chains";
  return {};
}

/// Every image of up to 4x4 pixels inside a light border, which the core lays again.
TEST(RtlContour, IsThePlainCoreOnEveryImage) {
  ScanBench<Vcontour_scan_small> bench;
  const int most = pixel_limit(16);
  for (int height = 1; height <= 4; ++height) {
    for (int width = 1; width <= 4; ++width) {
      if (width * height > most) continue;
      PixelImage image(width + 2, height + 2);
      for (unsigned bits = 0; bits < 1U << (width * height); ++bits) {
        for (int i = 0; i < width * height; ++i)
          image.set(1 + i % width, 1 + i / width, (bits >> i & 1U) != 0);
        ScanSettings settings;
        settings.cases = (bits ^ bits >> 4) % 4 == 0 ? 63 : 0;  // the filter leaves few different images
        for (const bool eight : {false, true}) {
          settings.eight = eight;
          const std::string fault =
              difference(bench.run(image, settings), plain_chains(image, settings, small_records));
          ASSERT_EQ(fault, "") << width << " x " << height << ", image " << bits
                               << (eight ? ", eight" : ", four");
        }
      }
    }
  }
}

/// Small frames, every setting at random; the small core runs out of records in many of them.
TEST(RtlContour, IsThePlainCoreOnRandomFrames) {
  ScanBench<Vcontour_scan_small> bench;
  std::mt19937_64 random(21);
  std::uint64_t full = 0;
  std::uint64_t rule = 0;
  std::uint64_t handed_on = 0;
  const unsigned frames = pixel_limit(16) < 16 ? 1500 : 10000;
  for (unsigned i = 0; i < frames; ++i) {
    const int most = i % 20 == 0 ? 32 : 14;
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const PixelImage image =
        noise_image(1 + below(most), 1 + below(most), 20 + below(61), 1 + below(4), random());
    ScanSettings settings;
    settings.cases = static_cast<std::uint8_t>(i % 2 == 0 ? 0 : i % 3 == 0 ? 63 : below(64));
    settings.eight = below(2) != 0;
    settings.holes = below(4) != 0;
    settings.max_turns = static_cast<unsigned>(below(3) == 0 ? below(8) : 30);
    settings.min_height = static_cast<unsigned>(below(3) == 0 ? below(5) : 0);
    settings.percent_in = i % 2 == 0 ? 100 : 30;
    settings.percent_walk = below(2) != 0 ? 100 : 40;
    const FrameChains plain = plain_chains(image, settings, small_records);
    const std::string fault = difference(bench.run(image, settings), plain);
    ASSERT_EQ(fault, "") << "frame " << i << ", " << image.width() << " x " << image.height();
    full += plain.counts.dropped_full;
    rule += plain.counts.dropped_rule;
    handed_on += plain.counts.handed_on;
  }
  EXPECT_GT(full, frames / 20U);
  EXPECT_GT(rule, frames / 20U);
  EXPECT_GT(handed_on, frames / 2U);
}

TEST(RtlContour, IsRightAgainAfterAFrameIsCutOff) {
  ScanBench<Vcontour_scan_small> bench;
  std::mt19937_64 random(22);
  for (int i = 0; i < 500; ++i) {
    ScanSettings settings;
    settings.percent_walk = i % 2 == 0 ? 100 : 30;
    const PixelImage cut = noise_image(20, 20, 45, 2, random());
    const int pixels = static_cast<int>(random() % 399);
    bench.run(cut, settings, pixels);
    const PixelImage image = noise_image(16, 16, 45, 2, random());
    const FrameChains hardware = bench.run(image, settings);
    ASSERT_TRUE(hardware.ended);
    ASSERT_EQ(hardware.chains, plain_chains(image, settings, small_records).chains) << "cut after " << pixels;
  }
}

/// 640x480 from clean to noise, coarse to fine, the walker keeping up on its own.
TEST(RtlContour, IsThePlainCoreAcrossDensityAndGranularity) {
  ScanBench<Vcontour_scan> bench;
  int compared = 0;
  for (const int granularity : {24, 8, 4}) {
    for (const int density : {5, 30, 50, 70}) {
      if (pixel_limit(16) < 16 && granularity != 8) continue;
      const PixelImage image =
          noise_image(640, 480, density, granularity, static_cast<std::uint64_t>(density));
      ScanSettings settings;
      settings.max_turns = 30;
      settings.min_height = 4;
      const FrameChains hardware = bench.run(image, settings);
      const FrameChains plain = plain_chains(image, settings, vga_records);
      ASSERT_EQ(difference(hardware, plain), "") << density << " % of " << granularity << " px";
      compared += static_cast<int>(plain.chains.size());
    }
  }
  EXPECT_GT(compared, 100);
}

/// Below 10 events per 100 pixels the scan takes at most 1.02 clocks a pixel, walker and all.
TEST(RtlContour, KeepsUpWithTheCamera) {
  ScanBench<Vcontour_scan> bench;
  const PixelImage image = noise_image(640, 480, 25, 12, 3);
  ScanSettings settings;
  settings.patient = false;
  const FrameChains hardware = bench.run(image, settings);
  ASSERT_TRUE(hardware.ended);
  const double pixels = 640.0 * 480.0;
  RecordProperty("runs", static_cast<int>(hardware.counts.runs));
  RecordProperty("cycles", static_cast<int>(hardware.cycles));
  EXPECT_LE(static_cast<double>(hardware.cycles) / pixels, 1.02) << hardware.counts.runs << " runs";
}

}  // namespace
}  // namespace runmark::rtl
