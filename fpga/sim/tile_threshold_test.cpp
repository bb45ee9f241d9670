#include <gtest/gtest.h>

#include <vector>

#include "Vtile_threshold.h"
#include "clocked.h"
#include "threshold/integer_tiles.h"

namespace runmark::rtl {
namespace {

struct Frame {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> grey;
};

std::vector<bool> plain_dark(const Frame& frame, int min_contrast) {
  IntegerTiles tiles(frame.width);
  tiles.begin_frame(frame.width, frame.height, min_contrast);
  std::vector<bool> dark;
  std::vector<BitWord> bits(bit_words(frame.width));
  const auto take = [&] {
    for (int y = tiles.ready_from(); y < tiles.ready_to(); ++y) {
      tiles.threshold(frame.grey.data() + y * frame.width, bits.data());
      for (int x = 0; x < frame.width; ++x) dark.push_back(bit_at(bits.data(), x));
    }
  };
  for (int y = 0; y < frame.height; ++y) {
    if (tiles.add_row(frame.grey.data() + y * frame.width)) take();
  }
  tiles.finish();
  take();
  dark.front() = false;  // on the border, and sent at once
  return dark;
}

class Bench {
 public:
  /// @param pixels  how many are sent before the frame is cut off; -1 for all
  std::vector<bool> run(const Frame& frame, int min_contrast, int percent_in, int percent_out,
                        int pixels = -1) {
    Willing sends(percent_in, 71);
    Willing takes(percent_out, 72);
    drive(core_->last_x, static_cast<unsigned>(frame.width - 1));
    drive(core_->last_y, static_cast<unsigned>(frame.height - 1));
    drive(core_->min_contrast, static_cast<unsigned>(min_contrast));
    const std::size_t all = frame.grey.size();
    const std::size_t most = pixels < 0 ? all : static_cast<std::size_t>(pixels);
    std::vector<bool> dark;
    std::size_t sent = 0;
    bool offered = false;
    const std::uint64_t begin = core_.cycles();
    while (core_.cycles() - begin < all * 20 + 1000 && (pixels < 0 ? dark.size() < all : sent < most)) {
      offered = offered || (sent < most && sends());
      core_->in_valid = offered;
      core_->in_sof = sent == 0;
      core_->in_grey = sent < all ? frame.grey[sent] : 0;
      core_->out_ready = takes();
      core_.settle();
      if (core_->in_valid && core_->in_ready) {
        offered = false;
        ++sent;
      }
      if (core_->out_valid && core_->out_ready) {
        // What is left of a frame that was cut off may come first.
        if (core_->out_sof) dark.clear();
        dark.push_back(core_->out_dark != 0);
      }
      core_.tick();
    }
    core_->in_valid = 0;
    cycles = core_.cycles() - begin;
    return dark;
  }
  std::uint64_t cycles = 0;

 private:
  Clocked<Vtile_threshold> core_;
};

Frame random_frame(int width, int height, std::mt19937_64& random) {
  Frame frame{width, height, {}};
  const auto noise = 1 + random() % 60;
  const auto spots = 2 + random() % 40;
  for (int i = 0; i < width * height; ++i) {
    frame.grey.push_back(
        static_cast<std::uint8_t>(90 + random() % noise + (random() % spots == 0 ? random() % 100 : 0)));
  }
  return frame;
}

TEST(RtlTileThreshold, IsThePlainCore) {
  Bench bench;
  std::mt19937_64 random(70);
  int dark = 0;
  for (int i = 0; i < 2000; ++i) {
    const int width = 16 + static_cast<int>(random() % 60);
    const int height = 1 + static_cast<int>(random() % 40);
    const Frame frame = random_frame(width, height, random);
    const int contrast = 1 + static_cast<int>(random() % 60);
    const auto plain = plain_dark(frame, contrast);
    if (i % 5 == 4) bench.run(frame, contrast, 100, 70, 1 + static_cast<int>(random() % frame.grey.size()));
    ASSERT_EQ(bench.run(frame, contrast, i % 2 == 0 ? 100 : 60, i % 3 == 0 ? 100 : 70), plain)
        << width << "x" << height << ", frame " << i;
    for (const bool d : plain) dark += d ? 1 : 0;
  }
  EXPECT_GT(dark, 100000);
}

TEST(RtlTileThreshold, TakesAPixelAClockAndEightRowsToEnd) {
  Bench bench;
  std::mt19937_64 random(73);
  const Frame frame = random_frame(640, 480, random);
  ASSERT_EQ(bench.run(frame, 20, 100, 100), plain_dark(frame, 20));
  EXPECT_LE(bench.cycles, 640U * 488 + 8);
}

}  // namespace
}  // namespace runmark::rtl
