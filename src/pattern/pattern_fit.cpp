#include "pattern/pattern_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pattern/homography.h"
#include "pattern/normal_equations.h"

namespace runmark {
namespace {

constexpr std::size_t most_places = std::size_t{PatternPicture::most_places} * PatternPicture::most_places;
constexpr std::size_t room = (most_places / CellPoints::group + 1) * CellPoints::group;
constexpr double least_blur = 0.08;  // cells
constexpr double most_blur = 0.9;

/// After the eight parameters of the plane.
enum Parameter : std::size_t { black = 8, contrast = 9, blur_u = 10, blur_v = 11 };
using Step = NormalEquations::Step;

/// Where the plane's change takes a point (s, t), each from -1 to 1 over the square, in cells.
Point moved(const Step& step, double s, double t) {
  const double tilt = step[6] * s + step[7] * t;
  return {step[0] + step[1] * s + step[2] * t + tilt * s, step[3] + step[4] * s + step[5] * t + tilt * t};
}

double length(Point a, Point b) { return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)); }

class Fit {
 public:
  Fit(const PatternCells& cells, const CellPoints& places, const std::array<Point, 4>& corners)
      : cells_(cells), places_(places), corners_(corners) {
    constexpr double usual = 0.9;  // pixels
    const auto in_cells = [&](double sides) {
      return std::clamp(usual * 2 * cells.width / std::max(sides, 1.0), least_blur, most_blur);
    };
    blur_u_ = in_cells(length(corners[0], corners[1]) + length(corners[3], corners[2]));
    blur_v_ = in_cells(length(corners[1], corners[2]) + length(corners[0], corners[3]));
  }

  /// One step; how far it moved the corners, in pixels, or nothing when it leads nowhere.
  [[nodiscard]] std::optional<double> improve(const GreyFrame& frame, const LightModel& light) {
    constexpr double held = 4;  // sharp edges say little about the blur
    const Homography place(corners_, cells_.width);
    std::array<float, room> seen;  // NOLINT(*-member-init): samples fill it
    sample_cells(frame, place, places_, seen.data());
    light.make_relative(places_, seen.data());
    NormalEquations equations;
    compare(seen.data(), equations);
    equations.hold(blur_u, held);
    equations.hold(blur_v, held);
    Step step{};
    if (!equations.solve(step)) return std::nullopt;
    return take(step, place);
  }

  /// The share of the variance that the picture explained before the last step.
  [[nodiscard]] double explained() const { return 1 - unexplained_ / std::max(variance_, 1e-6); }
  [[nodiscard]] bool is_sharp() const { return std::min(blur_u_, blur_v_) <= least_blur; }
  [[nodiscard]] const std::array<Point, 4>& corners() const { return corners_; }

 private:
  /// The frame beside the picture, place by place.
  void compare(const float* seen, NormalEquations& equations) {
    constexpr float doubt = 10;  // a rest of a third of the contrast counts half
    const PatternPicture picture(cells_, blur_u_, blur_v_);
    const int across = 2 * cells_.width + 1;
    std::array<float, PatternPicture::most_places> position{};  // -1 to 1
    for (int i = 0; i < across; ++i) {
      position[static_cast<std::size_t>(i)] =
          static_cast<float>(2 * place_at(i, cells_.width) / cells_.width - 1);
    }
    const auto b = static_cast<float>(black_);
    const auto c = static_cast<float>(contrast_);
    float sum = 0;
    float squares = 0;
    float left = 0;
    PatternPicture::Row row;  // NOLINT(*-member-init): filled for every row
    std::array<NormalEquations::Observation, PatternPicture::most_places> seen_row{};
    for (int y = 0; y < across; ++y) {
      picture.row(y, row);
      const float t = position[static_cast<std::size_t>(y)];
      for (std::size_t i = 0; i < static_cast<std::size_t>(across); ++i) {
        const float s = position[i];
        const float value = *seen++;
        const float rest = value - b - c * row.value[i];
        // What the frame shows here, the picture has where the plane's change came from.
        const float gu = -c * row.along[i];
        const float gv = -c * row.down[i];
        const float tilt = gu * s + gv * t;
        NormalEquations::Observation& o = seen_row[i];
        o.values = {gu,
                    gu * s,
                    gu * t,
                    gv,
                    gv * s,
                    gv * t,
                    tilt * s,
                    tilt * t,
                    1,
                    row.value[i],
                    c * row.by_blur_along[i],
                    c * row.by_blur_down[i],
                    rest,
                    0,
                    0,
                    0};
        const float weight = 1 / (1 + rest * rest * doubt);
        for (std::size_t k = 0; k < NormalEquations::parameters; ++k) o.weighted[k] = weight * o.values[k];
        sum += value;
        squares += value * value;
        left += rest * rest;
      }
      equations.add(seen_row.data(), static_cast<std::size_t>(across));
    }
    const double mean = static_cast<double>(sum) / (across * across);
    variance_ = static_cast<double>(squares) - mean * static_cast<double>(sum);
    unexplained_ = static_cast<double>(left);
  }

  [[nodiscard]] std::optional<double> take(const Step& step, const Homography& place) {
    constexpr double farthest = 0.8;  // cells in one step
    constexpr double most_wider = 0.2;
    constexpr std::array<std::array<double, 2>, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    const double half = cells_.width / 2.0;
    std::array<Point, 4> next{};
    double most = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& [s, t] = square[i];
      const Point change = moved(step, s, t);
      if (std::fabs(change.x) > farthest || std::fabs(change.y) > farthest) return std::nullopt;
      next[i] = place(half * (1 + s) + change.x, half * (1 + t) + change.y);
      most = std::max(most, length(next[i], corners_[i]));
    }
    corners_ = next;
    black_ += step[black];
    contrast_ = std::clamp(contrast_ + step[contrast], 0.4, 2.5);
    const auto widened = [most_wider](double blur, double by) {
      return std::clamp(blur + std::clamp(by, -most_wider, most_wider), least_blur, most_blur);
    };
    blur_u_ = widened(blur_u_, step[blur_u]);
    blur_v_ = widened(blur_v_, step[blur_v]);
    return most;
  }

  const PatternCells& cells_;
  const CellPoints& places_;
  std::array<Point, 4> corners_;
  double black_ = 0;
  double contrast_ = 1;
  double blur_u_ = 0;  // standard deviation, cells
  double blur_v_ = 0;
  double variance_ = 0;
  double unexplained_ = 0;
};

}  // namespace

PatternFit fit_pattern(const GreyFrame& frame, const PatternCells& cells, const CellPoints& places,
                       const LightModel& light, const std::array<Point, 4>& corners) {
  constexpr int most_rounds = 4;
  constexpr double near_enough = 0.15;  // pixels
  Fit fit(cells, places, corners);
  PatternFit result{corners, -1, false};
  for (int round = 0; round < most_rounds; ++round) {
    const std::optional<double> change = fit.improve(frame, light);
    result.explained = std::max(result.explained, fit.explained());
    if (!change) return result;
    if (*change < near_enough) break;
  }
  result.corners = fit.corners();
  result.is_sharp = fit.is_sharp();
  return result;
}

}  // namespace runmark
