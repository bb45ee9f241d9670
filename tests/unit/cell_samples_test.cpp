#include "pattern/cell_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "support/vector_targets.h"

namespace runmark {
namespace {

/// A frame of random pixels with no byte more than they need.
struct RandomFrame {
  RandomFrame(int width, int height, PixelFormat format, int step, std::mt19937& random) {
    const int channels = format == PixelFormat::grey ? 1 : 3;
    const auto bytes = static_cast<std::size_t>((width - 1) * step + channels);
    for (int y = 0; y < height; ++y) {
      lines.emplace_back(bytes);
      for (std::uint8_t& byte : lines.back()) byte = static_cast<std::uint8_t>(random());
    }
    for (const auto& line : lines) rows.push_back(line.data());
    frame = {rows.data(), width, height, step, format};
  }
  std::vector<std::vector<std::uint8_t>> lines;
  std::vector<const std::uint8_t*> rows;
  GreyFrame frame;
};

/// The middles of a marker of that many cells and of two rings round it.
CellPoints middles(int cells) {
  CellPoints points;
  for (int y = -2; y < cells + 2; ++y) {
    for (int x = -2; x < cells + 2; ++x) points.add(x + 0.5, y + 0.5);
  }
  return points;
}

std::vector<float> samples(const GreyFrame& frame, const Homography& place, const CellPoints& points) {
  std::vector<float> grey((points.size() + CellPoints::group - 1) / CellPoints::group * CellPoints::group);
  sample_cells(frame, place, points, grey.data());
  grey.resize(points.size());
  return grey;
}

std::array<Point, 4> random_corners(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> away(-0.2 * size, 0.2 * size);
  std::array<Point, 4> corners{{{0, 0}, {size, 0}, {size, size}, {0, size}}};
  for (Point& corner : corners) corner = {corner.x + away(random), corner.y + away(random)};
  return corners;
}

TEST(CellSamples, AreThoseOfTheFrame) {
  std::mt19937 random(1);
  const CellPoints points = middles(7);
  for (const auto& [format, step] : {std::pair{PixelFormat::grey, 1}, std::pair{PixelFormat::grey, 2},
                                     std::pair{PixelFormat::rgb, 3}, std::pair{PixelFormat::bgr, 4}}) {
    for (const auto& [width, height] :
         {std::pair{40, 30}, std::pair{1, 1}, std::pair{1, 25}, std::pair{25, 1}, std::pair{2, 2}}) {
      const RandomFrame random_frame(width, height, format, step, random);
      for (int i = 0; i < 20; ++i) {
        const Homography place(random_corners(random, 30), 7);
        const std::vector<float> grey = samples(random_frame.frame, place, points);
        for (std::size_t k = 0; k < points.size(); ++k) {
          const Point p = place(static_cast<double>(points.u[k]), static_cast<double>(points.v[k]));
          ASSERT_NEAR(grey[k], random_frame.frame.sample(static_cast<float>(p.x), static_cast<float>(p.y)),
                      0.05F)
              << width << "x" << height << " at (" << p.x << ", " << p.y << ")";
        }
      }
    }
  }
}

TEST(CellSamples, AreTheSameOnEveryVectorExtension) {
  std::mt19937 random(2);
  const CellPoints points = middles(6);
  const RandomFrame random_frame(64, 48, PixelFormat::grey, 1, random);
  const Homography place(random_corners(random, 50), 6);
  const std::vector<float> best = samples(random_frame.frame, place, points);
  test::on_every_vector_target([&](std::int64_t target) {
    EXPECT_EQ(samples(random_frame.frame, place, points), best) << hwy::TargetName(target);
  });
}

TEST(CellSamples, ComeFromInsideTheFrameWhereverTheCornersAre) {
  std::mt19937 random(3);
  const CellPoints points = middles(5);
  const RandomFrame random_frame(20, 20, PixelFormat::grey, 1, random);
  constexpr double huge = 1e30;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::array<Point, 4>> odd{
      {{{3, 3}, {3, 3}, {3, 3}, {3, 3}}},                              // no area
      {{{0, 0}, {10, 0}, {1, 1}, {0, 10}}},                            // the horizon runs through it
      {{{-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}}},  //
      {{{none, 0}, {10, none}, {10, 10}, {0, 10}}},                    //
  };
  for (const auto& corners : odd) {
    for (const float grey : samples(random_frame.frame, Homography(corners, 5), points)) {
      EXPECT_TRUE(!(grey < 0 || grey > 255)) << grey;
    }
  }
}

}  // namespace
}  // namespace runmark
