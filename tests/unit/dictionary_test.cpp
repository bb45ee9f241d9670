#include "runmark/dictionary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <tuple>

#include "dictionary/check_dictionary.h"
#include "dictionary/code_distance.h"

namespace runmark {
namespace {

std::string error_of(std::string_view text) {
  const auto dictionary = parse_codes(text, "mine");
  return dictionary ? "no error" : dictionary.error();
}

TEST(ParseCodes, ReadsThePlainForm) {
  const auto dictionary = parse_codes("4 1\n0x5867\n0x8b03\n", "mine");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->name, "mine");
  EXPECT_EQ(dictionary->width, 6);
  EXPECT_EQ(dictionary->border, Border::black);
  ASSERT_EQ(dictionary->cells.size(), 16U);
  EXPECT_EQ(dictionary->cells[0], (Cell{1, 1}));
  EXPECT_EQ(dictionary->cells[1], (Cell{2, 1}));
  EXPECT_EQ(dictionary->cells[15], (Cell{4, 4}));
  EXPECT_EQ(dictionary->codes, (std::vector<std::uint64_t>{0x5867, 0x8b03}));
  EXPECT_EQ(dictionary->corrected_bits, 1);
}

TEST(ParseCodes, SkipsCommentsBlankLinesAndCarriageReturns) {
  const auto dictionary = parse_codes("# mine\r\n\r\n4 1  # head\r\n\t5867 # first\r\n8B03", "mine");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->codes, (std::vector<std::uint64_t>{0x5867, 0x8b03}));
}

TEST(ParseCodes, IncludedBorderMakesTheCodeTheWholeSquare) {
  const auto dictionary = parse_codes("8 0\nborder included\n00665a7e42187e00\n", "templates");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->width, 8);
  EXPECT_EQ(dictionary->cells.size(), 64U);
  EXPECT_EQ(dictionary->cells.front(), (Cell{0, 0}));
}

TEST(ParseCodes, ListsCellsOutsideAReversedBorder) {
  const auto dictionary = parse_codes("3 0\nborder reversed\ncells 1,-2 6,1 3,6\ncells -2,3\n8\n", "odd");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->width, 5);
  EXPECT_EQ(dictionary->cells, (std::vector<Cell>{{1, -2}, {6, 1}, {3, 6}, {-2, 3}}));
  EXPECT_EQ(dictionary->distance, 2);
}

TEST(ParseCodes, SaysWhatIsWrongAndWhere) {
  const std::tuple<const char*, const char*> cases[] = {
      {"", "mine: no first line with cells per side and corrected bits"},
      {"# nothing\n", "mine: no first line with cells per side and corrected bits"},
      {"4\n", "mine, line 1: expected two numbers, cells per side and corrected bits"},
      {"4 1 1\n", "mine, line 1: expected two numbers, cells per side and corrected bits"},
      {"four 1\n", "mine, line 1: expected two numbers, cells per side and corrected bits"},
      {"1 0\n", "mine, line 1: cells per side must be 2 to 16"},
      {"999999999999 0\n", "mine, line 1: expected two numbers, cells per side and corrected bits"},
      {"4 -1\n", "mine, line 1: corrected bits must be 0 to 64"},
      {"4 1\n", "mine: no codes"},
      {"9 0\n1\n", "mine, line 2: more than 8 cells per side need a list of 'cells'"},
      {"9 0\nborder included\n1\n", "mine, line 3: more than 8 cells per side need a list of 'cells'"},
      {"4 0\nborder blue\n1\n", "mine, line 2: border must be black, reversed or included"},
      {"4 0\nborder black white\n1\n", "mine, line 2: more than one kind of border"},
      {"4 0\nborder black\nborder black\n1\n", "mine, line 3: second 'border' line"},
      {"4 0\ndistance 0\n1\n", "mine, line 2: distance must be one number, 1 to 64"},
      {"4 0\ndistance 3\ndistance 3\n1\n", "mine, line 3: second 'distance' line"},
      {"4 0\n5867\ndistance 3\n", "mine, line 3: 'distance' must come before the codes"},
      {"4 0\ncells 1,1 4\n1\n", "mine, line 2: '4' is not a cell: x,y"},
      {"4 0\ncells 1,1,1\n1\n", "mine, line 2: '1,1,1' is not a cell: x,y"},
      {"4 0\ncells 1,300\n1\n", "mine, line 2: '1,300' is not a cell: x,y"},
      {"4 0\ncells\n1\n", "mine, line 3: 0 data cells; there must be 1 to 64"},
      {"4 0\ncells 0,1\n1\n", "mine, line 3: cell 0,1 is not where this border allows data"},
      {"4 0\ncells 1,-2\n1\n", "mine, line 3: cell 1,-2 is not where this border allows data"},
      {"4 0\nborder reversed\ncells 1,-1\n1\n",
       "mine, line 4: cell 1,-1 is not where this border allows data"},
      {"4 0\ncells 1,1 1,1\n1\n",
       "mine, line 3: cell 1,1 turned by 90 degrees is 4,1, which is not a data cell"},
      {"4 0\ncells 1,1 4,1 4,4 1,4 4,1\n1\n", "mine, line 3: cell 4,1 is listed twice"},
      {"4 0\nzebra\n", "mine, line 2: 'zebra' is not a code of up to 16 hexadecimal digits"},
      {"4 0\n0x\n", "mine, line 2: '0x' is not a code of up to 16 hexadecimal digits"},
      {"4 0\n-1\n", "mine, line 2: '-1' is not a code of up to 16 hexadecimal digits"},
      {"4 0\n12345678901234567\n",
       "mine, line 2: '12345678901234567' is not a code of up to 16 hexadecimal digits"},
      {"4 0\n5867\n\n0x15867\n", "mine, line 4: code '0x15867' has more than 16 bits"},
      {"4 0\n5867 8b03\n", "mine, line 2: '8b03' after the code"},
      {"4 0\n5867\n8b03\n5867\n", "mine, line 4: ids 0 and 2 have the same code (in some rotation)"},
      {"2 0\n8\n4\n", "mine, line 3: ids 0 and 1 have the same code (in some rotation)"},
      {"2 0\n8\n9\n",
       "mine, line 3: code of id 1 looks the same turned, so its corners cannot be told apart; if it must "
       "stay, "
       "add a line 'symmetric 1'"},
      {"2 0\nsymmetric 0\n8\n", "mine, line 3: code of id 0 is stated as symmetric but is not"},
      {"2 0\nsymmetric x\n8\n", "mine, line 2: 'x' is not an id"},
      {"2 0\nsymmetric 7\n8\n", "mine: 'symmetric' names id 7, but there are 1 codes"},
      {"4 1\n0001\n0003\n", "mine: cannot correct 1 bits when codes differ in 1"},
  };
  for (const auto& [text, error] : cases) EXPECT_EQ(error_of(text), error) << text;
}

TEST(ParseCodes, PrintsStrangeBytesAsQuestionMarks) {
  const std::string error = error_of(std::string("4 0\n\x01\xff\x00z\n", 9));
  EXPECT_EQ(error,
            "mine, line 2: '?"
            "?"
            "?z' is not a code of up to 16 hexadecimal digits");
}

TEST(ParseCodes, TakesASymmetricCodeThatIsStated) {
  const auto dictionary = parse_codes("2 0\nsymmetric 1\n8\n9\n", "mine");
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->distance, 1);
}

TEST(ParseCodes, BoundsTheNumberOfCodes) {
  std::string text = "8 0\ndistance 1\n";
  for (int i = 0; i <= 65536; ++i) text += std::to_string(1000000 + i) + "\n";
  EXPECT_EQ(error_of(text), "mine, line 65539: more than 65536 codes");
  text = "8 0\n";
  for (int i = 0; i < 8193; ++i) text += std::to_string(1000000 + i) + "\n";
  EXPECT_EQ(error_of(text), "mine: more than 8192 codes need a line 'distance'");
}

// Nothing a file may hold makes the parser do more than say no.
TEST(ParseCodes, SurvivesAnyText) {
  const std::string seed =
      "# odd\n3 0\nborder reversed\ndistance 2\ncells 1,-2 6,1 3,6\ncells -2,3\nsymmetric 1\n8\n5\n0xc\n";
  std::mt19937 random(1);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = seed;
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      const char byte = random() % 2 == 0 ? static_cast<char>(random()) : seed[random() % seed.size()];
      switch (random() % 3) {
        case 0:
          text[at] = byte;
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        default:
          text.erase(at, 1 + random() % 8);
      }
      if (text.empty()) text = "4";
    }
    const auto dictionary = parse_codes(text, "odd");
    if (!dictionary) {
      EXPECT_EQ(dictionary.error().substr(0, 3), "odd") << text;
      continue;
    }
    ++accepted;
    EXPECT_EQ(check_dictionary(*dictionary), std::nullopt) << text;
  }
  EXPECT_GT(accepted, 200);  // otherwise the texts are too wild to test anything
}

TEST(BuiltinDictionary, EveryNameLoadsAndKeepsTheRules) {
  for (const std::string_view name : dictionary_names()) {
    const auto dictionary = builtin_dictionary(name);
    ASSERT_TRUE(dictionary) << dictionary.error();
    EXPECT_EQ(dictionary->name, name);
    EXPECT_EQ(check_dictionary(*dictionary), std::nullopt) << name;
    EXPECT_EQ(dictionary->corrected_bits,
              safe_corrected_bits(dictionary->cells.size(), dictionary->codes.size(), dictionary->distance))
        << name;
  }
}

struct Claim {
  const char* name;
  std::size_t codes;
  std::size_t cells;
  int distance;
};

// AprilTag's distances are in the families' names; ARUCO_MIP's too.
TEST(BuiltinDictionary, SizesAndDistances) {
  const Claim claims[] = {
      {"tag16h5", 30, 16, 5},
      {"tag25h9", 35, 25, 9},
      {"DICT_APRILTAG_36h10", 2320, 36, 10},
      {"tag36h11", 587, 36, 11},
      {"tagCircle21h7", 38, 21, 7},
      {"tagStandard41h12", 2115, 41, 12},
      {"ARUCO_MIP_16h3", 250, 16, 3},
      {"ARUCO_MIP_25h7", 100, 25, 7},
      {"ARUCO_MIP_36h12", 250, 36, 12},
      {"DICT_ARUCO_ORIGINAL", 1024, 25, 1},
      {"DICT_4X4_1000", 1000, 16, 2},
      {"DICT_7X7_1000", 1000, 49, 14},
  };
  for (const Claim& claim : claims) {
    const auto dictionary = builtin_dictionary(claim.name);
    ASSERT_TRUE(dictionary) << dictionary.error();
    EXPECT_EQ(dictionary->codes.size(), claim.codes) << claim.name;
    EXPECT_EQ(dictionary->cells.size(), claim.cells) << claim.name;
    EXPECT_EQ(dictionary->distance, claim.distance) << claim.name;
    EXPECT_EQ(least_distance(*dictionary), claim.distance) << claim.name;
  }
}

TEST(BuiltinDictionary, SmallOnesAreTheBeginningOfTheLargest) {
  for (const std::string size : {"4X4", "5X5", "6X6", "7X7"}) {
    const auto largest = builtin_dictionary("DICT_" + size + "_1000");
    ASSERT_TRUE(largest);
    int distance = 64;
    for (const int count : {50, 100, 250, 1000}) {
      const auto part = builtin_dictionary("DICT_" + size + "_" + std::to_string(count));
      ASSERT_TRUE(part);
      ASSERT_EQ(part->codes.size(), static_cast<std::size_t>(count));
      EXPECT_TRUE(std::equal(part->codes.begin(), part->codes.end(), largest->codes.begin()));
      EXPECT_LE(part->distance, distance);
      distance = part->distance;
    }
  }
}

TEST(BuiltinDictionary, TwoNamesOfOneDictionary) {
  const std::pair<const char*, const char*> pairs[] = {{"DICT_APRILTAG_36h11", "tag36h11"},
                                                       {"DICT_APRILTAG_16h5", "tag16h5"},
                                                       {"DICT_ARUCO_MIP_36h12", "ARUCO_MIP_36h12"}};
  for (const auto& [one, other] : pairs)
    EXPECT_EQ(builtin_dictionary(one)->codes, builtin_dictionary(other)->codes);
}

TEST(BuiltinDictionary, LetterCaseDoesNotMatter) {
  const auto dictionary = builtin_dictionary("dict_4x4_50");
  ASSERT_TRUE(dictionary);
  EXPECT_EQ(dictionary->name, "DICT_4X4_50");
}

TEST(BuiltinDictionary, KnownCodes) {
  // The picture of OpenCV's marker 0 of DICT_4X4_50, as in its tutorials: rows 1011 0101 0011 0010.
  EXPECT_EQ(builtin_dictionary("DICT_4X4_50")->codes[0], 0xb532U);
  // AprilTag's own order of bits is kept where data do not fill a square.
  EXPECT_EQ(builtin_dictionary("tagStandard41h12")->codes[0], 0x1bd8a64ad10U);
  EXPECT_EQ(builtin_dictionary("tagCustom48h12")->codes[1], 0xd6c8e905e5b5U);
  // The official picture of tag36_11_00000: 0xd7e00984b along AprilTag's spiral.
  EXPECT_EQ(builtin_dictionary("tag36h11")->codes[0], 0xd5d628584U);
}

TEST(BuiltinDictionary, UnknownNamesGetHints) {
  EXPECT_EQ(builtin_dictionary("DICT_6x6_205").error(),
            "unknown dictionary 'DICT_6x6_205'; did you mean DICT_6X6_100, DICT_6X6_250 or DICT_6X6_50?");
}

TEST(AcceptedShare, CountsTheReadings) {
  EXPECT_DOUBLE_EQ(accepted_share(4, 1, 0), 4.0 / 16);
  EXPECT_DOUBLE_EQ(accepted_share(4, 1, 2), 4.0 * (1 + 4 + 6) / 16);
}

TEST(SafeCorrectedBits, FollowsItsFormula) {
  EXPECT_EQ(safe_corrected_bits(36, 587, 11), 2);  // 3 bits: 1.13 in 4,096
  EXPECT_EQ(safe_corrected_bits(36, 250, 12), 3);
  EXPECT_EQ(safe_corrected_bits(16, 50, 4), 0);
  EXPECT_EQ(safe_corrected_bits(64, 1, 5), 2);  // bounded by the distance
}

TEST(LoadDictionary, ReadsAFileAndNamesItByItsStem) {
  const auto path = std::filesystem::temp_directory_path() / "runmark_dictionary_test.codes";
  std::ofstream(path) << "4 1\n5867\n8b03\n";
  const auto dictionary = load_dictionary(path.string());
  ASSERT_TRUE(dictionary) << dictionary.error();
  EXPECT_EQ(dictionary->name, "runmark_dictionary_test");
  std::ofstream(path) << "4 1\nspam\n";
  EXPECT_EQ(load_dictionary(path.string()).error(),
            path.string() + ", line 2: 'spam' is not a code of up to 16 hexadecimal digits");
  std::filesystem::remove(path);
  EXPECT_EQ(load_dictionary(path.string()).error(), path.string() + ": cannot be read");
  EXPECT_EQ(load_dictionary("DICT_4X4_50")->codes.size(), 50U);
}

TEST(LoadDictionary, RefusesAFolder) {
  const auto path = std::filesystem::temp_directory_path() / "runmark_folder.codes";
  std::filesystem::create_directory(path);
  EXPECT_EQ(load_dictionary(path.string()).error(), path.string() + ": empty or not a readable file");
  std::filesystem::remove(path);
}

TEST(LoadDictionary, RefusesWhatHasNoEnd) {
  const auto path = std::filesystem::temp_directory_path() / "runmark_endless.codes";
  std::filesystem::remove(path);
  std::filesystem::create_symlink("/dev/zero", path);
  EXPECT_EQ(load_dictionary(path.string()).error(),
            path.string() + ": larger than 8 MB, which no such file needs to be");
  std::filesystem::remove(path);
}

TEST(LoadDictionary, ReadsTheFilesOfTheRealImageSet) {
  const char* shared = std::getenv("RUNMARK_SHARED");
  const std::filesystem::path folder =
      std::filesystem::path(shared != nullptr ? shared : RUNMARK_SOURCE_DIR "/../shared") /
      "real-images/dictionaries";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no " << folder;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto dictionary = load_dictionary(entry.path().string());
    ASSERT_TRUE(dictionary) << dictionary.error();
    const auto builtin = builtin_dictionary(dictionary->name);
    if (builtin) {
      EXPECT_EQ(builtin->codes, dictionary->codes) << dictionary->name;
    }
  }
}

}  // namespace
}  // namespace runmark
