#include "corner/side_cracks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "support/vector_targets.h"

namespace runmark {
namespace {

/// A staircase of level and upright runs by turns, which leads to the right and down with strays and begins
/// at vertex `first`; the first vertex once more behind the last.
Outline staircase(std::mt19937& random, std::size_t runs, std::size_t first) {
  std::uniform_int_distribution<int> right(-1, 4);
  std::uniform_int_distribution<int> down(-1, 2);
  Outline outline(runs);
  float x = 100;
  float y = 200;
  for (std::size_t i = 0; i < runs; ++i) {
    outline.x[(first + i) % runs] = x;
    outline.y[(first + i) % runs] = y;
    (i % 2 == 0 ? x : y) += static_cast<float>(i % 2 == 0 ? right(random) : down(random));
  }
  outline.count = runs;
  outline.x[runs] = outline.x[0];
  outline.y[runs] = outline.y[0];
  return outline;
}

SideWay way_between(const Outline& outline, std::size_t from, std::size_t to) {
  const Point a = crack_point(outline, from);
  const Point b = crack_point(outline, to);
  const Point u{b.x - a.x, b.y - a.y};
  const double length = std::sqrt(u.x * u.x + u.y * u.y);
  return {a, u, 1.3 * length, (length - 1.3) * length, 2.5 * length};
}

/// The definition, run by run.
SideCracks plain_cracks_of(const Outline& outline, std::size_t from, std::size_t to, const SideWay& way) {
  SideCracks cracks{LineFit({way.start.x + way.along.x / 2, way.start.y + way.along.y / 2})};
  const Point u = way.along;
  for (std::size_t i = from; i != to; i = i + 1 == outline.count ? 0 : i + 1) {
    Point p = crack_point(outline, i);
    Point q = crack_point(outline, i + 1);
    const auto share = [&](Point v) { return (v.x - way.start.x) * u.x + (v.y - way.start.y) * u.y; };
    const auto off = [&](Point v) { return (v.x - way.start.x) * u.y - (v.y - way.start.y) * u.x; };
    // Halving finds where the run enters and leaves.
    const auto cut = [&](Point outer, Point inner, double bound) {
      for (int halving = 0; halving < 60; ++halving) {
        const Point middle{(outer.x + inner.x) / 2, (outer.y + inner.y) / 2};
        ((share(middle) < bound) == (share(outer) < bound) ? outer : inner) = middle;
      }
      return inner;
    };
    for (const double bound : {way.low, way.high}) {
      const bool low = bound == way.low;
      const auto beyond = [&](Point v) { return low ? share(v) < bound : share(v) > bound; };
      if (beyond(p) && beyond(q)) p = q;
      if (beyond(p)) p = cut(p, q, bound);
      if (beyond(q)) q = cut(q, p, bound);
    }
    const double forward = share(q) - share(p);
    if (std::fabs(off(p) + off(q)) > 2 * way.band) continue;
    if (std::fabs(off(q) - off(p)) > std::max(way.band, forward)) continue;
    cracks.covered += forward;
    cracks.fit.add_cracks(p, q);
  }
  return cracks;
}

class SideCracksOnEveryTarget : public testing::TestWithParam<std::int64_t> {
 protected:
  void SetUp() override { test::use_vector_targets(GetParam()); }
  void TearDown() override { test::use_vector_targets(0); }
};

TEST_P(SideCracksOnEveryTarget, AreThoseOfTheDefinition) {
  std::mt19937 random(5);
  int compared = 0;
  for (std::size_t runs = 20; runs < 90; ++runs) {
    // The second way goes on from the last vertex to the first.
    for (const std::size_t first : {std::size_t{0}, runs / 3}) {
      const Outline outline = staircase(random, runs, first);
      const std::size_t from = (first + 1) % runs;
      const std::size_t to = (first + runs - 2) % runs;
      const SideWay way = way_between(outline, from, to);
      const SideCracks cracks = side_cracks(outline, from, to, way);
      const SideCracks plain = plain_cracks_of(outline, from, to, way);
      ASSERT_NEAR(cracks.covered, plain.covered, 1e-6) << runs;
      if (plain.covered < 0.3 * (way.high - way.low)) continue;
      ++compared;
      ASSERT_NEAR(cracks.fit.mean_square(), plain.fit.mean_square(), 1e-6) << runs;
      const auto line = cracks.fit.line();
      const auto plain_line = plain.fit.line();
      ASSERT_TRUE(line && plain_line) << runs;
      ASSERT_NEAR(line->normal.x, plain_line->normal.x, 1e-6) << runs;
      ASSERT_NEAR(line->offset, plain_line->offset, 1e-5) << runs;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(SideCracks, AreTheSameOnEveryVectorExtension) {
  std::mt19937 random(6);
  for (std::size_t runs = 6; runs < 300; runs += 7) {
    const Outline outline = staircase(random, runs, 0);
    const SideWay way = way_between(outline, 0, runs - 1);
    const SideCracks best = side_cracks(outline, 0, runs - 1, way);
    test::on_every_vector_target([&](std::int64_t target) {
      const SideCracks cracks = side_cracks(outline, 0, runs - 1, way);
      EXPECT_EQ(cracks.covered, best.covered) << runs << hwy::TargetName(target);
      EXPECT_EQ(cracks.fit.mean_square(), best.fit.mean_square()) << runs << hwy::TargetName(target);
    });
  }
}

INSTANTIATE_TEST_SUITE_P(AllTargets, SideCracksOnEveryTarget, testing::ValuesIn(test::vector_targets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

}  // namespace
}  // namespace runmark
