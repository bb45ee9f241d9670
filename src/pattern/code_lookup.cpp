#include "pattern/code_lookup.h"

#include <algorithm>
#include <bit>

namespace runmark {

namespace {

struct Layout {
  int width = 0;   // bits of the chunk
  int radius = 0;  // wrong bits to look for in it
};

Layout layout(std::size_t bits, int corrected, int chunks, int chunk) {
  const int all = static_cast<int>(bits);
  const int width = all / chunks + (chunk < all % chunks ? 1 : 0);
  const int radius = corrected / chunks - (chunk <= corrected % chunks ? 0 : 1);
  return {width, radius};
}

/// Words of `width` bits with exactly `weight` of them set, in rising order, appended to `words`.
void append_words(int width, int weight, std::vector<std::uint64_t>& words) {
  const auto extend = [&](const auto& self, int top, int left, std::uint64_t word) -> void {
    if (left == 0) {
      words.push_back(word);
      return;
    }
    for (int bit = left - 1; bit < top; ++bit) self(self, bit, left - 1, word | std::uint64_t{1} << bit);
  };
  extend(extend, width, weight, 0);
}

double words_within(int width, int radius) {
  double words = 0;
  double choose = 1;
  for (int weight = 0; weight <= radius; ++weight) {
    words += choose;
    choose = choose * (width - weight) / (weight + 1);
  }
  return words;
}

/// About four buckets for each code, so that most are empty; at most 2^17.
int bucket_bits(int width, std::size_t codes) {
  return std::min({static_cast<int>(std::bit_width(codes)) + 2, 17, width});
}

bool at_most(std::uint64_t errors, int most) {
  for (int i = 0; i < most; ++i) errors &= errors - 1;  // clears the lowest one
  return errors == 0;
}

}  // namespace

CodeLookup::CodeLookup(const Dictionary& dictionary, int corrected_bits)
    : rotation_(dictionary.cells, dictionary.width),
      corrected_bits_(std::clamp(corrected_bits, 0, std::max(0, (dictionary.distance - 1) / 2))),
      codes_(dictionary.codes) {
  const std::size_t bits = dictionary.cells.size();
  int best = 1;
  for (int chunks = 2; chunks <= corrected_bits_ + 1; ++chunks) {
    if (cost(bits, codes_.size(), corrected_bits_, chunks) <
        cost(bits, codes_.size(), corrected_bits_, best)) {
      best = chunks;
    }
  }
  int shift = 0;
  for (int i = 0; i < best; ++i) {
    const auto [width, radius] = layout(bits, corrected_bits_, best, i);
    chunks_.push_back(make_chunk(shift, width, radius));
    shift += width;
  }
}

/// Of a miss, in buckets looked at; to compare one code costs about as much as to look at a bucket.
double CodeLookup::cost(std::size_t bits, std::size_t codes, int corrected, int chunks) {
  double sum = 0;
  for (int i = 0; i < chunks; ++i) {
    const auto [width, radius] = layout(bits, corrected, chunks, i);
    const double in_bucket =
        static_cast<double>(codes) / static_cast<double>(std::uint64_t{1} << bucket_bits(width, codes));
    sum += words_within(width, radius) * (1 + in_bucket);
  }
  return sum;
}

CodeLookup::Chunk CodeLookup::make_chunk(int shift, int width, int radius) const {
  Chunk chunk;
  chunk.shift = shift;
  chunk.width = width;
  chunk.bucket_bits = bucket_bits(width, codes_.size());
  constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 over the golden ratio: spreads well
  chunk.multiplier = chunk.bucket_bits == width ? std::uint64_t{1} << (64 - width) : golden;
  for (int weight = 0; weight <= radius; ++weight) append_words(width, weight, chunk.errors);
  for (std::uint64_t& error : chunk.errors) error <<= shift;

  chunk.starts.assign((std::size_t{1} << chunk.bucket_bits) + 1, 0);
  for (const std::uint64_t code : codes_) ++chunk.starts[chunk.bucket(code) + 1];
  for (std::size_t i = 1; i < chunk.starts.size(); ++i) chunk.starts[i] += chunk.starts[i - 1];
  chunk.ids.resize(codes_.size());
  std::vector<std::uint32_t> next = chunk.starts;
  for (std::size_t id = 0; id < codes_.size(); ++id) {
    chunk.ids[next[chunk.bucket(codes_[id])]++] = static_cast<std::uint16_t>(id);
  }
  return chunk;
}

std::size_t CodeLookup::Chunk::bucket(std::uint64_t code) const {
  const std::uint64_t value = code >> shift & (~std::uint64_t{0} >> (64 - width));
  return static_cast<std::size_t>(value * multiplier >> (64 - bucket_bits));
}

std::optional<CodeMatch> CodeLookup::find(std::uint64_t sampled) const {
  std::uint64_t code = sampled;
  for (int rotation = 0; rotation < 4; ++rotation) {
    for (const Chunk& chunk : chunks_) {
      for (const std::uint64_t error : chunk.errors) {
        const std::size_t bucket = chunk.bucket(code ^ error);
        for (std::uint32_t i = chunk.starts[bucket]; i < chunk.starts[bucket + 1]; ++i) {
          const std::uint16_t id = chunk.ids[i];
          const std::uint64_t errors = codes_[id] ^ code;
          if (at_most(errors, corrected_bits_)) return CodeMatch{id, rotation, std::popcount(errors)};
        }
      }
    }
    if (rotation < 3) code = rotation_.turned_back(code);
  }
  return std::nullopt;
}

std::size_t CodeLookup::memory() const {
  std::size_t bytes =
      sizeof *this + codes_.capacity() * sizeof codes_[0] + chunks_.capacity() * sizeof(Chunk);
  for (const Chunk& chunk : chunks_) {
    bytes += chunk.errors.capacity() * sizeof chunk.errors[0] +
             chunk.starts.capacity() * sizeof chunk.starts[0] + chunk.ids.capacity() * sizeof chunk.ids[0];
  }
  return bytes;
}

}  // namespace runmark
