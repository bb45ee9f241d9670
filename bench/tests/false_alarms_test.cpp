#include <gtest/gtest.h>

#include <opencv2/imgcodecs.hpp>

#include "bench/false_alarms/frames.h"
#include "bench/peers/reader.h"
#include "runmark/detector.h"

namespace runmark::bench {
namespace {

constexpr int frames = 500;
constexpr int frames_of_peers = 150;  // they take long

std::vector<Dictionary> dictionaries(std::initializer_list<const char*> names) {
  std::vector<Dictionary> all;
  for (const char* name : names) all.push_back(*builtin_dictionary(name));
  return all;
}

TEST(FalseAlarms, FramesAreReproducible) {
  const cv::Mat once = marker_free_frame(5);
  const cv::Mat again = marker_free_frame(5);
  EXPECT_EQ(cv::norm(once, again), 0);
  EXPECT_GT(cv::norm(once, marker_free_frame(8)), 0);
}

TEST(FalseAlarms, NoneWithCodesOfFiveCellsAndMore) {
  Options options;
  options.max_width = 320;
  options.max_height = 240;
  auto detector = Detector::create(
      options, dictionaries({"DICT_5X5_1000", "DICT_6X6_1000", "DICT_7X7_1000", "ARUCO_MIP_25h7",
                             "ARUCO_MIP_36h12", "tag25h9", "tag36h10", "tag36h11"}));
  ASSERT_TRUE(detector) << detector.error();
  for (int i = 0; i < frames; ++i) {
    const cv::Mat frame = marker_free_frame(i);
    const Detection found = detector->detect(
        ImageView::grey(frame.data, frame.cols, frame.rows, static_cast<std::ptrdiff_t>(frame.step[0])));
    for (const Marker& marker : found)
      ADD_FAILURE() << "frame " << i << ": " << marker.dictionary << ' ' << marker.id;
  }
}

TEST(FalseAlarms, SmallCodesNoMoreThanThePeers) {
  for (const char* name : {"DICT_4X4_50", "tag16h5"}) {
    const auto dictionary = dictionaries({name});
    const auto count = [&](const char* detector) {
      const auto reader = find_contender(detector)->make({dictionary, false, {320, 240}});
      int found = 0;
      for (int i = 0; i < frames_of_peers; ++i)
        found += static_cast<int>(reader->read(marker_free_frame(i)).size());
      return found;
    };
    const int ours = count("runmark");
    EXPECT_LE(ours, count("opencv")) << name;
    EXPECT_LE(ours, count("apriltag-1")) << name;
  }
}

}  // namespace
}  // namespace runmark::bench
