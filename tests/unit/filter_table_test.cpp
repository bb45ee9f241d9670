#include "preprocess/filter_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace runmark {
namespace {

const char* const docs_page = RUNMARK_SOURCE_DIR "/docs/preprocess.md";

char letter_of(FilterCase one) {
  switch (one) {
    case filter_hole_with_diagonals:
      return 'a';
    case filter_diagonal_object:
      return 'b';
    case filter_diagonal_hole:
      return 'c';
    case filter_lone_object:
      return 'd';
    case filter_lone_hole:
      return 'e';
    case filter_empty_column:
      return 'f';
    default:
      return '.';
  }
}

/// The table as the docs print it: 32 rows of 16 windows.
std::string printed_table() {
  std::string text = "```text\n        +0 +1 +2 +3 +4 +5 +6 +7 +8 +9 10 11 12 13 14 15\n";
  for (std::size_t row = 0; row < window_count; row += 16) {
    std::string number = std::to_string(row);
    text += std::string(5 - number.size(), ' ') + number + "   ";
    for (std::size_t window = row; window < row + 16; ++window) {
      text += std::string(" ") + letter_of(filter_table[window]) + (window % 16 == 15 ? "\n" : " ");
    }
  }
  return text + "```\n";
}

// RUNMARK_WRITE_DOCS=1 writes the table into the page instead of checking it.
TEST(FilterTable, DocsPrintIt) {
  std::stringstream read;
  read << std::ifstream(docs_page).rdbuf();
  std::string page = read.str();
  const std::string begin = "<!-- filter table -->\n";
  const auto from = page.find(begin);
  const auto to = page.find("<!-- end of filter table -->");
  ASSERT_NE(from, std::string::npos) << docs_page;
  ASSERT_NE(to, std::string::npos) << docs_page;
  const std::string printed = page.substr(from + begin.size(), to - from - begin.size());
  if (std::getenv("RUNMARK_WRITE_DOCS") != nullptr) {
    std::ofstream(docs_page) << page.replace(from + begin.size(), printed.size(), printed_table());
    return;
  }
  EXPECT_EQ(printed, printed_table());
}

TEST(FilterTable, EachCaseHasItsNumberOfWindows) {
  std::map<FilterCase, int> windows;
  for (const FilterCase one : filter_table) ++windows[one];
  EXPECT_EQ(windows[filter_hole_with_diagonals], 9);
  EXPECT_EQ(windows[filter_diagonal_object], 6);
  EXPECT_EQ(windows[filter_diagonal_hole], 6);
  EXPECT_EQ(windows[filter_lone_object], 1);
  EXPECT_EQ(windows[filter_lone_hole], 1);
  EXPECT_EQ(windows[filter_empty_column], 9);
}

TEST(FilterTable, MirroredWindowsShowTheSameCase) {
  constexpr int left_right[] = {2, 1, 0, 5, 4, 3, 8, 7, 6};
  constexpr int upside_down[] = {6, 7, 8, 3, 4, 5, 0, 1, 2};
  for (const auto& mirror : {left_right, upside_down}) {
    for (unsigned window = 0; window < window_count; ++window) {
      unsigned mirrored = 0;
      for (int bit = 0; bit < 9; ++bit) mirrored |= (window >> mirror[bit] & 1U) << bit;
      EXPECT_EQ(filter_table[window], filter_table[mirrored]) << window;
    }
  }
}

}  // namespace
}  // namespace runmark
