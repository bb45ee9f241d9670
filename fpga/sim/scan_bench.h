#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "clocked.h"
#include "contour/contour_linker.h"
#include "pipeline/contour_scan.h"
#include "pixel_image.h"

namespace runmark::rtl {

/// A closed chain by value: the places of its records from head to tail.
struct Chain {
  bool hole = false;
  std::vector<std::pair<int, int>> records;
  friend bool operator==(const Chain&, const Chain&) = default;
};

struct FrameChains {
  std::vector<Chain> chains;
  LinkerCounts counts;
  std::uint64_t cycles = 0;
  std::size_t record_peak = 0;
  std::uint64_t dropped_queue = 0;
  bool ended = false;
};

struct ScanSettings {
  std::uint8_t cases = 63;
  bool eight = true;
  bool holes = true;
  bool patient = true;
  unsigned max_turns = 30;
  unsigned min_height = 0;
  int percent_in = 100;    ///< how often a pixel is offered
  int percent_walk = 100;  ///< how often the walker moves
};

/// The plain C++ cores with the same capacities.
inline FrameChains plain_chains(const PixelImage& image, const ScanSettings& settings, std::size_t records) {
  ChainLimits limits;
  limits.max_turns = settings.max_turns;
  limits.max_records = 1U << 20;  // the hardware has no limit but its pool
  limits.min_height = static_cast<std::uint16_t>(settings.min_height);
  limits.holes = settings.holes;
  const auto connectivity = settings.eight ? Connectivity::eight : Connectivity::four;
  ContourScan scan(image.width(), {{settings.cases, connectivity}, limits, records});
  FrameChains result;
  scan.begin_frame(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    BitWord* row = scan.next_row();
    std::fill_n(row, bit_words(image.width()), BitWord{0});
    for (int x = 0; x < image.width(); ++x) {
      if (image.dark(x, y)) set_bit(row, x, true);
    }
    scan.advance([&](const ClosedChain& closed) {
      Chain chain{closed.hole, {}};
      closed.runs([&](int, int to, int line) { chain.records.emplace_back(to, line); });
      result.chains.push_back(std::move(chain));
    });
  }
  result.counts = scan.linker().counts();
  result.record_peak = scan.linker().pool().peak();
  result.ended = true;
  return result;
}

/// Drives the translated contour_scan: pixels in, and a walker that goes along every closed chain.
template <class Model>
class ScanBench {
 public:
  /// @param pixels  how many of the frame's pixels are sent before it is cut off; -1 for all
  FrameChains run(const PixelImage& image, const ScanSettings& settings, int pixels = -1) {
    Willing sends(settings.percent_in, 11);
    Willing walks(settings.percent_walk, 12);
    set_registers(image, settings);
    FrameChains result;
    const int all = pixels < 0 ? image.width() * image.height() : pixels;
    const std::uint64_t begin = core_.cycles();
    const std::uint64_t patience = static_cast<std::uint64_t>(all) * 60 + 20000;
    int at = 0;
    bool offered = false;
    while (core_.cycles() - begin < patience && !(pixels >= 0 && at == all)) {
      offered = offered || (at < all && sends());
      core_->in_valid = offered;
      core_->in_sof = at == 0;
      core_->in_dark = at < all && image.dark(at % image.width(), at / image.width());
      const bool moves = walks();
      core_->chain_ready = moves && step_ == Step::wait;
      core_->walk_read = moves && step_ == Step::read;
      drive(core_->walk_record, walk_at_);
      core_->release_valid = step_ == Step::release;
      drive(core_->release_head, head_);
      drive(core_->release_tail, tail_);
      core_.settle();
      if (core_->in_valid && core_->in_ready) {
        offered = false;
        ++at;
      }
      result.counts.runs += core_->count_run;
      result.counts.closed += core_->count_closed;
      result.counts.handed_on += core_->count_handed_on;
      result.counts.dropped_full += core_->count_dropped_full;
      result.counts.dropped_rule += core_->count_dropped_rule;
      result.dropped_queue += core_->count_dropped_queue;
      if (core_->count_abandoned) result.counts.dropped_full += core_->abandoned;
      walk(result);
      core_.tick();
      if (result.ended) break;
    }
    if (!result.ended && at > 0) ++cut_frames_;
    result.cycles = core_.cycles() - begin;
    result.record_peak = core_->record_peak;
    return result;
  }
  Clocked<Model>& clocked() { return core_; }

 private:
  enum class Step : std::uint8_t { wait, read, answer, release };

  void set_registers(const PixelImage& image, const ScanSettings& settings) {
    drive(core_->last_x, static_cast<unsigned>(image.width() - 1));
    drive(core_->last_y, static_cast<unsigned>(image.height() - 1));
    core_->cases = settings.cases;
    core_->eight = settings.eight;
    core_->holes = settings.holes;
    core_->patient = settings.patient;
    drive(core_->max_turns, settings.max_turns);
    drive(core_->min_height, settings.min_height);
    core_->give_up = 0;
  }

  /// What the walker does with this clock's answers.
  void walk(FrameChains& result) {
    switch (step_) {
      case Step::wait:
        if (!core_->chain_valid || !core_->chain_ready) break;
        if (core_->chain_end) {
          result.ended = cut_frames_ == 0;
          if (cut_frames_ > 0) {  // what came so far was of a frame that was cut off
            --cut_frames_;
            result.chains.clear();
          }
          break;
        }
        head_ = core_->chain_head;
        tail_ = core_->chain_tail;
        walk_at_ = head_;
        chain_ = {core_->chain_hole != 0, {}};
        step_ = Step::read;
        break;
      case Step::read:
        if (core_->walk_read && core_->walk_granted) step_ = Step::answer;
        break;
      case Step::answer:
        chain_.records.emplace_back(core_->walk_x, core_->walk_y);
        step_ = walk_at_ == tail_ ? Step::release : Step::read;
        if (step_ == Step::release) result.chains.push_back(chain_);
        walk_at_ = core_->walk_next;
        break;
      case Step::release:
        if (core_->release_ready) step_ = Step::wait;
        break;
    }
  }

  Clocked<Model> core_;
  int cut_frames_ = 0;
  Step step_ = Step::wait;
  unsigned head_ = 0;
  unsigned tail_ = 0;
  unsigned walk_at_ = 0;
  Chain chain_;
};

}  // namespace runmark::rtl
