#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "Vpreprocess.h"
#include "clocked.h"
#include "noise_image.h"
#include "pixel_image.h"
#include "preprocess/border.h"
#include "preprocess/crack_runs.h"
#include "preprocess/filter.h"

namespace runmark::rtl {
namespace {

enum Kind : std::uint8_t { straight, shift, start, join, begin_frame, end_frame };

struct Event {
  std::uint8_t kind;
  bool top = false, left_above = false;
  int x = 0, y = 0;
  friend bool operator==(const Event&, const Event&) = default;
};
std::ostream& operator<<(std::ostream& out, const Event& e) {
  return out << int{e.kind} << (e.top ? " top " : " bottom ") << (e.left_above ? "above " : "below ") << e.x
             << ' ' << e.y;
}

using Rows = std::vector<std::vector<BitWord>>;

Rows filtered_rows(const PixelImage& image, std::uint8_t cases) {
  const int width = image.width();
  const int height = image.height();
  Rows raw(static_cast<std::size_t>(height) + 2, std::vector<BitWord>(bit_words(width)));
  for (int y = 0; y < height; ++y) {
    auto& row = raw[static_cast<std::size_t>(y) + 1];
    for (int x = 0; x < width; ++x) set_bit(row.data(), x, image.dark(x, y));
    clear_border(row.data(), width, y, height);
  }
  Rows clean(static_cast<std::size_t>(height), std::vector<BitWord>(bit_words(width)));
  for (std::size_t y = 0; y < clean.size(); ++y) {
    filter_row_plain(raw[y].data(), raw[y + 1].data(), raw[y + 2].data(), width, cases, clean[y].data());
  }
  return clean;
}

/// The events of a frame: the crack runs at their right ends, and the cracks that touch no run.
std::vector<Event> expected_events(const PixelImage& image, std::uint8_t cases, Connectivity connectivity) {
  const int width = image.width();
  const Rows rows = filtered_rows(image, cases);
  std::vector<BitWord> above(bit_words(width));
  std::vector<CrackRun> runs(max_crack_runs(width));
  std::vector<Event> events{{begin_frame}};
  for (int y = 0; y < image.height(); ++y) {
    const auto& row = rows[static_cast<std::size_t>(y)];
    const std::size_t count = find_crack_runs(above.data(), row.data(), width, connectivity, runs);
    std::size_t next = 0;
    for (int x = 1; x < width; ++x) {
      bool touched = false;
      for (std::size_t i = 0; i < count; ++i) touched = touched || (runs[i].x0 <= x && x <= runs[i].x1);
      const bool above_crack = bit_at(above.data(), x) != bit_at(above.data(), x - 1);
      const bool crack = bit_at(row.data(), x) != bit_at(row.data(), x - 1);
      if (crack && above_crack && !touched) events.push_back({straight, false, false, 0, y});
      if (next < count && runs[next].x1 == x) {
        const CrackRun& run = runs[next++];
        const Kind kind = run.left_above != run.right_above ? shift : run.left_above ? join : start;
        events.push_back({kind, run.top, run.left_above, run.top ? run.x1 : run.x0, y});
      }
    }
    above = row;
  }
  events.push_back({end_frame});
  return events;
}

/// The core, fed frame by frame; leaves it as the last frame left it.
class Core {
 public:
  std::vector<Event> run(const PixelImage& image, std::uint8_t cases, bool eight, int percent_in,
                         int percent_out, int pixels = -1) {
    Willing sends(percent_in, 3);
    Willing takes(percent_out, 4);
    drive(core_->last_x, static_cast<unsigned>(image.width() - 1));
    drive(core_->last_y, static_cast<unsigned>(image.height() - 1));
    core_->cases = cases;
    core_->eight = eight;
    core_->give_up = 0;
    std::vector<Event> events;
    int at = 0;
    const int all = pixels < 0 ? image.width() * image.height() : pixels;
    bool offered = false;
    for (std::uint64_t clock = 0; clock < 200000; ++clock) {
      if (pixels >= 0 && at == all) break;  // the frame is cut off
      offered = offered || (at < all && sends());
      core_->in_valid = offered;
      core_->in_sof = at == 0;
      core_->in_dark = at < all && image.dark(at % image.width(), at / image.width());
      core_->out_ready = takes();
      core_.settle();
      if (core_->in_valid && core_->in_ready) {
        offered = false;
        ++at;
      }
      bool done = false;
      if (core_->out_valid && core_->out_ready) {
        Event event{core_->out_kind};
        if (event.kind <= join) event.y = core_->out_y;
        if (event.kind >= shift && event.kind <= join) {
          event.x = core_->out_x;
          event.top = core_->out_top != 0;
          event.left_above = core_->out_left_above != 0;
        }
        events.push_back(event);
        done = event.kind == end_frame;
      }
      core_.tick();
      if (done) break;
    }
    return events;
  }
  Clocked<Vpreprocess>& clocked() { return core_; }

 private:
  Clocked<Vpreprocess> core_;
};

PixelImage random_image(std::mt19937_64& random, int most_width, int most_height) {
  const int width = 1 + static_cast<int>(random() % static_cast<unsigned>(most_width));
  const int height = 1 + static_cast<int>(random() % static_cast<unsigned>(most_height));
  return noise_image(width, height, static_cast<int>(random() % 101), 1 + static_cast<int>(random() % 3),
                     random());
}

TEST(RtlPreprocess, IsThePlainCoreOnRandomFrames) {
  Core core;
  std::mt19937_64 random(7);
  for (int i = 0; i < 4000; ++i) {
    const PixelImage image = random_image(random, i % 10 == 0 ? 80 : 14, 12);
    const auto cases = static_cast<std::uint8_t>(i % 3 == 0 ? 0 : i % 3 == 1 ? 63 : random() % 64);
    const bool eight = random() % 2 != 0;
    const int in = i % 2 == 0 ? 100 : 50;
    const int out = i % 4 < 2 ? 100 : 40;
    const auto events = core.run(image, cases, eight, in, out);
    ASSERT_EQ(events, expected_events(image, cases, eight ? Connectivity::eight : Connectivity::four))
        << "frame " << i << ", " << image.width() << " x " << image.height() << ", cases " << int{cases};
  }
}

TEST(RtlPreprocess, BeginsAnewWhereverAFrameIsCutOff) {
  Core core;
  std::mt19937_64 random(8);
  for (int i = 0; i < 1000; ++i) {
    const PixelImage cut = random_image(random, 12, 9);
    const int pixels = static_cast<int>(random() % static_cast<unsigned>(cut.width() * cut.height()));
    core.run(cut, 63, true, 100, 100, pixels);
    const PixelImage image = random_image(random, 12, 9);
    auto events = core.run(image, 63, true, 100, 70);
    // What is left of the cut frame still comes out first.
    const auto last = std::find(events.rbegin(), events.rend(), Event{begin_frame});
    ASSERT_NE(last, events.rend());
    events.erase(events.begin(), last.base() - 1);
    ASSERT_EQ(events, expected_events(image, 63, Connectivity::eight)) << "after a cut at pixel " << pixels;
  }
}

TEST(RtlPreprocess, TakesAPixelAClockAndARowMore) {
  Core core;
  const PixelImage image = noise_image(80, 60, 40, 2, 5);
  const std::uint64_t before = core.clocked().cycles();
  core.run(image, 63, true, 100, 100);
  EXPECT_LE(core.clocked().cycles() - before, 80 * 60 + 80 + 8);
}

TEST(RtlPreprocess, GivesUpTheRestOfTheFrameWhenItMayNotWait) {
  Core core;
  const PixelImage image = noise_image(40, 40, 50, 1, 9);
  const auto whole = expected_events(image, 0, Connectivity::eight);
  auto& clocked = core.clocked();
  clocked->last_x = 39;
  clocked->last_y = 39;
  clocked->cases = 0;
  clocked->eight = 1;
  clocked->give_up = 1;
  std::vector<Event> events;
  int lost = 0;
  int at = 0;
  for (int clock = 0; clock < 1800; ++clock) {
    const bool stuck = clock > 500 && clock < 700;
    clocked->in_valid = at < 1600;
    clocked->in_sof = at == 0;
    clocked->in_dark = at < 1600 && image.dark(at % 40, at / 40);
    clocked->out_ready = !stuck;
    clocked.settle();
    ASSERT_TRUE(clocked->in_ready || at >= 1600 || clock == 0 || lost == 0) << "held the source back";
    if (clocked->in_valid && clocked->in_ready) ++at;
    if (clocked->out_valid && clocked->out_ready && clocked->out_kind != straight) {
      events.push_back({clocked->out_kind});
    }
    clocked.tick();
    lost += clocked->lost;
  }
  EXPECT_EQ(lost, 1);
  ASSERT_GE(events.size(), 2U);
  EXPECT_LT(events.size(), whole.size());
  EXPECT_EQ(events.back().kind, end_frame);
  const PixelImage next = noise_image(30, 20, 40, 2, 10);
  EXPECT_EQ(core.run(next, 63, true, 100, 100), expected_events(next, 63, Connectivity::eight));
}

}  // namespace
}  // namespace runmark::rtl
