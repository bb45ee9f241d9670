// Every capacity exhausted in turn (docs/design.md, fixed capacities): the counts say what was dropped,
// markers away from where it happened are found as ever, and the next frame is as new.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render/draw_marker.h"
#include "scenes.h"

namespace runmark::test {
namespace {

/// A light frame on which things are drawn at whole pixels.
class Sheet {
 public:
  Sheet(int width, int height)
      : width_(width),
        height_(height),
        grey_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 230) {}

  std::uint8_t& at(int x, int y) {
    return grey_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
  }
  void draw(const Dictionary& dictionary, std::size_t id, int left, int top, int pixels) {
    const MarkerDrawing drawing = draw_marker(dictionary, id, pixels, 1);
    for (int y = 0; y < drawing.side; ++y) {
      for (int x = 0; x < drawing.side; ++x) {
        at(left + x, top + y) = drawing.grey[static_cast<std::size_t>(y * drawing.side + x)] > 127 ? 230 : 20;
      }
    }
  }
  /// Upright dark lines two pixels wide that step to the side in every row: each row makes four records a
  /// line, and no outline closes before the last.
  void draw_zigzags(int left, int right, int top, int bottom) {
    for (int y = top; y < bottom; ++y) {
      const int shift = std::abs(y % 8 - 4);
      for (int x = left; x + 12 < right; x += 8) {
        at(x + shift, y) = 20;
        at(x + shift + 1, y) = 20;
      }
    }
  }
  [[nodiscard]] ImageView view() const { return ImageView::grey(grey_.data(), width_, height_, width_); }

 private:
  int width_;
  int height_;
  std::vector<std::uint8_t> grey_;
};

struct Found {
  std::vector<std::array<double, 9>> markers;  ///< id and corners, sorted
  FrameStats stats;

  [[nodiscard]] std::vector<int> ids() const {
    std::vector<int> result;
    for (const auto& marker : markers) result.push_back(static_cast<int>(marker[0]));
    return result;
  }
};

Found found_in(Detector& detector, const ImageView& view) {
  const Detection detection = detector.detect(view);
  EXPECT_EQ(detection.status, Status::ok);
  Found found;
  for (const Marker& m : detection) {
    const auto& c = m.corners;
    found.markers.push_back(
        {static_cast<double>(m.id), c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y, c[3].x, c[3].y});
  }
  std::ranges::sort(found.markers);
  found.stats = detector.stats();
  return found;
}

/// A detector that has just run out of something gives for this frame what a new one gives.
void expect_as_new(Detector& detector, const ImageView& view, const Options& options) {
  Detector fresh = make_detector(options, options.max_width, options.max_height);
  const Found wanted = found_in(fresh, view);
  const Found found = found_in(detector, view);
  EXPECT_GT(wanted.markers.size(), 0U);
  EXPECT_EQ(found.markers, wanted.markers);
  EXPECT_EQ(found.stats.crack_runs, wanted.stats.crack_runs);
  EXPECT_EQ(found.stats.closed_chains, wanted.stats.closed_chains);
  EXPECT_EQ(found.stats.dropped_chains, 0U);
  EXPECT_EQ(found.stats.dropped_markers, 0U);
}

class Capacities : public testing::TestWithParam<Pipeline> {
 protected:
  /// Options for frames of that size.
  static Options sized(int width, int height) {
    Options options;
    options.pipeline = GetParam();
    options.max_width = width;
    options.max_height = height;
    return options;
  }
};

TEST_P(Capacities, FrameSize) {
  const Options options = sized(320, 240);
  Sheet good(320, 240);
  good.draw(dictionary("tag36h11"), 5, 40, 40, 8);
  const Sheet large(321, 240);
  Detector detector = make_detector(options, 320, 240);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(detector.detect(large.view()).status, Status::frame_too_large);
    expect_as_new(detector, good.view(), options);
    EXPECT_EQ(detector.begin(320, 241), Status::frame_too_large);
    expect_as_new(detector, good.view(), options);
  }
}

TEST_P(Capacities, Records) {
  constexpr int width = 1280;
  constexpr int height = 1000;
  const Options options = sized(width, height);
  const Dictionary codes = dictionary("tag36h11");
  Sheet quiet(width, height);
  const auto draw_markers = [&](Sheet& sheet) {
    sheet.draw(codes, 3, 100, 20, 8);
    sheet.draw(codes, 4, 900, 30, 8);
    sheet.draw(codes, 5, 300, height - 130, 9);
    sheet.draw(codes, 6, 700, height - 140, 10);
  };
  draw_markers(quiet);
  Sheet crowded(width, height);
  draw_markers(crowded);
  crowded.draw_zigzags(20, width - 20, 150, height - 180);
  Detector detector = make_detector(options, width, height);
  const Found wanted = found_in(detector, quiet.view());
  EXPECT_EQ(wanted.ids(), (std::vector{3, 4, 5, 6}));
  EXPECT_EQ(wanted.stats.dropped_chains, 0U);
  const Found found = found_in(detector, crowded.view());
  EXPECT_GT(found.stats.dropped_chains, 0U);
  EXPECT_EQ(found.markers, wanted.markers) << "above and below the crowd";
  expect_as_new(detector, quiet.view(), options);
}

/// A ring whose sides step in every row: longer than any marker's outline may be, round a marker.
TEST_P(Capacities, RecordsOfOneChain) {
  constexpr int width = 1280;  // so wide that there are records enough for it
  constexpr int height = 2400;
  Options options = sized(width, height);
  options.octaves = 0;  // at half the width there are not
  const Dictionary codes = dictionary("tag36h11");
  Sheet sheet(width, height);
  for (int y = 20; y < height - 20; ++y) {
    const int shift = std::abs(y % 8 - 4);
    for (int x = 0; x < 6; ++x) sheet.at(20 + shift + x, y) = sheet.at(1240 + shift + x, y) = 20;
  }
  for (int x = 20; x < 1250; ++x) {
    for (int y = 0; y < 6; ++y) sheet.at(x, 20 + y) = sheet.at(x, height - 26 + y) = 20;
  }
  sheet.draw(codes, 9, 120, 200, 12);
  sheet.draw(codes, 10, 120, 2200, 12);
  Detector detector = make_detector(options, width, height);
  EXPECT_EQ(found_in(detector, sheet.view()).ids(), (std::vector{9, 10}));
  expect_as_new(detector, sheet.view(), options);
}

TEST_P(Capacities, MarkersOfAFrame) {
  constexpr std::size_t most = 2048;
  constexpr int pitch = 32;
  constexpr int columns = 60;
  constexpr int rows = 45;
  const Options options = sized(columns * pitch, rows * pitch);
  const Dictionary codes = dictionary("tag36h11");
  Sheet sheet(columns * pitch, rows * pitch);
  std::vector<int> ids;
  for (int i = 0; i < columns * rows; ++i) {
    const int id = i % static_cast<int>(codes.codes.size());
    sheet.draw(codes, static_cast<std::size_t>(id), i % columns * pitch + 1, i / columns * pitch + 1, 3);
    ids.push_back(id);
  }
  Detector detector = make_detector(options, options.max_width, options.max_height);
  const Found found = found_in(detector, sheet.view());
  EXPECT_EQ(found.markers.size(), most);
  EXPECT_EQ(found.stats.dropped_markers, ids.size() - most);
  // Those that came first are the ones that are kept: all of the upper rows.
  constexpr int kept_rows = 32;
  std::vector<int> expected(ids.begin(), ids.begin() + std::ptrdiff_t{kept_rows} * columns);
  std::vector<int> upper;
  for (const auto& marker : found.markers) {
    if (marker[2] < kept_rows * pitch) upper.push_back(static_cast<int>(marker[0]));
  }
  std::ranges::sort(expected);
  EXPECT_EQ(upper, expected);
  Sheet good(320, 240);
  good.draw(codes, 5, 40, 40, 8);
  expect_as_new(detector, good.view(), options);
}

/// Rejected squares are there to look at: when there are too many, some are not kept, and no marker is lost.
TEST_P(Capacities, RejectedSquares) {
  constexpr int pitch = 24;
  constexpr int columns = 80;
  constexpr int rows = 60;
  Options options = sized(columns * pitch, rows * pitch);
  options.keep_rejected = true;
  const Dictionary codes = dictionary("tag36h11");
  Sheet sheet(options.max_width, options.max_height);
  for (int i = 0; i < columns * (rows - 5); ++i) {
    for (int y = 4; y < 20; ++y) {
      for (int x = 4; x < 20; ++x) sheet.at(i % columns * pitch + x, i / columns * pitch + y) = 20;
    }
  }
  sheet.draw(codes, 8, 600, (rows - 5) * pitch + 10, 8);
  Detector detector = make_detector(options, options.max_width, options.max_height);
  EXPECT_EQ(found_in(detector, sheet.view()).ids(), std::vector{8});
  const std::size_t kept = detector.rejected().size();
  EXPECT_GT(kept, 100U);
  EXPECT_LT(kept, std::size_t{columns} * (rows - 5));
  Sheet good(320, 240);
  good.draw(codes, 5, 40, 40, 8);
  expect_as_new(detector, good.view(), options);
  EXPECT_LT(detector.rejected().size(), 20U);
}

INSTANTIATE_TEST_SUITE_P(Pipelines, Capacities,
                         testing::Values(Pipeline::standard, Pipeline::paper, Pipeline::hardware),
                         [](const auto& tested) {
                           return tested.param == Pipeline::standard ? "Default"
                                  : tested.param == Pipeline::paper  ? "Paper"
                                                                     : "Hardware";
                         });

/// Data below the square makes a quadrilateral wait for rows to come; more than 256 in one row of markers.
TEST(WaitingQuads, AreReadAtOnceWhenThereAreTooMany) {
  constexpr int pixels = 2;
  constexpr int pitch = 26;
  constexpr int columns = 300;
  const Dictionary codes = dictionary("tagStandard41h12");
  Options options;
  options.max_width = columns * pitch;
  options.max_height = 200;
  auto made = Detector::create(options, {codes});
  ASSERT_TRUE(made) << made.error();
  Sheet sheet(options.max_width, options.max_height);
  std::vector<int> ids;
  for (int i = 0; i < columns; ++i) {
    sheet.draw(codes, static_cast<std::size_t>(i), i * pitch + 1, 80, pixels);
    ids.push_back(i);
  }
  // Away from them: above and below.
  sheet.draw(codes, 500, 1000, 2, 4);
  sheet.draw(codes, 501, 3000, 130, 5);
  const Found found = found_in(*made, sheet.view());
  const std::vector<int> seen = found.ids();
  EXPECT_TRUE(std::ranges::count(seen, 500) == 1 && std::ranges::count(seen, 501) == 1);
  int in_row = 0;
  for (const int id : seen) in_row += id < columns ? 1 : 0;
  std::printf("  %d of %d markers in one row found\n", in_row, columns);
  EXPECT_GE(in_row, 256);
  EXPECT_EQ(found_in(*made, sheet.view()).markers, found.markers);
}

}  // namespace
}  // namespace runmark::test
