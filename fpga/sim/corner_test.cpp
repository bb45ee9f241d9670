#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "Vcorner.h"
#include "clocked.h"
#include "corner/corner_state_machine.h"
#include "scan_bench.h"

namespace runmark::rtl {
namespace {

using Corners = std::optional<std::array<CrackPoint, 4>>;

/// One chain by value through the core; records lie in memory in a random order.
class Bench {
 public:
  Corners run(const Chain& chain, int threshold, int percent, std::uint64_t seed) {
    const std::size_t count = chain.records.size();
    std::vector<unsigned> place(count);  // of each record
    for (std::size_t i = 0; i < count; ++i) place[i] = static_cast<unsigned>((i * 7 + seed) % 1021);
    std::vector<std::size_t> record_at(1021);
    for (std::size_t i = 0; i < count; ++i) record_at[place[i]] = i;
    Willing grants(percent, seed);
    drive(core_->threshold, static_cast<unsigned>(threshold));
    drive(core_->chain_head, place.front());
    drive(core_->chain_tail, place.back());
    core_->chain_hole = chain.hole;
    core_->chain_end = 0;
    core_->chain_valid = 1;
    bool answering = false;
    std::size_t answer = 0;
    bool released = false;
    const std::uint64_t begin = core_.cycles();
    Corners found;
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
        const auto xs = static_cast<std::uint64_t>(core_->quad_x);
        const auto ys = static_cast<std::uint64_t>(core_->quad_y);
        for (unsigned i = 0; i < 4; ++i) {
          (*found)[i] = {static_cast<int>(xs >> (10 * i) & 1023), static_cast<int>(ys >> (9 * i) & 511)};
        }
        EXPECT_EQ(core_->quad_bottom, chain.records.back().second);
        EXPECT_EQ(core_->quad_hole, chain.hole);
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
  Clocked<Vcorner> core_;
};

Corners plain_corners(const Chain& chain, int threshold) {
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
  closed.bottom = static_cast<std::uint16_t>(chain.records.back().second);
  return four_corners(closed, threshold);
}

/// The chains of a square turned by `degrees`, with ragged edges.
std::vector<Chain> square_chains(double side, double degrees, double ragged, std::mt19937_64& random) {
  const int size = static_cast<int>(side * 1.5) + 8;
  PixelImage image(size, size);
  const double c = std::cos(degrees * 0.017453292519943295);
  const double s = std::sin(degrees * 0.017453292519943295);
  std::uniform_real_distribution<double> noise(-ragged, ragged);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const double dx = x - size / 2.0;
      const double dy = y - size / 2.0;
      const double edge = side / 2 + noise(random);
      image.set(x, y, std::fabs(c * dx + s * dy) < edge && std::fabs(c * dy - s * dx) < edge);
    }
  }
  return plain_chains(image, {}, 1000).chains;
}

TEST(RtlCorner, IsThePlainCoreOnSquares) {
  Bench bench;
  std::mt19937_64 random(31);
  int quads = 0;
  int chains = 0;
  for (int i = 0; i < 300; ++i) {
    const double side = 10 + static_cast<double>(random() % 120);
    const double degrees = static_cast<double>(random() % 900) / 10 - 45;
    for (const Chain& chain : square_chains(side, i % 2 == 0 ? degrees / 10 : degrees, i % 3, random)) {
      const int threshold = i % 4 == 0 ? 1 + static_cast<int>(random() % 12) : 5;
      const Corners plain = plain_corners(chain, threshold);
      ASSERT_EQ(bench.run(chain, threshold, i % 2 == 0 ? 100 : 40, random() % 1000), plain)
          << side << " px, " << degrees << " degrees";
      quads += plain ? 1 : 0;
      ++chains;
    }
  }
  EXPECT_GT(quads, 60);
  EXPECT_GT(chains - quads, 60);
}

TEST(RtlCorner, IsThePlainCoreOnAnyChain) {
  Bench bench;
  std::mt19937_64 random(32);
  for (int i = 0; i < 2000; ++i) {
    Chain chain{random() % 2 != 0, {}};
    const std::size_t count = 1 + random() % 40;
    for (std::size_t k = 0; k < count; ++k) {
      const bool far = i % 3 == 0;  // so far that the counters saturate
      chain.records.emplace_back(random() % (far ? 640 : 16), random() % (far ? 480 : 16));
    }
    const int threshold = 1 + static_cast<int>(random() % (i % 5 == 0 ? 255 : 12));
    ASSERT_EQ(bench.run(chain, threshold, i % 2 == 0 ? 100 : 40, random() % 1000),
              plain_corners(chain, threshold));
  }
}

TEST(RtlCorner, TakesTwoClocksARecordAndRound) {
  Bench bench;
  std::mt19937_64 random(33);
  const Chain chain = square_chains(100, 2, 0, random).at(0);
  bench.run(chain, 5, 100, 0);
  EXPECT_LE(bench.cycles, 4 * chain.records.size() + 8);
}

}  // namespace
}  // namespace runmark::rtl
