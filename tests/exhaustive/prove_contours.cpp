// Runs every binary image there is, up to a number of pixels and in every shape, through the preprocess and
// contour cores and compares every contour with the naive follower's.
//
//   prove_contours [--pixels N] [--shape WxH] [--column X] [--threads N] [--only
//   unfiltered-8|unfiltered-4|whole]
//
// --only whole leaves out images that have a light side: they are images of a smaller shape.
//
// Without --pixels: RUNMARK_EXHAUSTIVE_PIXELS, else 20. Exit status 0: all right; 1: an image is wrong;
// 2: bad arguments.

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "every_image.h"

namespace {

using runmark::ProofResult;
using runmark::ProofScope;

constexpr int most_pixels = 32;

std::optional<int> number(std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && value >= least && value <= most ? std::optional(value) : std::nullopt;
}

struct Arguments {
  int pixels = 20;
  int width = 0;  // one shape only
  int height = 0;
  int threads = 2;
  ProofScope scope;
};

bool parse(std::string_view name, std::string_view value, Arguments& arguments) {
  if (name == "--pixels") {
    const auto pixels = number(value, 1, most_pixels);
    arguments.pixels = pixels.value_or(0);
    return pixels.has_value();
  }
  if (name == "--threads") {
    const auto threads = number(value, 1, 64);
    arguments.threads = threads.value_or(0);
    return threads.has_value();
  }
  if (name == "--column") {
    const auto column = number(value, 0, 4096);
    arguments.scope.column = column.value_or(0);
    return column.has_value();
  }
  if (name == "--shape") {
    const std::size_t cross = value.find('x');
    if (cross == std::string_view::npos) return false;
    arguments.width = number(value.substr(0, cross), 1, most_pixels).value_or(0);
    arguments.height = number(value.substr(cross + 1), 1, most_pixels).value_or(0);
    const int pixels = arguments.width * arguments.height;
    return pixels >= 1 && pixels <= most_pixels;
  }
  if (name == "--only" && value == "whole") {
    arguments.scope.smaller_left_out = true;
    return true;
  }
  if (name == "--only" && (value == "unfiltered-8" || value == "unfiltered-4")) {
    const bool eight = value == "unfiltered-8";
    arguments.scope.four = !eight;
    arguments.scope.eight = eight;
    arguments.scope.filtered = false;
    arguments.scope.limits = false;
    return true;
  }
  return false;
}

/// Prints the shape's result.
ProofResult prove(int width, int height, const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const ProofResult result = runmark::check_every_image(width, height, arguments.threads, arguments.scope);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("%dx%d: %llu images, %llu wrong, %.1f s\n", width, height,
              static_cast<unsigned long long>(result.images), static_cast<unsigned long long>(result.wrong),
              took.count());
  if (result.wrong != 0) {
    std::printf("first wrong image: %s\n", result.first_fault);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        std::putchar((result.first_wrong >> (y * width + x) & 1U) != 0 ? '#' : '.');
      }
      std::putchar('\n');
    }
  }
  std::fflush(stdout);
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  const char* limit = std::getenv("RUNMARK_EXHAUSTIVE_PIXELS");
  if (limit != nullptr && !parse("--pixels", limit, arguments)) {
    std::fprintf(stderr, "RUNMARK_EXHAUSTIVE_PIXELS=%s: not a number from 1 to %d\n", limit, most_pixels);
    return 2;
  }
  for (int i = 1; i < argc; i += 2) {
    if (i + 1 == argc || !parse(argv[i], argv[i + 1], arguments)) {
      std::fprintf(stderr, "prove_contours: %s %s: unknown argument, bad value or more than %d pixels\n",
                   argv[i], i + 1 == argc ? "(no value)" : argv[i + 1], most_pixels);
      return 2;
    }
  }
  std::uint64_t images = 0;
  std::uint64_t wrong = 0;
  const auto add = [&](const ProofResult& result) {
    images += result.images;
    wrong += result.wrong;
  };
  if (arguments.width != 0) {
    add(prove(arguments.width, arguments.height, arguments));
  } else {
    for (int pixels = 1; pixels <= arguments.pixels; ++pixels) {
      for (int width = 1; width <= pixels; ++width) {
        if (pixels % width == 0) add(prove(width, pixels / width, arguments));
      }
    }
  }
  std::printf("%llu images, %llu wrong\n", static_cast<unsigned long long>(images),
              static_cast<unsigned long long>(wrong));
  return wrong == 0 ? 0 : 1;
}
