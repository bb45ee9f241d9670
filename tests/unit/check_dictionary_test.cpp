#include "dictionary/check_dictionary.h"

#include <gtest/gtest.h>

#include <utility>

#include "runmark/detector.h"

namespace runmark {
namespace {

Dictionary good() { return *parse_codes("4 1\n5867\n8b03\n", "good"); }

TEST(CheckDictionary, TakesAGoodOne) { EXPECT_EQ(check_dictionary(good()), std::nullopt); }

// A program may fill in a Dictionary by itself, and get anything wrong.
TEST(CheckDictionary, SaysWhatIsWrong) {
  const auto after = [](auto change) {
    Dictionary dictionary = good();
    change(dictionary);
    return check_dictionary(dictionary).value_or("nothing");
  };
  EXPECT_EQ(after([](Dictionary& d) { d.cells.clear(); }), "0 data cells; there must be 1 to 64");
  EXPECT_EQ(after([](Dictionary& d) { d.cells.resize(65); }), "65 data cells; there must be 1 to 64");
  EXPECT_EQ(after([](Dictionary& d) { d.width = 0; }), "cells per side must be 2 to 16");
  EXPECT_EQ(after([](Dictionary& d) { d.width = 1 << 30; }), "cells per side must be 2 to 16");
  EXPECT_EQ(after([](Dictionary& d) { d.width = 7; }),
            "cell 1,1 turned by 90 degrees is 5,1, which is not a data cell");
  EXPECT_EQ(after([](Dictionary& d) {
              d.cells[0] = {0, 2};
            }),
            "cell 0,2 is not where this border allows data");
  EXPECT_EQ(after([](Dictionary& d) { d.cells[3] = d.cells[0]; }),
            "cell 1,1 turned by 90 degrees is 4,1, which is not a data cell");
  EXPECT_EQ(after([](Dictionary& d) { d.codes.clear(); }), "0 codes; there must be 1 to 65536");
  EXPECT_EQ(after([](Dictionary& d) { d.codes.resize(65537); }), "65537 codes; there must be 1 to 65536");
  EXPECT_EQ(after([](Dictionary& d) { d.codes[1] = 0x10000; }), "code of id 1 has more than 16 bits");
  EXPECT_EQ(after([](Dictionary& d) { d.codes.push_back(d.codes[0]); }),
            "ids 0 and 2 have the same code (in some rotation)");
  EXPECT_EQ(after([](Dictionary& d) { d.corrected_bits = -1; }),
            "cannot correct -1 bits when codes differ in 8");
  EXPECT_EQ(after([](Dictionary& d) { d.corrected_bits = 4; }),
            "cannot correct 4 bits when codes differ in 8");
}

TEST(CheckDictionary, TheDetectorRefusesABadOne) {
  Dictionary dictionary = good();
  dictionary.cells.resize(65);
  const auto detector = Detector::create({}, {std::move(dictionary)});
  ASSERT_FALSE(detector);
  EXPECT_EQ(detector.error(), "dictionary good: 65 data cells; there must be 1 to 64");
}

}  // namespace
}  // namespace runmark
