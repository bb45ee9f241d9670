#pragma once

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axi_memory.h"
#include "clocked.h"
#include "runmark_driver.h"

namespace runmark::rtl {

/// One pixel of AXI4-Stream video.
struct VideoBeat {
  std::uint32_t data = 0;
  bool user = false;  ///< first of a frame
  bool last = false;  ///< last of a line
};

/// How willing each partner of the core is, in per cent of the clocks.
struct Manners {
  int video = 100;
  int memory = 100;
  int latency = 4;  ///< of the memory, clocks
  int bus = 100;    ///< the processor on AXI4-Lite
  int results = 100;
  std::uint64_t seed = 0;
};

/// A word of the result stream and the clock it was taken in.
struct ResultWord {
  std::uint32_t data = 0;
  bool last = false;
  std::uint64_t cycle = 0;
};

/// A record of the result stream and the clock its last word was taken in.
struct StreamedRecord {
  runmark_record record{};
  std::uint64_t cycle = 0;
};

/// runmark_top on a bench: a camera, a memory and a processor that speak AXI, all of them moody, and a watch
/// on the manners of every channel: valid stays, and what goes with it does not change, until ready.
template <class Model>
class TopBench {
 public:
  explicit TopBench(const Manners& manners, std::size_t memory_bytes = std::size_t{1} << 20,
                    bool traced = false)
      : core_(traced),
        memory_(memory_bytes, manners.memory, manners.latency, manners.seed + 72),
        video_(manners.video, manners.seed + 71),
        bus_(manners.bus, manners.seed + 73),
        results_(manners.results, manners.seed + 74) {
    device_.context = this;
    device_.read = [](void* self, std::uint32_t at) {
      return static_cast<TopBench*>(self)->read_register(at);
    };
    device_.write = [](void* self, std::uint32_t at, std::uint32_t value) {
      static_cast<TopBench*>(self)->write_register(at, value);
    };
    core_->s_axil_awvalid = 0;
    core_->s_axil_wvalid = 0;
    core_->s_axil_bready = 0;
    core_->s_axil_arvalid = 0;
    core_->s_axil_rready = 0;
    core_->m_axi_bvalid = 0;
    core_->m_axi_rvalid = 0;
  }

  [[nodiscard]] const runmark_device& device() const { return device_; }
  [[nodiscard]] Clocked<Model>& clocked() { return core_; }
  [[nodiscard]] AxiMemory& memory() { return memory_; }
  /// Beats still to be taken.
  [[nodiscard]] std::deque<VideoBeat>& video() { return queue_; }
  void send(const std::vector<VideoBeat>& beats) { queue_.insert(queue_.end(), beats.begin(), beats.end()); }
  /// The clock in which each beat was taken.
  [[nodiscard]] std::vector<std::uint64_t>& taken_at() { return taken_at_; }
  [[nodiscard]] std::uint64_t cycles() const { return core_.cycles(); }
  /// Takes a record off the result stream once its last word has come.
  std::optional<StreamedRecord> take_record() {
    if (stream_.empty() || !stream_.back().last) return {};
    std::vector<std::uint32_t> words;
    for (const ResultWord& word : stream_) words.push_back(word.data);
    StreamedRecord taken{{}, stream_.back().cycle};
    stream_.clear();
    if (runmark_read_record(words.data(), &taken.record) != words.size())
      faults_.emplace_back("results: TLAST and the record's head differ");
    return taken;
  }
  [[nodiscard]] bool irq() {
    core_.settle();
    return core_->irq != 0;
  }
  /// Bad manners seen so far, one line each.
  [[nodiscard]] const std::vector<std::string>& faults() const { return faults_; }
  void hold_results(bool hold) { results_held_ = hold; }

  /// One clock of everything.
  void tick() {
    offered_ = offered_ || (!queue_.empty() && video_());
    core_->s_video_tvalid = offered_;
    if (offered_) {
      core_->s_video_tdata = queue_.front().data;
      core_->s_video_tuser = queue_.front().user;
      core_->s_video_tlast = queue_.front().last;
    }
    memory_.drive(*core_.operator->(), core_.cycles());
    core_->m_result_tready = !results_held_ && results_();
    core_.settle();
    watch();
    if (core_->s_video_tvalid && core_->s_video_tready) {
      queue_.pop_front();
      taken_at_.push_back(core_.cycles());
      offered_ = false;
    }
    if (core_->m_result_tvalid && core_->m_result_tready) {
      stream_.push_back({core_->m_result_tdata, core_->m_result_tlast != 0, core_.cycles()});
    }
    memory_.take(*core_.operator->(), core_.cycles(), faults_);
    aw_taken_ = core_->s_axil_awvalid && core_->s_axil_awready;
    w_taken_ = core_->s_axil_wvalid && core_->s_axil_wready;
    b_taken_ = core_->s_axil_bvalid && core_->s_axil_bready;
    ar_taken_ = core_->s_axil_arvalid && core_->s_axil_arready;
    r_taken_ = core_->s_axil_rvalid && core_->s_axil_rready;
    if (r_taken_) r_value_ = core_->s_axil_rdata;
    core_.tick();
  }

  std::uint32_t read_register(std::uint32_t at) {
    while (!bus_()) tick();
    drive(core_->s_axil_araddr, at);
    core_->s_axil_arvalid = 1;
    patiently("AXI4-Lite AR", [&] { return ar_taken_; });
    core_->s_axil_arvalid = 0;
    core_->s_axil_rready = bus_();
    patiently("AXI4-Lite R", [&] {
      if (!r_taken_) core_->s_axil_rready = bus_();
      return r_taken_;
    });
    core_->s_axil_rready = 0;
    return r_value_;
  }

  /// Address and data come in either order or at once.
  void write_register(std::uint32_t at, std::uint32_t value) {
    drive(core_->s_axil_awaddr, at);
    core_->s_axil_wdata = value;
    bool address_there = false;
    bool data_there = false;
    while (!address_there || !data_there) {
      const bool none = !address_there && !data_there;
      address_there = address_there || bus_();
      data_there = data_there || bus_();
      core_->s_axil_awvalid = address_there;
      core_->s_axil_wvalid = data_there;
      if (address_there && data_there) break;
      tick();
      if (!none && (aw_taken_ || w_taken_)) faults_.emplace_back("AXI4-Lite: half a write was taken");
    }
    patiently("AXI4-Lite AW and W", [&] { return aw_taken_ && w_taken_; });
    core_->s_axil_awvalid = 0;
    core_->s_axil_wvalid = 0;
    core_->s_axil_bready = bus_();
    patiently("AXI4-Lite B", [&] {
      if (!b_taken_) core_->s_axil_bready = bus_();
      return b_taken_;
    });
    core_->s_axil_bready = 0;
  }

 private:
  template <class Done>
  void patiently(const char* what, Done&& done) {
    for (int clock = 0; clock < 1000; ++clock) {
      tick();
      if (done()) return;
    }
    faults_.emplace_back(std::string(what) + ": no answer");
  }

  /// A channel as it stood in the last clock, when valid met no ready.
  class Watched {
   public:
    explicit Watched(const char* name) : name_(name) {}
    void look(bool valid, bool ready, std::uint64_t payload, std::uint64_t more,
              std::vector<std::string>& faults) {
      const std::pair now{payload, more};
      if (waiting_ && !valid) faults.emplace_back(std::string(name_) + ": valid was withdrawn");
      if (waiting_ && valid && now != payload_)
        faults.emplace_back(std::string(name_) + ": changed while waiting");
      waiting_ = valid && !ready;
      payload_ = now;
    }

   private:
    const char* name_;
    bool waiting_ = false;
    std::pair<std::uint64_t, std::uint64_t> payload_;
  };

  void watch() {
    const Model& c = *core_.operator->();
    aw_.look(c.m_axi_awvalid, c.m_axi_awready, c.m_axi_awaddr, c.m_axi_awlen, faults_);
    w_.look(c.m_axi_wvalid, c.m_axi_wready, c.m_axi_wdata, c.m_axi_wlast, faults_);
    ar_.look(c.m_axi_arvalid, c.m_axi_arready, c.m_axi_araddr, c.m_axi_arlen, faults_);
    result_.look(c.m_result_tvalid, c.m_result_tready, c.m_result_tdata, c.m_result_tlast, faults_);
    b_.look(c.s_axil_bvalid, c.s_axil_bready, c.s_axil_bresp, 0, faults_);
    r_.look(c.s_axil_rvalid, c.s_axil_rready, c.s_axil_rdata, c.s_axil_rresp, faults_);
  }

  Clocked<Model> core_;
  AxiMemory memory_;
  Willing video_;
  Willing bus_;
  Willing results_;
  runmark_device device_{};
  std::deque<VideoBeat> queue_;
  std::vector<std::uint64_t> taken_at_;
  std::deque<ResultWord> stream_;
  std::vector<std::string> faults_;
  bool offered_ = false;
  bool results_held_ = false;
  bool aw_taken_ = false, w_taken_ = false, b_taken_ = false, ar_taken_ = false, r_taken_ = false;
  std::uint32_t r_value_ = 0;
  Watched aw_{"AW"}, w_{"W"}, ar_{"AR"}, result_{"results"}, b_{"AXI4-Lite B"}, r_{"AXI4-Lite R"};
};

}  // namespace runmark::rtl
