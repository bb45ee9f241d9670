#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "runmark/export.h"
#include "runmark/marker.h"

namespace runmark {

/// Tells the markers of a video from what was taken for one in a single frame. A marker counts when it has
/// been seen in a number of frames, at most so many frames apart, each time no farther from where it was than
/// its side is long for each frame that has passed. Allocates nothing after it is made.
class Confirmation {
 public:
  /// @param frames  in how many frames it must be seen; 1 lets everything through
  RUNMARK_EXPORT explicit Confirmation(int frames);

  /// Takes the markers of the next frame and gives those that count, in their order. The result is valid
  /// until the next call; the names of dictionaries must be valid until `restart`.
  [[nodiscard]] RUNMARK_EXPORT std::span<const Marker> next(std::span<const Marker> found);

  /// The frames that follow are of another video.
  RUNMARK_EXPORT void restart();

 private:
  struct Track {
    Marker marker;  ///< where it was last
    int seen = 0;
    std::int64_t frame = 0;  ///< when
  };
  [[nodiscard]] Track* track_of(const Marker& marker);

  int frames_;
  std::int64_t frame_ = 0;
  std::vector<Track> tracks_;
  std::vector<Marker> confirmed_;
};

}  // namespace runmark
