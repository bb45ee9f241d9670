#include "runmark/board_view.h"

#include "boards/board_markers.h"
#include "boards/chess_corners.h"

namespace runmark {

BoardView view_board(const Board& board, std::span<const Marker> found, const ImageView& picture) {
  BoardView view;
  if (picture.check() != Status::ok) return view;
  for (const Candidate& c : agreeing(candidates(board, found))) {
    view.markers.push_back({c.index, *c.marker, corner_covariance(*c.marker, picture)});
  }
  if (board.charuco) view.corners = find_chess_corners(board, view.markers, GreySampler(picture));
  return view;
}

}  // namespace runmark
