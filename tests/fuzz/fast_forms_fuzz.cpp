// The plain form of each core against the fast one, in every vector extension of this processor, on any rows;
// and the whole detector in each of them.

#include <vector>

#include "../unit/support/vector_targets.h"
#include "detectors.h"
#include "pipeline/halve.h"
#include "pipeline/halve_fast.h"
#include "preprocess/crack_runs_fast.h"
#include "preprocess/filter.h"
#include "preprocess/specks_fast.h"
#include "threshold/grey_fast.h"
#include "threshold/tiles_fast.h"

namespace runmark::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<BitWord>;

constexpr int most_width = 200;
constexpr int most_height = 64;

/// Rows out of the fuzzer's bytes, each in memory of exactly its size.
class Rows {
 public:
  explicit Rows(Bytes bytes) : bytes_(std::move(bytes)) {
    if (bytes_.empty()) bytes_.push_back(0);
  }
  Bytes bytes(std::size_t count) {
    Bytes row(count);
    for (std::uint8_t& value : row) value = bytes_[at_++ % bytes_.size()];
    return row;
  }
  Words bits(int width) {
    Words words(bit_words(width));
    const Bytes row = bytes(static_cast<std::size_t>(width));
    for (int x = 0; x < width; ++x) set_bit(words.data(), x, row[static_cast<std::size_t>(x)] % 2 != 0);
    return words;
  }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

void compare_grey(Rows& rows, int width, int step, PixelFormat format) {
  const int channels = format == PixelFormat::grey ? 1 : 3;
  if (step < channels) step = channels;
  const Bytes pixels = rows.bytes(static_cast<std::size_t>((width - 1) * step + channels));
  Bytes plain(static_cast<std::size_t>(width));
  Bytes quick = plain;
  grey_row(pixels.data(), width, step, format, plain.data());
  test::on_every_vector_target([&](std::int64_t) {
    fast::grey_row(pixels.data(), width, step, format, quick.data());
    expect(quick == plain, "grey_row");
  });
}

void compare_tiles(Rows& rows, int width, const TileRule& rule) {
  const auto count = static_cast<std::size_t>(width);
  const auto tiles = static_cast<std::size_t>(tiles_across(width));
  std::array<Bytes, 4> grey;
  for (Bytes& row : grey) row = rows.bytes(count);
  const TileBand band{grey[0].data(), grey[1].data(), grey[2].data(), grey[3].data()};
  std::vector<TileLight> spread(3, TileLight(tiles));
  for (TileLight& b : spread) {
    b.lowest = rows.bytes(tiles);
    b.highest = rows.bytes(tiles);
    b.mean = rows.bytes(tiles);
    for (std::size_t i = 0; i < tiles; ++i) {
      if (b.lowest[i] > b.highest[i]) std::swap(b.lowest[i], b.highest[i]);
      b.mean[i] = std::clamp(b.mean[i], b.lowest[i], b.highest[i]);
    }
  }
  const ThreeBands bands{&spread[0], &spread[1], &spread[2]};
  TileLight light(tiles);
  Bytes levels(tiles);
  Words bits(bit_words(width));
  tile_light(band, width, light);
  tile_levels(bands, static_cast<int>(tiles), rule, levels.data());
  threshold_row(grey[0].data(), width, levels.data(), bits.data());
  test::on_every_vector_target([&](std::int64_t) {
    TileLight quick_light(tiles);
    Bytes quick_levels(tiles);
    Words quick_bits(bit_words(width));
    fast::tile_light(band, width, quick_light);
    expect(quick_light.lowest == light.lowest && quick_light.highest == light.highest &&
               quick_light.mean == light.mean,
           "tile_light");
    fast::tile_levels(bands, static_cast<int>(tiles), rule, quick_levels.data());
    expect(quick_levels == levels, "tile_levels");
    fast::threshold_row(grey[0].data(), width, levels.data(), quick_bits.data());
    expect(quick_bits == bits, "threshold_row");
  });
}

void compare_halves(Rows& rows, int width) {
  const auto count = static_cast<std::size_t>(width);
  const Bytes upper = rows.bytes(2 * count);
  const Bytes lower = rows.bytes(2 * count);
  Bytes plain(count);
  Bytes quick(count);
  halve_rows(upper.data(), lower.data(), width, plain.data());
  test::on_every_vector_target([&](std::int64_t) {
    fast::halve_rows(upper.data(), lower.data(), width, quick.data());
    expect(quick == plain, "halve_rows");
  });
}

void compare_bit_rows(Rows& rows, int width, std::uint8_t cases) {
  const std::array<Words, 3> bits{rows.bits(width), rows.bits(width), rows.bits(width)};
  Words plain(bit_words(width));
  Words quick(bit_words(width));
  filter_row_plain(bits[0].data(), bits[1].data(), bits[2].data(), width, cases, plain.data());
  filter_row(bits[0].data(), bits[1].data(), bits[2].data(), width, cases, quick.data());
  expect(quick == plain, "filter_row");
  for (const Connectivity connectivity : {Connectivity::four, Connectivity::eight}) {
    std::vector<CrackRun> runs(max_crack_runs(width));
    runs.resize(find_crack_runs(bits[0].data(), bits[1].data(), width, connectivity, runs));
    std::vector<CrackRun> quick_runs(max_crack_runs(width) + fast::crack_runs_slack);
    quick_runs.resize(fast::find_crack_runs(bits[0].data(), bits[1].data(), width, connectivity, quick_runs));
    expect(quick_runs == runs, "find_crack_runs");
    drop_specks(bits[0].data(), bits[1].data(), bits[2].data(), width, connectivity, plain.data());
    fast::drop_specks(bits[0].data(), bits[1].data(), bits[2].data(), width, connectivity, quick.data());
    expect(quick == plain, "drop_specks");
  }
}

/// The whole detector finds the same with every extension, which the single cores cannot show.
void compare_detectors(Rows& rows, int width, int height, const Options& chosen,
                       const std::vector<Dictionary>& codes) {
  const Bytes grey = rows.bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::optional<std::vector<Marker>> wanted;
  test::on_every_vector_target([&](std::int64_t) {
    Detector reader = detector(chosen, codes);
    const Detection found = reader.detect(ImageView::grey(grey.data(), width, height, width));
    expect(found.status == Status::ok, "the frame is read");
    expect_sound(reader, found.markers, width, height);
    if (!wanted) wanted.emplace(found.begin(), found.end());
    expect(std::ranges::equal(found.markers, *wanted,
                              [](Marker a, Marker b) {
                                a.dictionary = b.dictionary = {};  // of another detector
                                return same(a, b);
                              }),
           "all extensions find the same");
  });
}

void run(FuzzedDataProvider& input) {
  const int width = input.ConsumeIntegralInRange(1, most_width);
  const int height = input.ConsumeIntegralInRange(1, most_height);
  const int step = input.ConsumeIntegralInRange(1, 5);
  const auto format = input.PickValueInArray({PixelFormat::grey, PixelFormat::rgb, PixelFormat::bgr});
  const auto cases = input.ConsumeIntegralInRange<std::uint8_t>(0, filter_all);
  const TileRule rule{input.ConsumeIntegralInRange(1, 255), input.ConsumeIntegralInRange(1, 16),
                      input.ConsumeIntegralInRange(1, 255)};
  const Options chosen = options(input, width, height);
  const auto codes = dictionaries(input, chosen.pipeline);
  Rows rows(input.ConsumeRemainingBytes<std::uint8_t>());
  compare_detectors(rows, width, height, chosen, codes);
  compare_grey(rows, width, step, format);
  compare_tiles(rows, width, rule);
  compare_halves(rows, width);
  compare_bit_rows(rows, width, cases);
}

}  // namespace
}  // namespace runmark::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider input(data, size);
  runmark::fuzz::run(input);
  return 0;
}
