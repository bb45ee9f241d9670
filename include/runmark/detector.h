#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runmark/dictionary.h"
#include "runmark/export.h"
#include "runmark/image_view.h"
#include "runmark/marker.h"
#include "runmark/options.h"
#include "runmark/result.h"
#include "runmark/status.h"

namespace runmark {

/// Counts of one frame: the work that was done, and what a full capacity made the detector drop.
struct FrameStats {
  std::uint64_t pixels = 0;           ///< thresholded, all octaves
  std::uint64_t crack_runs = 0;       ///< inputs of the contour core
  std::uint64_t closed_chains = 0;    ///< contours that closed
  std::uint64_t quads = 0;            ///< candidates the corner core handed on
  std::uint64_t records_peak = 0;     ///< most records alive at once
  std::uint64_t dropped_chains = 0;   ///< given up because no record was free
  std::uint64_t dropped_markers = 0;  ///< found after the list of markers was full
};

/// What `detect` found. Iterates over the markers.
struct Detection {
  Status status = Status::ok;
  std::span<const Marker> markers;  ///< valid until the detector's next call
  [[nodiscard]] auto begin() const { return markers.begin(); }
  [[nodiscard]] auto end() const { return markers.end(); }
};

/// Finds markers. Owns all its memory, set aside when it is made; a call allocates nothing, prints
/// nothing and throws nothing. One detector serves one thread at a time.
class RUNMARK_EXPORT Detector {
 public:
  /// Errors: no dictionary, an option out of its range, a dictionary the pipeline cannot read.
  [[nodiscard]] static Result<Detector> create(const Options& options, std::vector<Dictionary> dictionaries);
  Detector(Detector&&) noexcept;
  Detector& operator=(Detector&&) noexcept;
  ~Detector();

  /// Finds the markers of a whole frame.
  [[nodiscard]] Detection detect(const ImageView& frame);

  /// Row streaming. `begin` starts a frame of that size; `push_rows` takes the next rows, top to
  /// bottom, in chunks of any height and anywhere in memory; all of one format. Their memory stays the
  /// caller's and must stay valid until `end`, unless Options::copy_rows is set. Markers appear in
  /// `markers` as soon as their last row and a few rows below it are in, and are never withdrawn.
  [[nodiscard]] Status begin(int width, int height);
  [[nodiscard]] Status push_rows(const ImageView& rows);
  [[nodiscard]] Status end();

  /// Markers of the current frame so far; grows while rows are pushed.
  [[nodiscard]] std::span<const Marker> markers() const;
  /// Corners, clockwise, of the squares in which no marker was read; complete after `end`. Empty without
  /// Options::keep_rejected.
  [[nodiscard]] std::span<const std::array<Point, 4>> rejected() const;
  [[nodiscard]] const FrameStats& stats() const;
  [[nodiscard]] const Options& options() const;
  /// Bytes the detector holds, dictionaries and their look-up tables included.
  [[nodiscard]] std::size_t memory() const;

 private:
  class Impl;
  explicit Detector(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace runmark
