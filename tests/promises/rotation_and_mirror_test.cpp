// Clean markers of 24 pixels and more: turned by quarters they keep their ids, and mirrored they give what
// the dictionary's own distances say, nothing at all in the case of tag36h11.

#include <algorithm>
#include <bit>
#include <cstdio>

#include "render/draw_marker.h"
#include "scenes.h"

namespace runmark::test {
namespace {

constexpr int least_square = 24;

/// A picture with one marker, square, with its own pixels.
struct Page {
  int side = 0;
  std::vector<std::uint8_t> grey;

  [[nodiscard]] std::uint8_t at(int x, int y) const { return grey[static_cast<std::size_t>(y * side + x)]; }
  [[nodiscard]] ImageView view() const { return ImageView::grey(grey.data(), side, side, side); }

  /// Its pixel (x, y) is that of this page which `from(x, y)` names.
  template <class From>
  [[nodiscard]] Page moved(From&& from) const {
    Page result{side, {}};
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto [from_x, from_y] = from(x, y);
        result.grey.push_back(at(from_x, from_y));
      }
    }
    return result;
  }
  [[nodiscard]] Page turned_clockwise() const {
    return moved([this](int x, int y) { return std::pair(y, side - 1 - x); });
  }
  [[nodiscard]] Page mirrored() const {
    return moved([this](int x, int y) { return std::pair(side - 1 - x, y); });
  }
};

int pixels_per_cell(const Dictionary& dictionary) {
  return (least_square + dictionary.width - 1) / dictionary.width;
}

Page page_of(const Dictionary& dictionary, std::size_t id, int pixels) {
  MarkerDrawing drawing = draw_marker(dictionary, id, pixels, 2);
  return {drawing.side, std::move(drawing.grey)};
}

/// What is read off the cells of a page on which nothing is out of place.
std::uint64_t cells_of(const Dictionary& dictionary, const Page& page, int pixels) {
  const int origin = (page.side - dictionary.width * pixels) / 2;
  std::uint64_t code = 0;
  for (const Cell cell : dictionary.cells) {
    const int x = origin + cell.x * pixels + pixels / 2;
    const int y = origin + cell.y * pixels + pixels / 2;
    code = code << 1U | (page.at(x, y) > 127 ? 1U : 0U);
  }
  return code;
}

/// Ids whose code is within the corrected bits of that page in one of its four orientations, one by one.
std::vector<int> ids_within_reach(const Dictionary& dictionary, Page page, int pixels) {
  std::vector<int> ids;
  for (int turn = 0; turn < 4; ++turn) {
    const std::uint64_t seen = cells_of(dictionary, page, pixels);
    for (std::size_t id = 0; id < dictionary.codes.size(); ++id) {
      if (std::popcount(dictionary.codes[id] ^ seen) <= dictionary.corrected_bits)
        ids.push_back(static_cast<int>(id));
    }
    page = page.turned_clockwise();
  }
  std::ranges::sort(ids);
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

std::vector<int> ids_found(Detector& detector, const Page& page) {
  const Detection found = detector.detect(page.view());
  EXPECT_EQ(found.status, Status::ok);
  std::vector<int> ids;
  for (const Marker& marker : found) ids.push_back(marker.id);
  return ids;
}

Detector reader_of(const Dictionary& codes) {
  constexpr int most_side = 400;
  auto made = Detector::create({.max_width = most_side, .max_height = most_side}, {codes});
  EXPECT_TRUE(made) << made.error();
  return *std::move(made);
}

/// Of dictionaries that are parts of one another only the largest.
std::vector<std::string> whole_dictionaries() {
  std::vector<std::string> names;
  for (const std::string_view name : dictionary_names()) {
    const bool part = name.ends_with("_50") || name.ends_with("_100") || name.ends_with("_250");
    if (!part && !name.starts_with("DICT_APRILTAG")) names.emplace_back(name);
  }
  return names;
}

class EveryDictionary : public testing::TestWithParam<std::string> {};

TEST_P(EveryDictionary, QuarterTurnsKeepTheId) {
  const Dictionary codes = dictionary(GetParam());
  Detector detector = reader_of(codes);
  const std::size_t step = std::max<std::size_t>(1, codes.codes.size() / 1000);
  int pages = 0;
  for (std::size_t id = 0; id < codes.codes.size(); id += step) {
    for (const int more : {0, 1, 4}) {
      if (more > 0 && id % 16 != 0) continue;
      Page page = page_of(codes, id, pixels_per_cell(codes) + more);
      for (int turn = 0; turn < 4; ++turn) {
        ASSERT_EQ(ids_found(detector, page), std::vector{static_cast<int>(id)})
            << "id " << id << ", " << (pixels_per_cell(codes) + more) * codes.width << " pixels, turned "
            << turn;
        page = page.turned_clockwise();
        ++pages;
      }
    }
  }
  std::printf("  %s: %d pages\n", GetParam().c_str(), pages);
}

TEST_P(EveryDictionary, MirrorsGiveWhatTheDistancesPredict) {
  const Dictionary codes = dictionary(GetParam());
  Detector detector = reader_of(codes);
  const std::size_t step = std::max<std::size_t>(1, codes.codes.size() / 200);
  const int pixels = pixels_per_cell(codes);
  int pages = 0;
  int found = 0;
  for (std::size_t id = 0; id < codes.codes.size(); id += step) {
    const Page page = page_of(codes, id, pixels).mirrored();
    const std::vector<int> predicted = ids_within_reach(codes, page, pixels);
    ASSERT_EQ(ids_found(detector, page), predicted) << "mirror of id " << id;
    ++pages;
    found += predicted.empty() ? 0 : 1;
  }
  std::printf("  %s: %d mirrors, %d of them are markers\n", GetParam().c_str(), pages, found);
}

TEST(Mirrors, OfTag36h11AreNoMarkers) {
  const Dictionary codes = dictionary("tag36h11");
  Detector detector = reader_of(codes);
  for (std::size_t id = 0; id < codes.codes.size(); ++id) {
    for (const int pixels : {3, 5, 9}) {
      ASSERT_EQ(ids_found(detector, page_of(codes, id, pixels).mirrored()), std::vector<int>{})
          << "id " << id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dictionaries, EveryDictionary, testing::ValuesIn(whole_dictionaries()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace runmark::test
