#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluate/observations.h"
#include "runmark/dictionary.h"

namespace runmark::bench {

/// A detector set up for its dictionaries: ours or a peer. Reports in this project's conventions.
class Reader {
 public:
  Reader() = default;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  virtual ~Reader() = default;
  /// @param grey  8 bits a pixel, one channel
  [[nodiscard]] virtual std::vector<Observation> read(const cv::Mat& grey) = 0;
};

/// What a reader is to look for.
struct Task {
  std::span<const Dictionary> dictionaries;
  bool inverted = false;  ///< white on black instead of black on white
  cv::Size largest{};     ///< of the frames to come
};

/// A detector with its parameters.
struct Contender {
  std::string_view name;
  std::unique_ptr<Reader> (*make)(const Task& task);
};

/// runmark, OpenCV's ArUco (stock, and with sub-pixel corners), AprilTag 3 (decimate 1 and 2); one
/// thread each, everything else as their makers set it.
[[nodiscard]] std::span<const Contender> contenders();

/// The contender of that name, or nullptr.
[[nodiscard]] const Contender* find_contender(std::string_view name);

}  // namespace runmark::bench
