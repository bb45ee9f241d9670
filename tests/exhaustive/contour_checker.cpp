#include "contour_checker.h"

#include <algorithm>
#include <span>

#include "preprocess/crack_runs_fast.h"
#include "preprocess/filter.h"
#include "preprocess/filter_table.h"

namespace runmark {
namespace {

constexpr auto none = static_cast<std::size_t>(-1);

/// Thrown out of the linker by a list that does not end.
struct EndlessChain {};

bool filtered_dark(const PixelImage& image, int x, int y, std::uint8_t cases) {
  unsigned window = 0;
  for (int bit = 0; bit < 9; ++bit) {
    window |= static_cast<unsigned>(image.dark(x + bit % 3 - 1, y + bit / 3 - 1)) << bit;
  }
  return filter_pixel(static_cast<Window>(window), cases);
}

}  // namespace

void BitImage::resize(int width, int height) {
  width_ = width;
  height_ = height;
  stride_ = bit_words(width);
  words_.assign(stride_ * (static_cast<std::size_t>(height) + 2), 0);
}

void BitImage::pack(const PixelImage& image, int x, int width) {
  resize(width, image.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int i = 0; i < image.width(); ++i) {
      if (image.dark(i, y)) set_bit(mutable_row(y), x + i, true);
    }
  }
}

void BitImage::filter(const BitImage& image, std::uint8_t cases) {
  resize(image.width(), image.height());
  for (int y = 0; y < height_; ++y) {
    filter_row(image.row(y - 1), image.row(y), image.row(y + 1), width_, cases, mutable_row(y));
  }
}

bool obeys(const NaiveContour& contour, const ChainLimits& limits) {
  return contour.turns <= limits.max_turns && contour.count <= limits.max_records &&
         contour.bottom - contour.top >= limits.min_height && (limits.holes || !contour.hole);
}

const char* ContourChecker::take(const PixelImage& image, std::uint8_t cases, int x, int row_width) {
  x_ = x;
  changed_ = false;
  pixels_ = image;
  bits_.pack(image, x, std::max(row_width, x + image.width()));
  if (cases == 0) return nullptr;
  std::swap(unfiltered_, bits_);
  bits_.filter(unfiltered_, cases);
  for (int y = 0; y < image.height(); ++y) {
    for (int i = 0; i < image.width(); ++i) {
      const bool dark = filtered_dark(image, i, y, cases);
      if (bit_at(bits_.row(y), x + i) != dark) return "the filter does not follow its table";
      if (dark != image.dark(i, y)) changed_ = true;
      pixels_.set(i, y, dark);
    }
  }
  return nullptr;
}

const char* ContourChecker::follow(Connectivity connectivity) {
  follower_.follow(pixels_, connectivity, expected_);
  const auto line = static_cast<std::size_t>(pixels_.width());
  contour_at_run_.resize(expected_.runs.size());
  run_at_crack_.assign(line * (static_cast<std::size_t>(pixels_.height()) + 1), none);
  for (std::size_t c = 0; c < expected_.contours.size(); ++c) {
    const NaiveContour& contour = expected_.contours[c];
    for (std::size_t i = contour.first; i < contour.first + contour.count; ++i) {
      const NaiveRun& run = expected_.runs[i];
      contour_at_run_[i] = c;
      run_at_crack_[static_cast<std::size_t>(run.y) * line +
                    static_cast<std::size_t>(std::min(run.x_from, run.x_to))] = i;
    }
  }

  const std::size_t most = max_crack_runs(bits_.width());
  runs_.resize(most * (static_cast<std::size_t>(bits_.height()) + 1) + fast::crack_runs_slack);
  row_ends_.clear();
  std::size_t count = 0;
  for (int y = 0; y <= bits_.height(); ++y) {
    count += fast::find_crack_runs(bits_.row(y - 1), bits_.row(y), bits_.width(), connectivity,
                                   std::span<CrackRun>(runs_).subspan(count));
    row_ends_.push_back(count);
  }
  return count == expected_.runs.size() ? nullptr : "the number of crack runs is wrong";
}

const char* ContourChecker::link(const ChainLimits& limits, std::size_t capacity) {
  if (records_.size() < capacity) records_.resize(capacity);
  ends_.resize(max_chain_ends(bits_.width()));
  end_at_.resize(static_cast<std::size_t>(bits_.width()) + 1);
  seen_.assign(expected_.contours.size(), false);
  ContourLinker linker(std::span<Record>(records_).first(capacity), ends_, end_at_, limits);

  const char* fault = nullptr;
  std::size_t from = 0;
  try {
    for (std::size_t y = 0; y < row_ends_.size(); ++y) {
      linker.row(static_cast<std::uint16_t>(y), std::span<CrackRun>(runs_).subspan(from, row_ends_[y] - from),
                 [&](const ClosedChain& chain) {
                   const char* found = compare(chain, limits);
                   if (fault == nullptr) fault = found;
                 });
      from = row_ends_[y];
    }
  } catch (const EndlessChain&) {
    return "a contour's list does not end";
  }
  counts_ = linker.counts();
  peak_ = linker.pool().peak();
  if (fault != nullptr) return fault;
  if (linker.open_ends() != 0) return "an end is open after the last row";
  if (linker.pool().alive() != 0) return "a record is not given back";
  if (peak_ > capacity) return "more records were alive than there are";
  if (counts_.runs != expected_.runs.size()) return "the linker's count of runs is wrong";
  const auto handed_on = static_cast<std::size_t>(std::count(seen_.begin(), seen_.end(), true));
  if (counts_.handed_on != handed_on) return "the linker's count of contours handed on is wrong";
  if (counts_.dropped_full == 0) {
    for (std::size_t c = 0; c < seen_.size(); ++c) {
      if (!seen_[c] && obeys(expected_.contours[c], limits)) return "a contour is missing";
    }
  } else if (capacity >= expected_.runs.size()) {
    return "a chain found no record though there are enough";
  }
  return nullptr;
}

const char* ContourChecker::compare(const ClosedChain& chain, const ChainLimits& limits) {
  const int width = pixels_.width();
  const char* fault = nullptr;
  std::size_t count = 0;
  const NaiveContour* contour = nullptr;
  std::size_t next = 0;
  chain.runs([&](int x_from, int x_to, int y) {
    if (++count > expected_.runs.size()) throw EndlessChain{};
    if (fault != nullptr) return;
    const int from = x_from - x_;
    const int to = x_to - x_;
    if (contour == nullptr) {
      const int crack = std::min(from, to);
      const bool inside = crack >= 0 && crack < width && y >= 0 && y <= pixels_.height();
      next = inside ? run_at_crack_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                    static_cast<std::size_t>(crack)]
                    : none;
      if (next == none) {
        fault = "a contour begins where no run is";
        return;
      }
      contour = &expected_.contours[contour_at_run_[next]];
    }
    const NaiveRun& run = expected_.runs[next];
    if (run.x_from != from || run.x_to != to || run.y != y) fault = "a point of a contour is wrong";
    if (++next == contour->first + contour->count) next = contour->first;
  });
  if (fault != nullptr) return fault;
  if (contour == nullptr) return "a contour has no run";
  const auto number = static_cast<std::size_t>(contour - expected_.contours.data());
  if (seen_[number]) return "a contour is handed on twice";
  seen_[number] = true;
  if (count != contour->count || chain.records != count) return "a contour's length is wrong";
  if (chain.turns != contour->turns) return "a contour's count of turns is wrong";
  if (chain.top != contour->top || chain.bottom != contour->bottom) return "a contour's height is wrong";
  if (chain.hole != contour->hole) return "a hole is taken for an object or the other way round";
  if (!obeys(*contour, limits)) return "a contour that breaks the limits is handed on";
  // The last run is the one that closed it.
  const NaiveRun& last = expected_.runs[next == contour->first ? next + count - 1 : next - 1];
  if (last.y != contour->bottom) return "a contour does not end with the run that closed it";
  return nullptr;
}

}  // namespace runmark
