#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/camera_path.h"
#include "render/colour.h"
#include "render/jpeg_damage.h"
#include "render/maths.h"
#include "render/samples.h"
#include "render/scene.h"
#include "render/standard_sets.h"
#include "runmark/dictionary.h"

namespace runmark::render {
namespace {

// A calm recipe: everything that disturbs is off.
Recipe calm() {
  Recipe r;
  r.width = 320;
  r.height = 240;
  r.sizes = {{60, 61, 1}};
  r.tilt = {};
  r.margin = {2, 2};
  r.occluded = 0;
  r.cut = 0;
  r.wall = Wall::gradient;
  r.clutter = {};
  r.level = {0.8, 0.8};
  r.gradient = {};
  r.lamps = {};
  r.shadows = {};
  r.vignette = {};
  r.distortion = {};
  r.blur = {};
  r.motion = {};
  r.noise = {};
  r.jpeg = {};
  return r;
}

RenderedFrame picture(const Recipe& recipe, int index = 0) {
  return render(make_scene(recipe, *builtin_dictionary("tag36h11"), 5, index));
}

int level(const RenderedFrame& frame, int x, int y) {
  return frame.grey[static_cast<std::size_t>(y * frame.width + x)];
}

// The steepest step between neighbours of a row.
int steepest(const RenderedFrame& frame) {
  int most = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 1; x < frame.width; ++x)
      most = std::max(most, std::abs(level(frame, x, y) - level(frame, x - 1, y)));
  }
  return most;
}

double rms_difference(const RenderedFrame& a, const RenderedFrame& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.grey.size(); ++i) {
    const double d = static_cast<double>(a.grey[i]) - b.grey[i];
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a.grey.size()));
}

TEST(RenderEffects, BlurAndMotionSoftenEdges) {
  Recipe r = calm();
  const int sharp = steepest(picture(r));
  r.blur = {2, 2};
  EXPECT_LT(steepest(picture(r)), sharp / 2);
  r = calm();
  r.motion = {1, {8, 8}};
  EXPECT_LT(steepest(picture(r)), sharp);
  EXPECT_GT(rms_difference(picture(r), picture(calm())), 1);
}

TEST(RenderEffects, NoiseHasTheDeviationAskedFor) {
  Plane grey(400, 400, 128.0F / 255);
  Sensor sensor;
  sensor.noise = 6;
  const auto levels = expose(grey, sensor);
  double sum = 0;
  double squares = 0;
  for (const std::uint8_t v : levels) {
    sum += v;
    squares += static_cast<double>(v) * v;
  }
  const double n = static_cast<double>(levels.size());
  EXPECT_NEAR(sum / n, 128, 0.1);
  EXPECT_NEAR(std::sqrt(squares / n - sum / n * sum / n), 6, 0.1);
}

TEST(RenderEffects, LightAndToneCurveChangeLevels) {
  Recipe r = calm();
  const RenderedFrame plain = picture(r);
  r.level = {0.4, 0.4};
  const RenderedFrame dark = picture(r);
  EXPECT_NEAR(level(dark, 3, 3), level(plain, 3, 3) / 2.0, 1.01);
  EXPECT_NEAR(dark.truth.markers.at(0).contrast, plain.truth.markers.at(0).contrast / 2, 0.1);
  r = calm();
  r.gamma = 2.2;
  EXPECT_GT(level(picture(r), 3, 3), level(plain, 3, 3));
  for (const auto change : {+[](Recipe& c) {
                              c.gradient = {0.5, 0.5};
                            },
                            +[](Recipe& c) {
                              c.vignette = {1, {0.6, 0.6}};
                            },
                            +[](Recipe& c) {
                              c.shadows = {1, {3, 3}};
                            },
                            +[](Recipe& c) {
                              c.lamps = {1, {2, 2}};
                            },
                            +[](Recipe& c) {
                              c.clutter = {10, 10};
                            },
                            +[](Recipe& c) { c.wall = Wall::brick; },
                            +[](Recipe& c) {
                              c.jpeg = {1, {20, 20}};
                            },
                            +[](Recipe& c) { c.inverted = true; }}) {
    Recipe other = calm();
    change(other);
    EXPECT_GT(rms_difference(picture(other), plain), 0.5);
  }
}

TEST(RenderEffects, MarginTiltAndDistortionShowInTheTruth) {
  Recipe r = calm();
  r.margin = {0.5, 0.5};
  r.tilt = {60, 60};
  r.distortion = {1, {-0.1, -0.1}};
  const FrameTruth truth = picture(r).truth;
  EXPECT_NEAR(truth.markers.at(0).margin, 0.5, 1e-9);
  EXPECT_NEAR(truth.markers.at(0).tilt, 60, 1e-5);
  EXPECT_EQ(truth.distortion, -0.1);
}

TEST(RenderEffects, CoveredAndCutMarkersAreOptional) {
  Recipe r = calm();
  r.sizes = {{30, 60, 1}};
  r.occluded = 1;
  r.cut = 1;
  int covered = 0;
  int cut = 0;
  int required = 0;
  for (int i = 0; i < 20; ++i) {
    for (const MarkerTruth& m : picture(r, i).truth.markers) {
      covered += m.occluded ? 1 : 0;
      cut += m.cut ? 1 : 0;
      required += m.optional() ? 0 : 1;
      const bool beyond = std::any_of(m.corners.begin(), m.corners.end(),
                                      [](Point p) { return p.x < 1 || p.y < 1 || p.x > 318 || p.y > 238; });
      EXPECT_EQ(m.cut, beyond);
    }
  }
  EXPECT_GE(covered, 15);
  EXPECT_GE(cut, 15);
  EXPECT_EQ(required, 20);
}

TEST(RenderEffects, JpegLosesMoreAtLowerQuality) {
  const RenderedFrame frame = picture(calm());
  const auto damage = [&](int quality) {
    RenderedFrame after_jpeg = frame;
    damage_as_jpeg(after_jpeg.grey, frame.width, frame.height, quality);
    return rms_difference(frame, after_jpeg);
  };
  EXPECT_LT(damage(100), 0.6);
  EXPECT_GT(damage(50), damage(90));
  EXPECT_GT(damage(10), damage(50));
  // A size that is no multiple of eight, and a flat block, which survives anything.
  std::vector<std::uint8_t> flat(13 * 9, 128);
  damage_as_jpeg(flat, 13, 9, 1);
  EXPECT_EQ(flat, std::vector<std::uint8_t>(13 * 9, 128));
}

TEST(RenderEffects, ColourKeepsTheGrey) {
  const Scene scene = make_scene(samples()[0].recipe, *builtin_dictionary("tag36h11"), 1, 0);
  const RenderedFrame frame = render(scene);
  const auto bgr = colourise(scene, frame);
  int coloured = 0;
  for (std::size_t i = 0; i < frame.grey.size(); ++i) {
    const int b = bgr[3 * i];
    const int g = bgr[3 * i + 1];
    const int r = bgr[3 * i + 2];
    coloured += std::abs(r - b) > 10 ? 1 : 0;
    if (std::max({r, g, b}) == 255) continue;
    ASSERT_LE(std::abs((77 * r + 150 * g + 29 * b + 128) / 256 - frame.grey[i]), 1);
  }
  EXPECT_GT(coloured, 1000);
}

TEST(RenderEffects, TheCameraMovesAndTheTruthWithIt) {
  const Scene scene = make_scene(calm(), *builtin_dictionary("tag36h11"), 5, 0);
  const MarkerTruth still = truth_of(after(scene, 0.7, 0)).markers.at(0);
  const MarkerTruth start = truth_of(scene).markers.at(0);
  EXPECT_NEAR(still.corners[0].x, start.corners[0].x, 1e-9);
  const RenderedFrame frame = render(after(scene, 0.2, 1));
  const MarkerTruth& moved = frame.truth.markers.at(0);
  EXPECT_GT(std::hypot(moved.corners[0].x - start.corners[0].x, moved.corners[0].y - start.corners[0].y), 3);
  // Black just inside the first corner, white just outside.
  const Point c = moved.corners[0];
  const Point d = moved.corners[2];
  const auto along = [&](double t) {
    return level(frame, static_cast<int>(std::lround(c.x + t * (d.x - c.x))),
                 static_cast<int>(std::lround(c.y + t * (d.y - c.y))));
  };
  EXPECT_LT(along(0.06) + 60, along(-0.06));
}

TEST(RenderEffects, SamplesHaveMarkersToFind) {
  for (const Sample& sample : samples()) {
    const auto dictionary = builtin_dictionary(sample.dictionary);
    ASSERT_TRUE(dictionary) << sample.name;
    const FrameTruth truth =
        truth_of(make_scene(sample.recipe, *dictionary, set_seed(sample.name, sample.seed), 0));
    const auto required = std::count_if(truth.markers.begin(), truth.markers.end(),
                                        [](const MarkerTruth& m) { return !m.optional(); });
    EXPECT_GE(required, 6) << sample.name;
  }
}

TEST(RenderMaths, AgreesWithTheCLibrary) {
  for (double x = -20; x < 20; x += 0.037) {
    EXPECT_NEAR(sine(x), std::sin(x), 1e-14);
    EXPECT_NEAR(cosine(x), std::cos(x), 1e-14);
    EXPECT_NEAR(exponential(x) / std::exp(x), 1, 1e-13);
    const double y = std::exp(x);
    EXPECT_NEAR(logarithm(y), std::log(y), 1e-13);
  }
  EXPECT_NEAR(power(0.37, 1 / 2.2), std::pow(0.37, 1 / 2.2), 1e-14);
  EXPECT_EQ(power(0, 0.5), 0);
}

TEST(RenderRng, IsUniformAndNormal) {
  Rng rng(1);
  double sum = 0;
  double squares = 0;
  constexpr int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double x = static_cast<double>(rng.normal());
    sum += x;
    squares += x * x;
    const double u = rng.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
  }
  EXPECT_NEAR(sum / n, 0, 0.015);
  EXPECT_NEAR(squares / n, 1, 0.02);
}

}  // namespace
}  // namespace runmark::render
