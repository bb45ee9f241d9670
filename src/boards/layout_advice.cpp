#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "boards/board_markers.h"
#include "boards/plane_map.h"
#include "camera/point_distance.h"
#include "runmark/board_view.h"

namespace runmark {
namespace {

/// The share of neighbours that lie where the board has them; negative when there are too few to tell.
double fit_of(const Board& board, std::span<const Marker> found) {
  constexpr int least_neighbours = 4;
  int neighbours = 0;
  int support = 0;
  for (const Candidate& c : candidates(board, found)) {
    neighbours += c.neighbours;
    support += c.support;
  }
  return neighbours < least_neighbours ? -1 : static_cast<double>(support) / neighbours;
}

std::string describe(const CharucoLayout& layout, const CharucoLayout& given) {
  std::string text = std::to_string(layout.columns) + " x " + std::to_string(layout.rows) + " squares";
  if (layout.rows % 2 == 0 || layout.legacy != given.legacy) {
    text += layout.legacy ? ", the layout of OpenCV before 4.6" : ", the layout of OpenCV since 4.6";
  }
  if (layout.turned) text += ", markers on their heads";
  return text;
}

/// How large the markers seen are against those of the board; nothing when there are too few to tell.
std::optional<double> relative_size(const Board& board, std::span<const Marker> found) {
  const std::vector<Candidate> seen = agreeing(candidates(board, found));
  std::vector<Point> on_board;
  std::vector<Point> in_picture;
  for (const Candidate& c : seen) {
    on_board.push_back(middle_of(board.markers[static_cast<std::size_t>(c.index)]));
    in_picture.push_back(middle_of(*c.marker));
  }
  std::vector<double> sizes;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    // Over the whole board a lens would bend the picture: the middles of the nearest ones are enough.
    constexpr std::size_t enough = 7;
    std::vector<std::size_t> order(seen.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return distance(on_board[a], on_board[i]) < distance(on_board[b], on_board[i]);
    });
    order.resize(std::min(order.size(), enough));
    std::vector<Point> from;
    std::vector<Point> to;
    for (const std::size_t k : order) {
      from.push_back(on_board[k]);
      to.push_back(in_picture[k]);
    }
    const std::optional<PlaneMap> map = PlaneMap::fit(from, to);
    if (!map) continue;
    double expected = 0;
    double measured = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const Point3& p = board.markers[static_cast<std::size_t>(seen[i].index)].corners[k];
      expected += distance((*map)({p.x, p.y}), in_picture[i]);
      measured += distance(seen[i].marker->corners[k], in_picture[i]);
    }
    if (expected > 0) sizes.push_back(measured / expected);
  }
  constexpr std::size_t least = 4;
  if (sizes.size() < least) return {};
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

/// The layout in which more than a share of `least` of the neighbours lie where they should.
std::string other_layout(const Board& board, std::span<const Marker> found, double least) {
  const CharucoLayout& given = *board.charuco;
  Dictionary dictionary;
  dictionary.name = board.markers[0].dictionary;
  dictionary.codes.resize(static_cast<std::size_t>(given.first_id) + board.markers.size() + 1);
  double best_fit = least;
  std::string advice;
  for (const bool exchanged : {false, true}) {
    for (const bool legacy : {given.legacy, !given.legacy}) {
      for (const bool turned : {given.turned, !given.turned}) {
        CharucoLayout other = given;
        if (exchanged) std::swap(other.columns, other.rows);
        other.legacy = legacy;
        other.turned = turned;
        const Result<Board> there = charuco_board(dictionary, other);
        const double share = there ? fit_of(*there, found) : 0;
        if (share <= best_fit) continue;
        best_fit = share;
        advice = "the markers seen do not lie as on the board described, but as on a ChArUco board of " +
                 describe(other, given);
      }
    }
  }
  return advice;
}

std::string size_advice(const Board& board, std::span<const Marker> found) {
  constexpr double clear = 0.08;
  const std::optional<double> size = relative_size(board, found);
  if (!size || std::fabs(*size - 1) < clear) return {};
  const double told = board.charuco->marker / board.charuco->square;
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(),
                "the markers seen are %.2f of a square wide, not %.2f as on the board described",
                *size * told, told);
  return text.data();
}

}  // namespace

std::string layout_advice(const Board& board, std::span<const Marker> found) {
  constexpr double good = 0.8;
  if (!board.charuco || board.markers.empty()) return {};
  const double fit = fit_of(board, found);
  if (fit < 0) return {};
  if (fit < good) {
    std::string other = other_layout(board, found, good);
    if (!other.empty()) return other;
  }
  return size_advice(board, found);
}

}  // namespace runmark
