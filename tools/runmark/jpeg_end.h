#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace runmark::cli {

/// Finds where a JPEG picture ends while its bytes come in. Segments are skipped by their lengths, so
/// a thumbnail inside one does not count. Source: ITU-T T.81, annex B.
class JpegEnd {
 public:
  /// `data` begins with the picture's SOI marker and may grow from call to call. The picture's length,
  /// EOI included, or 0 when its end has not come yet.
  [[nodiscard]] std::size_t find(std::span<const std::uint8_t> data);

  /// Width times height as stated by the frame headers found so far; 0 without one.
  [[nodiscard]] std::uint64_t pixels() const { return pixels_; }

 private:
  std::size_t at_ = 2;  ///< looked through up to here
  std::uint64_t pixels_ = 0;
};

}  // namespace runmark::cli
