#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "runmark/dictionary.h"

namespace runmark {

/// The least Hamming distance of any code from any other code and from its own rotations, all four
/// rotations considered; codes that are their own rotation do not count as rotations of themselves.
/// Time grows with the square of the number of codes: 1 ms for 1,000, 10 s for 65,536.
[[nodiscard]] int least_distance(const Dictionary& dictionary);

/// Two ids whose codes are equal in some rotation, the lower first: the same marker twice.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> equal_codes(const Dictionary& dictionary);

/// The share of all possible readings of `bits` cells that are taken for one of the codes, in any rotation,
/// with up to `corrected` wrong bits: 4 codes (C(bits, 0) + ... + C(bits, corrected)) / 2^bits. It is the
/// chance that a random square is taken for a marker once its border has been found right.
[[nodiscard]] double accepted_share(std::size_t bits, std::size_t codes, int corrected);

/// How many wrong bits may safely be corrected: as many as keep codes apart (2k < distance) and
/// accepted_share at 2^-12 (1 in 4,096) or less. 0 when even exact readings are more than that.
[[nodiscard]] int safe_corrected_bits(std::size_t bits, std::size_t codes, int distance);

}  // namespace runmark
