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

/// How many wrong bits may safely be corrected: the most, k, that keeps codes apart (2k < distance) and
/// keeps the share of all possible readings that are accepted at one in 4,096 at most:
///     4 codes * (C(bits, 0) + ... + C(bits, k)) / 2^bits <= 2^-12
/// 0 when even exact readings are more than that.
[[nodiscard]] int safe_corrected_bits(std::size_t bits, std::size_t codes, int distance);

}  // namespace runmark
