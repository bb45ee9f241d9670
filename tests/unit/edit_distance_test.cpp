#include "dictionary/edit_distance.h"

#include <gtest/gtest.h>

#include <array>

namespace runmark {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("", "tag"), 3U);
  EXPECT_EQ(edit_distance("tag", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("TAG", "tag"), 0U);
}

TEST(ClosestNames, BestFirstAndThreeAtMost) {
  constexpr std::array<std::string_view, 4> names{"alpha", "beta", "betas", "gamma"};
  EXPECT_EQ(closest_names("beta", names), "beta, betas or alpha");
  EXPECT_EQ(closest_names("beta", std::span(names).first(1)), "alpha");
  EXPECT_EQ(closest_names("beta", std::span(names).first(2)), "beta or alpha");
}

}  // namespace
}  // namespace runmark
