#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "corner/quad.h"
#include "pattern/cell_reading.h"
#include "pattern/code_lookup.h"
#include "pattern/grey_frame.h"
#include "pattern/homography.h"
#include "pattern/light_model.h"
#include "pattern/marker_layout.h"
#include "runmark/dictionary.h"
#include "runmark/marker.h"

namespace runmark {

/// What the reader accepts.
struct ReaderLimits {
  int corrected_bits = -1;  ///< for every dictionary, or -1 for each dictionary's own
  float min_margin = 0;
  bool inverted = false;  ///< also read white-on-black markers
};

/// Reads a quadrilateral as a marker of one of several dictionaries: places the cells by the homography of
/// its four corners, tells black from white by a light model, and looks the code up in four rotations.
class MarkerReader {
 public:
  /// @param dictionaries  referred to: they must outlive the reader
  MarkerReader(const std::vector<Dictionary>& dictionaries, const ReaderLimits& limits);

  /// The match that chance would make least likely among all dictionaries, by the bits of their codes and
  /// those corrected; then the one asked for first.
  [[nodiscard]] std::optional<Marker> read(const GreyFrame& frame, const Quad& quad) const;

  /// A second try by other corners: at cells as they are, and for codes that chance hardly ever makes.
  [[nodiscard]] std::optional<Marker> read_again(const GreyFrame& frame, const Quad& quad) const;

  /// Whether a quadrilateral may be a marker, by its border and by the lightest of its cells: a quick look
  /// before its edges are refined.
  [[nodiscard]] bool may_be_marker(const GreyFrame& frame, const Quad& quad) const;

  /// The lowest row that reading this quadrilateral may look at because of data cells below the square; -1
  /// when all cells lie inside it.
  [[nodiscard]] int lowest_row(const Quad& quad) const;

  /// The widest marker's cells along a side.
  [[nodiscard]] int most_cells() const { return most_cells_; }
  [[nodiscard]] bool reads(bool light_inside) const { return light_inside ? reads_light_ : reads_dark_; }
  [[nodiscard]] std::size_t memory() const;

 private:
  struct Book {
    const Dictionary* dictionary = nullptr;
    CodeLookup lookup;
  };
  /// Dictionaries whose cells lie alike: sampled once.
  struct Group {
    MarkerLayout layout;
    std::vector<Book> books;
    bool has_plain = false;  // there is a code without any cell unlike the border
  };
  [[nodiscard]] bool fits(const MarkerLayout& layout, const Quad& quad) const {
    const bool inverted = quad.light_inside != layout.is_reversed();
    return !inverted || limits_.inverted;
  }
  /// The marker read so far and how likely a random square reads as well.
  struct Best {
    std::optional<Marker> marker;
    double chance = 2;
    const MarkerLayout* layout = nullptr;
    std::uint64_t code = 0;
  };
  /// @param most_accepted  as of look_up, of cells as they are
  /// @param blurred  whether blurred cells are read too
  [[nodiscard]] std::optional<Marker> read(const GreyFrame& frame, const Quad& quad, double most_accepted,
                                           bool blurred) const;
  /// Compares the whole pattern with the frame and places the corners by all of its edges; false where a
  /// small code is not what the frame shows.
  [[nodiscard]] static bool confirm(const GreyFrame& frame, double blur, const Best& best, Marker& marker);
  void read_unblurred(const GreyFrame& frame, const Quad& quad, const Homography& place,
                      const LightModel& light, const Group& group, Best& best) const;
  /// Looks the code up in the dictionaries of that layout; false when none has it, or only dictionaries that
  /// take more than a share of `most_accepted` of random readings for one of their codes.
  static bool look_up(const CellReading& reading, const Quad& quad, const Group& group, double most_accepted,
                      Best& best);

  std::vector<Group> groups_;
  ReaderLimits limits_;
  int most_cells_ = 0;
  bool reads_dark_ = false;
  bool reads_light_ = false;
};

}  // namespace runmark
