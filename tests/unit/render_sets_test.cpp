#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "render/standard_sets.h"
#include "render/truth_json.h"
#include "runmark/dictionary.h"

namespace runmark::render {
namespace {

class StandardSetTest : public testing::TestWithParam<std::string_view> {};

INSTANTIATE_TEST_SUITE_P(All, StandardSetTest, testing::Values("vga", "hd", "fullhd", "uhd"),
                         [](const auto& set) { return std::string(set.param); });

TEST_P(StandardSetTest, HasEnoughOfEverySize) {
  const StandardSet* set = find_standard_set(GetParam());
  ASSERT_NE(set, nullptr);
  const Dictionary dictionary = *builtin_dictionary("tag36h11");
  const auto limits = size_buckets();
  std::vector<int> bucket(limits.size());
  int markers = 0;
  int optional = 0;
  int tilted = 0;
  for (int i = 0; i < set->scenes; ++i) {
    const FrameTruth truth = truth_of(make_scene(set->recipe, dictionary, set_seed(set->name, 0), i));
    for (const MarkerTruth& m : truth.markers) {
      if (m.optional()) {
        ++optional;
        continue;
      }
      ++markers;
      tilted += m.tilt > 60 ? 1 : 0;
      const auto above = std::upper_bound(limits.begin(), limits.end(), m.size + 1e-6);
      ASSERT_NE(above, limits.begin());
      ++bucket[static_cast<std::size_t>(above - limits.begin() - 1)];
    }
  }
  EXPECT_GE(set->scenes, 200);
  EXPECT_GE(markers, 2000);
  EXPECT_GE(optional, 50);
  EXPECT_GE(tilted, 100);
  for (std::size_t i = 0; i < bucket.size(); ++i) EXPECT_GE(bucket[i], 200) << "from " << limits[i] << " px";
}

TEST(TruthJson, HasTheFieldsOfTheRealImages) {
  const StandardSet* set = find_standard_set("vga");
  const Dictionary dictionary = *builtin_dictionary("DICT_4X4_50");
  int maybe = 0;
  for (int i = 0; i < 30; ++i) {
    const FrameTruth truth = truth_of(make_scene(set->recipe, dictionary, 1, i));
    const auto j = to_json(truth, "a.png");
    EXPECT_EQ(j["image"], "a.png");
    EXPECT_EQ(j["width"], 640);
    EXPECT_EQ(j["height"], 480);
    EXPECT_EQ(j["dictionary"], "DICT_4X4_50");
    EXPECT_EQ(j["inverted"], false);
    EXPECT_EQ(j["rendered"], true);
    EXPECT_EQ(j["markers"].size() + j["maybe"].size(), truth.markers.size());
    const auto ids = j["present_ids"].get<std::set<int>>();
    for (const auto* list : {"markers", "maybe"}) {
      for (const auto& m : j[list]) {
        EXPECT_TRUE(ids.contains(m["id"].get<int>()));
        EXPECT_EQ(m["corners"].size(), 4U);
        EXPECT_EQ(m["occluded"], std::string_view(list) == "maybe");
        for (const auto* field :
             {"side", "size", "cell", "tilt", "blur", "motion", "noise", "contrast", "distance"}) {
          EXPECT_TRUE(m[field].is_number()) << field;
        }
      }
    }
    maybe += static_cast<int>(j["maybe"].size());
  }
  EXPECT_GT(maybe, 0);
}

}  // namespace
}  // namespace runmark::render
