#include "boards/chess_corners.h"

#include <algorithm>
#include <cmath>

#include "boards/chess_corner.h"
#include "boards/plane_map.h"
#include "camera/point_distance.h"

namespace runmark {
namespace {

/// Pairs of places, on the board in squares and in the picture, from which the next corners are guessed.
struct Anchor {
  std::vector<Point> board;  // 4 of a marker, 1 of a corner
  std::vector<Point> picture;
  Point middle;  // on the board
};

class Finder {
 public:
  Finder(const Board& board, const std::vector<SeenMarker>& markers, const GreySampler& grey)
      : board_(board), layout_(*board.charuco), grey_(grey) {
    int inverted = 0;
    for (const SeenMarker& seen : markers) {
      Anchor anchor;
      for (std::size_t i = 0; i < 4; ++i) {
        const Point3& p = board.markers[static_cast<std::size_t>(seen.index)].corners[i];
        anchor.board.push_back({p.x / layout_.square, p.y / layout_.square});
        anchor.picture.push_back(seen.marker.corners[i]);
        anchor.middle.x += anchor.board.back().x / 4;
        anchor.middle.y += anchor.board.back().y / 4;
      }
      anchors_.push_back(std::move(anchor));
      inverted += seen.marker.inverted ? 1 : -1;
    }
    inverted_ = inverted > 0;
  }

  std::vector<SeenCorner> find() {
    std::vector<SeenCorner> seen;
    std::vector<bool> done(board_.chess_corners.size());
    // Each round reaches a square farther; a corner that failed is tried again when it has new neighbours.
    for (bool more = true; more;) {
      more = false;
      const std::size_t known = anchors_.size();
      std::vector<Anchor> found;
      for (std::size_t i = 0; i < done.size(); ++i) {
        if (done[i]) continue;
        const std::optional<ChessCorner> corner = find_one(i, known);
        if (!corner) continue;
        done[i] = true;
        more = true;
        constexpr double least_deviation = 0.01;  // pixels; what no fit explains
        seen.push_back({static_cast<int>(i), corner->place, std::max(corner->deviation, least_deviation)});
        found.push_back({{place_of(i)}, {corner->place}, place_of(i)});
      }
      anchors_.insert(anchors_.end(), found.begin(), found.end());
    }
    std::sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
    return seen;
  }

 private:
  /// On the board, in squares.
  [[nodiscard]] Point place_of(std::size_t corner) const {
    const Point3& p = board_.chess_corners[corner];
    return {p.x / layout_.square, p.y / layout_.square};
  }

  [[nodiscard]] std::optional<ChessCorner> find_one(std::size_t corner, std::size_t known) const {
    constexpr double farthest = 1.6;  // squares from the middle of an anchor
    constexpr std::size_t enough = 16;
    const Point at = place_of(corner);
    std::vector<const Anchor*> near;
    for (std::size_t i = 0; i < known; ++i) {
      if (distance(anchors_[i].middle, at) < farthest) near.push_back(&anchors_[i]);
    }
    std::stable_sort(near.begin(), near.end(), [&](const Anchor* a, const Anchor* b) {
      return distance(a->middle, at) < distance(b->middle, at);
    });
    std::vector<Point> on_board;
    std::vector<Point> in_picture;
    for (const Anchor* anchor : near) {
      if (on_board.size() >= enough) break;
      on_board.insert(on_board.end(), anchor->board.begin(), anchor->board.end());
      in_picture.insert(in_picture.end(), anchor->picture.begin(), anchor->picture.end());
    }
    const std::optional<PlaneMap> map = PlaneMap::fit(on_board, in_picture);
    if (!map) return {};
    constexpr double step = 0.25;  // squares
    const Point right = (*map)({at.x + step, at.y});
    const Point left = (*map)({at.x - step, at.y});
    const Point down = (*map)({at.x, at.y + step});
    const Point up = (*map)({at.x, at.y - step});
    CornerGuess guess;
    guess.place = (*map)(at);
    guess.right = {(right.x - left.x) / (2 * step), (right.y - left.y) / (2 * step)};
    guess.down = {(down.x - up.x) / (2 * step), (down.y - up.y) / (2 * step)};
    guess.margin = (1 - layout_.marker / layout_.square) / 2;
    const int columns = layout_.columns - 1;
    const auto index = static_cast<int>(corner);
    guess.plain_first = layout_.is_black(index % columns, index / columns);
    guess.inverted = inverted_;
    if (!is_sensible(guess)) return {};
    return fit_chess_corner(grey_, guess);
  }

  [[nodiscard]] bool is_sensible(const CornerGuess& g) const {
    constexpr double least_side = 4;  // pixels
    const double right = std::hypot(g.right.x, g.right.y);
    const double down = std::hypot(g.down.x, g.down.y);
    const double turn = g.right.x * g.down.y - g.right.y * g.down.x;
    return g.place.x > 0 && g.place.y > 0 && g.place.x < grey_.width() - 1 &&
           g.place.y < grey_.height() - 1 && right > least_side && down > least_side &&
           turn > 0.15 * right * down;
  }

  const Board& board_;
  const CharucoLayout& layout_;
  const GreySampler& grey_;
  std::vector<Anchor> anchors_;
  bool inverted_ = false;
};

}  // namespace

std::vector<SeenCorner> find_chess_corners(const Board& board, const std::vector<SeenMarker>& markers,
                                           const GreySampler& grey) {
  return Finder(board, markers, grey).find();
}

}  // namespace runmark
