#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "Vquad.h"
#include "clocked.h"
#include "corner/integer_quad.h"
#include "scan_bench.h"
#include "signed_port.h"

namespace runmark::rtl {
namespace {

constexpr unsigned coordinate_bits = 16;

/// One chain by value through the core; records lie in memory in a random order.
class Bench {
 public:
  std::optional<IntegerQuad> run(const Chain& chain, const IntegerQuadLimits& limits, int percent,
                                 std::uint64_t seed) {
    const std::size_t count = chain.records.size();
    std::vector<unsigned> place(count);  // of each record
    for (std::size_t i = 0; i < count; ++i) place[i] = static_cast<unsigned>((i * 7 + seed) % 1021);
    std::vector<std::size_t> record_at(1021);
    for (std::size_t i = 0; i < count; ++i) record_at[place[i]] = i;
    Willing grants(percent, seed);
    drive(core_->min_area, static_cast<std::uint64_t>(limits.min_area));
    drive(core_->max_area,
          static_cast<std::uint64_t>(std::min<std::int64_t>(limits.max_area, (1 << 20) - 1)));
    drive(core_->min_side, static_cast<unsigned>(limits.min_side));
    drive(core_->chain_head, place.front());
    drive(core_->chain_tail, place.back());
    core_->chain_hole = chain.hole;
    core_->chain_end = 0;
    core_->chain_valid = 1;
    bool answering = false;
    std::size_t answer = 0;
    bool released = false;
    const std::uint64_t begin = core_.cycles();
    std::optional<IntegerQuad> found;
    for (int clock = 0; clock < 100000; ++clock) {
      core_->walk_granted = grants();
      core_->release_ready = grants();
      core_->quad_ready = grants();
      if (answering) {
        drive(core_->walk_x, static_cast<unsigned>(chain.records[answer].first));
        drive(core_->walk_y, static_cast<unsigned>(chain.records[answer].second));
        drive(core_->walk_next, answer + 1 < count ? place[answer + 1] : 1023U);
      } else {
        drive(core_->walk_next, seed);  // whatever
      }
      core_.settle();
      const bool taken = core_->chain_valid && core_->chain_ready;
      if (released && core_->chain_ready) break;  // back at the start
      answering = core_->walk_read && core_->walk_granted;
      if (answering) answer = record_at[core_->walk_record];
      if (core_->release_valid && core_->release_ready) {
        EXPECT_EQ(core_->release_head, place.front());
        EXPECT_EQ(core_->release_tail, place.back());
        released = true;
      }
      if (core_->quad_valid && core_->quad_ready) {
        found.emplace();
        for (unsigned i = 0; i < 4; ++i) {
          found->corners[i] = {signed_part(core_->quad_x, i, coordinate_bits),
                               signed_part(core_->quad_y, i, coordinate_bits)};
        }
        found->light_inside = core_->quad_hole != 0;
        EXPECT_EQ(core_->quad_bottom, chain.records.back().second);
        EXPECT_FALSE(core_->quad_end);
      }
      core_.tick();
      if (taken) core_->chain_valid = 0;
    }
    EXPECT_TRUE(released);
    cycles = core_.cycles() - begin;
    return found;
  }
  std::uint64_t cycles = 0;

 private:
  Clocked<Vquad> core_;
};

std::optional<IntegerQuad> plain_quad(const Chain& chain, const IntegerQuadLimits& limits) {
  std::vector<Record> storage(chain.records.size());
  RecordPool pool(storage);
  pool.reset();
  RecordIndex last = no_record;
  for (const auto& [x, y] : chain.records) {
    const RecordIndex index =
        pool.take(static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), no_record);
    if (last != no_record) pool.link(last, index);
    last = index;
  }
  ClosedChain closed;
  closed.pool = &pool;
  closed.head = 0;
  closed.tail = last;
  closed.hole = chain.hole;
  closed.bottom = static_cast<std::uint16_t>(chain.records.back().second);
  return integer_quad(closed, limits);
}

/// The chains of a picture with one dark quadrilateral with ragged edges, and one with a light one.
std::vector<Chain> quad_chains(int size, double ragged, bool light, std::mt19937_64& random) {
  PixelImage image(size, size);
  std::uniform_real_distribution<double> part(0, 1);
  // Corners on a circle, apart from one another; at random one is pulled in so that it is no quadrilateral.
  std::array<std::array<double, 2>, 4> c{};
  const double turn = part(random) * 6.3;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = turn + 1.5708 * static_cast<double>(i) + 0.5 * (part(random) - 0.5);
    const double radius = size * (0.3 + 0.15 * part(random)) * (random() % 12 == 0 ? 0.3 : 1.0);
    c[i] = {size / 2.0 + radius * std::cos(angle), size / 2.0 + radius * std::sin(angle)};
  }
  std::uniform_real_distribution<double> noise(-ragged, ragged);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      bool in = true;
      for (std::size_t i = 0; i < 4; ++i) {
        const double ux = c[(i + 1) % 4][0] - c[i][0];
        const double uy = c[(i + 1) % 4][1] - c[i][1];
        const double across = (ux * (y - c[i][1]) - uy * (x - c[i][0])) / std::sqrt(ux * ux + uy * uy);
        in = in && across > noise(random);
      }
      const bool rim = x < 2 || y < 2 || x >= size - 2 || y >= size - 2;
      image.set(x, y, in != (light && !rim));
    }
  }
  ScanSettings settings;
  settings.cases = 0;
  settings.eight = false;
  return plain_chains(image, settings, 4000).chains;
}

TEST(RtlQuad, IsThePlainCoreOnQuadrilaterals) {
  Bench bench;
  std::mt19937_64 random(81);
  int quads = 0;
  int holes = 0;
  int others = 0;
  for (int i = 0; i < 2500; ++i) {
    const int size = 16 + static_cast<int>(random() % (i % 4 == 0 ? 400 : 80));
    IntegerQuadLimits limits;
    if (i % 7 == 0) limits.min_area = static_cast<std::int64_t>(random() % 3000);
    if (i % 11 == 0) limits.max_area = static_cast<std::int64_t>(random() % 6000);
    if (i % 5 == 0) limits.min_side = static_cast<int>(random() % 40);
    for (const Chain& chain : quad_chains(size, i % 3, i % 2 == 0, random)) {
      if (chain.records.size() > 1000) continue;
      const auto plain = plain_quad(chain, limits);
      ASSERT_EQ(bench.run(chain, limits, i % 2 == 0 ? 100 : 40, random() % 1000), plain) << "picture " << i;
      (plain ? quads : others) += 1;
      holes += plain && plain->light_inside ? 1 : 0;
    }
  }
  EXPECT_GT(quads, 200);
  EXPECT_GT(holes, 50);
  EXPECT_GT(others, 200);
}

TEST(RtlQuad, IsThePlainCoreOnNoise) {
  Bench bench;
  std::mt19937_64 random(82);
  int chains = 0;
  int quads = 0;
  for (int i = 0; i < 1500; ++i) {
    PixelImage image(40, 40);
    const std::uint64_t coarse = 1 + random() % 4;
    const std::uint64_t share = 20 + random() % 60;
    for (int y = 1; y < 39; ++y) {
      for (int x = 1; x < 39; ++x) {
        const auto cell =
            static_cast<std::uint64_t>(x) / coarse * 64 + static_cast<std::uint64_t>(y) / coarse;
        image.set(x, y,
                  (cell + 1) * (random.default_seed + static_cast<std::uint64_t>(i)) % 101 < share ||
                      random() % 12 == 0);
      }
    }
    ScanSettings settings;
    settings.cases = 0;
    settings.eight = i % 2 == 0;
    settings.max_turns = 1000;
    IntegerQuadLimits limits;
    limits.min_area = static_cast<std::int64_t>(random() % 20);
    limits.min_side = static_cast<int>(random() % 3);
    for (const Chain& chain : plain_chains(image, settings, 4000).chains) {
      if (chain.records.size() > 1000) continue;
      const auto plain = plain_quad(chain, limits);
      ASSERT_EQ(bench.run(chain, limits, i % 2 == 0 ? 100 : 40, random() % 1000), plain) << "image " << i;
      ++chains;
      quads += plain ? 1 : 0;
    }
  }
  std::printf("%d chains, %d quads\n", chains, quads);
  EXPECT_GT(chains, 2000);
  EXPECT_GT(quads, 50);
}

TEST(RtlQuad, TakesFewClocks) {
  Bench bench;
  std::mt19937_64 random(83);
  for (int i = 0; i < 20; ++i) {
    for (const Chain& chain : quad_chains(60, 1, false, random)) {
      bench.run(chain, {}, 100, 0);
      // Eight clocks a record and six once more round to the first corner, the scans, the lines and the
      // corners.
      EXPECT_LE(bench.cycles, 800 + 20 * chain.records.size());
    }
  }
}

}  // namespace
}  // namespace runmark::rtl
