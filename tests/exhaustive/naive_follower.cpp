#include "naive_follower.h"

#include <algorithm>

namespace runmark {
namespace {

enum Heading { right, down, left, up };
constexpr int step_x[] = {1, 0, -1, 0};
constexpr int step_y[] = {0, 1, 0, -1};
// The pixel ahead on either hand, seen from a crack corner: pixel (x, y) has its top left corner at (x, y).
constexpr int right_hand_x[] = {0, -1, -1, 0};
constexpr int right_hand_y[] = {0, 0, -1, -1};
constexpr int left_hand_x[] = {0, 0, -1, -1};
constexpr int left_hand_y[] = {-1, 0, 0, -1};

constexpr Heading turned_right(Heading heading) { return static_cast<Heading>((heading + 1) % 4); }
constexpr Heading turned_left(Heading heading) { return static_cast<Heading>((heading + 3) % 4); }
constexpr bool level(Heading heading) { return heading == right || heading == left; }

}  // namespace

void NaiveFollower::follow(const PixelImage& image, Connectivity connectivity, NaiveContours& found) {
  found.runs.clear();
  found.contours.clear();
  stride_ = static_cast<std::size_t>(image.width()) + 2;
  const std::size_t size = stride_ * (static_cast<std::size_t>(image.height()) + 2);
  dark_.assign(size, 0);
  walked_.assign(size, 0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) dark_[at(x, y)] = image.dark(x, y) ? 1 : 0;
  }
  // Every contour has a crack above a dark pixel, and the first one in raster order begins a run.
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (dark(x, y) && !dark(x, y - 1) && walked_[at(x, y)] == 0) walk(x, y, connectivity, found);
    }
  }
}

void NaiveFollower::walk(int x, int y, Connectivity connectivity, NaiveContours& found) {
  NaiveContour contour;
  contour.first = found.runs.size();
  contour.top = contour.bottom = y;
  long area = 0;  // positive when walked clockwise, round something dark
  Heading heading = right;
  Heading came = up;  // the last upright heading; the first run's is known at the end
  bool first_is_open = true;
  Heading first_left = up;
  int run_from = x;
  while (true) {
    if (heading == right) walked_[at(x, y)] = 1;
    x += step_x[heading];
    y += step_y[heading];
    const bool on_right = dark(x + right_hand_x[heading], y + right_hand_y[heading]);
    const bool on_left = dark(x + left_hand_x[heading], y + left_hand_y[heading]);
    if (on_right && !on_left) continue;
    // Dark on the left hand only: the pixel walked along meets another one at this corner.
    const bool across = on_left && (on_right || connectivity == Connectivity::eight);
    const Heading next = across ? turned_left(heading) : turned_right(heading);
    if (level(heading)) {
      found.runs.push_back({run_from, x, y});
      area += static_cast<long>(y) * (run_from - x);
      contour.top = std::min(contour.top, y);
      contour.bottom = std::max(contour.bottom, y);
      if (first_is_open) {
        first_left = next;
        first_is_open = false;
      } else if (came != next) {
        ++contour.turns;
      }
    } else {
      came = heading;
      run_from = x;
      if (next == right && walked_[at(x, y)] != 0) break;
    }
    heading = next;
  }
  if (came != first_left) ++contour.turns;
  contour.count = found.runs.size() - contour.first;
  contour.hole = area < 0;
  found.contours.push_back(contour);
}

}  // namespace runmark
