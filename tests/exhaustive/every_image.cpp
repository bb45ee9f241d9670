#include "every_image.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

#include "runmark/options.h"

namespace runmark {
namespace {

struct Run {
  ChainLimits limits;
  std::size_t capacity = 64;  // no image of 32 pixels has more runs
};

constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max();
constexpr Run no_limits{{.max_turns = any, .max_records = any}};

// Tight enough to drop something in images this small; each pair must drop the same early and late.
constexpr std::array<Run, 7> tight_limits{{
    {{.max_turns = 2, .max_records = any, .drop_early = true}},
    {{.max_turns = 2, .max_records = any, .drop_early = false}},
    {{.max_turns = any, .max_records = 4, .min_height = 2, .drop_early = true}},
    {{.max_turns = any, .max_records = 4, .min_height = 2, .drop_early = false}},
    {{.max_turns = 4, .max_records = 6, .holes = false, .drop_early = true}},
    {{.max_turns = 4, .max_records = 6, .holes = false, .drop_early = false}},
    {{.max_turns = 6, .max_records = 8}, 5},
}};

const char* check_connectivity(ContourChecker& checker, Connectivity connectivity, bool limits) {
  if (const char* fault = checker.follow(connectivity)) return fault;
  if (const char* fault = checker.link(no_limits.limits, no_limits.capacity)) return fault;
  if (!limits) return nullptr;
  for (const Run& run : tight_limits) {
    if (const char* fault = checker.link(run.limits, run.capacity)) return fault;
  }
  return nullptr;
}

const char* check_connectivities(ContourChecker& checker, const ProofScope& scope) {
  if (scope.four) {
    if (const char* fault = check_connectivity(checker, Connectivity::four, scope.limits)) return fault;
  }
  return scope.eight ? check_connectivity(checker, Connectivity::eight, scope.limits) : nullptr;
}

/// Whether an image (PixelImage::set_all) has a side without a dark pixel.
bool has_light_side(std::uint64_t bits, int width, int height) {
  std::uint64_t columns = 0;
  const std::uint64_t row = (std::uint64_t{1} << width) - 1;
  for (int y = 0; y < height; ++y) columns |= bits >> (y * width) & row;
  const std::uint64_t last_row = bits >> ((height - 1) * width);
  return (bits & row) == 0 || last_row == 0 || (columns & 1) == 0 || columns >> (width - 1) == 0;
}

}  // namespace

const char* check_image(ContourChecker& checker, const PixelImage& image, const ProofScope& scope) {
  if (scope.unfiltered) {
    if (const char* fault = checker.take(image, filter_none, scope.column)) return fault;
    if (const char* fault = check_connectivities(checker, scope)) return fault;
  }
  if (!scope.filtered) return nullptr;
  if (const char* fault = checker.take(image, filter_all, scope.column)) return fault;
  // What the filter leaves as it was has just been checked.
  if (scope.unfiltered && !checker.filter_changed()) return nullptr;
  return check_connectivities(checker, scope);
}

ProofResult check_every_image(int width, int height, int threads, const ProofScope& scope) {
  ProofResult result;
  result.images = std::uint64_t{1} << (width * height);
  constexpr std::uint64_t block = 4096;
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    ContourChecker checker;
    PixelImage image(width, height);
    for (std::uint64_t begin = next.fetch_add(block); begin < result.images; begin = next.fetch_add(block)) {
      for (std::uint64_t bits = begin; bits < std::min(begin + block, result.images); ++bits) {
        if (scope.smaller_left_out && has_light_side(bits, width, height)) continue;
        image.set_all(bits);
        const char* fault = check_image(checker, image, scope);
        if (fault == nullptr) continue;
        const std::lock_guard lock(mutex);
        if (result.wrong++ == 0 || bits < result.first_wrong) {
          result.first_wrong = bits;
          result.first_fault = fault;
        }
      }
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return result;
}

}  // namespace runmark
