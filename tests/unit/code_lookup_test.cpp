#include "pattern/code_lookup.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <utility>
#include <vector>

namespace runmark {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// The cells of a marker that was turned by 90 degrees clockwise, one by one.
std::uint64_t turned(const Dictionary& dictionary, std::uint64_t code) {
  const std::size_t bits = dictionary.cells.size();
  const auto bit_at = [&](Cell c) {
    for (std::size_t i = 0; i < bits; ++i) {
      if (dictionary.cells[i] == c) return code >> (bits - 1 - i) & 1U;
    }
    return std::uint64_t{0};
  };
  std::uint64_t result = 0;
  for (const Cell c : dictionary.cells) {
    // What is now at (x, y) was at (y, width - 1 - x): the left column, read upwards, is the new top row.
    result = result << 1U | bit_at({c.y, static_cast<std::int8_t>(dictionary.width - 1 - c.x)});
  }
  return result;
}

/// Every code in its four rotations.
std::vector<std::array<std::uint64_t, 4>> all_turned(const Dictionary& dictionary) {
  std::vector<std::array<std::uint64_t, 4>> all;
  for (std::uint64_t code : dictionary.codes) {
    auto& rotations = all.emplace_back();
    for (std::uint64_t& rotation : rotations) rotation = std::exchange(code, turned(dictionary, code));
  }
  return all;
}

/// By definition: lowest hamming, then lowest id, then lowest rotation.
std::optional<CodeMatch> brute_force(const std::vector<std::array<std::uint64_t, 4>>& codes, int corrected,
                                     std::uint64_t sampled) {
  std::optional<CodeMatch> best;
  for (std::size_t id = 0; id < codes.size(); ++id) {
    for (std::size_t rotation = 0; rotation < 4; ++rotation) {
      const int hamming = std::popcount(codes[id][rotation] ^ sampled);
      if (hamming <= corrected && (!best || hamming < best->hamming)) {
        best = CodeMatch{static_cast<int>(id), static_cast<int>(rotation), hamming};
      }
    }
  }
  return best;
}

std::uint64_t random_code(std::mt19937_64& random, std::size_t bits) { return random() >> (64 - bits); }

std::uint64_t with_errors(std::uint64_t code, int errors, std::size_t bits, std::mt19937_64& random) {
  std::uint64_t wrong = 0;
  while (std::popcount(wrong) < errors) wrong |= std::uint64_t{1} << random() % bits;
  return code ^ wrong;
}

TEST(CodeLookup, RotationIsClockwiseAsSeenInTheGrid) {
  // 2x2 cells, white at the top-left; seen with white at the top-right it was turned once, clockwise.
  const auto dictionary = parse_codes("2 0\n8\n", "one");
  ASSERT_TRUE(dictionary);
  const CodeLookup lookup(*dictionary, 0);
  EXPECT_EQ(lookup.find(0b1000), (CodeMatch{0, 0, 0}));
  EXPECT_EQ(lookup.find(0b0100), (CodeMatch{0, 1, 0}));
  EXPECT_EQ(lookup.find(0b0001), (CodeMatch{0, 2, 0}));
  EXPECT_EQ(lookup.find(0b0010), (CodeMatch{0, 3, 0}));
  EXPECT_EQ(lookup.find(0b1100), std::nullopt);
}

TEST(CodeLookup, TakesNoMoreErrorsThanKeepCodesApart) {
  const auto dictionary = builtin_dictionary("tag36h11");
  ASSERT_TRUE(dictionary);
  EXPECT_EQ(CodeLookup(*dictionary, 99).corrected_bits(), 5);
  EXPECT_EQ(CodeLookup(*dictionary, -1).corrected_bits(), 0);
}

TEST(CodeLookup, ASymmetricCodeTakesTheLowestRotation) {
  const auto dictionary = parse_codes("2 0\nsymmetric 0\n9\n", "one");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(CodeLookup(*dictionary, 0).find(0b1001), (CodeMatch{0, 0, 0}));
  EXPECT_EQ(CodeLookup(*dictionary, 0).find(0b0110), (CodeMatch{0, 1, 0}));
}

TEST(CodeLookup, HoldsOneCodeAndSixtyFourCells) {
  const auto dictionary = parse_codes("8 0\nborder included\n80665a7e42187e00\n", "one");
  ASSERT_TRUE(dictionary);
  const CodeLookup lookup(*dictionary, 3);
  EXPECT_EQ(lookup.find(0x80665a7e42187e00), (CodeMatch{0, 0, 0}));
  EXPECT_EQ(lookup.find(0x80665a7e42187e03), (CodeMatch{0, 0, 2}));
  EXPECT_EQ(lookup.find(turned(*dictionary, 0x00665a7e42187e03)), (CodeMatch{0, 1, 3}));
  EXPECT_EQ(lookup.find(0x80665a7e42187ef0), std::nullopt);
}

class EveryDictionary : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryDictionary, FindsWhatBruteForceFinds) {
  const auto dictionary = builtin_dictionary(GetParam());
  ASSERT_TRUE(dictionary) << dictionary.error();
  const std::size_t bits = dictionary->cells.size();
  const auto codes = all_turned(*dictionary);
  const int samples = dictionary->codes.size() > 10000 ? 20 : 60;
  std::mt19937_64 random(bits);
  for (int corrected = 0; corrected <= (dictionary->distance - 1) / 2; ++corrected) {
    const CodeLookup lookup(*dictionary, corrected);
    ASSERT_EQ(lookup.corrected_bits(), corrected);
    for (int i = 0; i < samples; ++i) {
      const std::uint64_t miss = random_code(random, bits);
      EXPECT_EQ(lookup.find(miss), brute_force(codes, corrected, miss)) << corrected;
      const std::uint64_t code = dictionary->codes[random() % dictionary->codes.size()];
      const std::uint64_t edge = with_errors(code, corrected + (i % 2), bits, random);
      EXPECT_EQ(lookup.find(edge), brute_force(codes, corrected, edge)) << corrected;
    }
  }
}

TEST_P(EveryDictionary, FindsEveryCodeInEveryRotationWithEveryNumberOfErrors) {
  const auto dictionary = builtin_dictionary(GetParam());
  ASSERT_TRUE(dictionary) << dictionary.error();
  const std::size_t bits = dictionary->cells.size();
  const auto codes = all_turned(*dictionary);
  std::mt19937_64 random(bits);
  for (int corrected = 0; corrected <= (dictionary->distance - 1) / 2; ++corrected) {
    const CodeLookup lookup(*dictionary, corrected);
    EXPECT_LT(lookup.memory(), 4U << 20U);
    // All of the largest dictionaries would take long, and longer under a sanitizer.
    const bool some = codes.size() > 10000 && (sanitized || corrected != dictionary->corrected_bits);
    for (std::size_t id = 0; id < codes.size(); id += some ? 16 : 1) {
      const bool symmetric = codes[id][2] == codes[id][0];
      for (std::size_t rotation = 0; rotation < (symmetric ? 1 : 4); ++rotation) {
        const int errors = static_cast<int>(random() % static_cast<std::uint64_t>(corrected + 1));
        ASSERT_EQ(lookup.find(with_errors(codes[id][rotation], errors, bits, random)),
                  (CodeMatch{static_cast<int>(id), static_cast<int>(rotation), errors}));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CodeLookup, EveryDictionary, testing::ValuesIn(dictionary_names()),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace runmark
