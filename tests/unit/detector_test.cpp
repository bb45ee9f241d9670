#include "runmark/detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support/corners.h"
#include "support/picture.h"

namespace runmark {
namespace {

using test::worst_corner;

Dictionary dictionary(const char* name) {
  auto loaded = builtin_dictionary(name);
  EXPECT_TRUE(loaded) << loaded.error();
  return *loaded;
}

Detector make(Options options, std::vector<Dictionary> dictionaries, int width, int height) {
  options.max_width = width;
  options.max_height = height;
  auto detector = Detector::create(options, std::move(dictionaries));
  EXPECT_TRUE(detector) << detector.error();
  return std::move(*detector);
}

TEST(Detector, ReadsEveryLayoutInOrderAtAnyAngle) {
  for (const char* name :
       {"DICT_4X4_50", "DICT_5X5_50", "DICT_6X6_50", "DICT_7X7_50", "tag16h5", "tag36h11",
        "DICT_ARUCO_ORIGINAL", "ARUCO_MIP_36h12", "tagStandard41h12", "tagCircle21h7", "tagCustom48h12"}) {
    const Dictionary d = dictionary(name);
    Detector detector = make({}, {d}, 200, 200);
    for (const double degrees : {0.0, 30.0, 90.0, 135.0, 200.0}) {
      const auto truth = test::turned_square({100.5, 99.25}, 60, degrees);
      test::Picture picture(200, 200, 220);
      test::draw_at(picture, d, 7, truth);
      const Detection found = detector.detect(picture.view());
      ASSERT_EQ(found.status, Status::ok);
      ASSERT_EQ(found.markers.size(), 1U) << name << " at " << degrees;
      EXPECT_EQ(found.markers[0].id, 7) << name;
      EXPECT_EQ(found.markers[0].dictionary, name);
      EXPECT_EQ(found.markers[0].hamming, 0) << name << " at " << degrees;
      EXPECT_FALSE(found.markers[0].inverted);
      EXPECT_LT(worst_corner(found.markers[0], truth), 0.15) << name << " at " << degrees;
    }
  }
}

TEST(Detector, InvertedMarkersByOption) {
  const Dictionary d = dictionary("tag36h11");
  const auto truth = test::turned_square({100.5, 99.25}, 60, 12);
  test::Picture picture(200, 200, 30);
  test::draw_at(picture, d, 3, truth, true);
  EXPECT_TRUE(make({}, {d}, 200, 200).detect(picture.view()).markers.empty());
  Detector detector = make({.inverted = true}, {d}, 200, 200);
  const Detection found = detector.detect(picture.view());
  ASSERT_EQ(found.markers.size(), 1U);
  EXPECT_EQ(found.markers[0].id, 3);
  EXPECT_TRUE(found.markers[0].inverted);
  EXPECT_LT(worst_corner(found.markers[0], truth), 0.15);
}

TEST(Detector, PaperPipelineReadsUprightMarkers) {
  const Dictionary d = dictionary("DICT_6X6_50");
  for (const double degrees : {0.0, 2.0, 90.0, 180.0, 268.0}) {
    const auto truth = test::turned_square({100.5, 99.25}, 64, degrees);
    test::Picture picture(200, 200, 220);
    test::draw_at(picture, d, 11, truth);
    Detector detector = make({.pipeline = Pipeline::paper}, {d}, 200, 200);
    const Detection found = detector.detect(picture.view());
    ASSERT_EQ(found.markers.size(), 1U) << degrees;
    EXPECT_EQ(found.markers[0].id, 11);
    EXPECT_LT(worst_corner(found.markers[0], truth), 3) << degrees;
  }
}

TEST(Detector, PaperPipelineRefusesOtherGridsByName) {
  Options options;
  options.pipeline = Pipeline::paper;
  const auto refused = Detector::create(options, {dictionary("DICT_4X4_50")});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("DICT_4X4_50"), std::string::npos);
}

TEST(Detector, HardwarePipelineReadsMarkersAtAnyAngle) {
  for (const char* name : {"DICT_4X4_50", "DICT_5X5_50", "DICT_6X6_50", "DICT_7X7_50", "tag36h11"}) {
    const Dictionary d = dictionary(name);
    Detector detector = make({.pipeline = Pipeline::hardware}, {d}, 200, 200);
    for (double degrees = 0; degrees < 360; degrees += 40) {
      const auto truth = test::turned_square({100.5, 99.25}, 60, degrees);
      test::Picture picture(200, 200, 220);
      test::draw_at(picture, d, 7, truth);
      const Detection found = detector.detect(picture.view());
      ASSERT_EQ(found.markers.size(), 1U) << name << " at " << degrees;
      EXPECT_EQ(found.markers[0].id, 7) << name;
      EXPECT_EQ(found.markers[0].dictionary, name);
      EXPECT_EQ(found.markers[0].hamming, 0) << name << " at " << degrees;
      EXPECT_LT(worst_corner(found.markers[0], truth), 0.8) << name << " at " << degrees;
      for (const Point& corner : found.markers[0].corners) {
        EXPECT_EQ(corner.x * 16, std::floor(corner.x * 16)) << "sixteenths of a pixel";
      }
    }
  }
}

TEST(Detector, HardwarePipelineInvertedAndSizeByOption) {
  const Dictionary d = dictionary("tag36h11");
  const auto truth = test::turned_square({100.5, 99.25}, 60, 12);
  test::Picture picture(200, 200, 30);
  test::draw_at(picture, d, 3, truth, true);
  Options options{.pipeline = Pipeline::hardware};
  EXPECT_TRUE(make(options, {d}, 200, 200).detect(picture.view()).markers.empty());
  options.inverted = true;
  Detector detector = make(options, {d}, 200, 200);
  const Detection found = detector.detect(picture.view());
  ASSERT_EQ(found.markers.size(), 1U);
  EXPECT_EQ(found.markers[0].id, 3);
  EXPECT_TRUE(found.markers[0].inverted);
  EXPECT_LT(worst_corner(found.markers[0], truth), 0.8);
  options.min_marker_size = 80;
  EXPECT_TRUE(make(options, {d}, 200, 200).detect(picture.view()).markers.empty());
  options.min_marker_size = 8;
  options.max_marker_size = 50;
  EXPECT_TRUE(make(options, {d}, 200, 200).detect(picture.view()).markers.empty());
}

TEST(Detector, HardwarePipelineRefusesOtherLayoutsByName) {
  Options options;
  options.pipeline = Pipeline::hardware;
  const auto refused = Detector::create(options, {dictionary("tagStandard41h12")});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().find("tagStandard41h12"), std::string::npos);
}

TEST(Detector, PaperPipelineReadsTemplateFiles) {
  const auto d = parse_codes("8 0\nborder included\n0x007e424a5242 7e00\n", "broken");
  EXPECT_FALSE(d);
  auto templates = parse_codes("8 0\nborder included\n007e5e465e7a7e00\n", "mine");
  ASSERT_TRUE(templates) << templates.error();
  const auto truth = test::turned_square({100.5, 99.25}, 64, 0);
  test::Picture picture(200, 200, 220);
  test::draw_at(picture, *templates, 0, truth);
  Detector detector = make({.pipeline = Pipeline::paper}, {*templates}, 200, 200);
  ASSERT_EQ(detector.detect(picture.view()).markers.size(), 1U);
}

TEST(Detector, OptionsOutOfRangeAreNamed) {
  const auto complaint_about = [](Options options) {
    const auto refused = Detector::create(options, {dictionary("tag36h11")});
    return refused ? std::string() : refused.error();
  };
  EXPECT_NE(complaint_about({.max_width = 0}).find("max_width 0"), std::string::npos);
  EXPECT_NE(complaint_about({.max_height = 70000}).find("max_height 70000"), std::string::npos);
  EXPECT_NE(complaint_about({.region = {0, 0, 5, 0}}).find("region"), std::string::npos);
  EXPECT_NE(complaint_about({.min_marker_size = 1}).find("marker size"), std::string::npos);
  EXPECT_NE(complaint_about({.corrected_bits = 99}).find("corrected_bits 99"), std::string::npos);
  EXPECT_NE(complaint_about({.min_margin = 2}).find("min_margin"), std::string::npos);
  EXPECT_NE(complaint_about({.fixed_threshold = 300}).find("fixed_threshold 300"), std::string::npos);
  EXPECT_NE(complaint_about({.octaves = 9}).find("octaves 9"), std::string::npos);
  EXPECT_FALSE(Detector::create({}, {})) << "no dictionary";
}

TEST(Detector, ConnectivityAndFilterByOption) {
  // Two dark squares that meet at a corner: one contour or two.
  test::Picture picture(64, 64, 220);
  for (int i = 10; i < 30; ++i) {
    for (int j = 10; j < 30; ++j) picture.at(i, j) = picture.at(i + 20, j + 20) = 20;
  }
  picture.at(50, 10) = 20;  // and a lone pixel
  const auto contours = [&](Options options) {
    options.pipeline = Pipeline::paper;
    Detector detector = make(options, {dictionary("DICT_6X6_50")}, 64, 64);
    EXPECT_EQ(detector.detect(picture.view()).status, Status::ok);
    return detector.stats().closed_chains;
  };
  EXPECT_EQ(contours({.filter = filter_none, .connectivity = Connectivity::eight}), 2U);
  EXPECT_EQ(contours({.filter = filter_none, .connectivity = Connectivity::four}), 3U);
  EXPECT_EQ(contours({.filter = filter_lone_object, .connectivity = Connectivity::eight}), 1U);
}

TEST(Detector, FramesItCannotTakeAreErrorValues) {
  Detector detector = make({}, {dictionary("tag36h11")}, 64, 48);
  const test::Picture wide(65, 48, 0);
  const test::Picture high(64, 49, 0);
  EXPECT_EQ(detector.detect(wide.view()).status, Status::frame_too_large);
  EXPECT_EQ(detector.detect(high.view()).status, Status::frame_too_large);
  EXPECT_EQ(detector.detect(ImageView{}).status, Status::bad_view);
  const test::Picture fits(64, 48, 0);
  EXPECT_EQ(detector.detect(fits.view()).status, Status::ok) << "and the next good frame is right";
}

TEST(Detector, StepsOfAnySizeAreTaken) {
  Detector detector = make({}, {dictionary("tag36h11")}, 1, 20);
  const std::vector<std::uint8_t> column(20, 128);
  for (const int step : {std::numeric_limits<int>::min(), -1, std::numeric_limits<int>::max()}) {
    EXPECT_EQ(detector.detect(ImageView::grey(column.data(), 1, 20, 1, step)).status, Status::ok) << step;
  }
}

/// A scene of several markers over a noisy gradient.
void draw_scene(test::Picture& picture, const Dictionary& d) {
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = static_cast<std::uint8_t>(120 + (x * 5 + y * 3) % 90);
    }
  }
  test::draw_at(picture, d, 1, test::turned_square({60, 60}, 50, 10));
  test::draw_at(picture, d, 2, test::turned_square({190, 70}, 80, 33));
  test::draw_at(picture, d, 3, {{{30, 130}, {90, 140}, {80, 200}, {25, 190}}});
  test::draw_at(picture, d, 1, test::turned_square({160, 180}, 30, 50));
  test::draw_at(picture, d, 5, test::turned_square({250, 200}, 20, 0));
  std::mt19937 random(5);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) = static_cast<std::uint8_t>(
          std::clamp<int>(picture.at(x, y) + static_cast<int>(random() % 9) - 4, 0, 255));
    }
  }
}

void expect_same(std::span<const Marker> a, std::span<const Marker> b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].id, b[i].id);
    EXPECT_EQ(a[i].hamming, b[i].hamming);
    EXPECT_EQ(a[i].margin, b[i].margin);
    EXPECT_EQ(a[i].row, b[i].row);
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(a[i].corners[c].x, b[i].corners[c].x);
      EXPECT_EQ(a[i].corners[c].y, b[i].corners[c].y);
    }
  }
}

TEST(Detector, StreamingRowsGivesTheSameMarkersAndNeverWithdraws) {
  const Dictionary d = dictionary("DICT_6X6_50");
  test::Picture picture(300, 240, 128);
  draw_scene(picture, d);
  std::mt19937 random(9);
  for (const Pipeline pipeline : {Pipeline::paper, Pipeline::hardware, Pipeline::standard}) {
    for (const bool copy : {false, true}) {
      Options options;
      options.pipeline = pipeline;
      options.copy_rows = copy;
      Detector whole = make(options, {d}, 300, 240);
      Detector streamed = make(options, {d}, 300, 240);
      const Detection expected = whole.detect(picture.view());
      if (pipeline != Pipeline::paper) {
        EXPECT_EQ(expected.markers.size(), 5U) << "two copies of id 1 are both reported";
      }
      for (int round = 0; round < 20; ++round) {
        ASSERT_EQ(streamed.begin(300, 240), Status::ok);
        std::vector<Marker> before;
        for (int y = 0; y < 240;) {
          const int chunk = std::min(1 + static_cast<int>(random() % 40), 240 - y);
          if (copy) {
            // Memory that is gone after the call.
            const ImageView rows = picture.view().rows(y, chunk);
            std::vector<std::uint8_t> passing(rows.data, rows.data + chunk * 300);
            ASSERT_EQ(streamed.push_rows(ImageView::grey(passing.data(), 300, chunk, 300)), Status::ok);
          } else {
            ASSERT_EQ(streamed.push_rows(picture.view().rows(y, chunk)), Status::ok);
          }
          y += chunk;
          const auto now = streamed.markers();
          ASSERT_GE(now.size(), before.size());
          expect_same(now.first(before.size()), before);
          before.assign(now.begin(), now.end());
          for (const Marker& marker : now) EXPECT_LT(marker.row, y);
        }
        ASSERT_EQ(streamed.end(), Status::ok);
        expect_same(streamed.markers(), expected.markers);
      }
    }
  }
}

TEST(Detector, StreamingCallsOutOfOrderAreRefused) {
  Detector detector = make({}, {dictionary("tag36h11")}, 64, 48);
  const test::Picture picture(64, 48, 200);
  EXPECT_EQ(detector.push_rows(picture.view()), Status::wrong_order);
  EXPECT_EQ(detector.end(), Status::wrong_order);
  ASSERT_EQ(detector.begin(64, 48), Status::ok);
  EXPECT_EQ(detector.begin(64, 48), Status::wrong_order);
  ASSERT_EQ(detector.push_rows(picture.view().rows(0, 40)), Status::ok);
  EXPECT_EQ(detector.push_rows(picture.view().rows(0, 9)), Status::wrong_order)
      << "more rows than the frame has";
  EXPECT_EQ(detector.end(), Status::wrong_order) << "rows are missing";
  EXPECT_EQ(detector.detect(picture.view()).status, Status::ok) << "the next frame is as new";
}

TEST(Detector, EveryPixelFormatAndRegion) {
  const Dictionary d = dictionary("DICT_6X6_50");
  test::Picture picture(300, 240, 128);
  draw_scene(picture, d);
  Detector detector = make({}, {d}, 300, 240);
  const auto expected_span = detector.detect(picture.view()).markers;
  const std::vector<Marker> expected(expected_span.begin(), expected_span.end());

  std::vector<std::uint8_t> bytes(300 * 240 * 4);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 300; ++x) {
      for (int c = 0; c < 4; ++c) bytes[static_cast<std::size_t>((y * 300 + x) * 4 + c)] = picture.at(x, y);
    }
  }
  expect_same(detector.detect(ImageView::grey(bytes.data(), 300, 240, 1200, 4)).markers, expected);
  expect_same(detector.detect(ImageView::rgb(bytes.data(), 300, 240, 1200, 4)).markers, expected);
  expect_same(detector.detect(ImageView::bgr(bytes.data(), 300, 240, 1200, 4)).markers, expected);

  // Stored mirrored, and stored by columns.
  std::vector<std::uint8_t> other(300 * 240);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 300; ++x) other[static_cast<std::size_t>(y * 300 + 299 - x)] = picture.at(x, y);
  }
  expect_same(detector.detect(ImageView::grey(other.data() + 299, 300, 240, 300, -1)).markers, expected);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 300; ++x) other[static_cast<std::size_t>(x * 240 + y)] = picture.at(x, y);
  }
  expect_same(detector.detect(ImageView::grey(other.data(), 300, 240, 1, 240)).markers, expected);

  Detector inside = make({.region = {120, 10, 180, 120}}, {d}, 300, 240);
  const Detection found = inside.detect(picture.view());
  ASSERT_EQ(found.markers.size(), 1U);
  EXPECT_EQ(found.markers[0].id, 2);
  EXPECT_LT(worst_corner(found.markers[0], test::turned_square({190, 70}, 80, 33)), 0.3)
      << "in pixels of the frame";
}

TEST(Detector, RejectedSquaresByOption) {
  const Dictionary d = dictionary("DICT_6X6_50");
  const auto marker = test::turned_square({80, 80}, 64, 0);
  const auto empty = test::turned_square({200, 120}, 64, 0);
  test::Picture picture(300, 240, 220);
  test::draw_at(picture, d, 7, marker);
  for (int y = 88; y < 152; ++y) {
    for (int x = 168; x < 232; ++x) picture.at(x, y) = 30;
  }
  EXPECT_TRUE(make({}, {d}, 300, 240).detect(picture.view()).status == Status::ok);
  for (const Pipeline pipeline : {Pipeline::standard, Pipeline::hardware, Pipeline::paper}) {
    for (const int left : {0, 10}) {  // in pixels of the frame, wherever the region begins
      Detector plain = make({.pipeline = pipeline}, {d}, 300, 240);
      Detector detector = make(
          {.pipeline = pipeline, .region = {left, 0, 300 - left, 240}, .keep_rejected = true}, {d}, 300, 240);
      ASSERT_EQ(plain.detect(picture.view()).markers.size(), 1U);
      EXPECT_TRUE(plain.rejected().empty());
      EXPECT_GT(detector.memory(), plain.memory());
      ASSERT_EQ(detector.detect(picture.view()).markers.size(), 1U);
      ASSERT_EQ(detector.rejected().size(), 1U)
          << "the empty square, once for all scales, and not the marker";
      Marker rejected;
      rejected.corners = detector.rejected()[0];
      const auto top_left = std::ranges::min_element(rejected.corners, {}, [](Point p) { return p.x + p.y; });
      std::rotate(rejected.corners.begin(), top_left, rejected.corners.end());
      EXPECT_LT(worst_corner(rejected, empty), 1.5);
    }
  }
}

TEST(Detector, SizesBeyondAnyFrameAreNoSizes) {
  for (const Pipeline pipeline : {Pipeline::standard, Pipeline::paper, Pipeline::hardware}) {
    Options options;
    options.pipeline = pipeline;
    options.max_width = options.max_height = 64;
    options.min_marker_size = 1e12;
    options.max_marker_size = 1e300;
    auto detector = Detector::create(options, {*builtin_dictionary("DICT_6X6_50")});
    ASSERT_TRUE(detector) << detector.error();
    const std::vector<std::uint8_t> grey(64 * 64, 20);
    EXPECT_EQ(detector->detect(ImageView::grey(grey.data(), 64, 64, 64)).markers.size(), 0U);
  }
}

TEST(Detector, SizesOutsideTheLimitsAreNotReported) {
  const Dictionary d = dictionary("DICT_6X6_50");
  test::Picture picture(300, 240, 128);
  draw_scene(picture, d);
  Detector large = make({.min_marker_size = 40}, {d}, 300, 240);
  for (const Marker& marker : large.detect(picture.view())) {
    EXPECT_GT(
        std::hypot(marker.corners[1].x - marker.corners[0].x, marker.corners[1].y - marker.corners[0].y), 35);
  }
  EXPECT_EQ(large.detect(picture.view()).markers.size(), 3U);
  Detector small = make({.max_marker_size = 40}, {d}, 300, 240);
  EXPECT_EQ(small.detect(picture.view()).markers.size(), 2U);
}

}  // namespace
}  // namespace runmark
