#include "runmark/detector.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "dictionary/check_dictionary.h"
#include "pipeline/found_markers.h"
#include "pipeline/hardware_pipeline.h"
#include "pipeline/paper_pipeline.h"
#include "pipeline/standard_pipeline.h"
#include "threshold/grey_fast.h"

namespace runmark {
namespace {

constexpr std::size_t most_markers = 2048;
constexpr std::size_t most_rejected = 1024;
constexpr int rows_ahead = 8;  // brought into the cache: two bands of tiles
constexpr std::ptrdiff_t cache_line = 64;

Result<std::unique_ptr<FramePipeline>> make_pipeline(const Options& options,
                                                     const std::vector<Dictionary>& dictionaries) {
  switch (options.pipeline) {
    case Pipeline::paper:
      for (const Dictionary& dictionary : dictionaries) {
        if (!PaperPipeline::can_read(dictionary)) {
          return Error{"dictionary " + dictionary.name +
                       ": the paper pipeline reads 6x6 cells in a black border, or templates of 8x8 cells"};
        }
      }
      return std::unique_ptr<FramePipeline>(std::make_unique<PaperPipeline>(options, dictionaries));
    case Pipeline::hardware:
      for (const Dictionary& dictionary : dictionaries) {
        if (!HardwarePipeline::can_read(dictionary)) {
          return Error{"dictionary " + dictionary.name +
                       ": the hardware pipeline reads a full square of 4x4 to 8x8 cells in a black border"};
        }
      }
      return std::unique_ptr<FramePipeline>(std::make_unique<HardwarePipeline>(options, dictionaries));
    case Pipeline::standard:
      break;
  }
  return std::unique_ptr<FramePipeline>(std::make_unique<StandardPipeline>(options, dictionaries));
}

/// What is wrong with the options, or nothing.
std::string complaint(const Options& o) {
  const auto outside = [](const char* name, auto value, auto low, auto high) {
    return std::string(name) + " " + std::to_string(value) + ": must be " + std::to_string(low) + " to " +
           std::to_string(high);
  };
  constexpr int most_side = 65535;
  constexpr int most_octaves = 6;
  if (o.max_width < 1 || o.max_width > most_side) return outside("max_width", o.max_width, 1, most_side);
  if (o.max_height < 1 || o.max_height > most_side) return outside("max_height", o.max_height, 1, most_side);
  const Region& r = o.region;
  if (r.x < 0 || r.y < 0 || r.width < 0 || r.height < 0 || (r.width == 0) != (r.height == 0)) {
    return "region: x, y, width and height must not be negative, and width and height both 0 or neither";
  }
  if (!(o.min_marker_size >= 4) || !(o.max_marker_size >= o.min_marker_size)) {
    return "marker size: the least must be at least 4 pixels and the greatest no less than it";
  }
  if (o.corrected_bits < -1 || o.corrected_bits > 16)
    return outside("corrected_bits", o.corrected_bits, -1, 16);
  if (!(o.min_margin >= 0 && o.min_margin <= 0.5F)) return outside("min_margin", o.min_margin, 0.0, 0.5);
  if (o.filter > filter_all && o.filter != filter_standard) return outside("filter", int{o.filter}, 0, 63);
  if (o.min_contrast < 1 || o.min_contrast > 255) return outside("min_contrast", o.min_contrast, 1, 255);
  if (o.fixed_threshold < 0 || o.fixed_threshold > 256) {
    return outside("fixed_threshold", o.fixed_threshold, 0, 256);
  }
  if (o.corner_offset < 1 || o.corner_offset > 255) return outside("corner_offset", o.corner_offset, 1, 255);
  if (o.octaves < 0 || o.octaves > most_octaves) return outside("octaves", o.octaves, 0, most_octaves);
  return {};
}

}  // namespace

class Detector::Impl {
 public:
  Impl(const Options& options, std::vector<Dictionary> dictionaries)
      : options_(options),
        dictionaries_(std::move(dictionaries)),
        found_(most_markers, options.keep_rejected ? most_rejected : 0) {}

  [[nodiscard]] std::string prepare() {
    auto pipeline = make_pipeline(options_, dictionaries_);
    if (!pipeline) return pipeline.error();
    pipeline_ = std::move(*pipeline);
    rows_.resize(static_cast<std::size_t>(options_.max_height));
    if (options_.copy_rows) {
      store_.resize(static_cast<std::size_t>(options_.max_width) *
                    static_cast<std::size_t>(options_.max_height));
    }
    return {};
  }

  Status begin(int width, int height) {
    if (streaming_) return Status::wrong_order;
    if (width < 1 || height < 1) return Status::bad_view;
    if (width > options_.max_width || height > options_.max_height) return Status::frame_too_large;
    frame_width_ = width;
    frame_height_ = height;
    rows_in_ = 0;
    stats_ = {};
    region_ = options_.region;
    if (region_.width == 0) region_ = {0, 0, width, height};
    region_.x = std::min(region_.x, width);
    region_.y = std::min(region_.y, height);
    region_.width = std::min(region_.width, width - region_.x);
    region_.height = std::min(region_.height, height - region_.y);
    found_.begin_frame({static_cast<double>(region_.x), static_cast<double>(region_.y)});
    if (region_.width > 0 && region_.height > 0) pipeline_->begin_frame(region_.width, region_.height);
    streaming_ = true;
    return Status::ok;
  }

  Status push_rows(const ImageView& rows, bool copy) {
    if (!streaming_) return Status::wrong_order;
    const Status status = rows.check();
    if (status != Status::ok) return status;
    if (rows.width != frame_width_ || rows.height > frame_height_ - rows_in_) return Status::wrong_order;
    if (rows_in_ > 0 && (rows.step != step_ || rows.format != format_)) return Status::bad_view;
    step_ = rows.step;
    format_ = rows.format;
    // Processors foresee how a row goes on, but not where the next one is; it is taken to be as far from this
    // one as this from the last, which does no harm where it is wrong. (The loop stands here because
    // compilers take a function that only fetches for one without effect.)
    const std::ptrdiff_t left = static_cast<std::ptrdiff_t>(region_.x) * step_;
    const std::ptrdiff_t right = left + static_cast<std::ptrdiff_t>(region_.width - 1) * step_;
    const auto [first, last] = std::minmax({left, right});
    const std::ptrdiff_t line = std::max(cache_line, std::abs(std::ptrdiff_t{step_}));
    for (int i = 0; i < rows.height; ++i) {
      const auto address = reinterpret_cast<std::uintptr_t>(rows.row(i));
      const std::uintptr_t ahead = address + rows_ahead * (address - last_row_);
      if (rows_in_ > 0 && rows_in_ + rows_ahead < frame_height_) {
        for (std::ptrdiff_t at = first; at <= last; at += line) {
          // NOLINTNEXTLINE(performance-no-int-to-ptr): an address to fetch from, not to read
          hwy::Prefetch(reinterpret_cast<const std::uint8_t*>(ahead + static_cast<std::uintptr_t>(at)));
        }
      }
      last_row_ = address;
      push_row(rows.row(i), copy);
    }
    return Status::ok;
  }

  Status end() {
    if (!streaming_) return Status::wrong_order;
    streaming_ = false;
    const bool whole = rows_in_ == frame_height_;
    if (region_.width > 0 && region_.height > 0) pipeline_->end_frame(stats_);
    found_.end_frame();
    return whole ? Status::ok : Status::wrong_order;
  }

  [[nodiscard]] std::span<const Marker> markers() const { return found_.all(); }
  [[nodiscard]] std::span<const std::array<Point, 4>> rejected() const { return found_.rejected(); }
  [[nodiscard]] const FrameStats& stats() const { return stats_; }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] std::size_t memory() const {
    return sizeof(*this) + pipeline_->memory() + found_.memory() + rows_.size() * sizeof(rows_[0]) +
           store_.size();
  }

 private:
  void push_row(const std::uint8_t* row, bool copy) {
    const int y = rows_in_++ - region_.y;
    if (y < 0 || y >= region_.height || region_.width == 0) return;
    row += static_cast<std::ptrdiff_t>(region_.x) * step_;
    GreyFrame frame{rows_.data(), region_.width, y + 1, step_, format_};
    if (copy) {
      std::uint8_t* kept =
          store_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(region_.width);
      fast::grey_row(row, region_.width, step_, format_, kept);
      row = kept;
      frame.step = 1;
      frame.format = PixelFormat::grey;
    }
    rows_[static_cast<std::size_t>(y)] = row;
    pipeline_->push_row(frame, found_, stats_);
  }

  Options options_;
  std::vector<Dictionary> dictionaries_;
  std::unique_ptr<FramePipeline> pipeline_;
  FoundMarkers found_;
  FrameStats stats_;
  std::vector<const std::uint8_t*> rows_;  // of the region
  std::vector<std::uint8_t> store_;        // Options::copy_rows
  Region region_;                          // of this frame
  int frame_width_ = 0;
  int frame_height_ = 0;
  int rows_in_ = 0;
  std::uintptr_t last_row_ = 0;  // where it stands
  int step_ = 1;
  PixelFormat format_ = PixelFormat::grey;
  bool streaming_ = false;
};

Result<Detector> Detector::create(const Options& options, std::vector<Dictionary> dictionaries) {
  if (dictionaries.empty()) return Error{"no dictionary given"};
  if (std::string what = complaint(options); !what.empty()) return Error{std::move(what)};
  for (const Dictionary& dictionary : dictionaries) {
    if (const auto what = check_dictionary(dictionary)) {
      return Error{"dictionary " + dictionary.name + ": " + *what};
    }
  }
  auto impl = std::make_unique<Impl>(options, std::move(dictionaries));
  if (std::string what = impl->prepare(); !what.empty()) return Error{std::move(what)};
  return Detector(std::move(impl));
}

Detector::Detector(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Detector::Detector(Detector&&) noexcept = default;
Detector& Detector::operator=(Detector&&) noexcept = default;
Detector::~Detector() = default;

Detection Detector::detect(const ImageView& frame) {
  Status status = frame.check();
  if (status == Status::ok) status = impl_->begin(frame.width, frame.height);
  if (status != Status::ok) return {status, {}};
  status = impl_->push_rows(frame, false);
  const Status ended = impl_->end();
  return {status == Status::ok ? ended : status, impl_->markers()};
}

Status Detector::begin(int width, int height) { return impl_->begin(width, height); }
Status Detector::push_rows(const ImageView& rows) {
  return impl_->push_rows(rows, impl_->options().copy_rows);
}
Status Detector::end() { return impl_->end(); }
std::span<const Marker> Detector::markers() const { return impl_->markers(); }
std::span<const std::array<Point, 4>> Detector::rejected() const { return impl_->rejected(); }
const FrameStats& Detector::stats() const { return impl_->stats(); }
const Options& Detector::options() const { return impl_->options(); }
std::size_t Detector::memory() const { return impl_->memory(); }

}  // namespace runmark
