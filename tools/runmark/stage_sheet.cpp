#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "stage_pictures.h"

namespace runmark::cli {
namespace {

constexpr int columns = 4;
constexpr int cell_width = 480;
constexpr int caption_height = 30;
constexpr int gap = 12;
constexpr int title_height = 48;
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar ink(40, 40, 40);

void put_line(cv::Mat& sheet, const std::string& text, cv::Point at, double scale) {
  cv::putText(sheet, text, at, font, scale, ink, 1, cv::LINE_AA);
}

/// The picture made to fit, in the middle of the cell.
void put_picture(cv::Mat& sheet, const cv::Mat& picture, const cv::Rect& cell) {
  const double zoom = std::min(static_cast<double>(cell.width) / picture.cols,
                               static_cast<double>(cell.height) / picture.rows);
  const cv::Size size(std::max(1, static_cast<int>(picture.cols * zoom)),
                      std::max(1, static_cast<int>(picture.rows * zoom)));
  cv::Mat scaled;
  cv::resize(picture, scaled, size, 0, 0, zoom < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
  const cv::Rect place(cell.x + (cell.width - size.width) / 2, cell.y + (cell.height - size.height) / 2,
                       size.width, size.height);
  scaled.copyTo(sheet(place));
  cv::rectangle(sheet, place, cv::Scalar::all(190));
}

/// 307200 as 307,200.
std::string with_commas(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), ",");
  }
  return text;
}

void put_counts(cv::Mat& sheet, const StageTrace& trace, const cv::Rect& cell) {
  const FrameStats& stats = trace.stats;
  const std::uint64_t runs = std::max<std::uint64_t>(stats.crack_runs, 1);
  const std::vector<std::string> lines{
      with_commas(stats.pixels) + " pixels, all scales",
      with_commas(stats.crack_runs) + " crack runs: one for " + std::to_string(stats.pixels / runs) +
          " pixels",
      with_commas(stats.closed_chains) + " contours closed",
      with_commas(stats.records_peak) + " records alive at most",
      with_commas(trace.markers.size()) + (trace.markers.size() == 1 ? " marker" : " markers")};
  int y = cell.y + 40;
  for (const std::string& line : lines) {
    put_line(sheet, line, {cell.x + 16, y}, 0.6);
    y += 34;
  }
}

}  // namespace

cv::Mat draw_sheet(const std::vector<StagePicture>& pictures, const StageTrace& trace,
                   const std::string& title) {
  std::vector<const StagePicture*> shown;
  for (const StagePicture& picture : pictures) {
    if (picture.on_sheet) shown.push_back(&picture);
  }
  const double shape = static_cast<double>(trace.picture.rows) / trace.picture.cols;
  const int cell_height = static_cast<int>(cell_width * std::clamp(shape, 0.5, 1.4));
  const int rows = (static_cast<int>(shown.size()) + columns) / columns;  // one cell more, for the counts
  const int step = cell_height + caption_height + gap;
  cv::Mat sheet(title_height + rows * step + gap, columns * (cell_width + gap) + gap, CV_8UC3,
                cv::Scalar::all(255));
  put_line(sheet, title, {gap, title_height - 16}, 0.8);
  const auto cell_at = [&](int i) {
    return cv::Rect(gap + i % columns * (cell_width + gap), title_height + i / columns * step, cell_width,
                    cell_height);
  };
  int i = 0;
  for (const StagePicture* picture : shown) {
    const cv::Rect cell = cell_at(i++);
    put_picture(sheet, picture->picture, cell);
    put_line(sheet, picture->caption, {cell.x, cell.y + cell_height + 21}, 0.5);
  }
  put_counts(sheet, trace, cell_at(i));
  return sheet;
}

}  // namespace runmark::cli
