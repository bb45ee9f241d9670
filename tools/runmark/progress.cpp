#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace runmark::cli {
namespace {

constexpr auto first_after = std::chrono::milliseconds(500);
constexpr auto again_after = std::chrono::milliseconds(100);
constexpr int bar_width = 30;

// ECMA-48: to the first column, erase to the end of the line.
constexpr const char* erase_line = "\r\x1b[K";

bool is_plain_terminal() {
  const char* terminal = std::getenv("TERM");
  return terminal == nullptr || std::string_view(terminal) == "dumb";
}

}  // namespace

Progress::Progress() : enabled_(isatty(STDERR_FILENO) != 0 && !is_plain_terminal()) {}

void Progress::update(std::int64_t done, double fraction) {
  if (!enabled_) return;
  const auto now = Clock::now();
  if (now - start_ < first_after || now - last_ < again_after) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double rate = static_cast<double>(done) / seconds;
  if (fraction <= 0) {
    std::fprintf(stderr, "%s%lld frames, %.1f frames/s", erase_line, static_cast<long long>(done), rate);
  } else {
    fraction = std::min(fraction, 1.0);
    const int filled = static_cast<int>(fraction * bar_width);
    std::string bar(static_cast<std::size_t>(filled), '#');
    bar.resize(bar_width, '-');
    const int left = static_cast<int>(seconds * (1 - fraction) / fraction + 0.5);
    std::fprintf(stderr, "%s[%s] %3d %%  %lld frames, %.1f frames/s, %d:%02d left", erase_line, bar.c_str(),
                 static_cast<int>(fraction * 100), static_cast<long long>(done), rate, left / 60, left % 60);
  }
  std::fflush(stderr);
  shown_ = true;
}

void Progress::clear() {
  if (!shown_) return;
  std::fputs(erase_line, stderr);
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace runmark::cli
