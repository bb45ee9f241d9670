#include "marker_format.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "pose_json.h"

namespace runmark::cli {
namespace {

/// To three decimals: a thousandth of a pixel is far below what any detector can tell.
double rounded(double value) { return std::round(value * 1000) / 1000 + 0.0; }

/// printf into a string of its own; lines longer than the buffer do not occur.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...) {
  std::array<char, 256> buffer{};
  std::va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(buffer.data(), buffer.size(), pattern, arguments);
  va_end(arguments);
  return buffer.data();
}

/// For people.
class TextFormat : public MarkerFormat {
 public:
  explicit TextFormat(const MarkerExtras& extras) : extras_(extras) {}

  [[nodiscard]] std::string frame(const Frame& frame, std::span<const Marker> markers,
                                  const FramePoses* poses, const FrameReport* report) const override {
    const std::string count = markers.size() == 1 ? "1 marker" : std::to_string(markers.size()) + " markers";
    std::string text = frame.source;
    if (!frame.still) text += format(", frame %lld", static_cast<long long>(frame.index));
    text += format(", %d x %d: ", frame.pixels.cols, frame.pixels.rows) + count + '\n';
    for (std::size_t i = 0; i < markers.size(); ++i) {
      text += line(markers[i]);
      if (extras_.row_time > 0) text += time_line(markers[i]);
      if (poses != nullptr && poses->markers[i]) text += line(*poses->markers[i]);
    }
    if (poses != nullptr && poses->has_board) text += board_line(*poses);
    if (report != nullptr) text += line(*report);
    return text;
  }

 private:
  static std::string line(const Marker& marker) {
    std::string text = format("  %-18.*s %5d ", static_cast<int>(marker.dictionary.size()),
                              marker.dictionary.data(), marker.id);
    for (const Point& corner : marker.corners) text += format(" (%8.3f, %8.3f)", corner.x, corner.y);
    return text + format("  hamming %d  margin %.3f%s\n", marker.hamming, static_cast<double>(marker.margin),
                         marker.inverted ? "  inverted" : "");
  }

  [[nodiscard]] std::string time_line(const Marker& marker) const {
    const auto [first, last] = rows_of(marker);
    return format("    rows %.3f to %.3f: %.3f to %.3f us after the first row\n", first, last,
                  first * extras_.row_time, last * extras_.row_time);
  }

  static std::string line(const PoseEstimate& estimate) {
    const PoseSolution& best = estimate.best;
    const Point3& t = best.pose.translation;
    const Point3 r = rotation_vector(best.pose);
    const auto deviation = [&](std::size_t i) { return std::sqrt(best.covariance[7 * i]); };
    return format(
               "    at (%.6g, %.6g, %.6g) +- (%.2g, %.2g, %.2g), rotation vector (%.4f, %.4f, %.4f), error "
               "%.3f px",
               t.x, t.y, t.z, deviation(0), deviation(1), deviation(2), r.x, r.y, r.z, best.error) +
           format(", ambiguity %.2f\n", estimate.ambiguity);
  }

  static std::string board_line(const FramePoses& poses) {
    return format("  board: %zu markers, %zu chessboard corners\n", poses.board.markers.size(),
                  poses.board.corners.size()) +
           (poses.board_pose ? line(*poses.board_pose) : "");
  }

  static std::string line(const FrameReport& report) {
    const FrameStats& s = report.stats;
    const auto number = [](std::uint64_t n) { return std::to_string(n); };
    return format("  %.3f ms: ", report.milliseconds) + number(s.pixels) + " pixels, " +
           number(s.crack_runs) + " crack runs, " + number(s.closed_chains) + " closed chains, " +
           number(s.quads) + " quads, " + number(s.records_peak) + " records at most, " +
           number(s.dropped_chains) + " chains and " + number(s.dropped_markers) + " markers dropped\n";
  }

  MarkerExtras extras_;
};

/// One JSON object a frame.
class JsonLinesFormat : public MarkerFormat {
 public:
  explicit JsonLinesFormat(const MarkerExtras& extras) : extras_(extras) {}

  [[nodiscard]] std::string frame(const Frame& frame, std::span<const Marker> markers,
                                  const FramePoses* poses, const FrameReport* report) const override {
    Json line{{"source", frame.source},
              {"frame", frame.index},
              {"width", frame.pixels.cols},
              {"height", frame.pixels.rows},
              {"markers", Json::array()}};
    for (std::size_t i = 0; i < markers.size(); ++i) {
      line["markers"].push_back(to_json(markers[i]));
      if (extras_.row_time > 0) add_times(markers[i], line["markers"].back());
      if (poses != nullptr && poses->markers[i])
        line["markers"].back()["pose"] = cli::to_json(*poses->markers[i]);
    }
    if (poses != nullptr && poses->has_board) line["board"] = board_json(*poses);
    if (report != nullptr) {
      line["stats"] = to_json(report->stats);
      line["ms"] = rounded(report->milliseconds);
    }
    // File names need not be UTF-8; JSON must be.
    return line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  }

 private:
  using Json = nlohmann::ordered_json;

  static Json to_json(const Marker& marker) {
    Json corners = Json::array();
    for (const Point& corner : marker.corners) {
      corners.push_back(Json::array({rounded(corner.x), rounded(corner.y)}));
    }
    return {{"dictionary", marker.dictionary},
            {"id", marker.id},
            {"corners", corners},
            {"hamming", marker.hamming},
            {"margin", rounded(static_cast<double>(marker.margin))},
            {"inverted", marker.inverted}};
  }

  void add_times(const Marker& marker, Json& json) const {
    const auto [first, last] = rows_of(marker);
    json["rows"] = {rounded(first), rounded(last)};
    json["row_times_us"] = {rounded(first * extras_.row_time), rounded(last * extras_.row_time)};
  }

  static Json to_json(const FrameStats& stats) {
    return {{"pixels", stats.pixels},
            {"crack_runs", stats.crack_runs},
            {"closed_chains", stats.closed_chains},
            {"quads", stats.quads},
            {"records_peak", stats.records_peak},
            {"dropped_chains", stats.dropped_chains},
            {"dropped_markers", stats.dropped_markers}};
  }

  MarkerExtras extras_;
};

/// One row a marker, as RFC 4180 has it but for the line ends.
class CsvFormat : public MarkerFormat {
 public:
  explicit CsvFormat(const MarkerExtras& extras) : extras_(extras) {}

  [[nodiscard]] std::string header() const override {
    return std::string(
               "source,frame,width,height,dictionary,id,x0,y0,x1,y1,x2,y2,x3,y3,hamming,margin,inverted") +
           (extras_.row_time > 0 ? ",first_row,last_row,first_us,last_us" : "") +
           (extras_.poses ? ",tx,ty,tz,qx,qy,qz,qw,error,ambiguity\n" : "\n");
  }

  [[nodiscard]] std::string frame(const Frame& frame, std::span<const Marker> markers,
                                  const FramePoses* poses, const FrameReport* /*report*/) const override {
    const std::string start =
        quoted(frame.source) +
        format(",%lld,%d,%d,", static_cast<long long>(frame.index), frame.pixels.cols, frame.pixels.rows);
    std::string text;
    for (std::size_t i = 0; i < markers.size(); ++i) {
      const Marker& marker = markers[i];
      text += start + quoted(std::string(marker.dictionary)) + format(",%d", marker.id);
      for (const Point& corner : marker.corners) text += format(",%.3f,%.3f", corner.x, corner.y);
      text +=
          format(",%d,%.3f,%d", marker.hamming, static_cast<double>(marker.margin), marker.inverted ? 1 : 0);
      if (extras_.row_time > 0) text += fields(marker);
      if (extras_.poses)
        text += poses != nullptr && poses->markers[i] ? fields(*poses->markers[i]) : ",,,,,,,,,";
      text += '\n';
    }
    return text;
  }

 private:
  [[nodiscard]] std::string fields(const Marker& marker) const {
    const auto [first, last] = rows_of(marker);
    return format(",%.3f,%.3f,%.3f,%.3f", first, last, first * extras_.row_time, last * extras_.row_time);
  }

  static std::string fields(const PoseEstimate& estimate) {
    const Point3& t = estimate.best.pose.translation;
    const auto [x, y, z, w] = quaternion(estimate.best.pose);
    return format(",%.8g,%.8g,%.8g,%.7f,%.7f,%.7f,%.7f,%.3f,%.4f", t.x, t.y, t.z, x, y, z, w,
                  estimate.best.error, estimate.ambiguity);
  }

  static std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"\n\r") == std::string::npos) return field;
    std::string text = "\"";
    for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + '"';
  }

  MarkerExtras extras_;
};

}  // namespace

std::unique_ptr<MarkerFormat> make_marker_format(std::string_view name, const MarkerExtras& extras) {
  if (name == "jsonl") return std::make_unique<JsonLinesFormat>(extras);
  if (name == "csv") return std::make_unique<CsvFormat>(extras);
  return std::make_unique<TextFormat>(extras);
}

}  // namespace runmark::cli
