// Small images at every place across the ends of words and vectors in wide rows.

#include <gtest/gtest.h>

#include "contour_checker.h"
#include "pixel_limit.h"
#include "runmark/options.h"

namespace runmark {
namespace {

const char* check(ContourChecker& checker, const PixelImage& image, int x, int row_width) {
  constexpr ChainLimits no_limits{.max_turns = 1000, .max_records = 1000};
  for (const std::uint8_t cases : {filter_none, filter_all}) {
    if (const char* fault = checker.take(image, cases, x, row_width)) return fault;
    if (cases != filter_none && !checker.filter_changed()) return nullptr;
    for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
      if (const char* fault = checker.follow(connectivity)) return fault;
      if (const char* fault = checker.link(no_limits)) return fault;
    }
  }
  return nullptr;
}

/// Every image of up to `pixels` pixels, from ending at the boundary to beginning at it, in rows that end
/// with the image and in longer ones.
void check_across(int boundary, int pixels) {
  ContourChecker checker;
  for (int width = 1; width <= pixels; ++width) {
    for (int height = 1; width * height <= pixels; ++height) {
      PixelImage image(width, height);
      for (std::uint64_t bits = 0; bits < std::uint64_t{1} << (width * height); ++bits) {
        image.set_all(bits);
        for (int x = boundary - width; x <= boundary; ++x) {
          for (const int row_width : {x + width, x + width + 1 + bits_per_word}) {
            const char* fault = check(checker, image, x, row_width);
            ASSERT_EQ(fault, nullptr) << fault << ": " << width << "x" << height << " image " << bits
                                      << " at column " << x << " of " << row_width;
          }
        }
      }
    }
  }
}

TEST(WideRows, AcrossTheFirstWord) { check_across(64, pixel_limit(12)); }
TEST(WideRows, AcrossTheSecondWord) { check_across(128, pixel_limit(10)); }
TEST(WideRows, AcrossAVectorOf256) { check_across(256, pixel_limit(10)); }
TEST(WideRows, AcrossAVectorOf512) { check_across(512, pixel_limit(10)); }

TEST(WideRows, EveryColumnOfAWideRow) {
  ContourChecker checker;
  PixelImage image(3, 3);
  for (std::uint64_t bits = 0; bits < 512; ++bits) {
    image.set_all(bits);
    for (int x = 0; x <= 600; ++x) {
      const char* fault = check(checker, image, x, 640);
      ASSERT_EQ(fault, nullptr) << fault << ": image " << bits << " at column " << x;
    }
  }
}

}  // namespace
}  // namespace runmark
