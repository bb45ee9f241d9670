#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <random>

#include "verilated.h"

namespace runmark::rtl {

/// A translated module with one clock. Inputs are set, `settle` lets outputs follow, `tick` is the clock
/// edge.
template <class Model>
class Clocked {
 public:
  /// @param traced  the model will be traced: it must have been translated for that
  explicit Clocked(bool traced = false)
      : context_(std::make_unique<VerilatedContext>()), model_(std::make_unique<Model>(context_.get())) {
    if (traced) context_->traceEverOn(true);
    context_->randReset(2);
    model_->clk = 0;
    model_->reset = 1;
    tick();
    tick();
    model_->reset = 0;
  }
  ~Clocked() {
    // A model's scopes say good-bye to the thread's context, which may be that of another model by now.
    Verilated::threadContextp(context_.get());
    model_->final();
  }
  Clocked(const Clocked&) = delete;
  Clocked& operator=(const Clocked&) = delete;

  Model* operator->() { return model_.get(); }
  void settle() { model_->eval(); }
  void tick() {
    model_->clk = 1;
    model_->eval();
    if (at_edge_) at_edge_(2 * cycles_);
    model_->clk = 0;
    model_->eval();
    if (at_edge_) at_edge_(2 * cycles_ + 1);
    ++cycles_;
  }
  /// Is told of every edge of the clock and its time, for waves.
  void at_edge(std::function<void(std::uint64_t)> told) { at_edge_ = std::move(told); }
  [[nodiscard]] std::uint64_t cycles() const { return cycles_; }

 private:
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<Model> model_;
  std::uint64_t cycles_ = 0;
  std::function<void(std::uint64_t)> at_edge_;
};

/// Sets an input of whatever width.
template <class Port>
void drive(Port& port, std::uint64_t value) {
  port = static_cast<Port>(value);
}

/// How often a stream's partner is willing, in per cent of the clocks.
class Willing {
 public:
  Willing(int percent, std::uint64_t seed) : percent_(percent), random_(seed) {}
  bool operator()() { return percent_ >= 100 || static_cast<int>(random_() % 100) < percent_; }

 private:
  int percent_;
  std::mt19937_64 random_;
};

}  // namespace runmark::rtl
