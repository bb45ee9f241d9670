#include "runmark/image_view.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace runmark {
namespace {

std::array<std::uint8_t, 64> pixels{};

TEST(ImageView, AcceptsWhatFits) {
  EXPECT_EQ(ImageView::grey(pixels.data(), 8, 8, 8).check(), Status::ok);
  EXPECT_EQ(ImageView::rgb(pixels.data(), 2, 2, 6).check(), Status::ok);
  EXPECT_EQ(ImageView::grey(pixels.data() + 56, 8, 8, -8).check(), Status::ok) << "bottom-up";
  EXPECT_EQ(ImageView::grey(pixels.data(), 1, 1, 0).check(), Status::ok);
  EXPECT_EQ(ImageView::grey(pixels.data() + 7, 8, 8, 8, -1).check(), Status::ok) << "mirrored";
  EXPECT_EQ(ImageView::grey(pixels.data(), 8, 8, 1, 8).check(), Status::ok) << "transposed";
  EXPECT_EQ(ImageView::rgb(pixels.data(), 3, 4, 3, 12).check(), Status::ok) << "transposed";
}

TEST(ImageView, RefusesWhatContradictsItself) {
  EXPECT_EQ(ImageView::grey(nullptr, 8, 8, 8).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 0, 8, 8).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 65536, 1, 65536).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 8, 8, 7).check(), Status::bad_view);
  EXPECT_EQ(ImageView::rgb(pixels.data(), 2, 2, 6, 2).check(), Status::bad_view);
  EXPECT_EQ(ImageView::rgb(pixels.data(), 2, 2, 6, -2).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 8, 8, 1, 7).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 8, 8, 0).check(), Status::bad_view);
  constexpr int least = std::numeric_limits<int>::min();
  constexpr std::ptrdiff_t least_stride = std::numeric_limits<std::ptrdiff_t>::min();
  EXPECT_EQ(ImageView::grey(pixels.data(), 2, 2, 1, least).check(), Status::ok) << "transposed and mirrored";
  EXPECT_EQ(ImageView::grey(pixels.data(), 2, 2, 0, least).check(), Status::bad_view);
  EXPECT_EQ(ImageView::grey(pixels.data(), 65535, 65535, least_stride, least).check(), Status::ok);
}

}  // namespace
}  // namespace runmark
