// Counts what runmark, OpenCV's ArUco and AprilTag 3 report in frames without any marker, as CSV: a row for
// each detector and dictionary.
#include <CLI/CLI.hpp>
#include <array>
#include <iostream>

#include "bench/false_alarms/frames.h"
#include "bench/peers/reader.h"

namespace {

using runmark::bench::frame_kinds;

struct Row {
  std::unique_ptr<runmark::bench::Reader> reader;
  std::string_view detector;
  std::string dictionary;
  std::vector<runmark::Dictionary> dictionaries;
  std::array<int, frame_kinds> found{};
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Counts false alarms in frames of noise, textures and text", "runmark-false-alarms");
  int frames = 1000;
  int first = 0;
  std::vector<std::string> dictionaries{"DICT_4X4_50",  "DICT_4X4_1000", "tag16h5", "DICT_5X5_250",
                                        "DICT_6X6_250", "DICT_7X7_1000", "tag25h9", "tag36h11"};
  std::vector<std::string> detectors{"runmark", "opencv", "apriltag-1"};
  app.add_option("--frames", frames, "how many")->check(CLI::Range(1, 1000000));
  app.add_option("--first", first, "number of the first one")->check(CLI::NonNegativeNumber);
  app.add_option("--dictionaries", dictionaries, "which ones, each by itself")->delimiter(',');
  app.add_option("--detectors", detectors, "which ones")->delimiter(',');
  CLI11_PARSE(app, argc, argv);
  std::vector<Row> rows;
  for (const std::string& detector : detectors) {
    const auto* contender = runmark::bench::find_contender(detector);
    for (const std::string& name : dictionaries) {
      const auto dictionary = runmark::load_dictionary(name);
      if (contender == nullptr || !dictionary) {
        std::cerr << "runmark-false-alarms: " << (contender == nullptr ? detector : name) << ": not known\n";
        return 2;
      }
      Row row{nullptr, contender->name, name, {*dictionary}, {}};
      rows.push_back(std::move(row));
      rows.back().reader = contender->make({rows.back().dictionaries, false, {320, 240}});
    }
  }
  for (int i = first; i < first + frames; ++i) {
    const cv::Mat frame = runmark::bench::marker_free_frame(i);
    for (Row& row : rows) {
      row.found[static_cast<std::size_t>(i % frame_kinds)] +=
          static_cast<int>(row.reader->read(frame).size());
    }
  }
  std::cout << "detector,dictionary,frames,noise,texture,text\n";
  for (const Row& row : rows) {
    std::cout << row.detector << ',' << row.dictionary << ',' << frames;
    for (const int found : row.found) std::cout << ',' << found;
    std::cout << '\n';
  }
  return 0;
}
