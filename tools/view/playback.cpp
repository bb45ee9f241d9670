#include "playback.h"

#include <algorithm>

namespace runmark::cli {

bool Playback::forward() {
  while (true) {
    if (!source_) source_ = open_source(inputs_[input_]);
    if (std::optional<Frame> next = source_->next()) {
      frame_ = std::move(next);
      break;
    }
    if (input_ + 1 == inputs_.size()) return false;
    ++input_;
    source_.reset();
  }
  const std::optional<double> rate = source_->frame_rate();
  const bool keeps_time = inputs_[input_].kind != InputKind::video || !rate;
  const auto step = std::chrono::duration_cast<Clock::duration>(
      std::chrono::duration<double>(keeps_time ? 0.0 : 1 / *rate));
  // A frame that is late by more than one does not make the ones after it hurry.
  const auto now = Clock::now();
  due_ = (now - due_ < step ? due_ : now) + step;
  return true;
}

bool Playback::skip() {
  if (input_ + 1 == inputs_.size()) return false;
  ++input_;
  source_.reset();
  return forward();
}

bool Playback::back() {
  const std::size_t wanted = input_ == 0 ? 0 : input_ - 1;
  if (inputs_[wanted].name == "-") return false;
  input_ = wanted;
  source_.reset();
  return forward();
}

int Playback::milliseconds_to_next() const {
  using Milliseconds = std::chrono::milliseconds;
  return static_cast<int>(
      std::max<Milliseconds::rep>(std::chrono::duration_cast<Milliseconds>(due_ - Clock::now()).count(), 0));
}

}  // namespace runmark::cli
