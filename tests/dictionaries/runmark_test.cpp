// Every code of every dictionary, read back by runmark itself.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "runmark/detector.h"
#include "sheet.h"

namespace runmark {
namespace {

class EveryCodeRunmark : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryCodeRunmark, IsRead) {
  const auto dictionary = builtin_dictionary(GetParam());
  ASSERT_TRUE(dictionary) << dictionary.error();
  Options options;
  options.max_width = options.max_height = 2000;
  options.corrected_bits = 0;
  auto detector = Detector::create(options, {*dictionary});
  ASSERT_TRUE(detector) << detector.error();
  for (std::size_t first = 0; first < dictionary->codes.size();) {
    const Sheet sheet = draw_sheet(*dictionary, first, 5, 1);  // 2,048 markers at most
    const Detection found =
        detector->detect(ImageView::grey(sheet.grey.data(), sheet.side, sheet.side, sheet.side));
    ASSERT_EQ(found.status, Status::ok);
    std::vector<Reading> readings;
    for (const Marker& marker : found) readings.push_back({marker.id, marker.corners});
    EXPECT_EQ(mistakes(sheet, readings, *dictionary, 0.5), std::vector<std::string>{});
    first += sheet.markers.size();
    if (one_sheet_only) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Names, EveryCodeRunmark, testing::ValuesIn(dictionary_names()),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace runmark
