#pragma once

#include <cstdint>
#include <vector>

#include "contour/contour_linker.h"
#include "naive_follower.h"
#include "pixel_image.h"
#include "preprocess/bit_row.h"
#include "preprocess/crack_run.h"

namespace runmark {

/// Rows of an image as bits, and a row of zeros above and below them.
class BitImage {
 public:
  /// The image with its left side at column x of rows `width` wide.
  void pack(const PixelImage& image, int x, int width);
  /// Another image after the filter.
  void filter(const BitImage& image, std::uint8_t cases);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// @param y  from -1 to height
  [[nodiscard]] const BitWord* row(int y) const { return &words_[static_cast<std::size_t>(y + 1) * stride_]; }

 private:
  BitWord* mutable_row(int y) { return &words_[static_cast<std::size_t>(y + 1) * stride_]; }
  void resize(int width, int height);

  int width_ = 0;
  int height_ = 0;
  std::size_t stride_ = 0;
  std::vector<BitWord> words_;
};

/// Runs the preprocess and contour cores on an image and holds them to the naive follower. What is wrong
/// comes back as a sentence; nullptr means all is right. Keeps its memory from image to image.
class ContourChecker {
 public:
  /// Takes an image in; with cases on it is filtered, which is held to the table of windows.
  /// @param x, row_width  where it stands in wider, otherwise light rows; 0: rows as wide as the image
  [[nodiscard]] const char* take(const PixelImage& image, std::uint8_t cases, int x = 0, int row_width = 0);

  /// Whether the filter changed the image.
  [[nodiscard]] bool filter_changed() const { return changed_; }

  /// Finds the crack runs and the contours to expect.
  [[nodiscard]] const char* follow(Connectivity connectivity);

  /// Links the crack runs and compares every contour, point for point, and what is left over.
  /// @param capacity  records in the pool. When it runs out contours may be missing, never wrong.
  [[nodiscard]] const char* link(const ChainLimits& limits, std::size_t capacity = 65535);

  [[nodiscard]] const LinkerCounts& counts() const { return counts_; }
  [[nodiscard]] const NaiveContours& expected() const { return expected_; }
  [[nodiscard]] std::size_t peak_records() const { return peak_; }

 private:
  [[nodiscard]] const char* compare(const ClosedChain& chain, const ChainLimits& limits);

  PixelImage pixels_{0, 0};
  BitImage unfiltered_;
  BitImage bits_;
  int x_ = 0;
  bool changed_ = false;
  NaiveFollower follower_;
  NaiveContours expected_;
  std::vector<std::size_t> contour_at_run_;  // number of the contour that a naive run belongs to
  std::vector<std::size_t> run_at_crack_;    // number of the naive run that begins at a horizontal crack
  std::vector<bool> seen_;                   // contours handed on
  std::vector<CrackRun> runs_;               // of all rows
  std::vector<std::size_t> row_ends_;        // where each row's runs end
  std::vector<Record> records_;
  std::vector<ChainEnd> ends_;
  std::vector<EndIndex> end_at_;
  LinkerCounts counts_;
  std::size_t peak_ = 0;
};

/// Whether a finished contour obeys the limits.
[[nodiscard]] bool obeys(const NaiveContour& contour, const ChainLimits& limits);

}  // namespace runmark
