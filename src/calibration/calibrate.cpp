#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/opencv_calibration.h"
#include "pose/refine_pose.h"
#include "runmark/calibration.h"

namespace runmark {
namespace {

constexpr std::size_t least_corners = 6;

/// Whether the corners span an area of the picture.
bool is_wide(const std::vector<Point>& image) {
  double x = 0;
  double y = 0;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (const Point& p : image) {
    x += p.x;
    y += p.y;
  }
  const auto n = static_cast<double>(image.size());
  for (const Point& p : image) {
    xx += (p.x - x / n) * (p.x - x / n);
    xy += (p.x - x / n) * (p.y - y / n);
    yy += (p.y - y / n) * (p.y - y / n);
  }
  const double half = (xx + yy) / 2;
  const double least = half - std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
  return least > 1e-3 * (xx + yy);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double length(Point p) { return std::hypot(p.x, p.y); }

/// The view without the corners left out.
CalibrationView used_part(const CalibrationView& view, const std::vector<bool>& used) {
  CalibrationView part{view.name, {}, {}};
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    part.object.push_back(view.object[i]);
    part.image.push_back(view.image[i]);
  }
  return part;
}

class Calibrator {
 public:
  Calibrator(std::span<const CalibrationView> views, int width, int height, Lens lens)
      : views_(views), width_(width), height_(height), lens_(lens) {
    for (const CalibrationView& view : views) {
      CalibratedView& result = result_.views.emplace_back();
      result.used.assign(view.object.size(), true);
    }
  }

  Result<Calibration> run() {
    constexpr int most_rounds = 4;
    for (int round = 0;; ++round) {
      if (auto error = fit()) return *error;
      if (round == most_rounds || !leave_out()) return result_;
    }
  }

 private:
  std::optional<Error> fit() {
    std::vector<CalibrationView> parts;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      if (result_.views[i].outlier) continue;
      parts.push_back(used_part(views_[i], result_.views[i].used));
      indices.push_back(i);
    }
    std::vector<const CalibrationView*> pointers;
    for (const CalibrationView& part : parts) pointers.push_back(&part);
    HeldCoefficients held;
    Result<RawCalibration> raw = calibrate_by_opencv(pointers, width_, height_, lens_, held);
    if (raw && lens_ == Lens::plain) raw = simpler(pointers, std::move(raw), held);
    if (!raw) return Error{raw.error()};
    result_.camera = raw->camera;
    result_.deviations = raw->deviations;
    for (std::size_t k = 0; k < indices.size(); ++k) result_.views[indices[k]].pose = raw->poses[k];
    measure();
    return {};
  }

  /// Holds coefficients at 0 that the views do not tell apart from it: they only fit the noise.
  Result<RawCalibration> simpler(const std::vector<const CalibrationView*>& views, Result<RawCalibration> raw,
                                 HeldCoefficients held) const {
    // Lenses are centred well, so a tangential part has to show itself; k3 has only to be more than noise.
    const auto within = [&](std::size_t i, double deviations) {
      return std::fabs(raw->camera.distortion[i]) < deviations * raw->deviations[4 + i];
    };
    if (within(4, 1)) {
      held.k3 = true;
      Result<RawCalibration> without = calibrate_by_opencv(views, width_, height_, lens_, held);
      if (!without) return raw;
      raw = std::move(without);
    }
    if (within(2, 2) && within(3, 2)) {
      held.tangential = true;
      Result<RawCalibration> without = calibrate_by_opencv(views, width_, height_, lens_, held);
      if (without) raw = std::move(without);
    }
    return raw;
  }

  /// Every corner's offset, with the pose refined to those that are used.
  void measure() {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < views_.size(); ++i) {
      CalibratedView& view = result_.views[i];
      Observation seen;
      const CalibrationView part = used_part(views_[i], view.used);
      for (std::size_t k = 0; k < part.object.size(); ++k) seen.add_point(part.object[k], part.image[k], 1);
      const auto refined = refine_pose(seen, result_.camera, view.pose);
      if (refined) view.pose = refined->solution.pose;
      view.offsets.clear();
      double view_sum = 0;
      std::size_t view_count = 0;
      for (std::size_t k = 0; k < views_[i].object.size(); ++k) {
        const std::optional<Point> p = result_.camera.project(view.pose(views_[i].object[k]));
        const Point seen_at = views_[i].image[k];
        const Point offset = p ? Point{seen_at.x - p->x, seen_at.y - p->y} : Point{1e6, 1e6};
        view.offsets.push_back(offset);
        if (!view.used[k]) continue;
        view_sum += offset.x * offset.x + offset.y * offset.y;
        ++view_count;
      }
      view.error = view_count > 0 ? std::sqrt(view_sum / static_cast<double>(view_count)) : 0;
      if (view.outlier) continue;
      sum += view_sum;
      count += view_count;
    }
    result_.error = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(count, 1)));
  }

  /// Marks what disagrees with the rest; false when nothing new does.
  bool leave_out() {
    constexpr double least_off = 0.3;  // pixels: nothing nearer is left out
    constexpr double far_off = 5;      // times the median
    constexpr double bad_view = 3;
    constexpr std::ptrdiff_t least_views = 4;
    std::vector<double> medians;  // one wrong corner makes no wrong view
    std::vector<double> offsets;
    for (const CalibratedView& view : result_.views) {
      std::vector<double> own;
      for (std::size_t k = 0; k < view.used.size(); ++k) {
        if (view.used[k]) own.push_back(length(view.offsets[k]));
      }
      medians.push_back(median(own));
      if (!view.outlier) offsets.insert(offsets.end(), own.begin(), own.end());
    }
    bool more = false;
    // A whole view first: it has bent the others.
    const double usual = median(offsets);
    const auto kept =
        std::count_if(result_.views.begin(), result_.views.end(), [](const auto& v) { return !v.outlier; });
    if (kept > least_views) {
      for (std::size_t i = 0; i < result_.views.size(); ++i) {
        if (result_.views[i].outlier || medians[i] < std::max(bad_view * usual, least_off)) continue;
        result_.views[i].outlier = true;
        more = true;
      }
      if (more) return true;
    }
    const double limit = std::max(far_off * usual, least_off);
    for (CalibratedView& view : result_.views) {
      if (view.outlier) continue;
      for (std::size_t k = 0; k < view.used.size(); ++k) {
        if (!view.used[k] || length(view.offsets[k]) < limit) continue;
        if (std::count(view.used.begin(), view.used.end(), true) <=
            static_cast<std::ptrdiff_t>(least_corners))
          break;
        view.used[k] = false;
        more = true;
      }
    }
    return more;
  }

  std::span<const CalibrationView> views_;
  int width_;
  int height_;
  Lens lens_;
  Calibration result_;
};

}  // namespace

CalibrationView calibration_view(const Board& board, const BoardView& view, std::string name) {
  CalibrationView result{std::move(name), {}, {}};
  if (!board.chess_corners.empty()) {
    for (const SeenCorner& corner : view.corners) {
      result.object.push_back(board.chess_corners[static_cast<std::size_t>(corner.index)]);
      result.image.push_back(corner.place);
    }
  } else {
    for (const SeenMarker& seen : view.markers) {
      const BoardMarker& place = board.markers[static_cast<std::size_t>(seen.index)];
      result.object.insert(result.object.end(), place.corners.begin(), place.corners.end());
      result.image.insert(result.image.end(), seen.marker.corners.begin(), seen.marker.corners.end());
    }
  }
  if (result.object.size() < least_corners || !is_wide(result.image)) return {result.name, {}, {}};
  return result;
}

Result<Calibration> calibrate(std::span<const CalibrationView> views, int width, int height, Lens lens) {
  if (width < 1 || height < 1) return Error{"a picture has at least one pixel"};
  if (views.size() < 2) {
    return Error{"a calibration needs at least two views of the board; " + std::to_string(views.size()) +
                 " given"};
  }
  for (const CalibrationView& view : views) {
    if (view.object.size() != view.image.size() || view.object.size() < least_corners ||
        !is_wide(view.image)) {
      return Error{view.name +
                   ": too little of the board is seen: 6 corners that are not on one line are needed"};
    }
  }
  return Calibrator(views, width, height, lens).run();
}

}  // namespace runmark
