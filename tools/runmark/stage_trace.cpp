#include "stage_trace.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

#include "corner/corner_state_machine.h"
#include "corner/quad_from_chain.h"
#include "errors.h"
#include "fitting_detector.h"
#include "pipeline/contour_scan.h"
#include "pipeline/halve.h"
#include "pipeline/hardware_pipeline.h"
#include "pipeline/paper_pipeline.h"
#include "pipeline/scale_rules.h"
#include "preprocess/run_scan.h"
#include "sample_grid.h"
#include "threshold/fixed_threshold.h"
#include "threshold/grey.h"
#include "threshold/integer_tiles.h"
#include "threshold/tile_threshold.h"

namespace runmark::cli {
namespace {

/// Rows of bits, one after the other.
class BitImage {
 public:
  BitImage(int width, int height)
      : width_(width), height_(height), words_(bit_words(width) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] BitWord* row(int y) {
    return words_.data() + bit_words(width_) * static_cast<std::size_t>(y);
  }
  [[nodiscard]] const BitWord* row(int y) const {
    return words_.data() + bit_words(width_) * static_cast<std::size_t>(y);
  }

  [[nodiscard]] cv::Mat picture() const {
    cv::Mat result(height_, width_, CV_8U);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) result.at<std::uint8_t>(y, x) = bit_at(row(y), x) ? 0 : 255;
    }
    return result;
  }

 private:
  int width_;
  int height_;
  std::vector<BitWord> words_;
};

cv::Mat to_grey(const cv::Mat& picture) {
  cv::Mat grey(picture.size(), CV_8U);
  const bool colour = picture.channels() == 3;
  for (int y = 0; y < picture.rows; ++y) {
    grey_row(picture.ptr(y), picture.cols, colour ? 3 : 1, colour ? PixelFormat::bgr : PixelFormat::grey,
             grey.ptr(y));
  }
  return grey;
}

cv::Mat halved(const cv::Mat& grey) {
  cv::Mat half(grey.rows / 2, grey.cols / 2, CV_8U);
  for (int y = 0; y < half.rows; ++y)
    halve_rows(grey.ptr(2 * y), grey.ptr(2 * y + 1), half.cols, half.ptr(y));
  return half;
}

BitImage threshold_by_level(const cv::Mat& grey, const FixedThreshold& threshold) {
  BitImage bits(grey.cols, grey.rows);
  for (int y = 0; y < grey.rows; ++y) threshold_row(grey.ptr(y), grey.cols, threshold, bits.row(y));
  return bits;
}

BitImage threshold_by_tiles(const cv::Mat& grey, const TileRule& rule) {
  BitImage bits(grey.cols, grey.rows);
  TileThreshold threshold(grey.cols);
  threshold.begin_frame(grey.cols, rule);
  const auto turn_to_bits = [&](int first) {
    for (int y = first; y < std::min(first + tile_side, grey.rows); ++y) {
      threshold_row(grey.ptr(y), grey.cols, threshold.levels(), bits.row(y));
    }
  };
  int first = 0;
  for (; first < grey.rows; first += tile_side) {
    TileBand band{};
    for (int i = 0; i < tile_side; ++i) {
      band[static_cast<std::size_t>(i)] = grey.ptr(std::min(first + i, grey.rows - 1));
    }
    threshold.add_band(band);
    if (first > 0) turn_to_bits(first - tile_side);
  }
  threshold.finish();
  turn_to_bits(first - tile_side);
  return bits;
}

BitImage threshold_in_integers(const cv::Mat& grey, int min_contrast) {
  BitImage bits(grey.cols, grey.rows);
  IntegerTiles tiles(grey.cols);
  tiles.begin_frame(grey.cols, grey.rows, min_contrast);
  const auto turn_to_bits = [&] {
    for (int y = tiles.ready_from(); y < tiles.ready_to(); ++y) tiles.threshold(grey.ptr(y), bits.row(y));
  };
  for (int y = 0; y < grey.rows; ++y) {
    if (tiles.add_row(grey.ptr(y))) turn_to_bits();
  }
  tiles.finish();
  turn_to_bits();
  return bits;
}

BitImage preprocess(const BitImage& bits, const cv::Size& size, const PreprocessRules& rules) {
  BitImage result(size.width, size.height);
  RunScan scan(size.width, rules);
  scan.begin_frame(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    std::copy_n(bits.row(y), bit_words(size.width), scan.next_row());
    scan.advance([&](int done, const BitWord* row, std::span<const CrackRun>) {
      std::copy_n(row, bit_words(size.width), result.row(done));
    });
  }
  return result;
}

Point to_frame(Point p, int scale) {
  return {p.x * scale + (scale - 1) / 2.0, p.y * scale + (scale - 1) / 2.0};
}

TracedContour trace(const ClosedChain& chain, int scale) {
  TracedContour contour;
  contour.hole = chain.hole;
  chain.runs([&](int from, int to, int y) {
    contour.corners.push_back(to_frame({from - 0.5, y - 0.5}, scale));
    contour.corners.push_back(to_frame({to - 0.5, y - 0.5}, scale));
  });
  return contour;
}

/// The corner core: a quadrilateral in pixels of its scale.
using CornerCore = std::function<std::optional<Quad>(const ClosedChain&)>;

ScaleTrace follow(const BitImage& bits, const cv::Size& size, int scale, const ContourRules& rules,
                  const CornerCore& corner_core) {
  ScaleTrace result;
  result.scale = scale;
  result.thresholded = bits.picture();
  result.preprocessed = preprocess(bits, size, rules.preprocess).picture();
  ContourScan scan(size.width, rules);
  scan.begin_frame(size.width, size.height);
  for (int y = 0; y < size.height; ++y) {
    std::copy_n(bits.row(y), bit_words(size.width), scan.next_row());
    scan.advance([&](const ClosedChain& chain) {
      result.contours.push_back(trace(chain, scale));
      std::optional<Quad> quad = corner_core(chain);
      if (!quad) return;
      for (Point& corner : quad->corners) corner = to_frame(corner, scale);
      result.quads.push_back(*quad);
    });
  }
  result.crack_runs = scan.linker().counts().runs;
  result.closed = scan.linker().counts().closed;
  return result;
}

std::optional<Quad> paper_quad(const ClosedChain& chain, const Options& options) {
  const auto corners = four_corners(chain, options.corner_offset);
  if (!corners) return std::nullopt;
  Quad quad;
  quad.light_inside = chain.hole;
  for (std::size_t i = 0; i < 4; ++i) {
    const CrackPoint& corner = (*corners)[chain.hole ? 3 - i : i];
    quad.corners[i] = {corner.x - 0.5, corner.y - 0.5};
  }
  const double side = std::sqrt(std::max(area_of(quad.corners), 0.0));
  const bool fits = side >= options.min_marker_size && side <= options.max_marker_size;
  if (!fits || !is_convex_clockwise(quad.corners)) return std::nullopt;
  return quad;
}

void trace_paper(StageTrace& result, const Options& options) {
  const BitImage bits = threshold_by_level(result.grey, {options.fixed_threshold, options.above_is_dark});
  result.scales.push_back(follow(bits, result.grey.size(), 1, PaperPipeline::contour_rules(options),
                                 [&](const ClosedChain& chain) { return paper_quad(chain, options); }));
}

std::optional<Quad> hardware_quad(const ClosedChain& chain, const IntegerQuadLimits& limits) {
  const auto found = integer_quad(chain, limits);
  if (!found) return std::nullopt;
  Quad quad;
  quad.light_inside = chain.hole;
  for (std::size_t i = 0; i < 4; ++i) quad.corners[i] = in_pixels(found->corners[i]);
  return quad;
}

void trace_hardware(StageTrace& result, const Options& options) {
  const IntegerQuadLimits limits = HardwarePipeline::quad_limits(options);
  result.scales.push_back(follow(threshold_in_integers(result.grey, options.min_contrast), result.grey.size(),
                                 1, HardwarePipeline::contour_rules(options),
                                 [&](const ClosedChain& chain) { return hardware_quad(chain, limits); }));
}

void trace_standard(StageTrace& result, const Options& options, const std::vector<Dictionary>& dictionaries) {
  const bool light =
      options.inverted || std::ranges::count(dictionaries, Border::reversed, &Dictionary::border) > 0;
  const bool dark = options.inverted || std::ranges::any_of(dictionaries, [](const Dictionary& dictionary) {
                      return dictionary.border != Border::reversed;
                    });
  cv::Mat grey = result.grey;
  for (int level = 0; level <= options.octaves && scale_is_used(level, grey.cols, grey.rows); ++level) {
    const ScaleRules scale = scale_rules(options, level, light);
    Outline scratch(max_vertices(scale.contours.chains));
    const auto corner = [&](const ClosedChain& chain) -> std::optional<Quad> {
      if (!(chain.hole ? light : dark)) return std::nullopt;
      return quad_from_chain(chain, scale.quads, scratch);
    };
    result.scales.push_back(
        follow(threshold_by_tiles(grey, scale.tiles), grey.size(), 1 << level, scale.contours, corner));
    grey = halved(grey);
    if (grey.empty()) break;
  }
}

Point middle_of(const std::array<Point, 4>& corners) {
  Point middle;
  for (const Point& corner : corners) middle = {middle.x + corner.x / 4, middle.y + corner.y / 4};
  return middle;
}

double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The grid of each marker; without markers that of the largest quadrilateral, to show what was read there.
void add_grids(StageTrace& result, const Options& options, const std::vector<Dictionary>& dictionaries) {
  const auto area = [](const auto& square) { return area_of(square.corners); };
  std::vector<Quad> quads;
  for (const ScaleTrace& scale : result.scales)
    quads.insert(quads.end(), scale.quads.begin(), scale.quads.end());
  const auto add = [&](const Quad& quad, const Dictionary& dictionary) {
    const std::optional<SampleGrid> grid =
        options.pipeline == Pipeline::paper
            ? paper_grid(result.grey, quad, {options.fixed_threshold, options.above_is_dark})
            : cell_grid(result.grey, quad, dictionary);
    if (grid) result.grids.push_back(*grid);
  };
  std::ranges::sort(result.markers, std::ranges::greater(), area);
  for (const Marker& marker : result.markers) {
    const Dictionary& dictionary = *std::ranges::find(dictionaries, marker.dictionary, &Dictionary::name);
    Quad quad{marker.corners, marker.inverted != (dictionary.border == Border::reversed)};
    if (options.pipeline == Pipeline::paper && !quads.empty()) {
      // The paper samples from the corner where its walk began, not from the marker's first one.
      quad = *std::ranges::min_element(quads, {}, [&](const Quad& other) {
        return distance(middle_of(other.corners), middle_of(marker.corners));
      });
    }
    add(quad, dictionary);
  }
  if (result.markers.empty() && !quads.empty())
    add(*std::ranges::max_element(quads, {}, area), dictionaries[0]);
}

/// The part of the picture that is looked at.
cv::Mat within(const cv::Mat& picture, const Region& region) {
  if (region.width == 0 || region.height == 0) return picture;
  const cv::Rect part =
      cv::Rect(region.x, region.y, region.width, region.height) & cv::Rect(0, 0, picture.cols, picture.rows);
  if (part.empty()) throw UserError("--region lies outside the picture");
  return picture(part).clone();
}

}  // namespace

StageTrace trace_stages(const cv::Mat& picture, const Options& asked,
                        const std::vector<Dictionary>& dictionaries) {
  StageTrace result;
  result.picture = within(picture, asked.region);
  result.grey = to_grey(result.picture);
  Options options = asked;
  options.region = {};
  options.max_width = result.picture.cols;
  options.max_height = result.picture.rows;

  FittingDetector detector(options, dictionaries);
  const Detection found = detector.detect(Frame{"the picture", 0, result.picture, true});
  result.stats = detector.stats();
  for (Marker marker : found) {
    // The detector's own names end with it.
    marker.dictionary = std::ranges::find(dictionaries, marker.dictionary, &Dictionary::name)->name;
    result.markers.push_back(marker);
  }
  if (options.pipeline == Pipeline::paper) {
    trace_paper(result, options);
  } else if (options.pipeline == Pipeline::hardware) {
    trace_hardware(result, options);
  } else {
    trace_standard(result, options, dictionaries);
  }
  add_grids(result, options, dictionaries);
  return result;
}

}  // namespace runmark::cli
