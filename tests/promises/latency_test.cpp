// How many rows after its last one a marker is given out.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "scenes.h"

namespace runmark::test {
namespace {

struct Latency {
  double least_size;
  int markers = 0;
  int worst = 0;
  int late = 0;  // more than 24 rows
};

double size_of(const Marker& marker) {
  double twice_area = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point& a = marker.corners[i];
    const Point& b = marker.corners[(i + 1) % 4];
    twice_area += a.x * b.y - b.x * a.y;
  }
  return std::sqrt(std::abs(twice_area) / 2);
}

/// Rows from the last one the black square touches to the one after which the marker was there.
int rows_late(const Marker& marker) {
  double lowest = 0;
  for (const Point& corner : marker.corners) lowest = std::max(lowest, corner.y);
  return marker.row - static_cast<int>(std::floor(lowest + 0.5));
}

/// By size of marker, the largest first.
using Latencies = std::array<Latency, 7>;

void take(Latencies& sizes, const Marker& marker) {
  Latency& bucket = *std::ranges::find_if(
      sizes, [size = size_of(marker)](const Latency& l) { return size >= l.least_size; });
  const int late = rows_late(marker);
  ++bucket.markers;
  bucket.worst = std::max(bucket.worst, late);
  if (late > 24) ++bucket.late;
}

/// Streams the scene row by row.
void add_scene(Latencies& sizes, const render::RenderedFrame& scene) {
  Detector detector = make_detector({}, scene.width, scene.height);
  ASSERT_EQ(detector.begin(scene.width, scene.height), Status::ok);
  std::size_t before = 0;
  for (int y = 0; y < scene.height; ++y) {
    ASSERT_EQ(detector.push_rows(view_of(scene).rows(y, 1)), Status::ok);
    const auto markers = detector.markers();
    for (; before < markers.size(); ++before) {
      ASSERT_EQ(markers[before].row, y);
      take(sizes, markers[before]);
    }
  }
  ASSERT_EQ(detector.end(), Status::ok);
}

int print_worst(const char* title, const Latencies& sizes) {
  int worst = 0;
  for (const Latency& bucket : sizes) {
    std::printf("  %s, from %3.0f px: %4d markers, at most %2d rows, %d of them more than 24\n", title,
                bucket.least_size, bucket.markers, bucket.worst, bucket.late);
    worst = std::max(worst, bucket.worst);
  }
  return worst;
}

constexpr Latencies no_markers{{{200}, {128}, {64}, {32}, {24}, {16}, {0}}};

TEST(Latency, AtMost24RowsInTheStandardSets) {
  Latencies sizes = no_markers;
  for (const auto& [set, scenes] : {std::pair("vga", 20), std::pair("hd", 4), std::pair("fullhd", 1)}) {
    for (int i = 0; i < scenes; ++i) add_scene(sizes, scene_of(set, i));
  }
  EXPECT_LE(print_worst("standard sets", sizes), 24);
  for (const Latency& bucket : sizes) EXPECT_GT(bucket.markers, 0);
}

// At a quarter of the size a row's contours wait for up to seven further rows, which are 28 of the frame's.
TEST(Latency, AtMost32RowsOutOfFocus) {
  Latencies sizes = no_markers;
  for (int i = 0; i < 6; ++i) add_scene(sizes, blurred_scene(i));
  EXPECT_LE(print_worst("out of focus", sizes), 32);
}

}  // namespace
}  // namespace runmark::test
