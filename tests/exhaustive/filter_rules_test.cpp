// What the filter cannot do, whatever the image and whichever cases are on (docs/preprocess.md).

#include <gtest/gtest.h>

#include <array>

#include "pixel_limit.h"
#include "preprocess/filter_table.h"

namespace runmark {
namespace {

/// The 3x3 window with its top left pixel at (x, y) of an image `stride` pixels wide.
constexpr Window window_at(unsigned image, int stride, int x, int y) {
  unsigned window = 0;
  for (int row = 0; row < 3; ++row) window |= (image >> ((y + row) * stride + x) & 7U) << (3 * row);
  return static_cast<Window>(window);
}

/// Two dark pixels of a square of four that meet at a corner only.
constexpr bool diagonal(bool nw, bool ne, bool sw, bool se) { return nw == se && ne == sw && nw != ne; }

// The four filtered pixels of a square depend on the 4x4 pixels round it.
TEST(FilterRules, NoSetOfCasesMakesADiagonalContact) {
  for (unsigned image = 0; image < 1U << 16; ++image) {
    const std::array<Window, 4> windows{window_at(image, 4, 0, 0), window_at(image, 4, 1, 0),
                                        window_at(image, 4, 0, 1), window_at(image, 4, 1, 1)};
    const auto shows = [&](std::uint8_t cases) {
      return diagonal(filter_pixel(windows[0], cases), filter_pixel(windows[1], cases),
                      filter_pixel(windows[2], cases), filter_pixel(windows[3], cases));
    };
    if (shows(filter_none)) continue;
    for (std::uint8_t cases = 1; cases <= filter_all; ++cases) {
      ASSERT_FALSE(shows(cases)) << "4x4 image " << image << ", cases " << int{cases};
    }
  }
}

// A filtered pixel and its four edge neighbours depend on the 5x5 pixels round it without the corners.
TEST(FilterRules, NoSetOfCasesMakesASinglePixel) {
  const unsigned images = shortened() ? 1U << 16 : 1U << 21;
  for (unsigned number = 0; number < images; ++number) {
    const unsigned image = (number & 7U) << 1 | (number >> 3 & 0x7FFFU) << 5 | (number >> 18) << 21;
    const std::array<Window, 5> windows{window_at(image, 5, 1, 1), window_at(image, 5, 1, 0),
                                        window_at(image, 5, 0, 1), window_at(image, 5, 2, 1),
                                        window_at(image, 5, 1, 2)};
    const auto single = [&](std::uint8_t cases) {
      const bool centre = filter_pixel(windows[0], cases);
      for (std::size_t i = 1; i < 5; ++i) {
        if (filter_pixel(windows[i], cases) == centre) return false;
      }
      return true;
    };
    if (single(filter_none)) continue;
    for (std::uint8_t cases = 1; cases <= filter_all; ++cases) {
      ASSERT_FALSE(single(cases)) << "5x5 image " << image << ", cases " << int{cases};
    }
  }
}

}  // namespace
}  // namespace runmark
