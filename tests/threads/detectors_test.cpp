// One detector a thread, many threads at once: each finds what a detector alone finds. Sharing one is refused
// by the compiler: it cannot be copied, and nothing that changes it can be called through a constant
// reference.

#include <gtest/gtest.h>

#include <concepts>
#include <thread>
#include <type_traits>

#include "runmark/detector.h"
#include "support/picture.h"

namespace runmark {
namespace {

static_assert(!std::is_copy_constructible_v<Detector> && !std::is_copy_assignable_v<Detector>);
static_assert(std::is_nothrow_move_constructible_v<Detector> && std::is_nothrow_move_assignable_v<Detector>);

template <class Reader>
concept Detects = requires(Reader& reader, const ImageView& view) {
  reader.detect(view);
};
template <class Reader>
concept Streams = requires(Reader& reader, const ImageView& view) {
  reader.begin(1, 1);
  reader.push_rows(view);
  reader.end();
};
static_assert(Detects<Detector> && Streams<Detector>);
static_assert(!Detects<const Detector> && !Streams<const Detector>);

constexpr int width = 320;
constexpr int height = 240;

/// Frames with a few markers each, at different places and angles.
const test::Picture& frame(std::size_t index) {
  static const std::vector<std::unique_ptr<test::Picture>> frames = [] {
    std::vector<std::unique_ptr<test::Picture>> made;
    const Dictionary codes = *builtin_dictionary("tag36h11");
    for (int i = 0; i < 3; ++i) {
      made.push_back(std::make_unique<test::Picture>(width, height, std::uint8_t{220}));
      test::draw_at(*made.back(), codes, static_cast<std::size_t>(i),
                    test::turned_square({70, 70}, 60, 2.0 * i));
      test::draw_at(*made.back(), codes, static_cast<std::size_t>(10 + i),
                    test::turned_square({220.0 + i, 150}, 90, 90.0 * i + 1));
    }
    return made;
  }();
  return *frames[index % frames.size()];
}

Detector make_detector(Pipeline pipeline) {
  auto made = Detector::create({.pipeline = pipeline, .max_width = width, .max_height = height},
                               {*builtin_dictionary("tag36h11")});
  EXPECT_TRUE(made) << made.error();
  return *std::move(made);
}

using Ids = std::vector<std::pair<int, double>>;  // and where

Ids detect(Detector& detector, const test::Picture& picture) {
  Ids ids;
  for (const Marker& marker : detector.detect(picture.view()))
    ids.emplace_back(marker.id, marker.corners[0].x);
  return ids;
}

class Threads : public testing::TestWithParam<Pipeline> {};

TEST_P(Threads, OneDetectorEachFromMany) {
  constexpr std::size_t threads = 16;
  constexpr std::size_t rounds = 12;
  std::vector<Ids> expected;
  for (std::size_t i = 0; i < 3; ++i) {
    Detector alone = make_detector(GetParam());
    expected.push_back(detect(alone, frame(i)));
    EXPECT_EQ(expected.back().size(), 2U);
  }
  std::vector<int> wrong(threads, 0);
  std::vector<std::thread> running;
  for (std::size_t t = 0; t < threads; ++t) {
    running.emplace_back([&, t] {
      // Made here, too: making detectors at the same time must be safe as well.
      Detector own = make_detector(GetParam());
      for (std::size_t round = 0; round < rounds; ++round) {
        if (detect(own, frame(t + round)) != expected[(t + round) % expected.size()]) ++wrong[t];
      }
    });
  }
  for (std::thread& thread : running) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(threads, 0));
}

/// A detector may be handed from thread to thread, as long as one has it at a time.
TEST_P(Threads, OneAfterTheOther) {
  Detector detector = make_detector(GetParam());
  const Ids expected = detect(detector, frame(0));
  EXPECT_FALSE(expected.empty());
  for (int i = 0; i < 8; ++i) {
    Ids found;
    std::thread([&] { found = detect(detector, frame(0)); }).join();
    EXPECT_EQ(found, expected);
    Detector moved = std::move(detector);
    detector = std::move(moved);
  }
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Threads,
                         testing::Values(Pipeline::standard, Pipeline::paper, Pipeline::hardware));

}  // namespace
}  // namespace runmark
