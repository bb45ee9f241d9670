#pragma once

#include <cstddef>
#include <vector>

#include "pixel_image.h"
#include "runmark/options.h"

namespace runmark {

/// A horizontal stretch of a contour from corner (x_from, y) to corner (x_to, y).
struct NaiveRun {
  int x_from = 0;
  int x_to = 0;
  int y = 0;
};

/// One closed contour: `count` runs from `first` on in NaiveContours::runs, in the order in which the
/// boundary is walked.
struct NaiveContour {
  std::size_t first = 0;
  std::size_t count = 0;
  std::size_t turns = 0;  ///< runs that the boundary comes to and leaves on the same side, up or down
  int top = 0;
  int bottom = 0;
  bool hole = false;
};

struct NaiveContours {
  std::vector<NaiveRun> runs;
  std::vector<NaiveContour> contours;
};

/// Follows every boundary between dark and light crack by crack, the dark pixel on the right hand, looking
/// at two pixels a step: the textbook definition, which knows neither rows nor runs nor open chains.
class NaiveFollower {
 public:
  void follow(const PixelImage& image, Connectivity connectivity, NaiveContours& found);

 private:
  void walk(int x, int y, Connectivity connectivity, NaiveContours& found);
  [[nodiscard]] bool dark(int x, int y) const { return dark_[at(x, y)] != 0; }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1);
  }

  std::vector<char> dark_;    // with a light pixel on every side
  std::vector<char> walked_;  // cracks above a pixel that some contour has passed
  std::size_t stride_ = 0;
};

}  // namespace runmark
