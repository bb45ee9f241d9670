#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "clocked.h"

namespace runmark::rtl {

/// The memory outside: AXI4 with as much reordering as one identifier allows, that is none. What was written
/// can be read only once the write has been acknowledged; who reads earlier is told so.
class AxiMemory {
 public:
  static constexpr std::uint32_t base = 0x10000000;

  /// @param willing  how often it is ready or answers, in per cent
  /// @param latency  clocks until a read is answered; writes take three times as long
  AxiMemory(std::size_t bytes, int willing, int latency, std::uint64_t seed)
      : bytes_(bytes, 0xA5), latency_(static_cast<std::uint64_t>(latency)), willing_(willing, seed) {}

  template <class Core>
  void drive(Core& core, std::uint64_t now) {
    core.m_axi_awready = willing_();
    core.m_axi_wready = willing_();
    core.m_axi_arready = willing_();
    if (!core.m_axi_bvalid || acknowledged_) {
      core.m_axi_bvalid = !written_.empty() && written_.front().due <= now && willing_();
    }
    core.m_axi_bresp = fails_ ? 2 : 0;
    if (!core.m_axi_rvalid || answered_) {
      core.m_axi_rvalid = !reads_.empty() && reads_.front().due <= now && willing_();
    }
    core.m_axi_rresp = fails_ ? 2 : 0;
    if (core.m_axi_rvalid) core.m_axi_rdata = word_at(reads_.front().at);
  }

  /// What was handed over in this clock; the outputs have settled. Complaints go to `faults`.
  template <class Core>
  void take(const Core& core, std::uint64_t now, std::vector<std::string>& faults) {
    if (core.m_axi_awvalid && core.m_axi_awready) {
      const std::uint32_t beats = core.m_axi_awlen + 1U;
      if (core.m_axi_awaddr % 8 != 0 || core.m_axi_awsize != 3 || core.m_axi_awburst != 1)
        faults.emplace_back("AW: not an aligned burst");
      if (core.m_axi_awaddr / 4096 != (core.m_axi_awaddr + 8 * beats - 1) / 4096)
        faults.emplace_back("AW: the burst crosses a page of 4096");
      if (!holds(core.m_axi_awaddr, 8 * beats)) faults.emplace_back("AW: outside the frames");
      asked_.push_back({core.m_axi_awaddr, {}, beats, 0});
    }
    if (core.m_axi_wvalid && core.m_axi_wready) take_beat(core, now, faults);
    acknowledged_ = core.m_axi_bvalid && core.m_axi_bready;
    if (acknowledged_) {
      const Burst& burst = written_.front();
      for (std::size_t i = 0; i < 8 * burst.beats.size(); ++i) {
        bytes_[burst.at - base + i] = static_cast<std::uint8_t>(burst.beats[i / 8] >> (8 * (i % 8)));
      }
      written_.pop_front();
    }
    if (core.m_axi_arvalid && core.m_axi_arready) {
      if (core.m_axi_araddr % 8 != 0 || core.m_axi_arlen != 0 || core.m_axi_arsize != 3)
        faults.emplace_back("AR: not one aligned word");
      if (!holds(core.m_axi_araddr, 8)) faults.emplace_back("AR: outside the frames");
      for (const auto* bursts : {&asked_, &written_}) {
        for (const Burst& burst : *bursts) {
          if (core.m_axi_araddr >= burst.at && core.m_axi_araddr < burst.at + 8 * burst.count)
            faults.emplace_back("AR: read before the write's acknowledgement");
        }
      }
      reads_.push_back({core.m_axi_araddr, {}, 1, now + latency_});
    }
    answered_ = core.m_axi_rvalid && core.m_axi_rready;
    if (answered_) reads_.pop_front();
  }

  /// From now on every answer is an error.
  void fail(bool fails) { fails_ = fails; }

 private:
  struct Burst {
    std::uint32_t at = 0;
    std::vector<std::uint64_t> beats;
    std::uint32_t count = 0;
    std::uint64_t due = 0;
  };

  template <class Core>
  void take_beat(const Core& core, std::uint64_t now, std::vector<std::string>& faults) {
    if (asked_.empty()) {
      faults.emplace_back("W: data before their address");
      return;
    }
    Burst& burst = asked_.front();
    burst.beats.push_back(core.m_axi_wdata);
    const bool last = burst.beats.size() == burst.count;
    if ((core.m_axi_wlast != 0) != last) faults.emplace_back("W: WLAST is wrong");
    if (core.m_axi_wstrb != 0xFF) faults.emplace_back("W: WSTRB is wrong");
    if (!last) return;
    burst.due = now + 3 * latency_;
    written_.push_back(burst);
    asked_.pop_front();
  }

  [[nodiscard]] bool holds(std::uint32_t at, std::uint32_t count) const {
    return at >= base && at - base + count <= bytes_.size();
  }
  [[nodiscard]] std::uint64_t word_at(std::uint32_t at) const {
    std::uint64_t word = 0;
    if (!holds(at, 8)) return word;
    for (unsigned k = 0; k < 8; ++k) word |= static_cast<std::uint64_t>(bytes_[at - base + k]) << (8 * k);
    return word;
  }

  std::vector<std::uint8_t> bytes_;
  std::uint64_t latency_;
  Willing willing_;
  std::deque<Burst> asked_;    // data still to come
  std::deque<Burst> written_;  // not yet acknowledged
  std::deque<Burst> reads_;
  bool acknowledged_ = false;
  bool answered_ = false;
  bool fails_ = false;
};

}  // namespace runmark::rtl
