#include <gtest/gtest.h>

#include "corner/corner_state_machine.h"
#include "frames.h"
#include "threshold/fixed_threshold.h"
#include "threshold/grey.h"

namespace runmark::hls_form {
namespace {

TEST(HlsThreshold, IsThePlainCore) {
  std::mt19937_64 random(81);
  for (int i = 0; i < 20; ++i) {
    Settings settings;
    settings.width = 1 + static_cast<int>(random() % 50);
    settings.height = 1 + static_cast<int>(random() % 20);
    settings.level = static_cast<int>(random() % 257);
    settings.above_is_dark = i % 3 == 0;
    settings.rgb = i % 2 == 0;
    std::vector<std::uint32_t> frame(static_cast<std::size_t>(settings.width * settings.height));
    for (auto& pixel : frame) pixel = static_cast<std::uint32_t>(random());
    PixelStream pixels("pixels");
    BitStream dark("dark");
    GreyStream grey("grey");
    const std::jthread feeder([&] {
      for (const auto pixel : frame) pixels.write(pixel);
    });
    const std::jthread core([&] { threshold(settings, pixels, dark, grey); });
    const FixedThreshold plain{settings.level, settings.above_is_dark};
    for (const std::uint32_t pixel : frame) {
      const auto level = settings.rgb ? grey_of(pixel & 255, pixel >> 8 & 255, pixel >> 16 & 255)
                                      : static_cast<std::uint8_t>(pixel & 255);
      ASSERT_EQ(dark.read() != 0, plain.dark(level));
      ASSERT_EQ(grey.read(), level);
    }
  }
}

/// The runs of every crack line by the plain cores, as the words the core writes.
std::vector<Word> plain_runs(const PixelImage& image, const Settings& settings) {
  const std::size_t words = bit_words(image.width());
  std::vector<std::vector<BitWord>> raw(static_cast<std::size_t>(image.height()) + 2,
                                        std::vector<BitWord>(words));
  for (int y = 0; y < image.height(); ++y) {
    auto& row = raw[static_cast<std::size_t>(y) + 1];
    for (int x = 0; x < image.width(); ++x) set_bit(row.data(), x, image.dark(x, y));
    clear_border(row.data(), image.width(), y, image.height());
  }
  std::vector<BitWord> above(words);
  std::vector<BitWord> current(words);
  std::vector<CrackRun> runs(max_crack_runs(image.width()));
  std::vector<Word> all;
  for (int y = 0; y < image.height(); ++y) {
    const auto i = static_cast<std::size_t>(y);
    filter_row(raw[i].data(), raw[i + 1].data(), raw[i + 2].data(), image.width(), settings.cases,
               current.data());
    const auto connectivity = settings.eight ? Connectivity::eight : Connectivity::four;
    const std::size_t count =
        find_crack_runs(above.data(), current.data(), image.width(), connectivity, runs);
    for (std::size_t k = 0; k < count; ++k) all.push_back(run_word(runs[k]));
    all.push_back(line_end_word(y, y == image.height() - 1));
    above.swap(current);
  }
  return all;
}

void expect_plain_runs(const PixelImage& image, const Settings& settings) {
  BitStream dark("dark");
  RunStream runs("runs");
  const std::jthread feeder([&] { send(image, dark); });
  const std::jthread core([&] { preprocess(settings, dark, runs); });
  for (const Word word : plain_runs(image, settings)) {
    ASSERT_EQ(runs.read(), word) << image.width() << " x " << image.height();
  }
  EXPECT_TRUE(runs.empty());
}

TEST(HlsPreprocess, IsThePlainCoreOnEveryImageOf3x3) {
  for (unsigned bits = 0; bits < 512; ++bits) {
    PixelImage image(5, 5);
    for (int i = 0; i < 9; ++i) image.set(1 + i % 3, 1 + i / 3, (bits >> i & 1U) != 0);
    Settings settings = settings_of(image);
    settings.cases = bits % 2 == 0 ? 63 : 0;
    settings.eight = bits % 4 < 2;
    ASSERT_NO_FATAL_FAILURE(expect_plain_runs(image, settings));
  }
}

TEST(HlsPreprocess, IsThePlainCoreOnRandomFrames) {
  std::mt19937_64 random(82);
  for (int i = 0; i < 300; ++i) {
    const auto [image, settings] = random_frame(i, random);
    ASSERT_NO_FATAL_FAILURE(expect_plain_runs(image, settings));
  }
}

TEST(HlsContour, IsThePlainCoreOnRandomFrames) {
  std::mt19937_64 random(83);
  std::size_t compared = 0;
  for (int i = 0; i < 300; ++i) {
    const auto [image, settings] = random_frame(i, random);
    std::vector<std::pair<Chain, bool>> plain;
    plain_chains(image, settings,
                 [&](const ClosedChain& closed) { plain.emplace_back(chain_of(closed), closed.hole); });
    BitStream dark("dark");
    RunStream runs("runs");
    ChainStream chains("chains");
    const std::jthread feeder([&, &image = image] { send(image, dark); });
    const std::jthread before([&, &settings = settings] { preprocess(settings, dark, runs); });
    const std::jthread core([&, &settings = settings] { contour(settings, runs, chains); });
    for (const auto& [chain, hole] : plain) {
      for (std::size_t k = 0; k < chain.size(); ++k) {
        const bool tail = k + 1 == chain.size();
        ASSERT_EQ(chains.read(), record_word(static_cast<unsigned>(chain[k].first),
                                             static_cast<unsigned>(chain[k].second), tail, hole))
            << "frame " << i;
      }
      ++compared;
    }
    ASSERT_EQ(chains.read(), frame_end) << "frame " << i;
  }
  EXPECT_GT(compared, 500U);
}

TEST(HlsCorner, IsThePlainCoreOnRandomFrames) {
  std::mt19937_64 random(84);
  std::size_t quads_compared = 0;
  for (int i = 0; i < 200; ++i) {
    auto [image, settings] = random_frame(10 * i, random);
    settings.corner_offset = 1 + static_cast<int>(random() % 6);
    std::vector<Word> plain;
    std::vector<std::pair<Chain, bool>> given;
    plain_chains(image, settings, [&](const ClosedChain& closed) {
      given.emplace_back(chain_of(closed), closed.hole);
      const auto corners = four_corners(closed, settings.corner_offset);
      if (!corners) return;
      plain.push_back(places_word((*corners)[0], (*corners)[1]));
      plain.push_back(places_word((*corners)[2], (*corners)[3]));
      plain.push_back(quad_word(closed.bottom, closed.hole));
      ++quads_compared;
    });
    ChainStream chains("chains");
    QuadStream quads("quads");
    const std::jthread feeder([&] {
      for (const auto& [chain, hole] : given) {
        for (std::size_t k = 0; k < chain.size(); ++k) {
          chains.write(record_word(static_cast<unsigned>(chain[k].first),
                                   static_cast<unsigned>(chain[k].second), k + 1 == chain.size(), hole));
        }
      }
      chains.write(frame_end);
    });
    const std::jthread core([&, &settings = settings] { corner(settings, chains, quads); });
    for (const Word word : plain) ASSERT_EQ(quads.read(), word) << "frame " << i;
    ASSERT_EQ(quads.read(), frame_end) << "frame " << i;
  }
  EXPECT_GT(quads_compared, 50U);
}

}  // namespace
}  // namespace runmark::hls_form
