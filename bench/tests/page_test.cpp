#include "bench/side_by_side/page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "bench/side_by_side/shared_markers.h"
#include "bench/side_by_side/svg_chart.h"
#include "bench/side_by_side/thumbnail.h"

namespace runmark::bench {
namespace {

Corners square(double x, double y, double side) {
  return {Point{x, y}, Point{x + side, y}, Point{x + side, y + side}, Point{x, y + side}};
}

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TruthImage two_markers() {
  TruthImage image{.image = "a.png", .width = 200, .height = 100, .dictionary = "tag36h11"};
  image.markers.push_back({.id = 1, .corners = square(10, 10, 50), .exact_corners = true});
  image.markers.push_back({.id = 2, .corners = square(100, 10, 50), .exact_corners = true});
  image.present_ids = {1, 2};
  return image;
}

// One finds both, a pixel off; the other one of them, two pixels off, and one that is not there.
std::vector<Run> two_runs() {
  return {{"first", {{"a.png", {{{1, square(11, 10, 50)}, {2, square(101, 10, 50)}}, 1.0}}}},
          {"second <&>", {{"a.png", {{{1, square(12, 10, 50)}, {7, square(20, 20, 30)}}, 2.0}}}}};
}

TEST(SharedMarkers, AreThoseAllFound) {
  const SharedMarkers shared = shared_markers({two_markers()}, two_runs());
  EXPECT_EQ(shared.count, 1);
  EXPECT_DOUBLE_EQ(shared.total[0].rms(), 1);
  EXPECT_DOUBLE_EQ(shared.total[1].rms(), 2);
}

TEST(ComparisonPage, StandsAloneAndShowsEveryMistake) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "runmark_page";
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(cv::imwrite((folder / "a.png").string(), cv::Mat(100, 200, CV_8UC1, cv::Scalar(128))));
  const std::string html =
      comparison_page("title", {two_markers()}, TruthFolder(folder / "truth.json"), two_runs());
  std::filesystem::remove_all(folder);
  EXPECT_EQ(count(html, "<svg"), 3);
  EXPECT_EQ(count(html, "<figure>"), 2) << "one miss, one false alarm";
  EXPECT_EQ(count(html, "src=\"data:image/jpeg;base64,"), count(html, "src="));
  EXPECT_EQ(count(html, "href="), 0);
  EXPECT_NE(html.find("second &lt;&amp;&gt;"), std::string::npos);
  EXPECT_NE(html.find("<td>1.0000<td>2/2<td>0"), std::string::npos);
  EXPECT_NE(html.find("<td>0.5000<td>1/2<td>1"), std::string::npos);
}

TEST(Chart, LeavesOutWhatIsNotKnown) {
  const Chart chart{"t", "u", {"a", "b"}, {{"one", {1.0, std::nullopt}}, {"two", {2.0, 3.0}}}};
  EXPECT_EQ(count(draw(chart), "<rect"), 3);
}

TEST(Thumbnail, OfNothingIsEmpty) {
  const cv::Mat grey(50, 50, CV_8UC1, cv::Scalar(0));
  EXPECT_TRUE(thumbnail(grey, square(500, 500, 20), {0, 0, 0}).empty());
  EXPECT_FALSE(thumbnail(grey, square(40, 40, 20), {0, 0, 0}).empty()) << "partly inside";
}

}  // namespace
}  // namespace runmark::bench
