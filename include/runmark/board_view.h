#pragma once

#include <span>
#include <string>
#include <vector>

#include "runmark/board.h"
#include "runmark/camera.h"
#include "runmark/corner_covariance.h"
#include "runmark/image_view.h"
#include "runmark/marker.h"
#include "runmark/pose.h"

namespace runmark {

/// A marker of a board in a picture.
struct SeenMarker {
  int index = -1;  ///< into Board::markers
  Marker marker;
  CornerCovariance covariance{};
};

/// An inner corner of the chessboard in a picture.
struct SeenCorner {
  int index = -1;  ///< into Board::chess_corners
  Point place;
  double deviation = 0;  ///< standard deviation of x and of y, in pixels
};

/// What a picture shows of a board.
struct BoardView {
  std::vector<SeenMarker> markers;
  std::vector<SeenCorner> corners;
};

/// The markers found that are the board's; where a board's marker was found more than once, or does not go
/// with the others, it is left out. From the picture they were found in come the corners of a ChArUco board's
/// chessboard, each fitted as the crossing of two blurred edges, and how sure all corners are. White-on-black
/// boards are taken as such when their markers were found inverted.
[[nodiscard]] RUNMARK_EXPORT BoardView view_board(const Board& board, std::span<const Marker> found,
                                                  const ImageView& picture);

/// The board's pose from all corners seen, weighted by their covariance. A board that is not flat has one
/// answer. A marker that does not fit the pose of the others is left out. Errors: too little of the board
/// seen, a camera that makes no sense, corners that no pose explains.
[[nodiscard]] RUNMARK_EXPORT Result<PoseEstimate> pose(const Board& board, const BoardView& view,
                                                       const Camera& camera);

/// One line when the markers found are not where this ChArUco board has them, but where another layout would:
/// of OpenCV before or since 4.6, with columns and rows exchanged, or with the markers on their heads; or
/// when they are clearly larger or smaller than described. Empty otherwise.
[[nodiscard]] RUNMARK_EXPORT std::string layout_advice(const Board& board, std::span<const Marker> found);

}  // namespace runmark
