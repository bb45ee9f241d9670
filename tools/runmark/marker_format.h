#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "frame.h"
#include "pose_finder.h"
#include "runmark/detector.h"

namespace runmark::cli {

/// How long one frame took and what was done for it; for --stats.
struct FrameReport {
  FrameStats stats;
  double milliseconds = 0;  ///< in the detector alone
};

/// Writes the markers of frames as text, each frame as whole lines.
class MarkerFormat {
 public:
  MarkerFormat() = default;
  MarkerFormat(const MarkerFormat&) = delete;
  MarkerFormat& operator=(const MarkerFormat&) = delete;
  virtual ~MarkerFormat() = default;

  /// What goes before the first frame.
  [[nodiscard]] virtual std::string header() const { return {}; }

  /// `poses` is null without a camera and a board, `report` without --stats.
  [[nodiscard]] virtual std::string frame(const Frame& frame, std::span<const Marker> markers,
                                          const FramePoses* poses, const FrameReport* report) const = 0;
};

/// What is said of each marker beside what was found.
struct MarkerExtras {
  bool poses = false;   ///< csv: columns for them
  double row_time = 0;  ///< microseconds from row to row; 0: nothing is said of times
};

/// `name` is text, jsonl or csv.
[[nodiscard]] std::unique_ptr<MarkerFormat> make_marker_format(std::string_view name,
                                                               const MarkerExtras& extras);

}  // namespace runmark::cli
