#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "dictionary/cell_rotation.h"
#include "runmark/dictionary.h"

namespace runmark {

/// A code found in a dictionary. The marker as it is drawn appears turned by `rotation` * 90 degrees
/// clockwise in the sampled grid: its corner i (top-left, top-right, bottom-right, bottom-left) is the
/// grid's corner (i + rotation) % 4.
struct CodeMatch {
  int id = -1;
  int rotation = 0;
  int hamming = 0;  ///< bits that differ
  friend bool operator==(const CodeMatch&, const CodeMatch&) = default;
};

/// Finds sampled codes in a dictionary, in any of four rotations, with up to a number of wrong bits.
///
/// The code is cut into chunks. When k bits of m chunks are wrong, k = m r + a with a < m, then one of the
/// first a + 1 chunks has at most r wrong bits or one of the others at most r - 1 (multi-index hashing:
/// Norouzi, Punjani, Fleet 2012). So each chunk has an index by its value, and only the codes that come up
/// under a value that near are compared. Codes are stored once; under 4 MB for any dictionary.
class CodeLookup {
 public:
  /// `corrected_bits` is brought into 0 to (distance - 1) / 2, so that no two codes can match.
  CodeLookup(const Dictionary& dictionary, int corrected_bits);

  /// `sampled` in the order of the dictionary's cells, as they were seen in one orientation. Where a code
  /// is its own rotation, the lowest rotation. Allocates nothing.
  [[nodiscard]] std::optional<CodeMatch> find(std::uint64_t sampled) const;

  [[nodiscard]] int corrected_bits() const { return corrected_bits_; }
  [[nodiscard]] std::size_t memory() const;  ///< bytes

 private:
  /// The codes by the value of `width` bits from `shift` up.
  struct Chunk {
    int shift = 0;
    int width = 0;
    int bucket_bits = 0;
    std::uint64_t multiplier = 0;       // spreads values over the buckets; keeps them when there is room
    std::vector<std::uint64_t> errors;  // the wrong bits to try, fewest first
    std::vector<std::uint32_t> starts;  // of each bucket in ids, and the end
    std::vector<std::uint16_t> ids;

    [[nodiscard]] std::size_t bucket(std::uint64_t code) const;
  };

  [[nodiscard]] static double cost(std::size_t bits, std::size_t codes, int corrected, int chunks);
  [[nodiscard]] Chunk make_chunk(int shift, int width, int radius) const;

  CellRotation rotation_;
  int corrected_bits_ = 0;
  std::vector<std::uint64_t> codes_;
  std::vector<Chunk> chunks_;
};

}  // namespace runmark
