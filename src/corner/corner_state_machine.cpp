#include "corner/corner_state_machine.h"

#include <algorithm>
#include <cstdlib>

namespace runmark {
namespace {

class CornerStateMachine {
 public:
  CornerStateMachine(int threshold, CrackPoint start) : threshold_(threshold), at_(start) {}

  void count_corners() { corners_ = 0; }

  void run_to(CrackPoint to) {
    offset_x_ = saturated(offset_x_ + to.x - at_.x);
    offset_y_ = saturated(offset_y_ + to.y - at_.y);
    if (std::abs(upright_ ? offset_x_ : offset_y_) >= threshold_) {
      if (corners_ < 4) corner_[corners_] = at_;
      if (corners_ <= 4) ++corners_;
      upright_ = !upright_;
      offset_x_ = upright_ ? 0 : to.x - at_.x;
      offset_y_ = upright_ ? to.y - at_.y : 0;
    }
    at_ = to;
  }

  [[nodiscard]] std::optional<std::array<CrackPoint, 4>> candidate() const {
    if (corners_ != 4) return std::nullopt;
    return corner_;
  }

 private:
  static int saturated(int offset) { return std::clamp(offset, -255, 255); }

  int threshold_;
  CrackPoint at_;
  bool upright_ = true;  // travelling up or down
  int offset_x_ = 0;
  int offset_y_ = 0;
  std::size_t corners_ = 0;
  std::array<CrackPoint, 4> corner_{};
};

}  // namespace

std::optional<std::array<CrackPoint, 4>> four_corners(const ClosedChain& chain, int threshold) {
  CornerStateMachine machine(threshold, {(*chain.pool)[chain.tail].x, chain.bottom});
  for (int round = 0; round < 2; ++round) {
    machine.count_corners();
    chain.runs([&](int from, int to, int line) {
      machine.run_to({from, line});
      machine.run_to({to, line});
    });
  }
  return machine.candidate();
}

}  // namespace runmark
