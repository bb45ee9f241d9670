#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runmark/calibration.h"

namespace runmark::cli {

/// Which parts of the picture the corners of a calibration reach: what lies outside is the lens model's
/// guess.
class Coverage {
 public:
  static constexpr int columns = 8;
  static constexpr int rows = 6;

  Coverage(const std::vector<CalibrationView>& views, const Calibration& calibration);

  [[nodiscard]] int corners(int column, int row) const {
    return counts_[static_cast<std::size_t>(row * columns + column)];
  }
  [[nodiscard]] int parts_reached() const;
  /// Ninths of the picture without a corner, such as "upper left"; empty when there are none.
  [[nodiscard]] std::vector<std::string_view> empty_regions() const { return empty_; }

 private:
  std::vector<int> counts_;
  std::vector<std::string_view> empty_;
};

/// Writes a picture of all corners, each view in a colour of its own, over the parts they reach. Throws
/// UserError.
void write_coverage_picture(const std::string& path, const std::vector<CalibrationView>& views,
                            const Calibration& calibration);

}  // namespace runmark::cli
