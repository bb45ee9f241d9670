#include "pattern/pattern_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "pattern/gaussian.h"
#include "pattern/marker_layout.h"
#include "pattern/normal_equations.h"
#include "support/picture.h"
#include "support/vector_targets.h"

namespace runmark {
namespace {

/// The picture blurred by a Gaussian of that many pixels, then with noise.
void spoil(test::Picture& picture, double blur, double noise, unsigned seed) {
  const int reach = static_cast<int>(std::ceil(3.5 * blur));
  std::vector<double> share;
  double all = 0;
  for (int i = -reach; i <= reach; ++i) {
    share.push_back(std::exp(-0.5 * (i / blur) * (i / blur)));
    all += share.back();
  }
  for (double& s : share) s /= all;
  const auto pass = [&](bool across) {
    std::vector<double> line;
    const int lines = across ? picture.height() : picture.width();
    const int size = across ? picture.width() : picture.height();
    const auto at = [&](int l, int i) -> std::uint8_t& {
      i = std::clamp(i, 0, size - 1);
      return across ? picture.at(i, l) : picture.at(l, i);
    };
    for (int l = 0; l < lines; ++l) {
      line.assign(static_cast<std::size_t>(size), 0.5);
      for (int i = 0; i < size; ++i) {
        for (int k = -reach; k <= reach; ++k)
          line[static_cast<std::size_t>(i)] += share[static_cast<std::size_t>(k + reach)] * at(l, i + k);
      }
      for (int i = 0; i < size; ++i) at(l, i) = static_cast<std::uint8_t>(line[static_cast<std::size_t>(i)]);
    }
  };
  pass(true);
  pass(false);
  std::mt19937 random(seed);
  std::normal_distribution<double> grain(0, noise);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      picture.at(x, y) =
          static_cast<std::uint8_t>(std::clamp(std::lround(picture.at(x, y) + grain(random)), 0L, 255L));
    }
  }
}

double rms(const std::array<Point, 4>& a, const std::array<Point, 4>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    sum += (a[i].x - b[i].x) * (a[i].x - b[i].x) + (a[i].y - b[i].y) * (a[i].y - b[i].y);
  }
  return std::sqrt(sum / 4);
}

struct Scene {
  Scene() : dictionary(*builtin_dictionary("tag36h11")), layout(dictionary) {}

  [[nodiscard]] PatternFit fit(const std::array<Point, 4>& start, std::size_t id) const {
    const Homography place(start, layout.width);
    const auto light = fit_light(picture.frame(), place, layout.rings, false, 1);
    if (!light) return {};
    return fit_pattern(picture.frame(), layout.cells_of(dictionary.codes[id]), layout.picture, *light, start);
  }

  Dictionary dictionary;
  MarkerLayout layout;
  test::Picture picture{140, 140, 220};
};

std::array<Point, 4> shifted(std::array<Point, 4> corners, double by) {
  corners[0].x += by;
  corners[1].y -= by;
  corners[2].x += by / 2;
  corners[3].x -= by;
  return corners;
}

TEST(PatternFit, FindsABlurredMarkersCornersFromAPixelAway) {
  for (const double blur : {0.8, 1.2, 1.8}) {
    for (const double degrees : {5.0, 13.0, 38.0}) {
      Scene scene;
      const auto truth = test::turned_square({44.3, 45.6}, 36, degrees);
      test::draw_at(scene.picture, scene.dictionary, 17, truth);
      spoil(scene.picture, blur, 3, 5);
      const PatternFit fit = scene.fit(shifted(truth, 0.8), 17);
      EXPECT_GT(fit.explained, 0.95);
      EXPECT_LT(rms(fit.corners, truth), 0.1) << blur << ' ' << degrees;
    }
  }
}

TEST(PatternFit, AnotherMarkersPatternDoesNotExplainTheFrame) {
  Scene scene;
  const auto truth = test::turned_square({45, 45}, 36, 10);
  test::draw_at(scene.picture, scene.dictionary, 17, truth);
  spoil(scene.picture, 1, 2, 5);
  EXPECT_GT(scene.fit(truth, 17).explained, 0.95);
  EXPECT_LT(scene.fit(truth, 18).explained, 0.6);
}

TEST(PatternFit, KnowsSharpEdges) {
  Scene scene;
  const auto truth = test::turned_square({70, 70}, 120, 0);
  test::draw_at(scene.picture, scene.dictionary, 3, truth);
  EXPECT_TRUE(scene.fit(truth, 3).is_sharp);
}

TEST(Gaussian, IsThatOfTheStandardLibrary) {
  for (double distance = -6; distance <= 6; distance += 0.05) {
    for (const double blur : {0.08, 0.3, 0.9, 2.0}) {
      const double x = distance / blur;
      EXPECT_NEAR(step_at(distance, blur), 0.5 * std::erfc(-x / std::sqrt(2.0)), 2e-7) << x;
      EXPECT_NEAR(slope_at(distance, blur) * blur, 0.3989422804014327 * std::exp(-x * x / 2), 1e-9) << x;
    }
  }
}

TEST(PatternPicture, ItsSlopesAreThoseOfItsValues) {
  const Dictionary dictionary = *builtin_dictionary("DICT_4X4_50");
  const MarkerLayout layout(dictionary);
  const PatternCells cells = layout.cells_of(dictionary.codes[7]);
  constexpr float step = 0.004F;
  const PatternPicture picture(cells, 0.4, 0.3);
  const PatternPicture along(cells, 0.404, 0.3);
  const PatternPicture down(cells, 0.4, 0.304);
  PatternPicture::Row row{};
  PatternPicture::Row more_along{};
  PatternPicture::Row more_down{};
  for (int y = 0; y <= 2 * layout.width; ++y) {
    picture.row(y, row);
    along.row(y, more_along);
    down.row(y, more_down);
    for (std::size_t x = 0; x <= static_cast<std::size_t>(2 * layout.width); ++x) {
      EXPECT_NEAR((more_along.value[x] - row.value[x]) / step, row.by_blur_along[x], 0.03F);
      EXPECT_NEAR((more_down.value[x] - row.value[x]) / step, row.by_blur_down[x], 0.03F);
    }
  }
}

TEST(PatternPicture, IsDarkAndLightWhereTheMarkerIs) {
  const Dictionary dictionary = *builtin_dictionary("DICT_4X4_50");
  const MarkerLayout layout(dictionary);
  PatternCells cells = layout.cells_of(dictionary.codes[7]);
  const PatternPicture picture(cells, 0.1, 0.1);
  PatternPicture::Row row{};
  for (int y = 0; y < layout.width; ++y) {
    picture.row(layout.width + 1 + y, row);
    for (int x = 0; x < layout.width; ++x) {
      EXPECT_NEAR(row.value[static_cast<std::size_t>(layout.width + 1 + x)], cells.at(x, y), 1e-3);
    }
    EXPECT_NEAR(row.value[0], 0.5, 0.01);  // half way from white to the border
    EXPECT_LT(row.along[0], -1);
  }
}

TEST(NormalEquations, SolveWhatTheyWereMadeOf) {
  std::mt19937 random(4);
  std::normal_distribution<float> number;
  NormalEquations::Step truth{};
  for (double& t : truth) t = static_cast<double>(number(random));
  NormalEquations equations;
  for (int n = 0; n < 200; ++n) {
    NormalEquations::Observation o{};
    double rest = 0;
    for (std::size_t i = 0; i < NormalEquations::parameters; ++i) {
      o.values[i] = number(random);
      o.weighted[i] = 0.5F * o.values[i];
      rest += static_cast<double>(o.values[i]) * truth[i];
    }
    o.values[NormalEquations::Observation::rest] = static_cast<float>(rest);
    equations.add(&o, 1);
  }
  NormalEquations::Step step{};
  ASSERT_TRUE(equations.solve(step));
  for (std::size_t i = 0; i < NormalEquations::parameters; ++i) EXPECT_NEAR(step[i], truth[i], 1e-4);
  EXPECT_FALSE(NormalEquations().solve(step));  // nothing holds any of them
}

TEST(NormalEquations, AreTheSameOnEveryVectorExtension) {
  std::mt19937 random(6);
  std::normal_distribution<float> number;
  std::vector<NormalEquations::Observation> seen(25);
  for (auto& o : seen) {
    for (std::size_t i = 0; i < NormalEquations::parameters; ++i) {
      o.values[i] = number(random);
      o.weighted[i] = 0.7F * o.values[i];
    }
    o.values[NormalEquations::Observation::rest] = number(random);
  }
  std::vector<NormalEquations::Step> steps;
  test::on_every_vector_target([&](std::int64_t) {
    NormalEquations equations;
    for (int row = 0; row < 3; ++row) equations.add(seen.data(), seen.size());
    ASSERT_TRUE(equations.solve(steps.emplace_back()));
  });
  for (const auto& step : steps) EXPECT_EQ(step, steps[0]);
}

}  // namespace
}  // namespace runmark
