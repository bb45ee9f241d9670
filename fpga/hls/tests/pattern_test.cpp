#include <gtest/gtest.h>

#include <thread>

#include "cores.h"
#include "pattern_cases.h"

namespace runmark::hls_form {
namespace {

namespace cases = runmark::pattern;

/// What the core makes of one quad; its answers come from the frame.
std::optional<cases::Found> found_by_core(cases::Case& it, const std::vector<std::uint64_t>& codes) {
  Settings settings;
  settings.width = cases::width;
  settings.height = cases::height;
  settings.level = it.settings.threshold.level;
  settings.above_is_dark = it.settings.threshold.above_is_dark;
  settings.min_area = static_cast<int>(it.settings.min_area);
  settings.max_area = static_cast<int>(it.settings.max_area);
  settings.max_errors = it.settings.max_errors;
  settings.codes = static_cast<int>(codes.size());
  static std::uint64_t book[max_codes];
  std::copy(codes.begin(), codes.end(), book);

  QuadStream quads("quads");
  ReadStream reads("reads");
  GreyStream answers("answers");
  MarkerStream markers("markers");
  const auto& corners = it.quad.corners;
  quads.write(places_word(corners[0], corners[1]));
  quads.write(places_word(corners[2], corners[3]));
  quads.write(quad_word(static_cast<unsigned>(it.quad.bottom), it.quad.hole));
  quads.write(frame_end);
  const std::jthread core([&] { hls_form::pattern(settings, book, quads, reads, answers, markers); });
  const std::jthread memory([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (reads.empty()) {
        std::this_thread::yield();
        continue;
      }
      const std::uint32_t place = reads.read();
      answers.write(it.frame.at(static_cast<int>(place & 0xFFFF), static_cast<int>(place >> 16)));
    }
  });
  const Word first = markers.read();
  if (first == frame_end) return std::nullopt;
  const Word second = markers.read();
  const Word rest = markers.read();
  EXPECT_EQ(markers.read(), frame_end);
  cases::Found found{static_cast<int>(field(rest, 0, 16)),
                     0,
                     static_cast<int>(field(rest, 16, 8)),
                     field(rest, 24, 1) != 0,
                     {place_of(first, 0), place_of(first, 1), place_of(second, 0), place_of(second, 1)}};
  return found;
}

TEST(HlsPattern, IsThePlainCore) {
  const auto dictionary = builtin_dictionary("DICT_6X6_250");
  ASSERT_TRUE(dictionary);
  std::mt19937_64 random(86);
  int matches = 0;
  for (int i = 0; i < 600; ++i) {
    cases::Case it = cases::random_case(i, *dictionary, dictionary->codes.size(), random);
    auto plain = cases::plain_match(it.frame, it.quad, it.settings, dictionary->codes);
    const auto core = found_by_core(it, dictionary->codes);
    ASSERT_EQ(core.has_value(), plain.has_value()) << "quad " << i;
    if (!plain) continue;
    plain->rotation = 0;  // not told apart from the order of the corners
    ASSERT_TRUE(*core == *plain) << "quad " << i << ": id " << core->id << " for " << plain->id;
    ++matches;
  }
  EXPECT_GT(matches, 200);
}

}  // namespace
}  // namespace runmark::hls_form
