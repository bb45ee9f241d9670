#include "runmark/confirmation.h"

#include <algorithm>
#include <cmath>

#include "corner/quad.h"

namespace runmark {
namespace {

constexpr std::size_t most_tracks = 4096;  // two full frames of a detector

Point middle_of(const Marker& marker) {
  Point sum;
  for (const Point& corner : marker.corners) sum = {sum.x + corner.x / 4, sum.y + corner.y / 4};
  return sum;
}

}  // namespace

Confirmation::Confirmation(int frames) : frames_(std::max(frames, 1)) {
  tracks_.reserve(most_tracks);
  confirmed_.reserve(most_tracks);
}

Confirmation::Track* Confirmation::track_of(const Marker& marker) {
  const Point middle = middle_of(marker);
  const double side = std::sqrt(area_of(marker.corners));
  Track* nearest = nullptr;
  double least = 0;
  for (Track& track : tracks_) {
    // A track goes on with one marker a frame.
    if (track.frame == frame_ || track.marker.id != marker.id || track.marker.dictionary != marker.dictionary)
      continue;
    const Point before = middle_of(track.marker);
    const double distance = std::hypot(middle.x - before.x, middle.y - before.y);
    const double farthest = side * static_cast<double>(frame_ - track.frame);
    if (distance > farthest || (nearest != nullptr && distance >= least)) continue;
    nearest = &track;
    least = distance;
  }
  return nearest;
}

std::span<const Marker> Confirmation::next(std::span<const Marker> found) {
  ++frame_;
  std::erase_if(tracks_, [this](const Track& track) { return frame_ - track.frame > frames_; });
  confirmed_.clear();
  for (const Marker& marker : found) {
    Track* track = track_of(marker);
    if (track == nullptr) {
      if (tracks_.size() == tracks_.capacity()) continue;
      track = &tracks_.emplace_back();
    }
    track->marker = marker;
    track->frame = frame_;
    if (++track->seen >= frames_ && confirmed_.size() < confirmed_.capacity()) confirmed_.push_back(marker);
  }
  return confirmed_;
}

void Confirmation::restart() { tracks_.clear(); }

}  // namespace runmark
